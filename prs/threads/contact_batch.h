#pragma once

#include "contact/contact_numbers.h"
#include "prs/threads/contacts.h"

namespace prs {

/// Extent of the computed contacts.
enum class ContactDetail {
  laws,     ///< Numbers for load distribution, ellipses and slip.
  numbers,  ///< All numbers of `find_contacts` with Detail::numbers.
};

/// Contacts of many mechanisms, side by side: equal to those of `find_contacts` with Detail::numbers to 1e-13, for
/// mechanisms that have both contacts. Memory is kept from one batch to the next.
class ContactBatch {
 public:
  explicit ContactBatch(simd::InstructionSet set = simd::InstructionSet::best) : set_(set) {}

  void clear() { mechanisms_.clear(); }
  std::size_t size() const { return mechanisms_.size(); }
  /// Adds a mechanism with all radii, see `resolved`, by its threads.
  void add(const contact::MechanismGeometry& threads, const std::optional<Materials>& materials);
  /// Finds the contacts of all mechanisms that were added.
  void find();
  /// Sets threads and contacts of the mechanism added as number k. Returns false if one of its contacts or threads is
  /// impossible: `find_contacts` gives the reason.
  bool get(std::size_t k, const Mechanism& mechanism, const contact::MechanismGeometry& threads, ContactDetail detail,
           Contacts& contacts) const;

  /// Sets only Hertz's constants, statuses and normals, from which a law is made.
  bool get_laws(std::size_t k, Contacts& contacts) const;

  /// Laws of the contacts of `get_laws`, as `contact_law` gives them without overrides.
  PerInterface<ContactLawNumbers> laws(std::size_t k) const;

 private:
  simd::InstructionSet set_;
  std::vector<contact::MechanismNumbers<double>> mechanisms_;
  std::vector<contact::MechanismContactNumbers<double>> found_;
};

}  // namespace prs
