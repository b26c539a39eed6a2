#pragma once

#include "prs/model/preload.h"
#include "prs/record/record.h"
#include "prs/threads/contacts.h"

namespace prs {

/// One interface's contact, among what else is known of the threads.
struct ContactAt {
  const Contacts* contacts = nullptr;
  Interface interface = Interface::screw;

  const InterfaceContact& contact() const { return contacts->interfaces[interface]; }
  /// Whether the backlash means something.
  bool same_pitch() const {
    const contact::MechanismGeometry& threads = contacts->threads;
    return contact::same_pitch(interface == Interface::screw ? threads.screw : threads.nut,
                               threads.roller);
  }
};

// One value per part, interface or sense of the load; their unit is that of the key they stand
// under.
template <>
Record<PerPart<double>> record_of();
template <>
Record<PerPart<std::array<double, 2>>> record_of();
template <>
Record<PerInterface<double>> record_of();
template <>
Record<PerDirection<double>> record_of();
template <>
Record<PerDirection<std::optional<double>>> record_of();

template <>
Record<ContactAt> record_of();
template <>
Record<Contacts> record_of();
template <>
Record<ThreadWidths> record_of();
/// The threads by themselves.
template <>
Record<contact::MechanismGeometry> record_of();

}  // namespace prs
