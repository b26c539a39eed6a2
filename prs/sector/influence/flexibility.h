#pragma once

#include <tuple>

#include "prs/sector/influence/grooved_body.h"
#include "prs/sector/influence/matrix_cache.h"
#include "prs/sector/influence/thrust_face.h"
#include "prs/sector/sector.h"

namespace prs {

/// The teeth of one body: types of contacts on each ridge, whether they lie at theta = pi, and the
/// harmonics step, 2 step, .. from `first` on.
struct Teeth {
  Groove groove;
  double far_radius = 0.0;
  Material material;
  std::vector<LoadedFlank> types;
  std::vector<bool> opposite;
  int first = 0;
  int step = 1;
  int contacts = 1;
  FlexibilityOptions options;
};

/// Displacements of one body at its contacts under unit normal forces: pressure-weighted means along the inward normal,
/// relative to the rigid motions stated at each body, without the half-space part of a contact's own patch, which is in
/// the exact Hertz law. [m/N], symmetric.
struct Flexibility {
  Eigen::MatrixXd matrix;
  double half_space = 0.0;         ///< Subtracted from each diagonal term [m/N]; roller: screw side.
  std::optional<ThrustFace> face;  ///< Face of a nut that can lift off its shoulder.
  Eigen::MatrixXd bent;            ///< Part of the matrix from the bending of a roller.

  /// Guides with a clearance, which springs replace in holding the ends of the roller.
  struct Guides {
    RingGuide ring;
    double held_by = 0.0;      ///< Stiffness of a spring [N/m].
    double end_length = 0.0;   ///< [m]
    Eigen::MatrixXd coupling;  ///< Displacements at the contacts by unit outward forces at the guides [m/N].
    Eigen::MatrixXd between;   ///< Outward displacements of the guides by such forces [m/N].
  };
  std::optional<Guides> guides;
};

/// Inputs of the flexibilities of the three bodies.
struct BodyGeometry {
  PerPart<Groove> grooves;
  PerPart<Material> materials;
  PerInterface<HertzPatch> patches;
  Structure structure;
  int rollers = 1;
  int contacts = 1;  ///< Number at each interface of a roller.
  ModelOptions::RollerContacts roller_contacts = ModelOptions::RollerContacts::opposite;
  /// Whether the screw is threaded beyond its rollers, as a standard one is; an inverted one is plain before them, at
  /// the pitch diameter.
  bool endless_screw = false;
  /// Whether rows and columns of unit forces along the flanks follow those of the normal ones, for
  /// the contacts of each interface.
  bool friction = false;

  double pitch() const { return grooves.roller.pitch; }
};

/// Ridges of the three bodies: flanks at the angles of the contact laws, heights from the mechanism or by default. The
/// mechanism must have its pitch diameters.
BodyGeometry body_geometry(const Mechanism& mechanism, const Structure& structure, const Materials& materials,
                           const PerInterface<ContactLaw>& laws, const PerInterface<HertzPatch>& patches,
                           Direction direction, const ModelOptions& model = {});

/// Flexibility of the screw: harmonics 0, N, 2 N, .. of N rollers, all of which push equally. Displacements are against
/// the loaded section, `free_length` before the first contact, which stays plane and slides radially. The screw ends
/// half a pitch behind its last ridge, an endless one three pitches behind its last contact.
Flexibility screw_flexibility(const BodyGeometry& body, Direction direction, const FlexibilityOptions& options,
                              MatrixCache& cache = shared_matrix_cache());

/// Flexibility of the nut: harmonics as for the screw. Displacements are against the thrust face, which is held
/// axially: the shoulder on the face of a flange that ends at the thrust section, else the section. `face` releases
/// parts that do not push under given loads.
Flexibility nut_flexibility(const BodyGeometry& body, Direction direction, double position,
                            const FlexibilityOptions& options, MatrixCache& cache = shared_matrix_cache());

/// Flexibility of the roller: all harmonics; contacts at the screw (theta = pi) come first, then those at the nut
/// (theta = 0), on the other flank of the same ridge. Those of a ring-shaped ridge lie half a pitch apart. Opposite
/// contacts bend the roller as if both lay at the middle of the ridge, and the effect of the other side's higher
/// harmonics is the mean of half a pitch before and behind. The guidance holds the roller sideways. Axially a point of
/// the axis is held, so that single entries depend on that point, but not the displacements under loads in balance.
Flexibility roller_flexibility(const BodyGeometry& body, Direction direction, const FlexibilityOptions& options,
                               MatrixCache& cache = shared_matrix_cache());

/// Defines members(value), a tuple of all members of a type that a computation depends on. It does not compile unless
/// every member is named.
#define PRS_MEMBERS(Type, ...)             \
  inline auto members(const Type& value) { \
    const auto& [__VA_ARGS__] = value;     \
    return std::tie(__VA_ARGS__);          \
  }
PRS_MEMBERS(Groove, internal, pitch, pitch_radius, addendum, dedendum, backward_angle, forward_angle)
PRS_MEMBERS(HertzPatch, along_profile, along_circumference)
PRS_MEMBERS(LoadedFlank, ridge, side, patch, patch_cells, tangential)
PRS_MEMBERS(PlainEnd, length, radius)
PRS_MEMBERS(Collar, from, to, radius)
inline auto members(const std::pair<double, double>& p) { return std::tie(p.first, p.second); }
PRS_MEMBERS(GroovedShape, groove, start, end, ridge, ridges, far_radius, plain_end, collars, sections, radii)
PRS_MEMBERS(MeshDensity, patch_cells, growth, largest_cell, step_cell, plain_flank_cells, split, ridge_depth)
PRS_MEMBERS(FlexibilityOptions, mesh, largest_wave, block_tolerance, neighbour_patch_cells, unilateral_thrust)
/// Members without those that only flash temperatures use.
inline auto members(const Material& value) {
  const auto& [youngs_modulus, poisson_ratio, density, thermal_expansion, conductivity, specific_heat,
               static_pressure_limit] = value;
  return std::tie(youngs_modulus, poisson_ratio, density, thermal_expansion);
}
/// Members without the clearance, on which no matrix depends.
inline auto members(const Guidance& value) {
  const auto& [kind, ring_stiffness, clearance] = value;
  return std::tie(kind, ring_stiffness);
}
PRS_MEMBERS(Teeth, groove, far_radius, material, types, opposite, first, step, contacts, options)

template <class T>
void append_bytes(std::string& bytes, const std::vector<T>& values);
template <class T>
void append_bytes(std::string& bytes, const std::optional<T>& value);

/// Bytes of all numbers in a value, nested ones included.
template <class T>
void append_bytes(std::string& bytes, const T& value) {
  if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>)
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  else
    std::apply([&](const auto&... member) { (append_bytes(bytes, member), ...); }, members(value));
}
template <class T>
void append_bytes(std::string& bytes, const std::vector<T>& values) {
  append_bytes(bytes, values.size());
  for (const T value : values) append_bytes(bytes, value);
}
template <class T>
void append_bytes(std::string& bytes, const std::optional<T>& value) {
  append_bytes(bytes, value.has_value());
  if (value) append_bytes(bytes, *value);
}

