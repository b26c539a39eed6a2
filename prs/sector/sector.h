#pragma once

#include <vector>

#include "fe/model.h"
#include "prs/model/deviations.h"
#include "prs/model/load_case.h"
#include "prs/model/materials.h"
#include "prs/model/mechanism.h"
#include "prs/model/model_options.h"
#include "prs/model/structure.h"
#include "prs/threads/contact_law.h"

namespace prs {

/// One roller with its share of screw and nut as bars, beams and Hertz springs (Abevi 2015, section
/// 3), refined where the options say so (docs/refined.md). x runs along the axis from the loaded
/// end of the screw into the mechanism, y outwards. Loads and the sections of screw and nut are
/// those of the mechanism divided by the rollers.
struct Sector {
  fe::Model model;
  /// Screw section that takes the load; its first contact without free_length.
  int loaded_node = 0;
  std::vector<int> screw_nodes;  ///< At the contacts, thread 1 first.
  /// At the contacts, along x: one a tooth where they lie opposite each other, else two.
  std::vector<int> roller_nodes;
  std::vector<int> nut_nodes;  ///< At the contacts.
  /// Outer and inner node of the roller's first end, inner and outer node of its last.
  std::vector<int> roller_end_nodes;
  PerInterface<ContactLaw> laws;
  PerInterface<std::vector<double>> gaps;  ///< Initial gap of each thread along the normal [m].
  Direction direction = Direction::tension;
  int rollers = 1;
  double roller_radius = 0.0;
  /// Of the loaded section, beside that of the model, per axial force on the sector [m/N].
  double offset_compliance = 0.0;

  int contacts() const { return static_cast<int>(screw_nodes.size()); }
  /// Index in `model.springs` of a thread's contact, 0 <= thread < contacts().
  int spring(Interface i, int thread) const {
    return i == Interface::screw ? thread : contacts() + thread;
  }
};

/// Builds the sector for one direction of the load and one position of the first contact on the
/// nut. The case must have passed `check_case`.
Sector build_sector(const Mechanism& mechanism, const Structure& structure,
                    const Materials& materials, const ModelOptions& options,
                    const PerInterface<ContactLaw>& laws, Direction direction, double position,
                    const Deviations& deviations = {});

}  // namespace prs
