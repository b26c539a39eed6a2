#include "prs/slip/running_equilibrium.h"

#include <Eigen/QR>

#include "prs/indices.h"
#include "prs/slip/slip.h"

namespace prs {
namespace {

using Eigen::VectorXd;

/// Change of a thread's load over a round, relative to the largest load, at which to stop.
constexpr double kTolerance = 1e-10;
constexpr int kMostRounds = 100;
/// Largest distance of a last step's slip ratio from the one that balances.
constexpr double kSlipMissed = 1e-13;
/// Share of a round's change down to which friction in proportion to the loads is followed.
constexpr double kShare = 0.02;

/// Anderson's acceleration of x = g(x) (Walker and Ni, SIAM J. Numer. Anal. 49, 2011, 1715): the
/// combination of the last steps for which g(x) - x vanishes as nearly as possible.
class Anderson {
 public:
  VectorXd next(const VectorXd& x, const VectorXd& g) {
    constexpr Eigen::Index kDepth = 3;
    const VectorXd residual = g - x;
    if (last_g_.size() > 0) {
      const Eigen::Index kept = std::min(changes_.cols(), kDepth - 1);
      const auto append = [kept](Eigen::MatrixXd& to, const VectorXd& column) {
        Eigen::MatrixXd all(column.size(), kept + 1);
        all << to.rightCols(kept), column;
        to = std::move(all);
      };
      append(changes_, residual - last_residual_);
      append(steps_, g - last_g_);
    } else {
      changes_ = steps_ = Eigen::MatrixXd(x.size(), 0);
    }
    last_residual_ = residual;
    last_g_ = g;
    if (changes_.cols() == 0) return g;
    return g - steps_ * changes_.colPivHouseholderQr().solve(residual);
  }

 private:
  Eigen::MatrixXd changes_, steps_;
  VectorXd last_residual_, last_g_;
};

/// Rollers of one nut, which slip alike; their threads start at `first` among all.
struct Slipping {
  SlipModel model;
  std::size_t first = 0;
};

/// The fixed point of loads and friction for one load case.
class FixedPoint {
 public:
  FixedPoint(const Conditions& c, const Contacts& contacts, const SlipModels& models, RunningRollers rollers,
             LoadCaseResult& loaded)
      : c_(c), contacts_(contacts), models_(models), rollers_(std::move(rollers)), loaded_(loaded) {
    for (const Interface i : kInterfaces) {
      InterfaceLoads& loads = threads()[i];
      loads.friction.emplace().threads_per_roller = loads.threads_per_roller;
    }
    const std::optional<double>& density = c.materials->roller.density;
    if (!density) return;
    const double volume = roller_body(contacts.mechanism, c.structure->roller).volume;
    thread_share_ = disc_area(*contacts.mechanism.pitch_diameter.roller) / volume;
    head_share_ = disc_area(c.structure->roller.end_diameter) / volume;
  }

  std::vector<SlipEquilibrium> solve(BodyAnswer answer, const RunningBodies& bodies, SpinOfNuts& near) {
    RunningLoads& r = running();
    std::vector<SlipEquilibrium> slip;
    SpinOfNuts last = near;
    bool anew = true;  // Whether to search the slip ratio again, in place of a step by the last slope.
    push_ = std::vector<RollerPush>(rollers_.present.size(), no_push(rollers_.threads));
    for (r.rounds = 1; r.rounds <= kMostRounds; ++r.rounds) {
      const std::vector<Slipping> nuts = slipping_on(answer);
      std::vector<double> centrifugal(push_.size(), 0.0);
      const double before = r.change;
      double missed = 0.0;
      slip.resize(nuts.size());
      for (const auto n : indices(nuts)) {
        const SlipModel& model = nuts[n].model;
        SlipEquilibrium& found = slip[n];
        std::optional<double> next;
        if (!anew) {
          found.balance.motion.slip_ratio = last[n]->slip_ratio;
          next = next_slip_ratio(model, found);
        }
        if (!next) {
          found = find_slip_equilibrium(model, last[n]);
          if (!found.ok()) {
            r.status = found.status == SlipStatus::jammed ? RunningStatus::jammed : RunningStatus::slip_no_equilibrium;
            return slip;
          }
          next = found.balance.motion.slip_ratio;
        }
        missed = std::max(missed, std::abs(*next - found.balance.motion.slip_ratio));
        last[n] = found.balance.spin.at(*next);
        set_friction(nuts[n], found);
        const double force = found.balance.forces.centrifugal;
        if (rollers_.of_flanks())
          centrifugal[nuts[n].first / rollers_.threads] = force;
        else
          centrifugal.assign(push_.size(), force);
      }
      if (!follow(bodies, centrifugal, anew && r.rounds > 3 && before > kTolerance, answer)) return slip;
      anew = r.rounds > 1 && (r.change > 0.3 * before || r.change <= kTolerance);
      if (r.change > kTolerance || missed > kSlipMissed) continue;
      for (const Interface i : kInterfaces) threads()[i].normal_load = answer.normal_load[i];
      r.guide_force = answer.guide_force;
      r.status = RunningStatus::converged;
      for (const auto n : indices(slip)) near[n] = slip[n].balance.spin;
      for (const Slipping& nut : nuts) set_axial_loads(nut);
      for (const Interface i : kInterfaces)
        threads()[i].running_over_static = over_static(threads()[i], r.at_rest.largest_normal_load[i]);
      return slip;
    }
    r.status = RunningStatus::iteration_limit;
    return slip;
  }

