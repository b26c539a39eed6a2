#include <fmt/format.h>

#include <iterator>

#include "prs/loads/thread_parts.h"
#include "prs/losses/slip_parts.h"
#include "prs/losses/slip_record.h"
#include "prs/model/case.h"
#include "prs/model/units.h"

namespace prs {
namespace {

template <std::vector<double> InterfaceSlip::*values>
const std::vector<double>& slip_of(const LoadCaseResult& result, Interface i) {
  return result.slip->threads[i].*values;
}

bool has_thread_slip(const LoadCaseResult& result) {
  return has_slip(result) && has_shares(result);
}

std::optional<double> with_equal_shares(const LoadCaseResult& result, Interface i) {
  const std::optional<EqualShareSlip>& equal = result.slip->equal_shares;
  return equal ? std::optional(equal->thread_power[i]) : std::nullopt;
}

bool has_power_of_rollers(const LoadCaseResult& result) {
  return has_rollers(result) && has_slip(result);
}

bool has_slip_of_threads(const LoadCaseResult& result) {
  return result.threads && has_slip(result);
}

}  // namespace

Figures thread_power(const Result& result, const FigureOptions& options) {
  FigureOptions one = options;
  if (options.load_case) one.load_cases = {*options.load_case};
  return from_zero(
      thread_figure({"thread_power", "Power lost at each thread of a roller", "Power", "W",
                     slip_of<&InterfaceSlip::power>, 1.0, has_thread_slip, with_equal_shares},
                    result, one));
}

/// Friction coefficient and sliding speed of each thread, a panel each.
Figures friction(const Result& result, const FigureOptions& options) {
  const LoadCaseResult* shown = chosen_case(result, options, has_thread_slip);
  if (!shown) return {};
  Figure figure{"friction",
                "Friction and sliding of each thread, " + shown_name(shown->load_case.name)};
  figure.columns = 2;
  struct Shown {
    const char* title;
    const char* unit;
    std::vector<double> InterfaceSlip::*values;
    double factor;
  };
  constexpr Shown kShown[] = {
      {"Friction coefficient", "", &InterfaceSlip::friction_coefficient, 1.0},
      {"Sliding speed", "mm/s", &InterfaceSlip::sliding_speed, per_si::millimetre}};
  for (std::size_t k = 0; k < std::size(kInterfaces); ++k)
    figure.add(interface_title(kInterfaces[k]), marked_line(k));
  for (const Shown& s : kShown) {
    Panel& panel = figure.panels.emplace_back();
    panel.title = s.title;
    for (std::size_t k = 0; k < std::size(kInterfaces); ++k)
      panel.series.push_back(
          {k, {over_threads(shown->slip->threads[kInterfaces[k]].*s.values, s.factor)}});
    panel.y = fitted({s.title, s.unit}, range_of_y(panel.series), true);
  }
  figure.x = thread_axis(shown->threads->screw.axial_load.size());
  return {std::move(figure)};
}

/// Power lost at every thread of every roller, at both interfaces.
Figures roller_power(const Result& result, const FigureOptions& options) {
  const LoadCaseResult* shown = chosen_case(result, options, has_power_of_rollers);
  if (!shown) return {};
  constexpr OfThreads kPowers{
      has_power_of_rollers, [](const LoadCaseResult& r, Interface i) -> const std::vector<double>& {
        return r.slip->threads[i].power;
      }};
  return {map_of_rollers({"roller_power", fmt::format("Power lost at all rollers, {}",
                                                      shown_name(shown->load_case.name))},
                         result, *shown, {"Power lost", "W"}, kPowers)};
}

/// Friction coefficient at every thread of every roller, at both interfaces.
Figures roller_friction(const Result& result, const FigureOptions& options) {
  const LoadCaseResult* shown = chosen_case(result, options, has_power_of_rollers);
  if (!shown) return {};
  constexpr OfThreads kCoefficients{
      has_power_of_rollers, [](const LoadCaseResult& r, Interface i) -> const std::vector<double>& {
        return r.slip->threads[i].friction_coefficient;
      }};
  return {map_of_rollers({"roller_friction", fmt::format("Friction at all rollers, {}",
                                                         shown_name(shown->load_case.name))},
                         result, *shown, {"Friction coefficient"}, kCoefficients)};
}

/// Friction coefficient and sliding velocity at both contacts of a thread.
Figures thread_friction(const Case& c, const Result& result, const FigureOptions& options) {
  const auto chosen = chosen_thread(result, options, has_slip_of_threads);
  if (!chosen) return {};
  const auto place = static_cast<std::size_t>(chosen->load_case - result.load_cases.data());
  const auto patches = thread_patches(c, result, place, chosen->thread);
  if (!patches) return {};
  return {thread_friction_figure(*chosen->load_case, *patches, chosen->thread)};
}

}  // namespace prs
