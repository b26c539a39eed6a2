#include "prs/mechanism/travel.h"

#include <Eigen/QR>
#include <algorithm>
#include <complex>
#include <future>
#include <thread>

namespace prs {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// What is within this of a limit is on it.
constexpr double kOnLimit = 1e-9;

/// Positions that are solved one after the other.
constexpr std::size_t kChunk = 64;

/// Loads that differ by less are the same load, as rounding has it.
constexpr double kSameNormalLoad = 1e-9;

double spin_order(const Mechanism& m, double slip_ratio) {
  const double of_carrier = m.type == Mechanism::Type::standard ? slip_ratio : 1.0 - slip_ratio;
  return static_cast<double>(m.starts.screw) / m.starts.roller * of_carrier;
}

/// Largest width of `values` over so many of them in a row.
double widest(const std::vector<double>& values, std::size_t count) {
  double width = 0.0;
  std::vector<std::size_t> low, high;  // Candidates for the extremes, the first of each at `from`.
  std::size_t low_from = 0, high_from = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
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
  for (const Lateral& p : points)
    farthest = std::max(farthest, std::hypot(p.y - mean.y, p.z - mean.z));
  return farthest;
}

/// What is kept of a position.
struct Position {
  FullDistribution d;
  double displacement = 0.0;
};

void add_support(TravelSupport& s, const SupportForce& f, double angle) {
  const Lateral across = turned_by(f.force[1], f.force[2], angle);
  s.position = f.position;
  s.force.emplace_back(f.force[0], across.y, across.z);
  s.moment.push_back(turned_by(f.moment.y, f.moment.z, angle));
}

void set_loads(TravelLoads& l, Interface i, const std::vector<Position>& positions,
               const std::vector<double>& angle, const std::vector<bool>& present) {
  const auto count = static_cast<double>(positions.size());
  l.mean = positions.front().d.normal_load[i];
  RollerThreads least = l.mean, most = l.mean;
  for (auto& roller : l.mean) std::ranges::fill(roller, 0.0);
  l.ripple = l.mean;
  l.least = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < positions.size(); ++p)
    for (std::size_t j = 0; j < l.mean.size(); ++j)
      for (std::size_t k = 0; present[j] && k < l.mean[j].size(); ++k) {
        const double load = positions[p].d.normal_load[i][j][k];
        l.mean[j][k] += load / count;
        least[j][k] = std::min(least[j][k], load);
        most[j][k] = std::max(most[j][k], load);
        l.least = std::min(l.least, load);
        if (load <= l.largest * (1.0 + kSameNormalLoad)) continue;
        l.largest = load;
        l.angle = angle[p];
        l.roller = static_cast<int>(j) + 1;
        l.thread = static_cast<int>(k) + 1;
      }
  for (std::size_t j = 0; j < l.mean.size(); ++j)
    for (std::size_t k = 0; k < l.mean[j].size(); ++k) l.ripple[j][k] = most[j][k] - least[j][k];
  for (const Position& p : positions)
    l.of_roller.push_back(p.d.normal_load[i][static_cast<std::size_t>(std::max(l.roller, 1) - 1)]);
}

}  // namespace

std::vector<MotionOrder> motion_orders(const Mechanism& m, double epsilon) {
  return {{"turn", 1.0},
          {"carrier", epsilon},
          {"carrier_on_screw", 1.0 - epsilon},
          {"roller_spin", spin_order(m, epsilon)},
          {"rollers_past_nut", m.rollers * epsilon},
          {"rollers_past_screw", m.rollers * (1.0 - epsilon)}};
}

std::optional<int> turns_until_repeat(const Mechanism& m, double epsilon) {
  const auto whole = [](double x) { return std::abs(x - std::round(x)) <= kOnLimit; };
  for (int turns = 1; turns <= 1000; ++turns)
    if (whole(turns * epsilon) && whole(turns * spin_order(m, epsilon))) return turns;
  return std::nullopt;
}

TravelBands travel_bands(const std::vector<double>& d, double sense, int one_turn, int in_300_mm) {
  const double last = static_cast<double>(d.size()) - 1.0;
  double mean = 0.0, slope = 0.0, square = 0.0;
  for (const double value : d) mean += value / (last + 1.0);
  for (std::size_t k = 0; k < d.size(); ++k) {
    const double from_middle = static_cast<double>(k) - 0.5 * last;
    slope += from_middle * (d[k] - mean);
    square += from_middle * from_middle;
  }
  slope /= square;
  TravelBands bands;
  bands.mean = sense * slope * last;
  std::vector<double> left;
  for (std::size_t k = 0; k < d.size(); ++k) {
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
  std::vector<double> x(count), cosine(count), sine(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(count);
    x[k] = d[k] - d.front() - (d.back() - d.front()) * share;
    cosine[k] = std::cos(kTurn * share);
    sine[k] = std::sin(kTurn * share);
  }
  std::vector<OrderAmplitude> spectrum;
  for (std::size_t k = 1; k <= count / 2; ++k) {
    double real = 0.0, imaginary = 0.0;
    for (std::size_t i = 0, at = 0; i < count; ++i, at = (at + k) % count) {
      real += x[i] * cosine[at];
      imaginary += x[i] * sine[at];
    }
    const double amplitude = 2.0 * std::hypot(real, imaginary) / static_cast<double>(count);
    spectrum.push_back({{},
                        static_cast<double>(k) / std::abs(turns),
                        2 * k == count ? 0.5 * amplitude : amplitude});
  }
  return spectrum;
}

std::vector<OrderAmplitude> fitted_orders(const std::vector<double>& d, const Travel& t,
                                          const std::vector<MotionOrder>& orders) {
  const double resolution = 1.0 / std::abs(t.turns);
  std::vector<OrderAmplitude> kept;
  for (const MotionOrder& o : orders) {
    const bool apart = std::ranges::all_of(kept, [&](const OrderAmplitude& k) {
      return std::abs(o.order - k.order) >= resolution - kOnLimit;
    });
    if (apart && o.order >= resolution - kOnLimit &&
        o.order <= 0.5 * t.steps - resolution + kOnLimit)
      kept.push_back({std::string(o.name), o.order, 0.0});
  }
  const auto rows = static_cast<Eigen::Index>(d.size());
  Eigen::MatrixXd a(rows, 2 + 2 * static_cast<Eigen::Index>(kept.size()));
  a.col(0).setOnes();
  a.col(1).setLinSpaced(rows, -1.0, 1.0);
  for (std::size_t i = 0; i < kept.size(); ++i)
    for (Eigen::Index k = 0; k < rows; ++k) {
      const double phase = kept[i].order * kTurn * static_cast<double>(k) / t.steps;
      a(k, 2 + 2 * static_cast<Eigen::Index>(i)) = std::cos(phase);
      a(k, 3 + 2 * static_cast<Eigen::Index>(i)) = std::sin(phase);
    }
  const Eigen::VectorXd fit =
      a.colPivHouseholderQr().solve(Eigen::Map<const Eigen::VectorXd>(d.data(), rows));
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const auto at = 2 + 2 * static_cast<Eigen::Index>(i);
    kept[i].amplitude = std::hypot(fit[at], fit[at + 1]);
  }
  return kept;
}

