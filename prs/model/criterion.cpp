#include "prs/model/criterion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace prs {

std::string_view name(Sense sense) { return sense == Sense::least ? "least" : "greatest"; }

std::string_view name(LimitSource source) {
  constexpr std::string_view kNames[] = {"case", "physics", "recommended"};
  return kNames[static_cast<std::size_t>(source)];
}

std::string_view name(Standing standing) {
  constexpr std::string_view kNames[] = {"green", "amber", "red", "no_limit", "not_computed", "not_applicable"};
  return kNames[static_cast<std::size_t>(standing)];
}

bool CriterionRow::is_worse(double a, double b) const { return sense == Sense::least ? a < b : a > b; }

bool FoundCriterion::is_worse(double v, std::optional<double> bound) const {
  if (bound == physical) return row->is_worse(v, *value);
  const auto share = [](double of, std::optional<double> to) { return to ? of / *to : 1.0; };
  return row->is_worse(share(v, bound), share(*value, physical));
}

void FoundCriterion::take(std::optional<double> v, std::string_view load_case, std::string_view what,
                          std::optional<double> bound) {
  if (!v || std::isnan(*v)) return;
  if (!best || row->is_worse(*best, *v)) best = v;
  if (value && !is_worse(*v, bound)) return;
  value = v;
  where = load_case;
  note = what;
  physical = bound;
}

void FoundCriterion::add(const FoundCriterion& other) {
  const FoundCriterion before = *this;
  const auto& v = other.value;
  if (!value || (v && (is_worse(*v, other.physical) || (row->last_of_equal && *v == *value)))) *this = other;
  best = before.best && (!other.best || row->is_worse(*other.best, *before.best)) ? before.best : other.best;
  if (!before.why.empty()) why = before.why;
  applies = applies || before.applies;
  is_partial = is_partial || before.is_partial;
  if (!standing || !before.standing) return;
  standing = std::max(*standing, *before.standing);
  note = before.note + (before.note.empty() || other.note.empty() ? "" : ", ") + other.note;
}

FoundCriterion convergence(const std::string& failed) {
  FoundCriterion found("convergence");
  found.note = failed;
  found.standing = failed.empty() ? Standing::green : Standing::red;
  return found;
}

std::string lacking_pressure_limits(const std::optional<Materials>& materials) {
  std::vector<std::string> parts;
  if (materials)
    for (const Part part : kParts)
      if (!static_pressure_limit((*materials)[part], (*materials)[part]))
        parts.push_back(fmt::format("materials.{}.static_pressure_limit", name(part)));
  return parts.size() == std::size(kParts) ? "materials.static_pressure_limit"
                                           : fmt::format("{}", fmt::join(parts, ", "));
}

std::optional<double> loaded_length(const Case& c) {
  if (!c.structure || !c.life) return std::nullopt;
  const Mechanism& m = c.mechanism;
  return carrier_part(m.type) == Part::nut ? c.structure->nut.length
                                           : m.contacts_per_roller * std::abs(m.lead) / m.starts.screw;
}

FoundCriterion stroke_criterion(const Case& c, std::string_view reason) {
  FoundCriterion stroke("stroke", reason);
  if (carrier_part(c.mechanism.type) == Part::screw) stroke.title = "Stroke over rollers' threads";
  return stroke;
}

}  // namespace prs
