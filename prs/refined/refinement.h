#pragma once

#include <optional>
#include <vector>

#include "prs/load_case.h"
#include "prs/materials.h"
#include "prs/mechanism.h"
#include "prs/model_options.h"
#include "prs/part.h"
#include "prs/refined/nut_shell.h"
#include "prs/sector.h"
#include "prs/structure.h"

namespace prs {

/// What `Bodies::refined` changes in the bars of a sector (docs/refined.md). With `bars` nothing:
/// pitch diameters, contacts opposite each other, no compliance beyond that of the contact laws.
struct Refinement {
  PerPart<double> core_diameter;      ///< Of what carries axial force and bends [m].
  bool roller_shear = false;          ///< Shear bends the roller.
  double roller_half_distance = 0.0;  ///< Of the two contacts of a roller tooth, along x [m].
  std::optional<NutShell> nut;        ///< In place of the nut's bars.
  bool nut_radially_rigid = false;    ///< The shell holds v = 0.
  /// Compliance of each contact in series with Hertz's, thread 1 first [m/N].
  PerInterface<std::vector<double>> compliance;
  double offset_compliance = 0.0;  ///< As in `Sector`.
};

/// Roots lie by the dedendum of `mechanism.thread` from the pitch radius, by default that of
/// `default_groove` but no more than half of the wall or core.
Refinement refinement(const Mechanism& mechanism, const Structure& structure,
                      const Materials& materials, const ModelOptions& options,
                      const PerInterface<ContactLaw>& laws, Direction direction,
                      const NutLine& line);

}  // namespace prs
