#include "prs/measures/yang_distribution.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>

#include "prs/sector/section_properties.h"

namespace prs {
namespace {

constexpr double kLargestResidual = 1e-9;

/// Integral of dx/(E A) of the nut between two sections.
double nut_compliance(const Structure::Nut& nut, double bore, double modulus, double from,
                      double to) {
  if (!(to > from)) return 0.0;
  double length = to - from, compliance = 0.0;
  for (const Structure::Flange& f : nut.flanges) {
    const double within = std::min(f.to, to) - std::max(f.from, from);
    if (within <= 0.0) continue;
    length -= within;
    compliance += within / ring_area(f.outer_diameter, bore);
  }
  return (compliance + std::max(length, 0.0) / ring_area(nut.outer_diameter, bore)) / modulus;
}

/// Loads of the threads by the approach of the last one; where their sum exceeds F on the way,
/// those so far, which is enough for a bracket. Returns the sum.
double find_loads(double last_approach, double force, double coefficient,
                  std::span<const ThreadGap> gaps, std::span<double> loads) {
  const auto load = [&](double approach) {
    if (!(approach > 0.0)) return 0.0;
    const double ratio = approach / coefficient;
    return ratio * std::sqrt(ratio);  // A power of 1.5 takes many times as long.
  };
  double approach = last_approach;
  double sum = loads.back() = load(approach);
  for (std::size_t k = gaps.size(); k-- > 0 && sum <= force;) {
    const ThreadGap& g = gaps[k];
    approach += sum * (g.screw + g.nut_behind_thrust) - (force - sum) * g.nut_before_thrust;
    sum += loads[k] = load(approach);
  }
  return sum;
}

}  // namespace

std::vector<ThreadGap> thread_gaps(const Mechanism& m, const Structure& s,
                                   const Materials& materials, double thrust, double position) {
  const double pitch = axial_pitch(m), bore = *m.pitch_diameter.nut;
  const double screw =
      m.rollers * pitch /
      (materials.screw.youngs_modulus * ring_area(*m.pitch_diameter.screw, s.screw.bore));
  const auto nut = [&](double from, double to) {
    return m.rollers * nut_compliance(s.nut, bore, materials.nut.youngs_modulus, from, to);
  };
  std::vector<ThreadGap> gaps;
  for (int k = 0; k + 1 < m.contacts_per_roller; ++k) {
    const double from = position + k * pitch, to = position + (k + 1) * pitch;
    const double held = std::clamp(thrust, from, to);
    gaps.push_back({screw, nut(from, held), nut(held, to)});
  }
  return gaps;
}

std::vector<double> yang_distribution(double force, double coefficient,
                                      std::span<const ThreadGap> gaps) {
  std::vector<double> loads(gaps.size() + 1);
  const auto excess = [&](double w) {
    return find_loads(w, force, coefficient, gaps, loads) / force - 1.0;
  };
  // Without approach of the last thread none carries; with twice that of F it carries more than F.
  const double greatest = 2.0 * coefficient * std::pow(force, 2.0 / 3.0);
  std::uintmax_t evaluations = 400;
  const auto root =
      boost::math::tools::toms748_solve(excess, 0.0, greatest, -1.0, excess(greatest),
                                        boost::math::tools::eps_tolerance<double>(52), evaluations);
  if (!(std::abs(excess(root.first)) < kLargestResidual)) return {};
  return loads;
}

}  // namespace prs
