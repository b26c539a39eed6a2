#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "prs/influence/grooved_body.h"
#include "prs/influence/hertz_patch.h"
#include "prs/influence/matrix_cache.h"
#include "prs/influence/thrust_face.h"
#include "prs/load_case.h"
#include "prs/materials.h"
#include "prs/mechanism.h"
#include "prs/model_options.h"
#include "prs/part.h"
#include "prs/sector.h"
#include "prs/structure.h"

namespace prs {

/// How exactly the flexibility of the bodies is worked out.
struct FlexibilityOptions {
  MeshDensity mesh;
  /// Harmonics are summed by finite elements up to n a_t/r = this; beyond, the body is taken as a
  /// half-space and its harmonics are added in closed form. More is not better on a coarse mesh,
  /// which represents the short waves worse than the closed form does.
  double largest_wave = 1.0;
  /// A harmonic is followed along the body until it has decayed to this share.
  double block_tolerance = 1e-3;
  /// Cells across the patches of the neighbours, which only feel a harmonic.
  int neighbour_patch_cells = 2;
  /// The thrust face of the nut pushes only; parts of it that would pull are let go.
  bool unilateral_thrust = true;
};

/// Options of an accuracy: `working` are the defaults.
FlexibilityOptions flexibility_options(ModelOptions::Accuracy accuracy);

/// Displacements of one body at its contacts under unit normal forces: pressure-weighted means
/// along the inward normal, against rigid motions as said at each body, without the half-space part
/// of a contact's own patch, which the exact Hertz law carries. [m/N], symmetric.
struct Flexibility {
  Eigen::MatrixXd matrix;
  int harmonics = 0;               ///< Summed by finite elements.
  int last_harmonic = 0;           ///< The highest of them.
  double half_space = 0.0;         ///< Taken from each diagonal term [m/N]; roller: screw side.
  double closed_remainder = 0.0;   ///< Added to each for the harmonics left out [m/N]; the same.
  std::optional<ThrustFace> face;  ///< Of a nut that can lift off its shoulder.
};

/// What the flexibilities of the three bodies depend on.
struct BodyGeometry {
  PerPart<Groove> grooves;
  PerPart<Material> materials;
  PerInterface<HertzPatch> patches;
  Structure structure;
  int rollers = 1;
  int contacts = 1;  ///< At each interface of a roller.
  ModelOptions::RollerContacts roller_contacts = ModelOptions::RollerContacts::opposite;
  /// An inverted screw is threaded where its rollers are and plain, at the pitch diameter, before
  /// them; the thread of a standard one goes on at both sides.
  bool endless_screw = false;

  double pitch() const { return grooves.roller.pitch; }
};

/// The ridges of the three bodies: flanks at the angles of the contact laws, heights as the
/// mechanism gives them or by default. The mechanism must have its pitch diameters.
BodyGeometry body_geometry(const Mechanism& mechanism, const Structure& structure,
                           const Materials& materials, const PerInterface<ContactLaw>& laws,
                           const PerInterface<HertzPatch>& patches, Direction direction,
                           const ModelOptions& model = {});

/// Screw: harmonics 0, N, 2 N, .. of N rollers, all of which push alike. Displacements against the
/// loaded section, `free_length` before the first contact, which stays plane and slides radially.
/// It ends half a pitch behind its last ridge, an endless one three pitches behind its last
/// contact.
Flexibility screw_flexibility(const BodyGeometry& body, Direction direction,
                              const FlexibilityOptions& options,
                              MatrixCache& cache = shared_matrix_cache());

/// Nut: the same harmonics. Displacements against the thrust face, on which it is held axially: the
/// shoulder on the face of a flange that ends at the thrust section, else the section. `face` lets
/// go of what does not push under given loads.
Flexibility nut_flexibility(const BodyGeometry& body, Direction direction, double position,
                            const FlexibilityOptions& options,
                            MatrixCache& cache = shared_matrix_cache());

/// Roller: all harmonics; contacts at the screw (theta = pi) come first, then those at the nut
/// (theta = 0), on the other flank of the same ridge. Those of a ring-shaped ridge lie half a pitch
/// apart. Opposite contacts bend it as if both lay at the middle of the ridge, and what a contact
/// feels of the other side's higher harmonics is the mean of half a pitch before and behind. Its
/// guidance holds it sideways. Axially a point of the axis is held, so that single entries depend
/// on that point, but not the displacements under loads in balance.
Flexibility roller_flexibility(const BodyGeometry& body, Direction direction,
                               const FlexibilityOptions& options,
                               MatrixCache& cache = shared_matrix_cache());

/// Response of a long body to one loaded ridge, harmonic by harmonic.
struct BlockResponse {
  int reach = 0;  ///< Ridges to each side.
  /// Entry d + `reach`: displacement at the contacts of ridge d (rows) by the contacts of ridge 0.
  std::vector<Eigen::MatrixXd> kernel;
};

/// Harmonic n >= 2 of unit forces at theta = 0 on the given flanks of one ridge in a block of
/// equal ridges; `far_radius` as in GroovedShape. Builds a new mesh for each `reach`, kept between
/// calls with the same one.
class BlockSolver {
 public:
  BlockSolver(const Groove& groove, double far_radius, const Material& material,
              const std::vector<LoadedFlank>& flanks, const FlexibilityOptions& options);

  BlockResponse solve(int harmonic, int reach);
  /// Ridges that the harmonic reaches to each side, at most `largest`.
  int reach(int harmonic, int largest) const;

 private:
  Groove groove_;
  double far_radius_;
  fe::Isotropic material_;
  std::vector<LoadedFlank> flanks_;
  FlexibilityOptions options_;
  int reach_ = -1;
  GroovedBody body_;
  std::unique_ptr<fe::HarmonicBody> solver_;
};

}  // namespace prs
