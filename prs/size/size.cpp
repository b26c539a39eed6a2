#include "prs/size/size.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "prs/input/fail_at.h"
#include "prs/model/case_error.h"
#include "prs/size/evaluation.h"
#include "prs/size/sized_screw.h"

namespace prs {
namespace {

constexpr double kAlike = 1e-9;
constexpr std::size_t kChunk = 8;  ///< Candidates that a thread takes at once.

/// What the objective has of a candidate: less is better; absent last.
double rated(const SizedCandidate& c, Requirement::Objective objective) {
  constexpr double kLast = std::numeric_limits<double>::infinity();
  switch (objective) {
    case Requirement::Objective::weight:
      return c.weight.value_or(kLast);
    case Requirement::Objective::nut_diameter:
      return c.nut_diameter;
    case Requirement::Objective::life:
      return c.life.revolutions ? -*c.life.travel : kLast;
    case Requirement::Objective::motor_torque:
      return c.motor_rms_torque.value_or(kLast);
    case Requirement::Objective::power_lost:
      break;
  }
  return c.power_lost.value_or(kLast);
}

/// -1 where a is less, 1 where it is more, by more than rounding.
int compared(double a, double b) {
  if (a == b || std::abs(a - b) <= kAlike * std::max(std::abs(a), std::abs(b))) return 0;
  return a < b ? -1 : 1;
}

bool comes_before(const SizedCandidate& a, const SizedCandidate& b,
                  Requirement::Objective objective) {
  if (a.passes != b.passes) return a.passes;
  if (!a.passes) {
    if (a.missed() != b.missed()) return a.missed() < b.missed();
    if (const int order = compared(b.least_missed_margin(), a.least_missed_margin()))
      return order < 0;
  }
  const std::array<double, 4> of_a{rated(a, objective), a.nut_diameter, a.screw_diameter, a.lead};
  const std::array<double, 4> of_b{rated(b, objective), b.nut_diameter, b.screw_diameter, b.lead};
  for (std::size_t k = 0; k < of_a.size(); ++k)
    if (const int order = compared(of_a[k], of_b[k])) return order < 0;
  return a.order < b.order;
}

/// Marks those that no other beats: `all` stand by rank.
void mark_pareto(std::vector<SizedCandidate>& all) {
  using enum Requirement::Objective;
  const auto measures = [](const SizedCandidate& c) {
    return std::array{rated(c, weight), rated(c, nut_diameter), rated(c, life),
                      rated(c, motor_torque), rated(c, power_lost)};
  };
  std::vector<std::pair<std::array<double, 5>, SizedCandidate*>> passing;
  for (SizedCandidate& c : all)
    if (c.passes) passing.push_back({measures(c), &c});
  const auto beats = [](const std::array<double, 5>& a, const std::array<double, 5>& b) {
    bool better = false;
    for (std::size_t k = 0; k < a.size(); ++k) {
      if (a[k] > b[k]) return false;
      better = better || a[k] < b[k];
    }
    return better;
  };
  // What is beaten is beaten by a member of the front that stands before it in this order.
  std::ranges::stable_sort(passing, {}, [](const auto& p) { return p.first; });
  std::vector<const std::array<double, 5>*> front;
  for (const auto& own : passing) {
    own.second->pareto =
        std::ranges::none_of(front, [&](const auto* other) { return beats(*other, own.first); });
    if (own.second->pareto) front.push_back(&own.first);
  }
}

std::optional<Relaxation> relaxation(const std::vector<SizedCandidate>& all) {
  for (const SizedCandidate& c : all)
    if (c.missed() == 1)
      for (const SizeCriterion& missed : c.criteria)
        if (!missed.holds() && missed.margin)
          return Relaxation{missed.name, c.rank, *missed.limit, *missed.value, *missed.margin};
  return std::nullopt;
}

}  // namespace

std::string_view name(CriterionStatus status) {
  constexpr std::string_view kNames[] = {"pass", "fail", "not_computed", "not_applicable"};
  return kNames[static_cast<std::size_t>(status)];
}

std::size_t SizedCandidate::missed() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(criteria, [](const SizeCriterion& c) { return !c.holds(); }));
}

double SizedCandidate::least_missed_margin() const {
  double least = std::numeric_limits<double>::infinity();
  for (const SizeCriterion& c : criteria)
    if (!c.holds()) least = std::min(least, c.margin.value_or(0.0));
  return least;
}

std::size_t SizeResult::passing() const {
  return static_cast<std::size_t>(std::ranges::count(candidates, true, &SizedCandidate::passes));
}

SizeResult size_screws(const SizeInput& in, const SizeOptions& options) {
  SizeResult result;
  result.input = in;
  result.warnings = in.warnings;
  result.data = candidates_of(in, result.warnings);
  const std::vector<CandidateData>& data = result.data;
  options.for_each(
      (data.size() + kChunk - 1) / kChunk, [&](std::size_t chunk) -> std::function<void()> {
        const std::size_t first = chunk * kChunk, last = std::min(first + kChunk, data.size());
        std::vector<SizedCandidate> done;
        std::vector<InvalidCandidate> invalid;
        for (std::size_t k = first; k < last; ++k) try {
            done.push_back(evaluated(result.input, data[k]));
            done.back().order = k;
          } catch (const CaseError& error) {
            invalid.push_back(
                {data[k].name, data[k].is_row, data[k].number, error.problem().text()});
          }
        return [&, last, done = std::move(done), invalid = std::move(invalid)]() mutable {
          std::ranges::move(done, std::back_inserter(result.candidates));
          std::ranges::move(invalid, std::back_inserter(result.invalid));
          if (options.progress) options.progress(last, data.size());
        };
      });
  if (result.candidates.empty())
    input::fail_at(
        in.source, "candidates",
        fmt::format("got no screw that can be made, of {}; the first, {}: {}; change "
                    "diameters, leads or starts",
                    data.size(), result.invalid.front().name, result.invalid.front().reason));
  std::ranges::sort(result.candidates, [&](const SizedCandidate& a, const SizedCandidate& b) {
    return comes_before(a, b, in.values.objective);
  });
  int rank = 0;
  for (SizedCandidate& c : result.candidates) c.rank = ++rank;
  mark_pareto(result.candidates);
  if (result.passing() == 0) result.relax = relaxation(result.candidates);
  if (options.curve_of >= 1 && options.curve_of <= result.candidates.size()) {
    const SizedCandidate& chosen = result.candidates[options.curve_of - 1];
    result.curve = force_over_speed(result.input, data[chosen.order], chosen);
  }
  return result;
}

std::string written_candidate(const SizeResult& result, std::size_t rank) {
  const SizedCandidate& c = result.candidates[rank - 1];
  const CandidateData& data = result.data[c.order];
  return sized_case_text(result.input, data, sized_case(result.input, data), *c.conductance,
                         c.life_basis == Requirement::Basis::maker);
}

}  // namespace prs
