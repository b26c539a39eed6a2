#pragma once

#include "prs/sector/influence/cache_key.h"
#include "prs/sector/influence/flexibility.h"

namespace prs {

/// A body under unit loads on its flanks.
struct LoadedBody {
  GroovedShape shape;
  std::vector<LoadedFlank> flanks;
  Material material;
  MeshDensity density;

  GroovedBody meshed() const { return mesh_grooved_body(shape, flanks, density); }
};
PRS_MEMBERS(LoadedBody, shape, flanks, material, density)

/// A nut, held at a section; with a shoulder on what it reaches of a free face there, `radii` of
/// the shape.
struct HeldNut {
  LoadedBody body;
  double thrust = 0.0;
  bool shoulder = false;
};
PRS_MEMBERS(HeldNut, body, thrust, shoulder)

LoadedBody loaded_screw(const BodyGeometry& b, Direction direction,
                        const FlexibilityOptions& options);
HeldNut held_nut(const BodyGeometry& b, Direction direction, double position,
                 const FlexibilityOptions& options);
/// Teeth of screw or nut, which all rollers touch alike.
Teeth teeth_of(const BodyGeometry& b, Part part, Direction direction,
               const FlexibilityOptions& options);

/// Nodes of some edges, each once.
std::vector<int> nodes_of(const std::vector<fe::MeridianEdge>& edges);
/// Nodes by which a nut is held.
std::vector<int> held_nodes(const GroovedBody& body, const HeldNut& nut);

/// Loads of harmonic 1 that push sideways with 1 N, spread evenly over a section; also the weights
/// of its mean sideways displacement, 1/2 (U - V).
Eigen::VectorXd transverse_force(const GroovedBody& body,
                                 const std::vector<fe::MeridianEdge>& section);

}  // namespace prs
