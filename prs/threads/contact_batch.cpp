#include "prs/threads/contact_batch.h"

namespace prs {
namespace {

bool set_contact(InterfaceContact& to, const contact::ContactNumbers<double>& found, double modulus) {
  if (!found.geometry.ok()) return false;
  to.geometry = found.geometry;
  to.contact_modulus = modulus;
  to.shear.reset();
  to.von_mises.reset();
  to.hertz = modulus == 0.0 ? contact::HertzConstants{} : found.hertz;
  return modulus == 0.0 || to.hertz.ok();
}

}  // namespace

void ContactBatch::add(const contact::MechanismGeometry& threads, const std::optional<Materials>& materials) {
  contact::MechanismNumbers<double>& m = mechanisms_.emplace_back(contact::numbers_of(threads));
  if (!materials) return;
  m.modulus_at_screw = contact::contact_modulus(materials->screw, materials->roller);
  m.modulus_at_nut = contact::contact_modulus(materials->nut, materials->roller);
}

void ContactBatch::find() {
  found_.resize(mechanisms_.size());
  contact::find_contacts(mechanisms_, found_, set_);
}

bool ContactBatch::get_laws(std::size_t k, Contacts& c) const {
  const contact::MechanismContactNumbers<double>& found = found_[k];
  const auto set = [](InterfaceContact& to, const contact::ContactNumbers<double>& contact) {
    const contact::ContactPoint& point = contact.geometry.point;
    if (!point.ok()) return false;
    to.geometry.point.status = point.status;
    to.geometry.point.normal = point.normal;
    to.hertz = contact.hertz;
    return to.hertz.ok();
  };
  return found.sound != 0.0 && set(c.interfaces.screw, found.screw) && set(c.interfaces.nut, found.nut);
}

PerInterface<ContactLawNumbers> ContactBatch::laws(std::size_t k) const {
  const auto law = [](const contact::ContactNumbers<double>& c) {
    return ContactLawNumbers{
        {c.hertz.hertz_constant, c.normal.angle, 0.0}, c.normal.cosine, c.normal.sine, c.hertz.cbrt_constant};
  };
  return {law(found_[k].screw), law(found_[k].nut)};
}

bool ContactBatch::get(std::size_t k, const Mechanism& mechanism, const contact::MechanismGeometry& threads,
                       ContactDetail detail, Contacts& c) const {
  const contact::MechanismContactNumbers<double>& found = found_[k];
  const contact::MechanismNumbers<double>& m = mechanisms_[k];
  if (found.sound == 0.0 || !set_contact(c.interfaces.screw, found.screw, m.modulus_at_screw) ||
      !set_contact(c.interfaces.nut, found.nut, m.modulus_at_nut))
    return false;
  c.mechanism = mechanism;
  c.threads = threads;
  c.bad_threads = {};
  c.warnings.clear();
  for (const Interface i : kInterfaces) {
    InterfaceContact& contact = c.interfaces[i];
    contact.clearance.reset();
    if (detail == ContactDetail::numbers) contact.clearance = thread_clearance(c.threads, i, contact.geometry.point);
  }
  return true;
}

}  // namespace prs
