#include "prs/slip/running.h"

#include <Eigen/QR>

#include "prs/indices.h"
#include "prs/slip/slip.h"
#include "prs/slip/slip_warnings.h"

namespace prs {
namespace {

using Eigen::VectorXd;
using fe::NewtonStatus;

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

/// Response of the bodies to a push.
struct Answer {
  NewtonStatus status = NewtonStatus::iteration_limit;
  PerInterface<std::vector<double>> normal_load;   ///< Loads as in `InterfaceLoads` [N].
  std::vector<std::array<double, 2>> guide_force;  ///< See `RunningLoads`.
};

/// Indices of the rollers among all threads; under preload rows are the flank that the load names and the other one.
struct Rollers {
  std::vector<std::size_t> present{0};
  std::size_t threads = 0;
  enum class Rows { rollers, flanks, nuts } rows = Rows::rollers;

  bool of_flanks() const { return rows != Rows::rollers; }
};

/// Rollers of one nut, which slip alike; their threads start at `first` among all.
struct Slipping {
  SlipModel model;
  std::size_t first = 0;
};

/// A component of friction and its axis.
struct Component {
  std::vector<double> FrictionForces::*force;
  double contact::Vector3<double>::*axis;
};
constexpr Component kComponents[] = {{&FrictionForces::radial, &contact::Vector3<double>::x},
                                     {&FrictionForces::tangential, &contact::Vector3<double>::y},
                                     {&FrictionForces::axial, &contact::Vector3<double>::z}};

double largest(const std::vector<double>& values) { return std::ranges::max(values); }

std::optional<double> over_static(const InterfaceLoads& running, double largest_at_rest) {
  return largest_at_rest > 0.0 ? std::optional(largest(running.normal_load) / largest_at_rest) : std::nullopt;
}

RunningStatus status_of(NewtonStatus status) {
  return status == NewtonStatus::mechanism ? RunningStatus::mechanism : RunningStatus::no_equilibrium;
}

RollerPush no_push(std::size_t threads) {
  const std::vector<double> none(threads, 0.0);
  return {{none, none}, {none, none}};
}

/// The fixed point of loads and friction for one load case.
class FixedPoint {
 public:
  using Bodies = std::function<Answer(const std::vector<RollerPush>&)>;
  using Turned = std::function<std::optional<Answer>(const std::vector<RollerPush>&)>;

  FixedPoint(const Conditions& c, const Contacts& contacts, const SlipModels& models, Rollers rollers,
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

  /// Solves from the state at rest, which `loaded` has; its loads become those of the running screw.
  /// One equilibrium for each nut. `near`: the last slip ratio that was found. `turned`, where it is given: the answer
  /// to friction in these proportions to the normal loads; none where it must be followed step by step.
  std::vector<SlipEquilibrium> solve(Answer answer, const Bodies& bodies, const Turned& turned,
                                     std::optional<double>& near) {
    RunningLoads& r = running();
    std::vector<SlipEquilibrium> slip;
    std::vector<std::optional<double>> slip_ratio(2, near);
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
          found.balance.motion.slip_ratio = *slip_ratio[n];
          next = next_slip_ratio(model, found);
        }
        if (!next) {
          found = find_slip_equilibrium(model, slip_ratio[n]);
          if (!found.ok()) {
            r.status = found.status == SlipStatus::jammed ? RunningStatus::jammed : RunningStatus::slip_no_equilibrium;
            return slip;
          }
          next = found.balance.motion.slip_ratio;
        }
        missed = std::max(missed, std::abs(*next - found.balance.motion.slip_ratio));
        slip_ratio[n] = next;
        set_friction(nuts[n], found);
        const double force = found.balance.forces.centrifugal;
        if (rollers_.of_flanks())
          centrifugal[nuts[n].first / rollers_.threads] = force;
        else
          centrifugal.assign(push_.size(), force);
      }
      if (!follow(bodies, turned, centrifugal, anew && r.rounds > 3 && before > kTolerance, answer)) return slip;
      anew = r.rounds > 1 && (r.change > 0.3 * before || r.change <= kTolerance);
      if (r.change > kTolerance || missed > kSlipMissed) continue;
      for (const Interface i : kInterfaces) threads()[i].normal_load = answer.normal_load[i];
      r.guide_force = answer.guide_force;
      r.status = RunningStatus::converged;
      near = slip.front().balance.motion.slip_ratio;
      for (const Slipping& nut : nuts) set_axial_loads(nut);
      for (const Interface i : kInterfaces)
        threads()[i].running_over_static = over_static(threads()[i], r.at_rest.largest_normal_load[i]);
      return slip;
    }
    r.status = RunningStatus::iteration_limit;
    return slip;
  }