/// compute(given), cached under the bytes of its argument; as a plain function it depends on nothing else. `fits`
/// checks the matrices of a file. Increase the number in the key when the same input gives other matrices.
template <class Given>
std::shared_ptr<const MatrixCache::Matrices> cached(MatrixCache& cache, std::string_view what, const Given& given,
                                                    MatrixCache::Matrices (*compute)(const Given&),
                                                    bool (*fits)(const Given&, const MatrixCache::Matrices&)) {
  std::string key = "flexibility 3 ";
  key += what;
  append_bytes(key, given);
  return cache.get(
      key, [&] { return compute(given); },
      [&](const MatrixCache::Matrices& matrices) { return fits(given, matrices); });
}

/// A body under unit loads on its flanks.
struct LoadedBody {
  GroovedShape shape;
  std::vector<LoadedFlank> flanks;
  Material material;
  MeshDensity density;

  GroovedBody meshed() const { return mesh_grooved_body(shape, flanks, density); }
};
PRS_MEMBERS(LoadedBody, shape, flanks, material, density)

/// A nut, held at a section; if it has a shoulder, on the part of a free face there that the shoulder covers, `radii`
/// of the shape.
struct HeldNut {
  LoadedBody body;
  double thrust = 0.0;
  bool shoulder = false;
};
PRS_MEMBERS(HeldNut, body, thrust, shoulder)

LoadedBody loaded_screw(const BodyGeometry& b, Direction direction, const FlexibilityOptions& options);
HeldNut held_nut(const BodyGeometry& b, Direction direction, double position, const FlexibilityOptions& options);
/// Teeth of screw or nut, which all rollers touch equally.
Teeth teeth_of(const BodyGeometry& b, Part part, Direction direction, const FlexibilityOptions& options);

/// Nodes of some edges, each listed once.
std::vector<int> nodes_of(const std::vector<fe::MeridianEdge>& edges);
/// Nodes at which a nut is held.
std::vector<int> held_nodes(const GroovedBody& body, const HeldNut& nut);

/// Loads of harmonic 1 that push sideways with 1 N, spread evenly over a section; also the weights
/// of its mean sideways displacement, 1/2 (U - V).
Eigen::VectorXd transverse_force(const GroovedBody& body, const std::vector<fe::MeridianEdge>& section);
/// Loads of harmonic 1, a moment of 1 N m that turns the slope of a section; also the weights of its mean
/// slope, by axial displacements -r y'.
Eigen::VectorXd turning_moment(const GroovedBody& body, const std::vector<fe::MeridianEdge>& section);

}  // namespace prs
