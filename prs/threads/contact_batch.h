#pragma once

#include "contact/contact_numbers.h"
#include "prs/threads/contacts.h"

namespace prs {

/// What of the contacts is wanted.
enum class ContactDetail {
  laws,     ///< What load distribution, ellipses and slip need.
  numbers,  ///< All that `find_contacts` gives with Detail::numbers.
};

/// Contacts of many mechanisms, side by side: those of `find_contacts` with Detail::numbers to
/// 1e-13, for mechanisms that have both contacts. Memory is kept from one batch to the next.
class ContactBatch {
 public:
  explicit ContactBatch(simd::InstructionSet set = simd::InstructionSet::best) : set_(set) {}

  void clear() { mechanisms_.clear(); }
  std::size_t size() const { return mechanisms_.size(); }
  /// `threads` are those of a mechanism with all radii, see `resolved`.
  void add(const contact::MechanismGeometry& threads, const std::optional<Materials>& materials);
  /// Finds the contacts of all that were added.
  void find();
  /// Sets threads and contacts of the mechanism that was added as number k. False where one of its
  /// contacts or threads cannot be: `find_contacts` says why.
  bool get(std::size_t k, const Mechanism& mechanism, const contact::MechanismGeometry& threads, ContactDetail detail,
           Contacts& contacts) const;

  /// Sets Hertz's constants, statuses and normals alone, what a law is made of.
  bool get_laws(std::size_t k, Contacts& contacts) const;

  /// Laws of contacts that `get_laws` has, as `contact_law` gives them without overrides.
  PerInterface<ContactLawNumbers> laws(std::size_t k) const;

 private:
  simd::InstructionSet set_;
  std::vector<contact::MechanismNumbers<double>> mechanisms_;
  std::vector<contact::MechanismContactNumbers<double>> found_;
};

}  // namespace prs
