#include "validation/reference_fe/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "prs/loads/analyze.h"
#include "prs/model/case_error.h"

namespace prs::reference_fe {
namespace {

double position_of(const Case& screw, const Setup& setup) {
  const std::string name = fmt::format("config{}-{}", setup.config, prs::name(setup.direction));
  const auto found = std::ranges::find(screw.load_cases, name, &LoadCase::name);
  if (found == screw.load_cases.end() || !found->position)
    throw CaseError("load_cases", fmt::format("expected a case {} with a position", name));
  return *found->position;
}

/// Loads of a curve as load cases.
void add_load_cases(Case& c, const Curve& curve, const Case& screw) {
  for (const CurvePoint& point : curve.points) {
    LoadCase load_case;
    load_case.name = name(curve.setup);
    load_case.axial_force = point.load;
    load_case.direction = curve.setup.direction;
    load_case.position = position_of(screw, curve.setup);
    c.load_cases.push_back(load_case);
  }
}

void require_threads(const Case& screw, const std::vector<Curve>& reference) {
  const std::size_t threads = reference.front().points.front().load_rate.screw.size();
  if (threads != static_cast<std::size_t>(screw.mechanism.contacts_per_roller))
    throw CaseError("mechanism.contacts_per_roller",
                    fmt::format("expected {}, as many threads as the reference has", threads));
}

/// Indices of curves with the same roller, which one run can solve.
std::vector<std::vector<std::size_t>> grouped(const std::vector<Curve>& curves) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const auto group = std::ranges::find_if(groups, [&](const auto& indices) {
      const Setup& first = curves[indices.front()].setup;
      return first.guidance == curves[k].setup.guidance &&
             first.contacts == curves[k].setup.contacts;
    });
    (group == groups.end() ? groups.emplace_back() : *group).push_back(k);
  }
  return groups;
}

CurvePoint point_of(const LoadCaseResult& result) {
  CurvePoint point{result.load_case.axial_force, 0.0, {}};
  if (!result.threads || !result.axial_displacement) return point;
  point.displacement = *result.axial_displacement;
  for (const Interface i : kInterfaces) point.load_rate[i] = (*result.threads)[i].load_rate;
  return point;
}

LoadDiscrepancy load_discrepancy(const std::vector<double>& rates,
                                 const std::vector<double>& reference) {
  LoadDiscrepancy d{0.0, 0.0, 0.0, -HUGE_VAL, HUGE_VAL};
  const double share = 1.0 / static_cast<double>(rates.size());
  for (std::size_t k = 0; k < rates.size(); ++k) {
    const double difference = rates[k] - reference[k];
    d.mean += share * std::abs(difference);
    d.largest = std::max(d.largest, std::abs(difference));
    const double relative = difference / reference[k];
    d.relative_mean += share * relative;
    d.relative_highest = std::max(d.relative_highest, relative);
    d.relative_lowest = std::min(d.relative_lowest, relative);
  }
  return d;
}

/// Gathers the discrepancies of points.
class Gathering {
 public:
  void add(const Curve& curve, const CurvePoint& point, const std::optional<Discrepancy>& d) {
    ++s_.points;
    if (!d) {
      ++s_.unsolved;
      return;
    }
    const bool first = s_.points - s_.unsolved == 1;
    const auto keep = [&](Extreme& extreme, double value, bool better) {
      if (first || better) extreme = {value, curve.setup, point.load};
    };
    keep(s_.least_stiff, d->stiffness, d->stiffness < s_.least_stiff.value);
    keep(s_.stiffest, d->stiffness, d->stiffness > s_.stiffest.value);
    const double largest = std::max(d->loads.screw.largest, d->loads.nut.largest);
    keep(s_.best_loads, largest, largest < s_.best_loads.value);
    keep(s_.worst_loads, largest, largest > s_.worst_loads.value);
    s_.mean_stiffness += d->stiffness;
    for (const Interface i : kInterfaces) {
      s_.mean_load[i] += d->loads[i].mean;
      s_.largest_load[i] = std::max(s_.largest_load[i], d->loads[i].largest);
    }
  }

  Summary result() const {
    Summary s = s_;
    const double solved = std::max(1, s.points - s.unsolved);
    s.mean_stiffness /= solved;
    for (const Interface i : kInterfaces) s.mean_load[i] /= solved;
    return s;
  }

 private:
  Summary s_;
};

}  // namespace

std::vector<Curve> computed_curves(const Case& screw, ModelOptions::Bodies bodies,
                                   const std::vector<Curve>& reference) {
  require_threads(screw, reference);
  std::vector<Curve> all(reference.size());
  for (const std::vector<std::size_t>& indices : grouped(reference)) {
    Case c = screw;
    c.model.bodies = bodies;
    c.model.roller_contacts = reference[indices.front()].setup.contacts;
    c.structure->roller.guidance.kind = reference[indices.front()].setup.guidance;
    c.load_cases.clear();
    for (const std::size_t k : indices) add_load_cases(c, reference[k], screw);
    const std::vector<LoadCaseResult> results = analyze(c).load_cases;
    auto result = results.begin();
    for (const std::size_t k : indices) {
      all[k].setup = reference[k].setup;
      for (std::size_t n = 0; n < reference[k].points.size(); ++n)
        all[k].points.push_back(point_of(*result++));
    }
  }
  return all;
}

std::optional<Discrepancy> discrepancy(const CurvePoint& point, const CurvePoint& reference) {
  if (!point.is_solved() || !reference.is_solved()) return std::nullopt;
  return Discrepancy{point.stiffness() / reference.stiffness() - 1.0,
                     {load_discrepancy(point.load_rate.screw, reference.load_rate.screw),
                      load_discrepancy(point.load_rate.nut, reference.load_rate.nut)}};
}

const Extreme& Summary::farthest_stiffness() const {
  return std::abs(least_stiff.value) > std::abs(stiffest.value) ? least_stiff : stiffest;
}

Summary summary(const std::vector<Curve>& curves, const std::vector<Curve>& reference,
                const Selection& selection) {
  Gathering gathering;
  for (std::size_t k = 0; k < curves.size(); ++k)
    for (std::size_t load = 0; load < curves[k].points.size(); ++load) {
      const CurvePoint& point = curves[k].points[load];
      if (selection(curves[k].setup, point.load))
        gathering.add(curves[k], point, discrepancy(point, reference[k].points[load]));
    }
  return gathering.result();
}

}  // namespace prs::reference_fe
