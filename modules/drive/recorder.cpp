#include "modules/drive/recorder.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>

namespace prs {
namespace {

constexpr int kBits = 18;  // Accuracy of the time of an extreme within its step.
constexpr double kWeights[PRS_POINTS] = {1.0 / 20.0, 49.0 / 180.0, 16.0 / 45.0, 49.0 / 180.0, 1.0 / 20.0};

double motor_power(const PrsView& v) { return v.motor_torque * v.omega_m; }
double load_power(const PrsView& v) { return -v.external * v.v; }

template <class Value>
double integral(const PrsView points[PRS_POINTS], const Value& value) {
  double sum = 0.0;
  for (int k = 0; k < PRS_POINTS; ++k) sum += kWeights[k] * value(points[k]);
  return sum * (points[PRS_POINTS - 1].t - points[0].t);
}

/// Quadrature with points evenly spaced in the root of the time since `anchor`, at which the integrand has a root.
template <class Value>
double integral_in_root(double anchor, const PrsView points[PRS_POINTS], const Value& value) {
  const auto root = [&](int k) { return std::sqrt(std::abs(points[k].t - anchor)); };
  double sum = 0.0;
  for (int k = 0; k < PRS_POINTS; ++k) sum += kWeights[k] * value(points[k]) * 2.0 * root(k);
  return sum * std::abs(root(PRS_POINTS - 1) - root(0));
}

/// Effective mass that a closing flank stops.
double reduced_mass(const PrsDrive& d, double mass, double reach) {
  if (d.coupled == 0 && d.by == PRS_BY_SPEED) return mass;
  const double turning = (d.screw_inertia + (d.coupled != 0 ? 0.0 : d.motor_inertia)) / (reach * reach);
  return mass * turning / (mass + turning);
}

}  // namespace

Recorder::Recorder(const DriveRun& run, PrsRun& core, const PrsStepper& stepper, DriveResult& result)
    : run_(run),
      core_(core),
      stepper_(stepper),
      result_(result),
      follow_until_(run.drive.by >= PRS_SPEED_LOOP ? std::min(run.duration, run.drive.cut_at) : -1.0) {
  PrsView view;
  prs_view(&core_, 0.0, core_.state.y, nullptr, &view);
  result_.stored_start = prs_stored_energy(&core_, &view);
}

PrsObserver Recorder::observer() {
  return {this, [](void* self, const PrsView* view, int closed) { static_cast<Recorder*>(self)->begin(*view, closed); },
          [](void* self, const PrsView* points) { static_cast<Recorder*>(self)->step(points); }};
}

PrsView Recorder::at(double t) const {
  double y[PRS_STATES];
  PrsView view;
  stepper_.at(stepper_.self, t, y);
  prs_view(&core_, t, y, nullptr, &view);
  return view;
}

double Recorder::tracked(const PrsView& v, int which) const {
  const double lost = v.delta + core_.reach * v.theta;
  switch (which) {
    case kTension:
      return v.force;
    case kCompression:
      return -v.force;
    case kTorque:
      return v.motor_torque;
    case kBackTorque:
      return -v.motor_torque;
    case kLag:
      return lost;
    case kLead:
      return -lost;
    case kStop:
      return v.stop_pressed;
    case kError:
      return follows(v.t) ? v.error : -HUGE_VAL;
    case kBackError:
      return follows(v.t) ? -v.error : -HUGE_VAL;
    default:
      return result_.impacts.empty() ? -HUGE_VAL : result_.impacts.back().flank * v.force;
  }
}

void Recorder::track(const PrsView& view) {
  for (int j = 0; j < kAll; ++j) {
    DrivePeak& peak = peaks_[j];
    const double value = tracked(view, j);
    if (value == -HUGE_VAL) continue;
    if (!peak.is_reached || value > peak.value + 1e-13 * std::abs(peak.value)) peak = {value, view.t, true};
  }
  result_.largest_force = std::max(result_.largest_force, std::abs(view.force));
  result_.largest_speed = std::max(result_.largest_speed, std::abs(view.omega));
}

void Recorder::refine(const PrsView points[PRS_POINTS]) {
  for (int j = 0; j < kAll; ++j)
    for (int k = 1; k + 1 < PRS_POINTS; ++k) {
      double t[3], y[3], when = 0.0, predicted = 0.0;
      for (int i = 0; i < 3; ++i) t[i] = points[k - 1 + i].t, y[i] = tracked(points[k - 1 + i], j);
      if (prs_vertex(t, y, &when, &predicted) == 0) continue;
      if (!(predicted > peaks_[j].value + 1e-11 * std::abs(peaks_[j].value))) continue;
      const auto share_at = [&](double share) { return at(t[0] + share * (t[2] - t[0])); };
      const auto below = [&](double share) { return -tracked(share_at(share), j); };
      track(share_at(boost::math::tools::brent_find_minima(below, 0.0, 1.0, kBits).first));
    }
}

double Recorder::magnitude(double (*power)(const PrsView&), const PrsView points[PRS_POINTS], int depth) const {
  int changes = 0, last = 0;
  for (int k = 1; k < PRS_POINTS; ++k)
    if ((power(points[k - 1]) < 0.0) != (power(points[k]) < 0.0)) {
      ++changes;
      last = k;
    }
  if (changes == 0 || depth > 12) return integral(points, [&](const PrsView& v) { return std::abs(power(v)); });
  const double start = points[0].t, end = points[PRS_POINTS - 1].t;
  double middle = 0.5 * (start + end);
  if (changes == 1) {
    double from = points[last - 1].t, to = points[last].t;
    const bool negative = power(points[last - 1]) < 0.0;
    for (int i = 0; i < 20; ++i) {
      middle = 0.5 * (from + to);
      ((power(at(middle)) < 0.0) == negative ? from : to) = middle;
    }
    // Each part has one sign, up to rounding.
    depth = 12;
  }
  double sum = 0.0;
  for (const auto& [from, to] : {std::pair{start, middle}, std::pair{middle, end}}) {
    PrsView part[PRS_POINTS];
    for (int k = 0; k < PRS_POINTS; ++k) part[k] = at(from + prs_places[k] * (to - from));
    sum += magnitude(power, part, depth + 1);
  }
  return sum;
}

void Recorder::sample(const PrsView& v) {
  DriveResult& r = result_;
  r.time.push_back(next_sample());
  r.x.push_back(v.x);
  r.v.push_back(v.v);
  r.phi.push_back(v.phi);
  r.omega.push_back(v.omega);
  r.phi_m.push_back(v.phi_m);
  r.omega_m.push_back(v.omega_m);
  r.delta.push_back(v.delta);
  r.force.push_back(v.force);
  r.motor_torque.push_back(v.motor_torque);
  r.coupling_torque.push_back(v.coupling_torque);
  r.external.push_back(v.external);
  r.stop_force.push_back(v.stop_pressed);
  if (!(run_.drive.linkage.arm > 0.0)) return;
  r.lever_angle.push_back(v.lever.angle);
  r.lever_speed.push_back(v.v / v.lever.ratio);
  r.lever_torque.push_back(v.external * v.lever.ratio);
}

void Recorder::begin(const PrsView& view, int closed) {
  if (closed != 0) closed_ = view.t;
  if (closed != 0 && view.t > 0.0) {
    if (!result_.impacts.empty()) result_.impacts.back().force = peaks_[kImpact];
    const double speed = std::abs(view.delta_rate);
    result_.impacts.push_back(
        {view.t, closed, speed, 0.5 * reduced_mass(run_.drive, view.mass, core_.reach) * speed * speed});
    peaks_[kImpact] = {0.0, view.t, true};
  }
  track(view);
  while (result_.time.size() < run_.samples && next_sample() <= view.t + core_.resolution) sample(view);
}

void Recorder::step(const PrsView points[PRS_POINTS]) {
  DriveResult& r = result_;
  const PrsDrive& d = run_.drive;
  const double from = points[0].t, to = points[PRS_POINTS - 1].t;
  // After a flank closes, force and damping begin with the root of the time; a lifted one opens in the same way.
  const bool opens = core_.state.modes.lifted != 0, roots = opens || from - closed_ < 8.0 * (to - from);
  const double anchor = opens ? to : closed_;
  PrsView even[PRS_POINTS];
  if (roots) {
    const double first = std::sqrt(std::abs(from - anchor)), last = std::sqrt(std::abs(to - anchor));
    even[0] = points[0], even[PRS_POINTS - 1] = points[PRS_POINTS - 1];
    for (int k = 1; k + 1 < PRS_POINTS; ++k) {
      const double root = first + prs_places[k] * (last - first);
      even[k] = at(anchor + (opens ? -1.0 : 1.0) * root * root);
    }
  }
  const auto add = [&](double& sum, const auto& value) {
    sum += roots ? integral_in_root(anchor, even, value) : integral(points, value);
  };
  add(r.motor, motor_power);
  add(r.load, load_power);
  add(r.screw_friction, [](const PrsView& v) { return v.screw_friction * v.omega; });
  add(r.motor_friction, [](const PrsView& v) { return v.motor_friction * v.omega_m; });
  add(r.load_friction, [](const PrsView& v) { return v.load_friction * v.v; });
  if (d.coupled != 0)
    add(r.coupling, [&](const PrsView& v) { return d.coupling_damping * v.theta_rate * v.theta_rate; });
  add(r.contact, [](const PrsView& v) { return (v.force - v.static_force) * v.delta_rate; });
  add(r.end_stop, [](const PrsView& v) { return v.stop_damped; });
  add(r.viscous,
      [&](const PrsView& v) { return d.motor_damping * v.omega_m * v.omega_m + d.load_damping * v.v * v.v; });
  r.turnover += magnitude(motor_power, points, 0) + magnitude(load_power, points, 0);
  add(r.torque_squared, [](const PrsView& v) { return v.motor_torque * v.motor_torque; });
  if (follows(to - 0.5 * core_.resolution)) add(r.error_squared, [](const PrsView& v) { return v.error * v.error; });
  for (int k = 0; k < PRS_POINTS; ++k) track(points[k]);
  refine(points);
  r.last_reference = points[PRS_POINTS - 1].reference;
  while (r.time.size() < run_.samples) {
    const double t = next_sample();
    if (t >= to - core_.resolution) break;
    sample(at(std::max(t, from)));
  }
}

void Recorder::finish() {
  DriveResult& r = result_;
  PrsView view;
  prs_view(&core_, core_.state.t, core_.state.y, nullptr, &view);
  r.stored_end = prs_stored_energy(&core_, &view);
  r.turnover += r.stored_start;
  r.stopped_at = core_.state.t;
  r.position = view.x;
  r.tension = peaks_[kTension];
  r.compression = peaks_[kCompression];
  r.torque = larger(kTorque, kBackTorque);
  r.stop = peaks_[kStop];
  r.error = larger(kError, kBackError);
  r.lost_motion = peaks_[kLag].value + peaks_[kLead].value;
  if (!r.impacts.empty()) r.impacts.back().force = peaks_[kImpact];
}

}  // namespace prs