  std::vector<RollerPush> push() && { return std::move(push_); }

 private:
  RunningLoads& running() { return *loaded_.running; }
  PerInterface<InterfaceLoads>& threads() { return *loaded_.threads; }

  /// Follows loads with friction in the proportion tau_i = T_i/N_i of the last slip, whose change then is that of the
  /// round. Returns false if there are none. `slow`: whether the last rounds changed the loads hardly less than earlier
  /// ones.
  bool follow(const RunningBodies& bodies, const std::vector<double>& centrifugal, bool slow, BodyAnswer& answer) {
    RunningLoads& r = running();
    const PerInterface<std::vector<double>> start = answer.normal_load;
    PerInterface<std::vector<double>> before = start;
    const PerInterface<FrictionForces> given{*threads().screw.friction, *threads().nut.friction};
    const auto set_in_proportion = [&](const PerInterface<std::vector<double>>& normal_load) {
      for (const Interface i : kInterfaces)
        for (const auto k : indices(normal_load[i])) {
          const double times = start[i][k] > 0.0 ? normal_load[i][k] / start[i][k] : 0.0;
          for (const auto& [force, _] : kFrictionComponents)
            ((*threads()[i].friction).*force)[k] = times * (given[i].*force)[k];
        }
    };
    if (bodies.follow) {
      PerInterface<std::vector<double>> unit = start;
      for (const Interface i : kInterfaces) std::ranges::fill(unit[i], 1.0);
      set_in_proportion(unit);
      VectorXd tau = forces(centrifugal);
      if (slow) tau = rounds_.next(last_tau_, tau);
      last_tau_ = tau;
      take(tau);
      if (std::optional<BodyAnswer> found = bodies.follow(push_)) {
        answer = std::move(*found);
        r.change = largest_change(answer.normal_load, start);
        set_in_proportion(answer.normal_load);
        take(forces(centrifugal));
        return true;
      }
      set_in_proportion(start);
    }
    Anderson anderson;
    VectorXd x = forces(centrifugal);
    for (int step = 0; step < kMostRounds; ++step) {
      take(x);
      answer = bodies.go_on(push_);
      if (answer.status != fe::NewtonStatus::converged) {
        r.status = running_status(answer.status);
        return false;
      }
      const double change = largest_change(answer.normal_load, before);
      r.change = largest_change(answer.normal_load, start);
      before = answer.normal_load;
      set_in_proportion(before);
      if (change <= std::max(kShare * r.change, 0.1 * kTolerance)) return true;
      x = anderson.next(x, forces(centrifugal));
    }
    r.status = RunningStatus::iteration_limit;
    return false;
  }

  /// Largest change, over the largest load.
  static double largest_change(const PerInterface<std::vector<double>>& now,
                               const PerInterface<std::vector<double>>& before) {
    double change = 0.0, load = 0.0;
    for (const Interface i : kInterfaces)
      for (const auto k : indices(now[i])) {
        change = std::max(change, std::abs(now[i][k] - before[i][k]));
        load = std::max(load, now[i][k]);
      }
    if (load > 0.0) return change / load;
    return change > 0.0 ? 1.0 : 0.0;
  }

  /// Models of slip on these loads. If the file states the angle of a normal, F_i is that of the sector, |s cos(psi)
  /// N_i +- T_x,i|.
  std::vector<Slipping> slipping_on(const BodyAnswer& answer) {
    running().guide_force = answer.guide_force;
    const double named = sense(*loaded_.load_case.direction);
    for (const Interface i : kInterfaces) {
      InterfaceLoads& loads = threads()[i];
      loads.normal_load = answer.normal_load[i];
      const double cosine = std::cos(loads.normal_angle);
      for (const auto p : indices(rollers_.present))
        for (const auto k : up_to(rollers_.threads)) {
          const double s = rollers_.of_flanks() && p > 0 ? -named : named;
          const std::size_t at = rollers_.present[p] * rollers_.threads + k;
          const double friction = (i == Interface::screw ? 1.0 : -1.0) * push_[p].axial[i][k];
          loads.axial_load[at] = std::abs(s * cosine * loads.normal_load[at] + friction);
        }
    }
    std::vector<Slipping> nuts;
    for (SlipModel& model : models_.of_nuts(loaded_)) {
      const bool is_named = (model.axial_force < 0.0) == (named > 0.0);
      const bool other = rollers_.rows == RunningRollers::Rows::nuts && !is_named;
      nuts.push_back({std::move(model), other ? rollers_.threads : 0});
    }
    return nuts;
  }

