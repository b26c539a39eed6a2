#include "prs/mechanism/travel.h"

#include <Eigen/QR>
#include <algorithm>
#include <complex>
#include <functional>
#include <unsupported/Eigen/FFT>

#include "prs/indices.h"

namespace prs {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Tolerance within which a value is on a limit.
constexpr double kOnLimit = 1e-9;

/// Number of positions that are solved one after the other.
constexpr int kChunk = 64;

/// Difference of loads, relative, that is only rounding.
constexpr double kSameNormalLoad = 1e-9;

/// Largest range of `values` over this many of them in a row.
double widest(const std::vector<double>& values, std::size_t count) {
  double width = 0.0;
  std::vector<std::size_t> low, high;  // Candidates for the extremes, the current ones at `from`.
  std::size_t low_from = 0, high_from = 0;
  for (const auto k : indices(values)) {
    const auto push = [&](std::vector<std::size_t>& queue, std::size_t& from, auto beats) {
      while (queue.size() > from && !beats(values[queue.back()], values[k])) queue.pop_back();
      queue.push_back(k);
      if (queue[from] + count <= k) ++from;
    };
    push(low, low_from, std::less<>());
    push(high, high_from, std::greater<>());
    if (k + 1 >= count) width = std::max(width, values[high[high_from]] - values[low[low_from]]);
  }
  return width;
}

Lateral turned_by(double y, double z, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * y - s * z, s * y + c * z};
}

double farthest_from_mean(const std::vector<Lateral>& points) {
  Lateral mean;
  for (const Lateral& p : points) {
    mean.y += p.y / static_cast<double>(points.size());
    mean.z += p.z / static_cast<double>(points.size());
  }
  double farthest = 0.0;
  for (const Lateral& p : points) farthest = std::max(farthest, std::hypot(p.y - mean.y, p.z - mean.z));
  return farthest;
}

void add_support(TravelSupport& s, const SupportForce& f, double angle) {
  const Lateral across = turned_by(f.force[1], f.force[2], angle);
  s.position = f.position;
  s.force.emplace_back(f.force[0], across.y, across.z);
  s.moment.push_back(turned_by(f.moment.y, f.moment.z, angle));
}

/// Collects normal loads position by position.
class Collected {
 public:
  explicit Collected(const FullModel& f) : f_(f) {
    loads.mean = RollerThreads(static_cast<std::size_t>(f.rollers),
                               std::vector<double>(static_cast<std::size_t>(f.threads()), 0.0));
    loads.ripple = most_ = loads.mean;
    least_ = RollerThreads(loads.mean.size(),
                           std::vector<double>(loads.mean[0].size(), std::numeric_limits<double>::infinity()));
  }

  TravelLoads loads;

  void add(const RollerThreads& normal_load, double angle, double share) {
    if (1.0 / share < kMostShown) all_.push_back(normal_load);
    for (const FullModel::Roller& r : f_.present) {
      const auto j = static_cast<std::size_t>(r.number);
      for (const auto k : indices(normal_load[j])) {
        const double load = normal_load[j][k];
        loads.mean[j][k] += share * load;
        least_[j][k] = std::min(least_[j][k], load);
        most_[j][k] = std::max(most_[j][k], load);
        if (load <= loads.largest * (1.0 + kSameNormalLoad)) continue;
        loads.largest = load;
        loads.angle = angle;
        loads.roller = r.number + 1;
        loads.thread = static_cast<int>(k) + 1;
      }
    }
  }
  TravelLoads finished() && {
    loads.least = std::numeric_limits<double>::infinity();
    for (const FullModel::Roller& r : f_.present) {
      const auto j = static_cast<std::size_t>(r.number);
      for (const auto k : indices(loads.mean[j])) {
        loads.ripple[j][k] = most_[j][k] - least_[j][k];
        loads.least = std::min(loads.least, least_[j][k]);
      }
    }
    for (const RollerThreads& at : all_) loads.of_roller.push_back(item_at(at, loads.roller - 1));
    return std::move(loads);
  }

 private:
  static constexpr double kMostShown = 5000.0;  ///< Largest number of positions whose loads are all kept.

  const FullModel& f_;
  RollerThreads least_, most_;
  std::vector<RollerThreads> all_;
};

}  // namespace

TravelBands travel_bands(const std::vector<double>& d, double sense, int one_turn, int in_300_mm) {
  const double last = static_cast<double>(d.size()) - 1.0;
  double mean = 0.0, slope = 0.0, square = 0.0;
  for (const double value : d) mean += value / (last + 1.0);
  for (const auto k : indices(d)) {
    const double from_middle = static_cast<double>(k) - 0.5 * last;
    slope += from_middle * (d[k] - mean);
    square += from_middle * from_middle;
  }
  slope /= square;
  TravelBands bands;
  bands.mean = sense * slope * last;
  std::vector<double> left;
  for (const auto k : indices(d)) {
    bands.line.push_back(mean + slope * (static_cast<double>(k) - 0.5 * last));
    left.push_back(d[k] - bands.line.back());
  }
  const auto [least, most] = std::ranges::minmax(left);
  bands.variation = most - least;
  bands.variation_one_turn = widest(left, static_cast<std::size_t>(one_turn) + 1);
  if (in_300_mm > 0) bands.variation_300_mm = widest(left, static_cast<std::size_t>(in_300_mm) + 1);
  return bands;
}

