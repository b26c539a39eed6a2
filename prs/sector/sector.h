#pragma once

#include "fe/model.h"
#include "prs/sector/sector_model.h"

namespace prs {

/// A sector's numbers as bars, beams, shells and Hertz springs. x runs along the axis from the
/// loaded end of the screw into the mechanism, y outwards. Loads and the sections of screw and nut
/// are those of the mechanism divided by the rollers.
struct Sector : SectorModel {
  fe::Model model;
  /// Screw section that takes the load; its first contact without free_length.
  int loaded_node = 0;
  std::vector<int> screw_nodes;  ///< At the contacts, thread 1 first.
  /// At the contacts, along x: one per tooth where they lie opposite each other, else two.
  std::vector<int> roller_nodes;
  std::vector<int> nut_nodes;  ///< At the contacts.
  /// Outer and inner node of the roller's first end, inner and outer node of its last.
  std::vector<int> roller_end_nodes;

  /// Index in `model.springs` of the contact of thread k, 0 <= k < contacts().
  int spring(Interface i, int k) const { return i == Interface::screw ? k : contacts() + k; }
};

Sector build_sector(const SectorModel& model);

/// Whether a length of the roller is one of its plain ends.
inline bool is_head(const Sector& s, const fe::BeamElement& b) {
  return b.first == s.roller_end_nodes.front() || b.second == s.roller_end_nodes.back();
}

/// Builds the sector from the arguments of `sector_model`.
template <class... Parts>
Sector build_sector(const Mechanism& mechanism, const Parts&... parts) {
  return build_sector(sector_model(mechanism, parts...));
}

}  // namespace prs