  /// Sets T_i = N_i (n - m_i) of each thread.
  void set_friction(const Slipping& nut, const SlipEquilibrium& found) {
    for (const Interface i : kInterfaces) {
      const LoadedThreads& t = nut.model.threads[i];
      FrictionForces& friction = *threads()[i].friction;
      for (const auto& [force, axis] : kFrictionComponents) {
        std::vector<double>& values = friction.*force;
        values.resize(threads()[i].normal_load.size());
        for (const auto k : indices(t.patch_of_thread)) {
          double& value = values[nut.first + k] = 0.0;
          const std::optional<std::size_t> patch = t.patch_of_thread[k];
          if (!patch) continue;
          const contact::PatchFriction& f = found.balance.patches[i].friction[*patch];
          const ContactFrameOf<double>& frame = nut.model.frame(i, t.contacts[*patch]);
          value = threads()[i].normal_load[nut.first + k] *
                  (f.traction_major * frame.major_axis.*axis + f.traction_minor * frame.minor_axis.*axis);
        }
      }
    }
  }

  /// Sets F_i = N_i |m_z,i| of converged loads, friction included.
  void set_axial_loads(const Slipping& nut) {
    const double unit = std::abs(loaded_.load_case.axial_force) / loaded_rollers(contacts_.mechanism);
    for (const Interface i : kInterfaces) {
      InterfaceLoads& loads = threads()[i];
      const LoadedThreads& t = nut.model.threads[i];
      for (const auto k : indices(t.patch_of_thread)) {
        const std::size_t at = nut.first + k;
        if (!c_.contact.normal_angle[i])
          loads.axial_load[at] =
              t.patch_of_thread[k]
                  ? std::abs(loads.normal_load[at] * nut.model.frame(i, t.contacts[*t.patch_of_thread[k]]).normal.z -
                             loads.friction->axial[at])
                  : 0.0;
        loads.load_rate[at] = loads.axial_load[at] / unit;
      }
    }
  }

  /// Vector of all unknown forces, the centrifugal ones of the rows last [N].
  VectorXd forces(const std::vector<double>& centrifugal) const {
    std::vector<double> all;
    for (const std::size_t roller : rollers_.present)
      for (const Interface i : kInterfaces) {
        const FrictionForces& friction = *(*loaded_.threads)[i].friction;
        for (const auto* values : {&friction.axial, &friction.radial}) {
          const auto first = values->begin() + static_cast<std::ptrdiff_t>(roller * rollers_.threads);
          all.insert(all.end(), first, first + static_cast<std::ptrdiff_t>(rollers_.threads));
        }
      }
    append(all, centrifugal);
    return Eigen::Map<VectorXd>(all.data(), std::ssize(all));
  }
  void take(const VectorXd& x) {
    Eigen::Index next = 0;
    for (RollerPush& push : push_) {
      for (const Interface i : kInterfaces)
        for (auto* values : {&push.axial[i], &push.radial[i]})
          for (double& value : *values) value = x[next++];
    }
    for (RollerPush& push : push_) {
      push.of_thread = thread_share_ * x[next];
      push.of_heads = head_share_ * x[next++];
    }
  }

  const Conditions& c_;
  const Contacts& contacts_;
  const SlipModels& models_;
  RunningRollers rollers_;
  LoadCaseResult& loaded_;
  std::vector<RollerPush> push_;  ///< Push on each present roller.
  Anderson rounds_;
  VectorXd last_tau_;
  double thread_share_ = 0.0, head_share_ = 0.0;  ///< Shares of a roller's mass per length [1/m].
};

}  // namespace

RunningEquilibrium running_equilibrium(const Conditions& c, const Contacts& contacts, const SlipModels& models,
                                       RunningRollers rollers, BodyAnswer at_rest, const RunningBodies& bodies,
                                       LoadCaseResult& loaded, SpinOfNuts& near) {
  FixedPoint point(c, contacts, models, std::move(rollers), loaded);
  RunningEquilibrium found{point.solve(std::move(at_rest), bodies, near), {}};
  found.push = std::move(point).push();
  return found;
}

RunningStatus running_status(fe::NewtonStatus status) {
  return status == fe::NewtonStatus::mechanism ? RunningStatus::mechanism : RunningStatus::no_equilibrium;
}

std::optional<double> over_static(const InterfaceLoads& running, double largest_at_rest) {
  return largest_at_rest > 0.0 ? std::optional(largest(running.normal_load) / largest_at_rest) : std::nullopt;
}

}  // namespace prs
