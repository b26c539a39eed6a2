#include "prs/study/bar_batch.h"

#include <algorithm>
#include <utility>

#include "prs/sector/chain/fallback_solver.h"
#include "prs/threads/contact_laws.h"
#include "prs/threads/initial_gaps.h"
#include "prs/threads/threads.h"

namespace prs {

bool BarBatch::takes(const Case& c, std::span<const std::size_t> load_cases) {
  using Teeth = ModelOptions::ToothCompliance::Kind;
  const bool plain = c.model.bodies == ModelOptions::Bodies::bars &&
                     c.model.mechanism == ModelOptions::Mechanism::sector &&
                     c.model.tooth_compliance.kind == Teeth::none && c.structure && c.materials;
  return plain && std::ranges::all_of(load_cases, [&](std::size_t k) {
           if (k >= c.load_cases.size()) return false;
           const LoadCase& load = c.load_cases[k];
           return load.share == LoadCase::Share::solved && load.direction && load.position;
         });
}

void BarBatch::clear(ContactDetail detail) {
  detail_ = detail;
  used_offsets_ = 0;
  contacts_.clear();
  designs_.clear();
  forces_.clear();
  positions_.clear();
  directions_.clear();
}

void BarBatch::add(std::size_t row, const Case& c, const Mechanism& mechanism,
                   std::span<const std::size_t> load_cases) {
  load_cases_ = load_cases.size();
  const std::size_t first = forces_.size();
  designs_.push_back(
      {row, contacts_.size(), first, mechanism, threads_of(mechanism), c.contact, {}, {}, true});
  contacts_.add(designs_.back().threads, c.materials);
  if (deviates(mechanism, c.deviations)) {
    if (offsets_.size() <= used_offsets_) offsets_.emplace_back();
    offsets_[used_offsets_] = {c.deviations, *c.materials};
    designs_.back().offsets = used_offsets_++;
  }
  if (sectors_.size() < first + load_cases_) sectors_.resize(first + load_cases_);
  for (std::size_t i = 0; i < load_cases_; ++i) {
    const LoadCase& load = c.load_cases[load_cases[i]];
    const auto is_on_same_sector = [&](std::size_t k) {
      const LoadCase& other = c.load_cases[k];
      return other.direction == load.direction && other.position == load.position;
    };
    const std::span<const std::size_t> before = load_cases.first(i);
    const auto same = std::ranges::find_if(before, is_on_same_sector);
    if (same != before.end())
      sectors_[first + i] = sectors_[first + static_cast<std::size_t>(same - before.begin())];
    else
      set_sector_model(sectors_[first + i], mechanism, *c.structure, *c.materials, c.model, {},
                       *load.direction, *load.position, {});
    forces_.push_back(load.axial_force);
    positions_.push_back(*load.position);
    directions_.push_back(*load.direction);
  }
}

/// Designs without contacts have no sectors any more.
void BarBatch::set_laws() {
  contacts_.find();
  std::size_t next = 0;
  for (Design& design : designs_) {
    design.has_contacts = contacts_.get_laws(design.contacts, found_);
    if (!design.has_contacts) continue;
    design.laws = contacts_.laws(design.contacts);
    for (const Interface i : kInterfaces)
      if (design.overrides.hertz_constant[i] || design.overrides.normal_angle[i])
        design.laws[i] = numbers_of(contact_law(design.overrides, found_.interfaces[i], i));
    for (std::size_t i = 0; i < load_cases_; ++i) {
      const std::size_t from = design.first_sector + i, to = next + i;
      if (from != to) std::swap(sectors_[from], sectors_[to]);
      forces_[to] = forces_[from];
      positions_[to] = positions_[from];
      directions_[to] = directions_[from];
      prs::set_laws(sectors_[to], design.laws);
    }
    design.first_sector = next;
    if (design.offsets) set_gaps(design);
    next += load_cases_;
  }
  forces_.resize(next);
  positions_.resize(next);
  directions_.resize(next);
}

void BarBatch::set_gaps(const Design& design) {
  const auto& [deviations, materials] = offsets_[*design.offsets];
  for (std::size_t i = 0; i < load_cases_; ++i)
    sectors_[design.first_sector + i].gaps =
        initial_gaps(design.mechanism, deviations, materials,
                     {design.laws.screw.normal_angle, design.laws.nut.normal_angle},
                     directions_[design.first_sector + i]);
}

bool BarBatch::set_results(const Design& design, const LoadDetail& detail) {
  if (!design.has_contacts) return false;
  if (detail_ == ContactDetail::laws) {
    contacts_.get_laws(design.contacts, found_);
    found_.mechanism.rollers = design.mechanism.rollers;
  } else if (!contacts_.get(design.contacts, design.mechanism, design.threads, detail_, found_)) {
    return false;
  }
  results_.resize(load_cases_);
  for (std::size_t i = 0; i < load_cases_; ++i) {
    const std::size_t k = design.first_sector + i;
    if (!FallbackSolver::complete(loads_[k], detail.tangent_stiffness)) return false;
    results_[i].load_case.axial_force = forces_[k];
    results_[i].load_case.position = positions_[k];
    set_solved_result(results_[i], found_, design.laws, loads_[k], set_, detail);
  }
  return true;
}

}  // namespace prs
