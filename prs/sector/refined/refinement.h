#pragma once

#include <optional>
#include <vector>

#include "prs/model/load_case.h"
#include "prs/model/materials.h"
#include "prs/model/mechanism.h"
#include "prs/model/model_options.h"
#include "prs/model/part.h"
#include "prs/model/structure.h"
#include "prs/sector/refined/nut_shell.h"
#include "prs/threads/contact_law.h"

namespace prs {

/// What `Bodies::refined` changes in the bars of a sector (docs/refined.md). With `bars` nothing:
/// pitch diameters, contacts opposite each other, no compliance beyond that of the contact laws.
struct Refinement {
  double plain_screw_diameter = 0.0;  ///< From the loaded section to the first contact [m].
  double screw_diameter = 0.0;        ///< Between the contacts [m].
  double roller_diameter = 0.0;       ///< Of what bends and carries axial force [m].
  std::vector<double> nut_bore;       ///< Inner radius between a node of the line and the next [m].
  bool roller_shear = false;          ///< Shear bends the roller.
  double roller_half_distance = 0.0;  ///< Of the two contacts of a roller tooth, along x [m].
  std::optional<NutShell> nut;        ///< In place of the nut's bars.
  bool nut_radially_rigid = false;    ///< The shell holds v = 0.
  /// Compliance of each contact in series with Hertz's, thread 1 first [m/N].
  PerInterface<std::vector<double>> compliance;
  double offset_compliance = 0.0;  ///< As in `Sector`.
};

/// Roots lie by the dedendum of `mechanism.thread` from the pitch radius, by default that of
/// `default_groove`. Where the nut is thin they are less deep: they leave `kLeastWall`, or half of
/// what lies outside the pitch radius where that is less. The thread of an inverted screw begins
/// at its first contact, that of a standard one at the loaded section.
Refinement refinement(const Mechanism& mechanism, const Structure& structure,
                      const Materials& materials, const ModelOptions& options,
                      const PerInterface<ContactLaw>& laws, Direction direction,
                      const NutLine& line);

}  // namespace prs