std::vector<double> TravelResult::deviation() const {
  std::vector<double> less_mean = displacement;
  for (double& d : less_mean) d -= mean_displacement;
  return less_mean;
}

TravelResult travel(const TravelModel& model, const Mechanism& m, const Travel& wanted) {
  TravelResult r;
  r.travel = wanted;
  r.slip_ratio = slip_ratio(m, wanted);
  r.lead = m.lead;
  const auto count = static_cast<std::size_t>(wanted.last()) + 1;
  for (int k = 0; k <= wanted.last(); ++k) r.angle.push_back(wanted.angle(k));
  std::vector<Position> positions(count);
  const FullModel first = model.model(r.angle.front());
  const auto solve_chunk = [&](std::size_t chunk) -> std::optional<std::size_t> {
    const auto solver = model.solver();
    for (std::size_t k = chunk * kChunk; k < std::min(count, (chunk + 1) * kChunk); ++k) {
      FullModel f = model.model(r.angle[k]);
      if (model.carrier) {
        turn_axes(f, model.carrier(r.angle[k]));
        for (std::size_t j = 0; j < f.present.size(); ++j)  // Rounding would make other zeros.
          f.present[j].azimuth = first.present[j].azimuth;
      }
      Position& p = positions[k];
      p.d = solver(f);
      if (!p.d.solve.converged()) return k;
      p.displacement = p.d.screw_end.displacement[0];
      for (const Interface i : kInterfaces)
        p.displacement += f.sense() * f.smallest_gap[i] / f.sector.cosine[i];
    }
    return std::nullopt;
  };
  std::optional<std::size_t> failed;
  for (std::size_t chunk = 0; chunk * kChunk < count && !failed; ++chunk)
    failed = solve_chunk(chunk);
  if (failed) {
    const FullDistribution& d = positions[*failed].d;
    r.failure = {r.angle[*failed],
                 d.reason.empty() ? std::string(fe::name(d.solve.status)) : d.reason,
                 d.solve.status};
    return r;
  }

  std::vector<Lateral> side_force;
  r.bearings.resize(positions.front().d.bearings.size());
  for (std::size_t k = 0; k < count; ++k) {
    const FullDistribution& d = positions[k].d;
    const double angle = model.carrier ? model.carrier(r.angle[k]) : 0.0;
    r.displacement.push_back(positions[k].displacement);
    r.mean_displacement += positions[k].displacement / static_cast<double>(count);
    const auto& q = d.screw_end.displacement;
    r.end_displacement.push_back(turned_by(q[1], q[2], angle));
    r.end_rotation.push_back(turned_by(q[3], q[4], angle));
    add_support(r.nut, d.nut, angle);
    side_force.push_back({r.nut.force.back()[1], r.nut.force.back()[2]});
    for (std::size_t b = 0; b < r.bearings.size(); ++b)
      add_support(r.bearings[b], d.bearings[b], angle);
    if (d.tangent_stiffness)
      r.tangent_stiffness.push_back(*d.tangent_stiffness);
    else if (!r.left_out_at)
      r.left_out_at = r.angle[k];
  }
  if (r.left_out_at) r.tangent_stiffness.clear();
  r.side_force_ripple = farthest_from_mean(side_force);
  r.tilt_ripple = farthest_from_mean(r.end_rotation);
  const double step = std::abs(m.lead) / wanted.steps;
  const double in_300_mm = std::floor(0.3 / step + kOnLimit);
  r.bands =
      travel_bands(r.displacement, (wanted.turns < 0) == (m.lead < 0.0) ? 1.0 : -1.0, wanted.steps,
                   in_300_mm <= wanted.last() ? static_cast<int>(in_300_mm) : 0);
  r.spectrum = travel_spectrum(r.displacement, wanted.turns);
  r.orders = fitted_orders(r.displacement, wanted, motion_orders(m, r.slip_ratio));
  std::vector<bool> present(static_cast<std::size_t>(m.rollers), false);
  for (const FullModel::Roller& roller : first.present)
    present[static_cast<std::size_t>(roller.number)] = true;
  for (const Interface i : kInterfaces) set_loads(r.loads[i], i, positions, r.angle, present);
  return r;
}

}  // namespace prs
