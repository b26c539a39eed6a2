#include "prs/slip/running.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "prs/loads/full_result.h"
#include "prs/loads/load_case_result.h"
#include "prs/sector/bodies.h"
#include "prs/mechanism/full_distribution.h"
#include "prs/sector/running_sector.h"
#include "prs/sector/section_properties.h"

namespace prs {
namespace {

/// Change of a thread's load over a round, relative to the largest load, at which to stop.
constexpr double kTolerance = 1e-10;
constexpr int kMostRounds = 100;
/// Share of a round's change down to which friction in proportion to the loads is followed.
constexpr double kShare = 0.02;

/// Anderson's acceleration of x = g(x) (Walker and Ni, SIAM J. Numer. Anal. 49, 2011, 1715): the
/// combination of the last steps for which g(x) - x vanishes as nearly as possible.
class Anderson {
 public:
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& g) {
    constexpr Eigen::Index kDepth = 3;
    const Eigen::VectorXd residual = g - x;
    if (last_g_.size() > 0) {
      const Eigen::Index kept = std::min(changes_.cols(), kDepth - 1);
      const auto append = [kept](Eigen::MatrixXd& to, const Eigen::VectorXd& column) {
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
  Eigen::VectorXd last_residual_, last_g_;
};

/// What the bodies answer to a push.
struct Answer {
  fe::NewtonStatus status = fe::NewtonStatus::iteration_limit;
  PerInterface<std::vector<double>> normal_load;   ///< As in `InterfaceLoads` [N].
  std::vector<std::array<double, 2>> guide_force;  ///< See `RunningLoads`.
};

/// Where the rollers stand among all threads.
struct Rollers {
  std::vector<std::size_t> present{0};
  std::size_t threads = 0;
};

double largest(const std::vector<double>& values) { return std::ranges::max(values); }

RunningStatus status_of(fe::NewtonStatus status) {
  return status == fe::NewtonStatus::mechanism ? RunningStatus::mechanism
                                               : RunningStatus::no_equilibrium;
}

/// The fixed point of loads and friction for one load case.
class FixedPoint {
 public:
  using Bodies = std::function<Answer(const std::vector<RollerPush>&)>;

  FixedPoint(const Conditions& c, const Contacts& contacts, const SlipModels& models,
             Rollers rollers, LoadCaseResult& loaded)
      : c_(c), contacts_(contacts), models_(models), rollers_(std::move(rollers)), loaded_(loaded) {
    running().largest_static_load = {largest(threads().screw.normal_load),
                                     largest(threads().nut.normal_load)};
    running().static_displacement = loaded.axial_displacement.value_or(0.0);
    const std::optional<double>& density = c.materials->roller.density;
    if (!density) return;
    const double volume = roller_body(contacts.mechanism, c.structure->roller).volume;
    thread_share_ = disc_area(*contacts.mechanism.pitch_diameter.roller) / volume;
    head_share_ = disc_area(c.structure->roller.end_diameter) / volume;
  }

  /// From the state at rest, which `loaded` has; its loads become those of the running screw.
  SlipEquilibrium solve(const Bodies& bodies, const std::optional<double>& near) {
    RunningLoads& r = running();
    SlipEquilibrium slip;
    std::optional<double> slip_ratio = near;
    push_ = std::vector<RollerPush>(rollers_.present.size(), no_push());
    Answer answer{fe::NewtonStatus::converged,
                  {threads().screw.normal_load, threads().nut.normal_load},
                  r.guide_force};
    for (r.rounds = 1; r.rounds <= kMostRounds; ++r.rounds) {
      const SlipModel model = model_on(answer);
      slip = find_slip_equilibrium(model, slip_ratio);
      if (!slip.ok()) {
        r.status = slip.status == SlipStatus::jammed ? RunningStatus::jammed
                                                     : RunningStatus::slip_no_equilibrium;
        return slip;
      }
      slip_ratio = slip.balance.motion.slip_ratio;
      set_friction(model, slip);
      if (!follow(bodies, slip.balance.forces.centrifugal, answer)) return slip;
      if (r.change > kTolerance) continue;
      for (const Interface i : kInterfaces) threads()[i].normal_load = answer.normal_load[i];
      r.guide_force = answer.guide_force;
      r.status = RunningStatus::converged;
      set_axial_loads(model);
      return slip;
    }
    r.status = RunningStatus::iteration_limit;
    return slip;
  }

  const std::vector<RollerPush>& push() const { return push_; }

 private:
  RunningLoads& running() { return *loaded_.running; }
  PerInterface<InterfaceLoads>& threads() { return *loaded_.threads; }

  /// Loads with friction in the proportion tau_i = T_i/N_i of the last slip, whose change then is
  /// that of the round. False where there are none.
  bool follow(const Bodies& bodies, double centrifugal, Answer& answer) {
    RunningLoads& r = running();
    const PerInterface<std::vector<double>> start = answer.normal_load;
    PerInterface<std::vector<double>> before = start;
    const PerInterface<RunningLoads::Friction> given = r.friction;
    Anderson anderson;
    Eigen::VectorXd x = vector_of(pushes(r.friction), centrifugal);
    for (int step = 0; step < kMostRounds; ++step) {
      take(x);
      answer = bodies(push_);
      if (answer.status != fe::NewtonStatus::converged) {
        r.status = status_of(answer.status);
        return false;
      }
      const double change = largest_change(answer.normal_load, before);
      r.change = largest_change(answer.normal_load, start);
      before = answer.normal_load;
      for (const Interface i : kInterfaces)
        for (std::size_t k = 0; k < before[i].size(); ++k) {
          const double times = start[i][k] > 0.0 ? before[i][k] / start[i][k] : 0.0;
          r.friction[i].axial[k] = times * given[i].axial[k];
          r.friction[i].radial[k] = times * given[i].radial[k];
          r.friction[i].tangential[k] = times * given[i].tangential[k];
        }
      if (change <= std::max(kShare * r.change, 0.1 * kTolerance)) return true;
      x = anderson.next(x, vector_of(pushes(r.friction), centrifugal));
    }
    r.status = RunningStatus::iteration_limit;
    return false;
  }

  /// Over the largest load.
  static double largest_change(const PerInterface<std::vector<double>>& now,
                               const PerInterface<std::vector<double>>& before) {
    double change = 0.0, load = 0.0;
    for (const Interface i : kInterfaces)
      for (std::size_t k = 0; k < now[i].size(); ++k) {
        change = std::max(change, std::abs(now[i][k] - before[i][k]));
        load = std::max(load, now[i][k]);
      }
    return change / load;
  }

  RollerPush no_push() const {
    const std::vector<double> none(rollers_.threads, 0.0);
    return {{none, none}, {none, none}};
  }

  /// The model of slip on these loads. Where the file states the angle of a normal, F_i is that of
  /// the sector, |s cos(psi) N_i +- T_x,i|.
  SlipModel model_on(const Answer& answer) {
    running().guide_force = answer.guide_force;
    const double s = sense(*loaded_.load_case.direction);
    for (const Interface i : kInterfaces) {
      InterfaceLoads& loads = threads()[i];
      loads.normal_load = answer.normal_load[i];
      const double cosine = std::cos(loads.normal_angle);
      for (std::size_t p = 0; p < rollers_.present.size(); ++p)
        for (std::size_t k = 0; k < rollers_.threads; ++k) {
          const std::size_t at = rollers_.present[p] * rollers_.threads + k;
          const double friction = (i == Interface::screw ? 1.0 : -1.0) * push_[p].axial[i][k];
          loads.axial_load[at] = std::abs(s * cosine * loads.normal_load[at] + friction);
        }
    }
    return models_.of(loaded_);
  }

  /// T_i = N_i (n - m_i) of each thread.
  void set_friction(const SlipModel& model, const SlipEquilibrium& slip) {
    for (const Interface i : kInterfaces) {
      const LoadedThreads& t = model.threads[i];
      RunningLoads::Friction& friction = running().friction[i];
      const std::size_t count = t.patch_of_thread.size();
      for (auto* values : {&friction.axial, &friction.radial, &friction.tangential})
        values->assign(count, 0.0);
      for (std::size_t k = 0; k < count; ++k) {
        if (!t.patch_of_thread[k]) continue;
        const contact::PatchFriction& f =
            slip.balance.patches[i].friction[*t.patch_of_thread[k]];
        const double major = threads()[i].normal_load[k] * f.traction_major;
        const double minor = threads()[i].normal_load[k] * f.traction_minor;
        const ContactFrameOf<double>& frame = model.frames[i];
        friction.radial[k] = major * frame.major_axis.x + minor * frame.minor_axis.x;
        friction.tangential[k] = major * frame.major_axis.y + minor * frame.minor_axis.y;
        friction.axial[k] = major * frame.major_axis.z + minor * frame.minor_axis.z;
      }
    }
  }

  /// F_i = N_i |m_z,i| of converged loads, friction included.
  void set_axial_loads(const SlipModel& model) {
    const double unit = std::abs(model.axial_force) / contacts_.mechanism.rollers;
    for (const Interface i : kInterfaces) {
      InterfaceLoads& loads = threads()[i];
      const std::vector<double>& friction = running().friction[i].axial;
      for (std::size_t k = 0; k < loads.axial_load.size(); ++k) {
        if (!c_.contact.normal_angle[i])
          loads.axial_load[k] =
              std::abs(loads.normal_load[k] * model.frames[i].normal.z - friction[k]);
        loads.load_rate[k] = loads.axial_load[k] / unit;
      }
    }
  }

  std::vector<RollerPush> pushes(const PerInterface<RunningLoads::Friction>& friction) const {
    std::vector<RollerPush> all;
    for (const std::size_t roller : rollers_.present) {
      RollerPush& push = all.emplace_back();
      const auto part = [&](const std::vector<double>& values) {
        const auto first = values.begin() + static_cast<std::ptrdiff_t>(roller * rollers_.threads);
        return std::vector<double>(first, first + static_cast<std::ptrdiff_t>(rollers_.threads));
      };
      for (const Interface i : kInterfaces) {
        push.axial[i] = part(friction[i].axial);
        push.radial[i] = part(friction[i].radial);
      }
    }
    return all;
  }

  /// All unknown forces, the centrifugal one of a roller last [N].
  Eigen::VectorXd vector_of(const std::vector<RollerPush>& pushes, double centrifugal) const {
    std::vector<double> all;
    for (const RollerPush& push : pushes)
      for (const Interface i : kInterfaces) {
        all.insert(all.end(), push.axial[i].begin(), push.axial[i].end());
        all.insert(all.end(), push.radial[i].begin(), push.radial[i].end());
      }
    all.push_back(centrifugal);
    return Eigen::Map<Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
  }
  void take(const Eigen::VectorXd& x) {
    Eigen::Index next = 0;
    for (RollerPush& push : push_) {
      for (const Interface i : kInterfaces)
        for (auto* values : {&push.axial[i], &push.radial[i]})
          for (double& value : *values) value = x[next++];
      push.of_thread = thread_share_ * x[x.size() - 1];
      push.of_heads = head_share_ * x[x.size() - 1];
    }
  }

  const Conditions& c_;
  const Contacts& contacts_;
  const SlipModels& models_;
  Rollers rollers_;
  LoadCaseResult& loaded_;
  std::vector<RollerPush> push_;                     ///< On each roller present.
  double thread_share_ = 0.0, head_share_ = 0.0;     ///< Of a roller's mass per length [1/m].
};

/// Without loads.
LoadCaseResult not_running(LoadCaseResult rest) {
  const fe::NewtonStatus status = rest.solve->status;
  if (!rest.threads) rest.running->status = status_of(status);
  rest.threads.reset();
  rest.full.reset();
  rest.axial_displacement = rest.axial_stiffness = rest.tangent_stiffness = {};
  return rest;
}

/// Loads that stand on friction, with axial forces as slip has them.
LoadCaseResult with_friction(LoadCaseResult loaded, LoadCaseResult slipped) {
  for (const Interface i : kInterfaces) {
    (*loaded.threads)[i].axial_load = std::move((*slipped.threads)[i].axial_load);
    (*loaded.threads)[i].load_rate = std::move((*slipped.threads)[i].load_rate);
  }
  loaded.running = std::move(slipped.running);
  return loaded;
}

}  // namespace

std::string_view name(RunningStatus status) {
  constexpr std::string_view kNames[] = {"converged", "iteration_limit", "slip_no_equilibrium",
                                         "jammed",    "no_equilibrium",  "mechanism"};
  return kNames[static_cast<std::size_t>(status)];
}

LoadCaseResult RunningSolver::solve(const LoadCase& load_case,
                                    std::optional<SlipEquilibrium>& slip) {
  return conditions_.model.mechanism == ModelOptions::Mechanism::full
             ? of_all_rollers(load_case, slip)
             : of_sector(load_case, slip);
}

LoadCaseResult RunningSolver::of_sector(const LoadCase& load_case,
                                        std::optional<SlipEquilibrium>& slip) {
  std::unique_ptr<SectorSolver>& kept = sectors_[{*load_case.direction, *load_case.position}];
  if (!kept)
    kept = std::make_unique<SectorSolver>(build_sector(
        sector_model(contacts_.mechanism, *conditions_.structure, *conditions_.materials,
                     conditions_.model, laws_, *load_case.direction, *load_case.position,
                     conditions_.deviations)));
  SectorSolver& solver = *kept;
  const auto threads = static_cast<std::size_t>(solver.sector().contacts());
  const auto forces_on_guides = [&](const RollerPush& push) {
    std::vector<std::array<double, 2>> all;
    if (const auto guides =
            guide_forces(solver.sector(), solver.equations(), solver.state(), push))
      all.push_back(*guides);
    return all;
  };

  const double force = load_case.axial_force;
  const PerInterface<std::vector<double>> none(
      {std::vector<double>(threads, 0.0), std::vector<double>(threads, 0.0)});
  LoadCaseResult rest = solved_result(load_case, contacts_, laws_, solver.solve(force));
  rest.running.emplace();
  rest.running->guide_force = forces_on_guides({none, none});
  if (!rest.threads) return not_running(std::move(rest));

  fe::NewtonSummary last;
  FixedPoint point(conditions_, contacts_, models_, {{0}, threads}, rest);
  slip = point.solve(
      [&](const std::vector<RollerPush>& push) {
        last = solver.go_on(force, push_loads(solver.sector(), push.front()));
        Answer answer{last.status, {}, forces_on_guides(push.front())};
        for (const Interface i : kInterfaces)
          for (int k = 0; k < solver.sector().contacts(); ++k)
            answer.normal_load[i].push_back(
                solver.equations().response(solver.state(), solver.sector().spring(i, k)).force);
        return answer;
      },
      last_slip_ratio_);
  if (!rest.running->converged()) return not_running(std::move(rest));
  last_slip_ratio_ = slip->balance.motion.slip_ratio;
  LoadDistribution d = solver.at(solver.state(), force);
  d.solve = std::move(last);
  return with_friction(solved_result(load_case, contacts_, laws_, std::move(d)), std::move(rest));
}

LoadCaseResult RunningSolver::of_all_rollers(const LoadCase& load_case,
                                             std::optional<SlipEquilibrium>& slip) {
  FullSolver solver(FullStart::neighbour);
  const auto result = [&](Detail detail, const std::vector<RollerPush>& push) {
    return full_result(load_case, conditions_, contacts_, laws_, solver, detail, push);
  };
  Rollers rollers{{}, static_cast<std::size_t>(contacts_.mechanism.contacts_per_roller)};
  for (int r = 0; r < contacts_.mechanism.rollers; ++r)
    if (std::ranges::find(conditions_.deviations.missing_rollers, r + 1) ==
        conditions_.deviations.missing_rollers.end())
      rollers.present.push_back(static_cast<std::size_t>(r));
  const auto forces_on_guides = [&](const std::array<RingForce, 2>& rings) {
    std::vector<std::array<double, 2>> all;
    if (conditions_.model.roller == ModelOptions::Roller::flexible)
      for (const std::size_t r : rollers.present)
        all.push_back({rings[0].rollers[r], rings[1].rollers[r]});
    return all;
  };

  LoadCaseResult rest = result(Detail::numbers, {});
  rest.running.emplace();
  if (!rest.threads) return not_running(std::move(rest));
  rest.running->guide_force = forces_on_guides(rest.full->rings);
  FixedPoint point(conditions_, contacts_, models_, rollers, rest);
  slip = point.solve(
      [&](const std::vector<RollerPush>& push) {
        FullDistribution d = full_distribution(load_case, conditions_, contacts_, laws_, solver,
                                               Detail::numbers, push);
        Answer answer{d.solve.status, {}, forces_on_guides(d.rings)};
        for (const Interface i : kInterfaces)
          for (const std::vector<double>& roller : d.normal_load[i])
            answer.normal_load[i].insert(answer.normal_load[i].end(), roller.begin(), roller.end());
        return answer;
      },
      last_slip_ratio_);
  if (!rest.running->converged()) return not_running(std::move(rest));
  last_slip_ratio_ = slip->balance.motion.slip_ratio;
  return with_friction(result(Detail::complete, point.push()), std::move(rest));
}

}  // namespace prs