std::vector<OrderAmplitude> travel_spectrum(const std::vector<double>& d, int turns) {
  const std::size_t count = d.size() - 1;
  std::vector<double> x(count);
  for (const auto k : up_to(count))
    x[k] = d[k] - d.front() - (d.back() - d.front()) * static_cast<double>(k) / static_cast<double>(count);
  std::vector<std::complex<double>> transformed;
  Eigen::FFT<double>().fwd(transformed, x);
  std::vector<OrderAmplitude> spectrum;
  for (std::size_t k = 1; k <= count / 2; ++k) {
    const double amplitude = 2.0 * std::abs(transformed[k]) / static_cast<double>(count);
    spectrum.push_back({{}, static_cast<double>(k) / std::abs(turns), 2 * k == count ? 0.5 * amplitude : amplitude});
  }
  return spectrum;
}

std::vector<OrderAmplitude> fitted_orders(const std::vector<double>& d, const Travel& t,
                                          const std::vector<MotionOrder>& orders) {
  const double resolution = 1.0 / std::abs(t.turns);
  std::vector<OrderAmplitude> kept;
  for (const MotionOrder& o : orders) {
    const bool apart = std::ranges::all_of(
        kept, [&](const OrderAmplitude& k) { return std::abs(o.order - k.order) >= resolution - kOnLimit; });
    if (apart && o.order >= resolution - kOnLimit && o.order <= 0.5 * t.steps - resolution + kOnLimit)
      kept.push_back({std::string(o.name), o.order, 0.0});
  }
  const auto rows = static_cast<Eigen::Index>(d.size());
  Eigen::MatrixXd a(rows, 2 + 2 * static_cast<Eigen::Index>(kept.size()));
  a.col(0).setOnes();
  a.col(1).setLinSpaced(rows, -1.0, 1.0);
  for (const auto i : indices(kept))
    for (Eigen::Index k = 0; k < rows; ++k) {
      const double phase = kept[i].order * kTurn * static_cast<double>(k) / t.steps;
      a(k, 2 + 2 * static_cast<Eigen::Index>(i)) = std::cos(phase);
      a(k, 3 + 2 * static_cast<Eigen::Index>(i)) = std::sin(phase);
    }
  const Eigen::VectorXd fit = a.colPivHouseholderQr().solve(Eigen::Map<const Eigen::VectorXd>(d.data(), rows));
  for (const auto i : indices(kept)) {
    const auto at = 2 + 2 * static_cast<Eigen::Index>(i);
    kept[i].amplitude = std::hypot(fit[at], fit[at + 1]);
  }
  return kept;
}

TravelResult travel(const TravelModel& model, const Mechanism& m, const Travel& wanted) {
  TravelResult r;
  r.travel = wanted;
  r.slip_ratio = slip_ratio(m, wanted);
  r.lead = m.lead;
  const int count = wanted.last() + 1;
  const FullModel first = model.model(wanted.from);
  PerInterface<Collected> collected{Collected(first), Collected(first)};
  std::vector<Lateral> side_force;
  std::function<FullDistribution(const FullModel&)> solver;
  for (int k = 0; k < count; ++k) {
    if (k % kChunk == 0) solver = model.solver();
    const double theta = wanted.angle(k), turned = model.carrier ? model.carrier(theta) : 0.0;
    FullModel f = model.model(theta);
    if (model.carrier) {
      turn_axes(f, turned);
      for (const auto j : indices(f.present))  // Rounding would change the zeros.
        f.present[j].azimuth = first.present[j].azimuth;
    }
    const FullDistribution d = solver(f);
    if (!d.solve.converged()) {
      r.failure = {theta, d.reason.empty() ? std::string(fe::name(d.solve.status)) : d.reason, d.solve.status};
      return r;
    }
    const auto& q = d.screw_end.displacement;
    double displacement = q[0];
    for (const Interface i : kInterfaces) displacement += f.sense() * f.smallest_gap[i] / f.sector.cosine[i];
    r.angle.push_back(theta);
    r.displacement.push_back(displacement);
    r.mean_displacement += displacement / count;
    r.end_displacement.push_back(turned_by(q[1], q[2], turned));
    r.end_rotation.push_back(turned_by(q[3], q[4], turned));
    add_support(r.nut, d.nut, turned);
    side_force.push_back({r.nut.force.back()[1], r.nut.force.back()[2]});
    r.bearings.resize(d.bearings.size());
    for (const auto b : indices(r.bearings)) add_support(r.bearings[b], d.bearings[b], turned);
    if (d.tangent_stiffness)
      r.tangent_stiffness.push_back(*d.tangent_stiffness);
    else if (!r.left_out_at)
      r.left_out_at = theta;
    for (const Interface i : kInterfaces) collected[i].add(d.normal_load[i], theta, 1.0 / count);
  }
  if (r.left_out_at) r.tangent_stiffness.clear();
  r.side_force_ripple = farthest_from_mean(side_force);
  r.tilt_ripple = farthest_from_mean(r.end_rotation);
  const double in_300_mm = std::floor(0.3 * wanted.steps / std::abs(m.lead) + kOnLimit);
  r.bands = travel_bands(r.displacement, (wanted.turns < 0) == (m.lead < 0.0) ? 1.0 : -1.0, wanted.steps,
                         in_300_mm <= wanted.last() ? static_cast<int>(in_300_mm) : 0);
  r.spectrum = travel_spectrum(r.displacement, wanted.turns);
  r.orders = fitted_orders(r.displacement, wanted, motion_orders(m, r.slip_ratio));
  for (const Interface i : kInterfaces) r.loads[i] = std::move(collected[i]).finished();
  return r;
}

}  // namespace prs