  const std::vector<RollerPush>& push() const { return push_; }

 private:
  RunningLoads& running() { return *loaded_.running; }
  PerInterface<InterfaceLoads>& threads() { return *loaded_.threads; }

  /// Follows loads with friction in the proportion tau_i = T_i/N_i of the last slip, whose change then is that of the
  /// round. Returns false if there are none. `slow`: whether the last rounds changed the loads hardly less than earlier
  /// ones.
  bool follow(const Bodies& bodies, const Turned& turned, const std::vector<double>& centrifugal, bool slow,
              Answer& answer) {
    RunningLoads& r = running();
    const PerInterface<std::vector<double>> start = answer.normal_load;
    PerInterface<std::vector<double>> before = start;
    const PerInterface<FrictionForces> given{*threads().screw.friction, *threads().nut.friction};
    const auto set_in_proportion = [&](const PerInterface<std::vector<double>>& normal_load) {
      for (const Interface i : kInterfaces)
        for (const auto k : indices(normal_load[i])) {
          const double times = start[i][k] > 0.0 ? normal_load[i][k] / start[i][k] : 0.0;
          for (const auto& [force, _] : kComponents)
            ((*threads()[i].friction).*force)[k] = times * (given[i].*force)[k];
        }
    };
    if (turned) {
      PerInterface<std::vector<double>> unit = start;
      for (const Interface i : kInterfaces) std::ranges::fill(unit[i], 1.0);
      set_in_proportion(unit);
      VectorXd tau = forces(centrifugal);
      if (slow) tau = rounds_.next(last_tau_, tau);
      last_tau_ = tau;
      take(tau);
      if (std::optional<Answer> found = turned(push_)) {
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
      answer = bodies(push_);
      if (answer.status != NewtonStatus::converged) {
        r.status = status_of(answer.status);
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
  std::vector<Slipping> slipping_on(const Answer& answer) {
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
      const bool other = rollers_.rows == Rollers::Rows::nuts && !is_named;
      nuts.push_back({std::move(model), other ? rollers_.threads : 0});
    }
    return nuts;
  }

  /// Sets T_i = N_i (n - m_i) of each thread.
  void set_friction(const Slipping& nut, const SlipEquilibrium& found) {
    for (const Interface i : kInterfaces) {
      const LoadedThreads& t = nut.model.threads[i];
      FrictionForces& friction = *threads()[i].friction;
      for (const auto& [force, axis] : kComponents) {
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
  Rollers rollers_;
  LoadCaseResult& loaded_;
  std::vector<RollerPush> push_;  ///< Push on each present roller.
  Anderson rounds_;
  VectorXd last_tau_;
  double thread_share_ = 0.0, head_share_ = 0.0;  ///< Shares of a roller's mass per length [1/m].
};

/// Reason why there are no loads of a running screw, if those at rest are known.
Warning why_not_running(const RunningLoads& r) {
  switch (r.status) {
    case RunningStatus::jammed:
    case RunningStatus::slip_no_equilibrium:
      return no_slip(r.status == RunningStatus::jammed, "running loads");
    case RunningStatus::iteration_limit:
      return Warning{"friction", "running_iteration_limit",
                     "running loads do not converge: a load still changes by {value} of the largest "
                     "in a round"}
          .with(r.change);
    default:
      return {"friction", "running_no_equilibrium",
              "running loads: with this friction no loads of the threads are in equilibrium"};
  }
}

/// Result without loads.
LoadCaseResult not_running(LoadCaseResult rest) {
  if (rest.threads)
    rest.warnings.push_back(why_not_running(*rest.running));
  else
    rest.running->status = status_of(rest.solve->status);
  rest.threads.reset();
  rest.full.reset();
  rest.axial_displacement = rest.axial_stiffness = rest.tangent_stiffness = {};
  return rest;
}

/// Result with running loads, with axial forces as in slip.
LoadCaseResult with_friction(LoadCaseResult loaded, LoadCaseResult slipped) {
  for (const Interface i : kInterfaces) {
    InterfaceLoads &to = (*loaded.threads)[i], &from = (*slipped.threads)[i];
    to.axial_load = std::move(from.axial_load);
    to.load_rate = std::move(from.load_rate);
    to.friction = std::move(from.friction);
    to.running_over_static = from.running_over_static;
  }
  loaded.loads = slipped.loads;
  loaded.running = std::move(slipped.running);
  return loaded;
}

/// Takes the loads at rest for those of a running screw that are to be found.
void start(LoadCaseResult& rest) {
  rest.loads = ModelOptions::Loads::running;
  RunningLoads& running = rest.running.emplace();
  if (rest.threads)
    running.at_rest = {{largest(rest.threads->screw.normal_load), largest(rest.threads->nut.normal_load)},
                       rest.axial_displacement.value_or(0.0)};
}

/// A loose screw: it turns without friction, and its loads are those at rest.
LoadCaseResult running_without_contact(LoadCaseResult rest) {
  rest.running->status = RunningStatus::converged;
  rest.running->guide_force = rest.other_flank->guide_force;
  for (const Interface i : kInterfaces) {
    InterfaceLoads& loads = (*rest.threads)[i];
    const std::vector<double> none(loads.normal_load.size(), 0.0);
    loads.friction = FrictionForces{loads.threads_per_roller, none, none, none};
  }
  return rest;
}

}  // namespace

LoadCaseResult RunningSolver::solve(const LoadCase& load_case, Detail detail, std::optional<SlipEquilibrium>& slip) {
  second_nut_.reset();
  return has_both_flanks(conditions_, load_case.share) ? of_flanks(load_case, slip)
         : conditions_.model.all_rollers()             ? of_all_rollers(load_case, detail, slip)
                                                       : of_sector(load_case, slip);
}

LoadCaseResult RunningSolver::of_flanks(const LoadCase& load_case, std::optional<SlipEquilibrium>& slip) {
  if (!flanks_) flanks_.emplace(conditions_, contacts_);
  const Direction named = *load_case.direction;
  LoadCaseResult rest = flanks_->solve(load_case);
  start(rest);
  if (!rest.threads) return not_running(std::move(rest));
  const PerInterface<double> at_rest = rest.running->at_rest.largest_normal_load;
  const std::size_t threads = rest.threads->screw.normal_load.size();
  const auto carries = [&](Interface i) {
    return at_rest[i] > 0.0 || largest(rest.other_flank->threads[i].normal_load) > 0.0;
  };
  if (std::ranges::none_of(kInterfaces, carries)) return running_without_contact(std::move(rest));
  const bool two_nuts = rest.other_flank->of_second_roller;
  Answer answer{NewtonStatus::converged, {}, rest.other_flank->guide_force};
  for (const Interface i : kInterfaces) {
    InterfaceLoads& loads = (*rest.threads)[i];
    FlankThreads& other = rest.other_flank->threads[i];
    append(loads.normal_load, other.normal_load);
    loads.axial_load.resize(2 * threads);
    loads.load_rate.resize(2 * threads);
    answer.normal_load[i] = loads.normal_load;
    other = {};
  }
  const auto of_flank = [&](const std::vector<RollerPush>& push) {
    PerDirection<RollerPush> by_direction;
    by_direction[named] = push[0];
    by_direction[opposite(named)] = push[1];
    return by_direction;
  };

  PreloadPoint last;
  FixedPoint point(conditions_, contacts_, models_,
                   {{0, 1}, threads, two_nuts ? Rollers::Rows::nuts : Rollers::Rows::flanks}, rest);
  std::vector<SlipEquilibrium> found = point.solve(
      answer,
      [&](const std::vector<RollerPush>& push) {
        last = flanks_->go_on(load_case, of_flank(push));
        Answer to{last.solve.status, {}, {}};
        if (!last.solve.converged()) return to;
        to.guide_force = flanks_->guide_forces(last, named, of_flank(push));
        for (const Interface i : kInterfaces)
          for (const Direction d : {named, opposite(named)}) append(to.normal_load[i], last.sides[d].normal_load[i]);
        return to;
      },
      {}, last_slip_ratio_);
  if (!rest.running->converged()) {
    rest.other_flank.reset();
    return not_running(std::move(rest));
  }
  slip = std::move(found.front());
  if (two_nuts) second_nut_ = std::move(found.back());

  LoadCaseResult loaded = both_flanks_result(load_case, contacts_, laws_, std::move(last));
  loaded.other_flank->of_second_roller = two_nuts;
  for (const Interface i : kInterfaces) {
    InterfaceLoads& loads = (*rest.threads)[i];
    FlankThreads& other = loaded.other_flank->threads[i];
    const auto cut = [&](std::vector<double>& values) {
      std::vector<double> behind(values.begin() + static_cast<std::ptrdiff_t>(threads), values.end());
      values.resize(threads);
      return behind;
    };
    other.normal_load = cut(loads.normal_load);
    other.axial_load = cut(loads.axial_load);
    cut(loads.load_rate);
    if (load_case.axial_force == 0.0) std::ranges::fill(loads.load_rate, kNoShare);
    for (const auto& [force, _] : kComponents) cut((*loads.friction).*force);
    loads.running_over_static = over_static(loads, at_rest[i]);
  }
  return with_friction(std::move(loaded), std::move(rest));
}

RunningSolver::SectorAt& RunningSolver::sector_at(Direction d, double position) {
  std::unique_ptr<SectorAt>& kept = sectors_[{d, position}];
  if (!kept) kept = std::make_unique<SectorAt>(LoadedSector{{conditions_, contacts_, laws_}, d, position});
  return *kept;
}

LoadCaseResult RunningSolver::of_sector(const LoadCase& load_case, std::optional<SlipEquilibrium>& slip) {
  SectorAt& at = sector_at(*load_case.direction, *load_case.position);
  RunningSector& bodies = *at.bodies;
  LoadCaseResult rest = solved_result(load_case, contacts_, laws_, bodies.at_rest(load_case.axial_force));
  start(rest);
  if (!rest.threads) return not_running(std::move(rest));
  const auto answer_to = [&](const RollerPush& push, NewtonStatus status) {
    Answer answer{status, bodies.normal_load(), {}};
    if (at.guides)
      answer.guide_force.push_back(at.guides->forces(answer.normal_load, push));
    else if (at.sector.has_loose_guides())
      answer.guide_force.push_back(bodies.guides().of_ends());
    return answer;
  };

  const auto threads = static_cast<std::size_t>(at.sector.contacts());
  FixedPoint point(conditions_, contacts_, models_, {{0}, threads}, rest);
  slip =
      point
          .solve(
              answer_to(no_push(threads), NewtonStatus::converged),
              [&](const std::vector<RollerPush>& push) { return answer_to(push.front(), bodies.go_on(push.front())); },
              [&](const std::vector<RollerPush>& per_normal_load) -> std::optional<Answer> {
                RollerPush push = per_normal_load.front();
                if (!bodies.follow(push)) return std::nullopt;
                const Answer loads = answer_to(push, NewtonStatus::converged);
                for (const Interface i : kInterfaces)
                  for (const auto k : up_to(threads)) {
                    push.axial[i][k] *= loads.normal_load[i][k];
                    push.radial[i][k] *= loads.normal_load[i][k];
                  }
                return answer_to(push, NewtonStatus::converged);
              },
              last_slip_ratio_)
          .front();
  if (!rest.running->converged()) return not_running(std::move(rest));
  return with_friction(solved_result(load_case, contacts_, laws_, bodies.loads(point.push().front())), std::move(rest));
}

/// Running loads of all rollers at one carrier angle, and the workspace of their search.
struct RunningSolver::AllRunning {
  LoadCaseResult result;
  FullDistribution loads;
  std::vector<RollerPush> push;
  std::optional<SlipEquilibrium> slip;
};

RunningSolver::AllRunning RunningSolver::all_rollers_at(const LoadCase& load_case, FullSolver& solver) {
  Rollers rollers{{}, static_cast<std::size_t>(contacts_.mechanism.contacts_per_roller)};
  const std::vector<int>& missing = conditions_.deviations.missing_rollers;
  for (int r = 0; r < contacts_.mechanism.rollers; ++r)
    if (!contains(missing, r + 1)) rollers.present.push_back(static_cast<std::size_t>(r));
  const auto forces_on_guides = [&](const std::array<RingForce, 2>& rings) {
    std::vector<std::array<double, 2>> all;
    if (conditions_.model.roller == ModelOptions::Roller::flexible)
      for (const std::size_t r : rollers.present) all.push_back({rings[0].rollers[r], rings[1].rollers[r]});
    return all;
  };

  AllRunning all;
  all.result = full_result(load_case, conditions_, contacts_, laws_, solver, Detail::numbers);
  LoadCaseResult& rest = all.result;
  start(rest);
  if (!rest.threads) {
    rest = not_running(std::move(rest));
    return all;
  }
  FixedPoint point(conditions_, contacts_, models_, rollers, rest);
  const auto under = [&](std::vector<RollerPush> push, bool RollerPush::*kind) {
    for (RollerPush& one : push) one.*kind = true;
    all.loads = full_distribution(load_case, conditions_, contacts_, laws_, solver, Detail::numbers, push);
    Answer answer{all.loads.solve.status, {}, {}};
    if (!all.loads.solve.converged()) return answer;
    answer.guide_force = forces_on_guides(all.loads.rings);
    for (const Interface i : kInterfaces)
      for (const std::vector<double>& roller : all.loads.normal_load[i]) append(answer.normal_load[i], roller);
    return answer;
  };
  all.slip = point
                 .solve(
                     {NewtonStatus::converged,
                      {rest.threads->screw.normal_load, rest.threads->nut.normal_load},
                      forces_on_guides(rest.full->rings)},
                     [&](const std::vector<RollerPush>& push) { return under(push, &RollerPush::is_trial); },
                     [&](const std::vector<RollerPush>& push) -> std::optional<Answer> {
                       Answer answer = under(push, &RollerPush::per_normal_load);
                       if (answer.status != NewtonStatus::converged) return std::nullopt;
                       return answer;
                     },
                     last_slip_ratio_)
                 .front();
  all.push = point.push();
  if (!rest.running->converged()) rest = not_running(std::move(rest));
  return all;
}

LoadCaseResult RunningSolver::of_all_rollers(const LoadCase& load_case, Detail detail,
                                             std::optional<SlipEquilibrium>& slip) {
  LoadCase here = load_case;
  here.spatial.orbit.reset();
  here.modes.reset();
  if (here.travel) here.travel->turns = 0;  // Parts as turned, without positions.
  FullSolver solver(FullStart::neighbour);
  AllRunning all = all_rollers_at(here, solver);
  slip = std::move(all.slip);
  all.result.load_case = load_case;
  if (!all.result.threads) return std::move(all.result);
  LoadCaseResult result = with_friction(full_result(load_case, conditions_, contacts_, laws_, solver, detail, all.push),
                                        std::move(all.result));
  FullLoads full = *result.full;
  set_symmetric(full, result);
  if (load_case.spatial.orbit) {
    Orbit orbit = turned(here, *load_case.spatial.orbit);
    if (orbit.converged())
      full.orbit = std::move(orbit);
    else
      result.warnings.push_back(no_orbit(*orbit.failure));
  }
  result.full = std::make_shared<const FullLoads>(std::move(full));
  return result;
}

void RunningSolver::set_symmetric(FullLoads& full, LoadCaseResult& result) const {
  Conditions nominal = conditions_;
  nominal.deviations = {};
  nominal.model.mechanism = ModelOptions::Mechanism::sector;
  LoadCase axial = result.load_case;
  axial.spatial = {};
  std::optional<SlipEquilibrium> slip;
  const SlipModels models(nominal, contacts_, models_.oils());
  const LoadCaseResult alike = RunningSolver(nominal, contacts_, models).solve(axial, Detail::numbers, slip);
  if (!alike.threads) return;
  full.symmetric = {*alike.axial_displacement, alike.tangent_stiffness, {}};
  full.symmetric_stiffness = *alike.axial_stiffness;
  for (const Interface i : kInterfaces) {
    full.symmetric.largest_normal_load[i] = largest((*alike.threads)[i].normal_load);
    RollerShares& shares = *(*result.threads)[i].rollers;
    shares.overload_factor = shares.largest_normal_load / full.symmetric.largest_normal_load[i];
  }
}

Orbit RunningSolver::turned(const LoadCase& load_case, const SpatialLoad::Orbit& wanted) {
  FullSolver solver(FullStart::neighbour);
  const auto solved = [&](double carrier_angle) {
    LoadCase at = load_case;
    at.spatial.carrier_angle = carrier_angle;
    at.spatial.orbit.reset();
    AllRunning all = all_rollers_at(at, solver);
    if (all.result.threads) return std::move(all.loads);
    FullDistribution failed;
    failed.reason = fmt::format("running loads end as {}", name(all.result.running->status));
    return failed;
  };
  return full_orbit(load_case, conditions_, contacts_, laws_, solved, wanted);
}

namespace {

bool has_slip_ratio_to_find(const LoadCase& load) {
  return load.travel && std::isnan(load.travel->stated_slip_ratio) &&
         load.travel->slip_ratio != Travel::SlipRatio::rolling;
}

}  // namespace

std::optional<Conditions> with_slip_ratios(const Conditions& c, const Contacts& contacts) {
  if (std::ranges::none_of(c.load_cases, has_slip_ratio_to_find)) return std::nullopt;
  Conditions stated = c;
  for (LoadCase& load : stated.load_cases) {
    if (!has_slip_ratio_to_find(load)) continue;
    double& found = load.travel->stated_slip_ratio;
    if (load.travel->slip_ratio == Travel::SlipRatio::ideal) {
      found = ideal_slip_ratio(kinematic_geometry(contacts, axial_force_on_nut(load)));
      continue;
    }
    const std::optional<SlipResult> slip = slip_alone(c, contacts, load);
    if (!slip || !slip->converged())
      throw CaseError(path_in(load, "travel.slip_ratio"),
                      "got solved, but `slip` finds none for this load case; expected a number from "
                      "0 to 1, rolling or ideal; write one of them");
    found = slip->slip_ratio;
  }
  return stated;
}

Result analyze_loads(const Conditions& c, Contacts contacts, AnalysisOptions options) {
  if (const auto stated = with_slip_ratios(c, contacts)) return analyze_loads(*stated, std::move(contacts), options);
  const auto runs = [&](const LoadCase& load) { return solve_takes_running_loads(c.model, load.share); };
  if (std::ranges::none_of(c.load_cases, runs)) return analyze(c, std::move(contacts), options);
  require_rolling(c, contacts);
  Result result = analyze(c, std::move(contacts), options, runs);
  const SlipModels models(c, result.contacts);
  Conditions alone = c;  // `solve` has one flank, even if the other one is closed too.
  alone.preload.reset();
  RunningSolver solver(alone, result.contacts, models);
  for (LoadCaseResult& loaded : result.load_cases) {
    if (!runs(loaded.load_case)) continue;
    std::optional<SlipEquilibrium> slip;
    loaded = solver.solve(loaded.load_case, options.detail, slip);
    if (options.detail == Detail::complete) add_warnings(loaded, result.contacts);
  }
  return result;
}

}  // namespace prs
