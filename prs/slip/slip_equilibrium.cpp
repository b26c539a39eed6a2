#include "prs/slip/slip_equilibrium.h"

#include <algorithm>
#include <limits>

#include "prs/indices.h"
#include "prs/slip/slip_search.h"

namespace prs {
namespace {

using simd::Dual, simd::value;

double sign(double x) { return std::copysign(1.0, x); }

template <class Number>
struct RollerHeadOf {
  Number guide_force{}, bearing_force{};
  contact::JournalBearingStateOf<Number> state{};
};

/// Sliding of the other flank of an interface, if there is one.
template <class Number>
contact::PatchMotionOf<Number> other_sliding(const SlipModel& model, Interface i, const Number& slip_ratio,
                                             const Number& spin) {
  if (!model.other_flank) return {};
  const auto& [geometry, frames] = *model.other_flank;
  return patch_motion(frames[i], contact_motion(geometry, kinematics(geometry, model.speed, slip_ratio, spin), i));
}

/// Forces of the patches of an interface; calls take(k, friction, forces) for each. Clears `possible`
/// if one has no normal load.
template <class Number, class Take>
InterfaceForces<Number> interface_forces(const SlipModel& model, Interface i,
                                         const contact::PatchMotionOf<Number>& sliding,
                                         const contact::PatchMotionOf<Number>& other, bool& possible, Take take) {
  const LoadedThreads& threads = model.threads[i];
  InterfaceForces<Number> sum;
  for (std::size_t k = 0; k < threads.patches.size() && possible; ++k) {
    const LoadedThreads::Contact& contact = threads.contacts[k];
    const contact::PatchFrictionOf<Number> friction =
        threads.patches[k].friction(contact.other_flank ? other : sliding);
    const ContactFrameOf<double>& frame = model.frame(i, contact);
    const PatchForces<Number> at = contact.normal_load
                                       ? forces_of(frame, friction, turned_normal<Number, double>(frame, friction),
                                                   Number(*contact.normal_load), threads.alike)
                                       : patch_forces(frame, friction, contact.axial_load, threads.alike);
    possible = is_possible(at.normal_load) && value(at.on_roller.force.z) * frame.normal.z <= 0.0;
    sum.force = sum.force + at.on_roller.force;
    sum.spin_torque += at.on_roller.spin_torque;
    if (contact.other_flank) {
      const auto &here = model.other_flank->geometry.points[i], &there = model.geometry.points[i];
      sum.couple += (here.x - there.x) * at.on_roller.force.y - (here.y - there.y) * at.on_roller.force.x;
    }
    take(k, friction, at);
  }
  return sum;
}

/// Forces and friction of the heads of one roller whose guides push it with these forces.
template <class Number>
std::array<RollerHeadOf<Number>, 2> heads_of(const SlipModel& model, const RollerForcesOf<Number>& f,
                                             const Number& speed, const std::optional<std::array<double, 2>>& guides) {
  std::array<RollerHeadOf<Number>, 2> heads;
  for (const auto h : up_to(2)) {
    RollerHeadOf<Number>& head = heads[h];
    head.guide_force = guides ? Number((*guides)[h]) : -0.5 * f.contacts_x;
    if (!guides || !model.guides.carry_centrifugal) head.guide_force -= 0.5 * f.centrifugal;
    const Number along_radius = head.guide_force - 0.5 * f.gears_x, along_orbit = 0.5 * f.carrier_y;
    // A head without load, as of grooved rollers in guides with clearance, has no direction of its force.
    const bool unloaded = value(along_radius) == 0.0 && value(along_orbit) == 0.0;
    head.bearing_force = unloaded ? Number(0.0) : simd::length(along_radius, along_orbit);
    if (model.has_bearing()) head.state = head_state<Number, double>(model, speed, head.bearing_force);
  }
  return heads;
}

/// Calls visit(heads) for each roller whose heads are known by themselves.
template <class Number, class Visit>
void for_each_roller(const SlipModel& model, const RollerForcesOf<Number>& f, const Number& speed, Visit visit) {
  if (model.guides.of_roller.empty()) visit(heads_of<Number>(model, f, speed, {}));
  for (const auto& guides : model.guides.of_roller) visit(heads_of<Number>(model, f, speed, guides));
}

/// See `balance_carrier`: the mean torque of all rollers.
template <class Number>
contact::JournalBearingStateOf<Number> both_heads(const SlipModel& model, const RollerForcesOf<Number>& f,
                                                  const Number& speed) {
  if (model.guides.of_roller.empty()) return equal_heads<Number, double>(model, f, speed);
  contact::JournalBearingStateOf<Number> mean{Number(0.0), Number(0.0)};
  for_each_roller(model, f, speed, [&](const auto& heads) {
    for (const auto& head : heads) {
      if (mean.eccentricity_ratio < head.state.eccentricity_ratio)
        mean.eccentricity_ratio = head.state.eccentricity_ratio;
      mean.torque += head.state.torque / static_cast<double>(model.guides.of_roller.size());
    }
  });
  return mean;
}

/// Balance at one slip ratio; calls take(i, k, friction, forces) for each patch.
template <class Number, class Take>
RollerBalanceOf<Number> balance_of(const SlipModel& model, const Number& slip_ratio, const Number& spin, bool& possible,
                                   Take take) {
  return roller_balance(
      model, slip_ratio, spin,
      [&](Interface i, const contact::PatchMotionOf<Number>& sliding) {
        return interface_forces(
            model, i, sliding, other_sliding(model, i, slip_ratio, spin), possible,
            [&](std::size_t k, const auto& friction, const auto& forces) { take(i, k, friction, forces); });
      },
      [&](const auto&, const RollerForcesOf<Number>& f, const Number& speed) { return both_heads(model, f, speed); });
}

/// The balance with slopes along the slip ratio, the spin or both.
RollerBalanceOf<Dual<double>> with_slopes(const SlipModel& model, const Dual<double>& slip_ratio,
                                          const Dual<double>& spin, bool& possible) {
  return balance_of(model, slip_ratio, spin, possible, [](auto&&...) {});
}

/// Moment about the axis of a roller without teeth, in the sense of the speed over `residue_unit`; it grows with the
/// spin.
Dual<double> toothless_moment(const SlipModel& model, const RollerMomentsOf<Dual<double>>& m) {
  return sign(model.speed) / residue_unit(model) * (m.contacts + m.spin + m.carrier);
}

struct SpinRoot {
  double spin = 0.0;
  /// Slopes of `toothless_moment` and of R_z along the spin, where they were evaluated last.
  double moment_slope = 0.0, residue_slope = 0.0;
};

constexpr double kGreatestSpin = 1e3;

/// Spin at which `toothless_moment` vanishes: Newton's method between bounds, from `start`. Not possible where the
/// threads cannot overcome the carrier's torque.
SpinRoot spin_root_from(const SlipModel& model, double slip_ratio, double start, bool& possible) {
  constexpr int kMostSteps = 100;
  constexpr double kFirstStep = 1e-2, kSpinTolerance = 1e-13;
  double low = -std::numeric_limits<double>::infinity(), high = -low, longest = kFirstStep;
  double before = 0.0;  // Length of the last step if it was one of Newton's method.
  SpinRoot root{start};
  for (int k = 0; k < kMostSteps; ++k) {
    const RollerMomentsOf<Dual<double>> moments =
        with_slopes(model, {slip_ratio, 0.0}, {root.spin, 1.0}, possible).moments;
    const Dual<double> moment = toothless_moment(model, moments);
    root.moment_slope = moment.slope;
    root.residue_slope = moments.residue().slope;
    if (!possible || std::abs(moment.value) <= 1e-16) break;
    (moment.value > 0.0 ? high : low) = root.spin;
    const double newton = root.spin - moment.value / moment.slope, step = std::abs(newton - root.spin);
    // The next step of a converging Newton's method is at most step^2/before.
    const bool last = step <= kSpinTolerance || (step < before && step * step <= kSpinTolerance * before);
    const bool bounded = std::isfinite(high - low), shrinks = before == 0.0 || step <= 0.5 * before;
    before = 0.0;
    if (last || (newton > low && newton < high && bounded && shrinks)) {
      root.spin = newton;
      before = step;
    } else if (bounded) {
      root.spin = 0.5 * (low + high);
    } else {
      root.spin -= std::copysign(std::min(step, longest), moment.value);
      if (step <= longest) before = step;
      longest *= 4.0;
      possible = std::abs(root.spin) < kGreatestSpin;
    }
    if (last || !possible) break;
  }
  return root;
}

/// Spin of the roller: with teeth 0, else the root of `toothless_moment`. The force that then lacks along the orbit is
/// what teeth would give, so that the residue of the moments vanishes with it. `start`: a spin that may be close.
SpinRoot spin_root(const SlipModel& model, double slip_ratio, double start, bool& possible) {
  if (!contact::is_grooved(model.geometry.type)) return {};
  if (start != 0.0 && std::abs(start) < kGreatestSpin) {
    bool found = possible;
    const SpinRoot root = spin_root_from(model, slip_ratio, start, found);
    if (found) return root;
  }
  return spin_root_from(model, slip_ratio, 0.0, possible);
}

/// R_z with its slope along the slip ratio; none if a contact jams. The search of the spin starts from `spin`, a
/// balance nearby, which then becomes that of this balance.
std::optional<Dual<double>> residue_with_slope(const SlipModel& model, double slip_ratio, RollerSpin& spin) {
  bool possible = true;
  const SpinRoot root = spin_root(model, slip_ratio, spin.at(slip_ratio).spin, possible);
  const RollerMomentsOf<Dual<double>> moments =
      with_slopes(model, {slip_ratio, 1.0}, {root.spin, 0.0}, possible).moments;
  if (!possible) return std::nullopt;
  spin = {slip_ratio, root.spin, 0.0};
  if (root.moment_slope > 0.0) spin.slope = -toothless_moment(model, moments).slope / root.moment_slope;
  const Dual<double> residue = moments.residue();
  return Dual<double>(residue.value, residue.slope + root.residue_slope * spin.slope) / residue_unit(model);
}

}  // namespace

bool balance_at(const SlipModel& model, double slip_ratio, SlipBalance& b) {
  bool possible = true;
  const double spin = spin_root(model, slip_ratio, b.spin.at(slip_ratio).spin, possible).spin;
  for (const Interface i : kInterfaces) {
    PatchBalance& at = b.patches[i];
    at.friction.resize(model.threads[i].patches.size());
    at.normal_load.resize(model.threads[i].patches.size());
    at.power = 0.0;
    b.other_sliding[i] = other_sliding(model, i, slip_ratio, spin);
  }
  b.RollerBalance::operator=(balance_of(
      model, slip_ratio, spin, possible,
      [&](Interface i, std::size_t k, const contact::PatchFriction& friction, const PatchForces<double>& forces) {
        PatchBalance& at = b.patches[i];
        at.friction[k] = friction;
        at.normal_load[k] = forces.normal_load;
        at.power += model.threads[i].alike * forces.normal_load * friction.power_per_load;
      }));
  if (possible) b.spin = {slip_ratio, spin, b.spin.slope};
  return possible;
}

double residue_unit(const SlipModel& m) {
  const double force = m.carried.value_or(std::abs(m.axial_force));
  return m.geometry.centre_distance * (force > 0.0 ? force : 1.0) / m.rollers;
}

double relative_residue(const SlipModel& m, const SlipBalance& b) { return b.moments.residue() / residue_unit(m); }

SlipEquilibrium find_slip_equilibrium(const SlipModel& model, const std::optional<RollerSpin>& near) {
  SlipSearch search(slip_range(model.geometry), model.speed, model.imposed_slip_ratio,
                    near ? std::optional(near->slip_ratio) : std::nullopt);
  SlipEquilibrium found;
  found.balance.spin = near.value_or(RollerSpin{});
  while (!search.done()) {
    if (search.wants_slope()) {
      if (const auto residue = residue_with_slope(model, search.slip_ratio(), found.balance.spin))
        search.take(residue->value, residue->slope);
      else
        search.jam();
    } else if (balance_at(model, search.slip_ratio(), found.balance)) {
      search.take(relative_residue(model, found.balance), 0.0);
    } else {
      search.jam();
    }
  }
  found.status = search.status();
  found.evaluations = search.evaluations();
  found.slope = search.slope();
  if (near && found.status == SlipStatus::no_equilibrium) return find_slip_equilibrium(model);
  return found;
}

std::optional<double> next_slip_ratio(const SlipModel& model, SlipEquilibrium& slip) {
  constexpr double kSmall = 1e-3;
  const double at = slip.balance.motion.slip_ratio;
  if (!balance_at(model, at, slip.balance)) return std::nullopt;
  if (slip.status == SlipStatus::imposed) return at;
  const double step = -relative_residue(model, slip.balance) / slip.slope;
  const bool small = std::abs(step) <= kSmall * std::abs(at - slip_range(model.geometry).ideal);
  return small ? std::optional(at + step) : std::nullopt;
}

void set_heads(std::vector<std::array<RollerHead, 2>>& heads, const SlipModel& model, const SlipBalance& b) {
  heads.clear();
  for_each_roller(model, b.forces, b.motion.roller_to_carrier, [&](const auto& of_roller) {
    std::array<RollerHead, 2>& added = heads.emplace_back();
    for (const auto h : up_to(2)) {
      const auto& head = of_roller[h];
      added[h] = {head.guide_force, head.bearing_force, {}, {}};
      if (model.has_bearing()) added[h].torque = head.state.torque;
      if (model.bearing_viscosity > 0.0) added[h].eccentricity_ratio = head.state.eccentricity_ratio;
    }
  });
  if (model.threads.screw.threads_per_roller == 0) return;
  if (heads.size() == 1) heads.assign(static_cast<std::size_t>(model.rollers), std::array(heads.front()));
  const std::vector<int>& missing = model.guides.missing;
  for (std::size_t r = 0; r < heads.size() || r < missing.size(); ++r)
    if (contains(missing, static_cast<int>(r + 1))) heads.emplace(heads.begin() + static_cast<std::ptrdiff_t>(r));
}

DriveTorques drive_torques(const SlipModel& m, const SlipBalance& b) {
  // Moment about the screw's axis of the forces on a roller, which act back on screw and nut.
  const auto about_axis = [&](Interface i) {
    return moment_z(m.geometry.points[i], 0.0, b.interfaces[i].force) + b.interfaces[i].couple +
           b.interfaces[i].spin_torque;
  };
  const double c = m.geometry.centre_distance;
  const double roller_gear = roller_gear_radius(m.geometry);
  const double gear_arm = m.geometry.carrier_on_nut() ? c + roller_gear : c - roller_gear;
  const double gears = gear_arm * b.forces.gears_y;
  return {m.rollers * (about_axis(Interface::screw) + (m.geometry.carrier_on_nut() ? 0.0 : gears)) +
              sign(m.speed) * m.screw_torque,
          m.rollers * (about_axis(Interface::nut) + (m.geometry.carrier_on_nut() ? gears : 0.0)) -
              sign(m.speed) * m.nut_torque};
}

PowerBySource lost_power(const SlipModel& m, const SlipBalance& b) {
  return {m.rollers * b.patches.screw.power, m.rollers * b.patches.nut.power,
          m.rollers * std::abs(b.carrier_roller_torque * b.motion.roller_to_carrier),
          m.screw_torque * std::abs(b.motion.screw_to_carrier), m.nut_torque * std::abs(b.motion.nut_to_carrier)};
}

PowerFlow power_flow(const SlipModel& m, const SlipBalance& b) {
  const DriveTorques torques = drive_torques(m, b);
  const double advance = b.motion.nut_advance - b.motion.screw_advance;
  return {(m.geometry.carrier_on_nut() ? torques.screw : torques.nut) * turning_speed(m.geometry.type, m.speed),
          m.axial_force * advance};
}

DrivenBy driven_by(double axial_force, double speed, double lead) {
  return axial_force * speed * lead < 0.0 ? DrivenBy::load : DrivenBy::screw;
}

std::optional<double> PowerFlow::efficiency() const {
  if (load < 0.0 && shaft > 0.0) return -load / shaft;
  if (load > 0.0 && shaft < 0.0) return -shaft / load;
  return std::nullopt;
}

}  // namespace prs
