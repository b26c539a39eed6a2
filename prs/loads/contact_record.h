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
Record<PerPart<double>> record_of(Type<PerPart<double>>);
Record<PerPart<std::array<double, 2>>> record_of(Type<PerPart<std::array<double, 2>>>);
Record<PerInterface<double>> record_of(Type<PerInterface<double>>);
Record<PerDirection<double>> record_of(Type<PerDirection<double>>);
Record<PerDirection<std::optional<double>>> record_of(Type<PerDirection<std::optional<double>>>);

Record<ContactAt> record_of(Type<ContactAt>);
Record<Contacts> record_of(Type<Contacts>);
Record<ThreadWidths> record_of(Type<ThreadWidths>);
/// The threads by themselves.
Record<contact::MechanismGeometry> record_of(Type<contact::MechanismGeometry>);

}  // namespace prs
