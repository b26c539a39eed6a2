#pragma once

#include "prs/model/load_case.h"
#include "prs/model/mechanism.h"
#include "prs/model/structure.h"
#include "prs/sector/influence/teeth.h"
#include "prs/sector/influence/thrust_face.h"
#include "prs/sector/sector.h"

namespace prs {

/// Displacements of one body at its contacts under unit normal forces: pressure-weighted means
/// along the inward normal, against rigid motions as said at each body, without the half-space part
/// of a contact's own patch, which the exact Hertz law carries. [m/N], symmetric.
struct Flexibility {
  Eigen::MatrixXd matrix;
  double half_space = 0.0;         ///< Taken from each diagonal term [m/N]; roller: screw side.
  std::optional<ThrustFace> face;  ///< For a nut that can lift off its shoulder.
  Eigen::MatrixXd bent;            ///< Of it what bends a roller.
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
  /// Whether rows and columns of unit forces along the flanks follow those of the normal ones, for
  /// the contacts of each interface.
  bool friction = false;

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

}  // namespace prs
