#include "prs/size/size.h"

#include "prs/input/document.h"
#include "prs/study/schedule.h"

namespace prs {
namespace {

constexpr double kAlike = 1e-9;
constexpr std::size_t kChunk = 8;  ///< Candidates that a thread takes at once.

/// What each objective has of a candidate: less is better; absent last.
std::array<double, 5> objectives_of(const SizedCandidate& c) {
  constexpr double kLast = std::numeric_limits<double>::infinity();
  return {c.weight.value_or(kLast), c.nut_diameter, -c.life.travel.value_or(-kLast),
          c.motor_rms_torque.value_or(kLast), c.power_lost.value_or(kLast)};
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
    const std::size_t by_a = a.missed().size(), by_b = b.missed().size();
    if (by_a != by_b) return by_a < by_b;
    if (const int order = compared(b.least_missed_margin(), a.least_missed_margin()))
      return order < 0;
  }
  const auto measures = [objective](const SizedCandidate& c) {
    return std::array{objectives_of(c)[static_cast<std::size_t>(objective)], c.nut_diameter,
                      c.screw.screw_diameter, c.screw.lead};
  };
  const auto of_a = measures(a), of_b = measures(b);
  for (std::size_t k = 0; k < of_a.size(); ++k)
    if (const int order = compared(of_a[k], of_b[k])) return order < 0;
  return a.order < b.order;
}

/// Marks those that no other beats: `all` stand by rank.
void mark_pareto(std::vector<SizedCandidate>& all) {
  std::vector<std::pair<std::array<double, 5>, SizedCandidate*>> passing;
  for (SizedCandidate& c : all)
    if (c.passes) passing.push_back({objectives_of(c), &c});
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
    if (c.missed().size() == 1)
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

std::vector<std::string> SizedCandidate::missed() const {
  std::vector<std::string> names;
  for (const SizeCriterion& c : criteria)
    if (!c.holds()) names.emplace_back(c.name);
  return names;
}

double SizedCandidate::least_missed_margin() const {
  double least = std::numeric_limits<double>::infinity();
  for (const SizeCriterion& c : criteria)
    if (!c.holds()) least = std::min(least, c.margin.value_or(0.0));
  return least;
}

std::optional<double> SizedCandidate::hottest_part() const {
  if (!temperature) return std::nullopt;
  return std::max({temperature->screw, temperature->roller, temperature->nut});
}

std::size_t SizeResult::passing() const {
  return static_cast<std::size_t>(std::ranges::count(candidates, true, &SizedCandidate::passes));
}

SizeResult size_screws(const SizeInput& in, const SizeOptions& options) {
  SizeResult result;
  result.input = in;
  result.warnings = in.warnings;
  const std::vector<CandidateData> data = candidates_of(in, result.warnings);
  result.candidates.reserve(data.size());
  run_in_order((data.size() + kChunk - 1) / kChunk,
               options.threads == 0 ? default_threads() : options.threads,
               [&](std::size_t chunk) -> std::function<void()> {
                 const std::size_t first = chunk * kChunk,
                                   last = std::min(first + kChunk, data.size());
                 std::vector<SizedCandidate> done;
                 std::vector<InvalidCandidate> invalid;
                 for (std::size_t k = first; k < last; ++k) try {
                     done.push_back(evaluated(result.input, data[k]));
                     done.back().order = k;
                   } catch (const CaseError& error) {
                     invalid.push_back({data[k], error.problem().text()});
                   }
                 return [&, last, done = std::move(done), invalid = std::move(invalid)]() mutable {
                   std::ranges::move(done, std::back_inserter(result.candidates));
                   std::ranges::move(invalid, std::back_inserter(result.invalid));
                   if (options.progress) options.progress(last, data.size());
                 };
               });
  if (result.candidates.empty())
    input::fail_at(in.source, "candidates",
                   "got no screw that can be made, of {}; the first, {}: {}; change diameters, "
                   "leads or starts",
                   data.size(), result.invalid.front().name, result.invalid.front().reason);
  std::ranges::sort(result.candidates, [&](const SizedCandidate& a, const SizedCandidate& b) {
    return comes_before(a, b, in.values.objective);
  });
  int rank = 0;
  for (SizedCandidate& c : result.candidates) c.rank = ++rank;
  mark_pareto(result.candidates);
  if (result.passing() == 0) result.relax = relaxation(result.candidates);
  if (options.curve_of >= 1 && options.curve_of <= result.candidates.size())
    result.curve = force_over_speed(result.input, result.candidates[options.curve_of - 1]);
  return result;
}

}  // namespace prs
