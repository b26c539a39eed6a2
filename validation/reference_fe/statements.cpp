#include "validation/reference_fe/statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "prs/model/units.h"

namespace prs::reference_fe {
namespace {

/// From where to where a discrepancy of the bar model lies. The bands are the spread over all
/// cases, widened by the reference's error bar: they say how large the gap is and are no tolerance.
struct Band {
  double from = 0.0;
  double to = 0.0;

  bool holds(double least, double greatest) const { return least >= from && greatest <= to; }
};

constexpr Band kBarsInTension{0.25, 0.33};
constexpr Band kBarsInCompression{0.16, 0.20};
constexpr Band kBarsLoadRate{0.005, 0.016};

ErrorBar sum(const ErrorBar& a, const ErrorBar& b) {
  return {a.stiffness + b.stiffness, a.load_rate + b.load_rate};
}

/// `-1.20 % (3 tension both_end_nodes opposite, 45 kN)`, the value times a factor.
std::string shown(const Extreme& e, const char* format, int factor = 1) {
  return fmt::format(fmt::runtime(format), percent(e.value * factor)) +
         fmt::format(" ({}, {:g} kN)", name(e.setup), e.load * per_si::kilonewton);
}

int threads(const Fidelities& f) {
  return static_cast<int>(f.reference.front().points.back().load_rate.screw.size());
}

/// In % of the mean thread load, which says the same with few threads and with many.
double of_mean_load(double load_rate, int threads) { return percent(load_rate * threads); }

double full_load(const Fidelities& f) { return f.reference.front().points.back().load; }

Summary bars_at_full_load(const Fidelities& f, Direction direction) {
  return summary(f.bars, f.reference, [&](const Setup& setup, double load) {
    return setup.direction == direction && load == full_load(f);
  });
}

Finding bars_are_too_stiff(const Fidelities& f) {
  const Summary tension = bars_at_full_load(f, Direction::tension);
  const Summary compression = bars_at_full_load(f, Direction::compression);
  const auto in = [](const Band& band, const Summary& s) {
    return s.unsolved == 0 && band.holds(s.least_stiff.value, s.stiffest.value);
  };
  return {in(kBarsInTension, tension) && in(kBarsInCompression, compression),
          fmt::format("tension {:.1f} to {:.1f} %, compression {:.1f} to {:.1f} %",
                      percent(tension.least_stiff.value), percent(tension.stiffest.value),
                      percent(compression.least_stiff.value), percent(compression.stiffest.value))};
}

Finding bars_shift_the_loads(const Fidelities& f) {
  const Summary s =
      summary(f.bars, f.reference, [&](const Setup&, double load) { return load == full_load(f); });
  return {s.unsolved == 0 && kBarsLoadRate.holds(s.best_loads.value, s.worst_loads.value),
          fmt::format("{} to {}", shown(s.best_loads, "{:.1f} %", threads(f)),
                      shown(s.worst_loads, "{:.1f} %", threads(f)))};
}

/// Whether curves stay within limits of others, at all setups and loads.
Finding stays_within(const ErrorBar& limits, const std::vector<Curve>& curves,
                     const std::vector<Curve>& reference, int threads) {
  const Summary s = summary(curves, reference, [](const Setup&, double) { return true; });
  const bool holds = s.unsolved == 0 &&
                     std::abs(s.farthest_stiffness().value) <= limits.stiffness &&
                     s.worst_loads.value <= limits.load_rate;
  std::string evidence =
      fmt::format("stiffness {} to {}; a thread's load up to {}, mean {:.1f} %",
                  shown(s.least_stiff, "{:+.2f} %"), shown(s.stiffest, "{:+.2f} %"),
                  shown(s.worst_loads, "{:.1f} %", threads),
                  of_mean_load(0.5 * (s.mean_load.screw + s.mean_load.nut), threads));
  if (s.unsolved > 0)
    evidence += fmt::format("; {} of {} points without an answer", s.unsolved, s.points);
  return {holds, std::move(evidence)};
}

std::vector<Statement<Fidelities>> statements(int threads) {
  const auto limits_text = [&](const ErrorBar& limits) {
    return fmt::format(
        "{:g} % of the stiffness and, at every thread, {:g} % of the mean thread load ({} threads)",
        percent(limits.stiffness), of_mean_load(limits.load_rate, threads), threads);
  };
  const ErrorBar joint = sum(kReferenceError, kInfluenceError);
  return {
      {"bars",
       fmt::format("at full load the paper's bars are {:g} to {:g} % too stiff in tension and {:g} "
                   "to {:g} % in compression",
                   percent(kBarsInTension.from), percent(kBarsInTension.to),
                   percent(kBarsInCompression.from), percent(kBarsInCompression.to)),
       bars_are_too_stiff},
      {"bars",
       fmt::format("at full load the worst thread of a case is {:g} to {:g} % of the mean thread "
                   "load off ({} threads)",
                   of_mean_load(kBarsLoadRate.from, threads),
                   of_mean_load(kBarsLoadRate.to, threads), threads),
       bars_shift_the_loads},
      {"refined", "within " + limits_text(kRefinedError) + " of the reference, at all loads",
       [=](const Fidelities& f) {
         return stays_within(kRefinedError, f.refined, f.reference, threads);
       }},
      {"refined", "within " + limits_text(kRefinedError) + " of the influence model, at all loads",
       [=](const Fidelities& f) {
         return stays_within(kRefinedError, f.refined, f.influence, threads);
       }},
      {"influence", "within both error bars of the reference at all loads: " + limits_text(joint),
       [=](const Fidelities& f) { return stays_within(joint, f.influence, f.reference, threads); }},
  };
}

}  // namespace

std::vector<ComparedStatement> compare_statements(const Fidelities& fidelities) {
  const std::vector<Variant<Fidelities>> variants{{"all cases", fidelities}};
  return compare(statements(threads(fidelities)), variants);
}

}  // namespace prs::reference_fe
