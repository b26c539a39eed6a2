#include "prs/loads/full_result.h"

#include "prs/bodies/body_solver.h"
#include "prs/indices.h"
#include "prs/loads/analyze.h"
#include "prs/mechanism/full_influence.h"

namespace prs {
namespace {

/// Difference of loads, relative, that is only rounding.
constexpr double kSameLoad = 1e-9;

/// Share of the mean load below which a thread carries nothing.
constexpr double kUnloaded = 1e-6;

std::vector<double> flat(const RollerThreads& values) {
  std::vector<double> all;
  for (const std::vector<double>& roller : values) all.insert(all.end(), roller.begin(), roller.end());
  return all;
}

RollerShares roller_shares(const InterfaceLoads& loads, const FullModel& f, double symmetric) {
  RollerShares s;
  s.missing = f.rollers - static_cast<int>(f.present.size());
  const auto threads = static_cast<std::size_t>(f.threads());
  s.share.assign(static_cast<std::size_t>(f.rollers), 0.0);
  const double unloaded = kUnloaded * f.axial_force / (static_cast<double>(f.rollers) * f.threads());
  for (const FullModel::Roller& r : f.present)
    for (const auto k : up_to(threads)) {
      const auto roller = static_cast<std::size_t>(r.number);
      const std::size_t at = roller * threads + k;
      s.share[roller] += loads.axial_load[at] / f.axial_force;
      if (loads.axial_load[at] <= unloaded) ++s.unloaded_threads;
      if (loads.normal_load[at] <= s.largest_normal_load * (1.0 + kSameLoad)) continue;
      s.largest_normal_load = loads.normal_load[at];
      s.largest_roller = r.number + 1;
      s.largest_thread = static_cast<int>(k) + 1;
    }
  s.overload_factor = s.largest_normal_load / symmetric;
  return s;
}

/// Force between bearings, over the axial force, beyond which balances have less than nine digits.
constexpr double kForcedBearing = 1e3;

std::optional<Warning> forced_bearings(const std::vector<SupportForce>& bearings, double axial_force) {
  double largest = 0.0;
  for (const SupportForce& b : bearings) largest = std::max(largest, b.force.norm());
  if (largest <= kForcedBearing * axial_force) return std::nullopt;
  return Warning{"structure.screw.bearings", "forced_bearings",
                 fmt::format("they push against each other with {{value}}, {:.2g} times the axial "
                             "force",
                             largest / axial_force),
                 "check their `offset`, or give them a stiffness in place of `lateral: rigid`"}
      .with(largest, {}, "kN"_unit);
}

std::optional<Warning> lifted_shoulder(const Structure::Nut& nut, const SupportForce& seat) {
  const double held = lifting_moment(nut, seat);
  const double moment = std::hypot(seat.moment.y, seat.moment.z);
  if (moment <= held) return std::nullopt;
  return Warning{"structure.nut.shoulder", "lifted_shoulder",
                 "the moment of {value} lifts one side of a shoulder that only pushes, "
                 "from {limit} on; the model holds it there, as bolts do"}
      .with(moment, held, "N m"_unit);
}

/// Whether no roller has deviations of its own.
bool alike(const Deviations& d) {
  return d.roller_diameters.empty() && d.roller_position.near.empty() && d.roller_position.far.empty() &&
         d.missing_rollers.empty() && d.pitch_error.roller.lists.empty() && d.turning.rollers == TurningRollers{};
}

/// Whether nothing but the rollers depends on the azimuth, so that all turns with the carrier.
bool is_round(const Conditions& c, const SpatialLoad& load) {
  const auto none = [](const Lateral& l) { return l.y == 0.0 && l.z == 0.0; };
  const Deviations& d = c.deviations;
  return none(load.side_force.value) && none(load.moment.value) && none(load.eccentricity) && none(load.nut_tilt) &&
         none(load.nut_offset) && none(d.thread_eccentricity.screw) && none(d.thread_eccentricity.nut) &&
         d.index_error.screw.empty() && d.index_error.nut.empty() && d.turning == Turning{} &&
         c.model.contact_phase == ModelOptions::ContactPhase::equal &&
         std::ranges::all_of(c.structure->screw.bearings,
                             [&](const Bearing& b) { return none(b.offset) && none(b.angle); });
}

/// A load case on all rollers, its models solved one after the other.
class AllRollers {
 public:
  AllRollers(const LoadCase& load_case, const Conditions& c, const Contacts& contacts,
             const PerInterface<ContactLaw>& laws, FullSolver& solver, const std::vector<RollerPush>& push = {})
      : load_case_(load_case), c_(c), contacts_(contacts), laws_(laws), push_(push) {
    bodies_ = body_solver(c).all_rollers(
        {c, contacts, laws}, [this] { return model(); }, solver);
  }

  RollersOnBodies& bodies() const { return *bodies_; }
  /// Model with the turns of the load case.
  FullModel model() const { return model(load_case_, turn_of(contacts_.mechanism, load_case_)); }
  FullModel model(const LoadCase& at, const Turn& turn) const {
    FullModel model =
        full_model(contacts_.mechanism, *c_.structure, *c_.materials, c_.model, laws_, at, c_.deviations, turn);
    model.push = push_;
    return model;
  }
  /// Model in which only the carrier has turned.
  FullModel model(double carrier_angle) const {
    LoadCase at = load_case_;
    at.spatial.carrier_angle = carrier_angle;
    return model(at, {});
  }
  FullDistribution solved(const FullModel& model, Detail detail) const { return bodies_->solve(model, detail); }
  Orbit turned(const SpatialLoad::Orbit& wanted) const {
    return turned(wanted, [this](const FullModel& f) { return solved(f, Detail::numbers); });
  }
  Orbit turned(const SpatialLoad::Orbit& wanted,
               const std::function<FullDistribution(const FullModel&)>& solver) const {
    return orbit([this](double carrier_angle) { return model(carrier_angle); }, solver, wanted,
                 load_case_.spatial.carrier_angle, {alike(c_.deviations), is_round(c_, load_case_.spatial)});
  }

 private:
  const LoadCase& load_case_;
  const Conditions& c_;
  const Contacts& contacts_;
  const PerInterface<ContactLaw>& laws_;
  std::vector<RollerPush> push_;
  std::unique_ptr<RollersOnBodies> bodies_;
};

/// Quasi-static positions of the turning mechanism at rest.
TravelResult travelled(const AllRollers& all, const LoadCase& load_case, const Mechanism& m) {
  const Travel& wanted = *load_case.travel;
  const auto turn = [&](double theta) { return turn_of(m, wanted, theta); };
  return travel(all.bodies().travel([&](double theta) { return all.model(load_case, turn(theta)); },
                                    [&](double theta) { return turn(theta).carrier - turn(wanted.from).carrier; }),
                m, wanted);
}

/// Natural modes at the equilibrium d, and at positions of the travel.
ModesResult vibrating(const AllRollers& all, const FullModel& f, const FullDistribution& d, const LoadCase& load_case,
                      const Conditions& c, const Mechanism& m) {
  const Travel at_rest;
  const Travel& turning = load_case.travel ? *load_case.travel : at_rest;
  const Modes& wanted = *load_case.modes;
  const auto at = [&](const FullModel& model, const FullDistribution& loads) {
    if (loads.screw_end.compliance.size() > 0)
      return modes({model, loads, m, *c.structure, *c.materials, slip_ratio(m, turning)}, wanted);
    ModesResult none;
    none.left_out = loads.screw_end.left_out;
    return none;
  };
  ModesResult result = at(f, d);
  if (!result.left_out.empty() || !wanted.positions) return result;
  ModesResult::AlongTravel along;
  FullSolver solver;
  const double positions = *wanted.positions;
  for (int k = 0; k < *wanted.positions; ++k) {
    const double theta = turning.angle(static_cast<int>(std::floor(k * turning.last() / positions + 0.5)));
    const FullModel there = all.model(load_case, turn_of(m, turning, theta));
    const FullDistribution loads = solver.solve(there, Detail::complete);
    ModesResult found;
    found.left_out = "there is no equilibrium";
    if (loads.solve.converged()) found = at(there, loads);
    if (found.left_out.empty() && found.modes.size() < result.modes.size()) found.left_out = "the screw buckles";
    if (!found.left_out.empty()) {
      result.along_travel_left_out = fmt::format("{} at {:.6g} deg", found.left_out, theta * 180.0 / std::numbers::pi);
      return result;
    }
    along.angle.push_back(theta);
    along.frequency.emplace_back();
    for (const Mode& mode : found.modes) along.frequency.back().push_back(mode.frequency);
  }
  result.along_travel = std::move(along);
  return result;
}

/// Gyroscopic moment of a disc, as a share of its tilting inertia, that splits pairs of modes by several per cent.
constexpr double kGyroscopic = 0.02;

void warn_of_modes(const ModesResult& modes, const Structure& structure, const std::optional<double>& speed,
                   std::vector<Warning>& warnings) {
  if (!modes.idle_rollers.empty())
    warnings.push_back(
        Warning{"", "modes_without_idle_rollers",
                fmt::format("roller{} {} carr{} nothing and ha{} no part in the modes",
                            modes.idle_rollers.size() == 1 ? "" : "s", fmt::join(modes.idle_rollers, ", "),
                            modes.idle_rollers.size() == 1 ? "ies" : "y", modes.idle_rollers.size() == 1 ? "s" : "ve")}
            .with(static_cast<double>(modes.idle_rollers.size())));
  if (!modes.left_out.empty())
    warnings.push_back({"", "no_modes", fmt::format("the modes are left out: {}", modes.left_out)});
  if (!modes.along_travel_left_out.empty())
    warnings.push_back({"", "no_modes_along_travel",
                        fmt::format("the modes along the travel are left out: {}", modes.along_travel_left_out)});
  if (modes.buckled > 0)
    warnings.push_back({"", "buckled",
                        "the screw buckles under the axial force: a mode without frequency is left "
                        "out",
                        "lower the force or hold the screw closer"});
  if (!speed || modes.modes.empty()) return;
  const double omega = 2.0 * std::numbers::pi * modes.modes.front().frequency;
  for (const auto k : indices(structure.masses)) {
    const ExtraMass& m = structure.masses[k];
    if (m.carrier == ExtraMass::Carrier::screw &&
        std::abs(*speed) * m.inertia.x > kGyroscopic * omega * (m.inertia.y + m.inertia.z))
      warnings.push_back({fmt::format("structure.masses[{}]", k), "gyroscopic",
                          "turns so fast that gyroscopic moments, which the modes leave out, split "
                          "pairs of frequencies by per cents"});
  }
}

/// Results that belong to no single thread, without the orbit.
FullLoads full_loads(const AllRollers& all, const FullModel& f, FullDistribution& d, const LoadCase& load_case,
                     const Conditions& c, const Contacts& contacts) {
  FullLoads full;
  full.freedoms = d.freedoms;
  full.rollers = f.rollers;
  full.carrier_angle = load_case.spatial.carrier_angle + turn_of(contacts.mechanism, load_case).carrier;
  for (const int roller : d.idle_rollers) full.idle_rollers.push_back(roller + 1);
  full.missing_rollers = c.deviations.missing_rollers;
  full.screw_end = std::move(d.screw_end);
  full.nut = d.nut;
  full.rings = std::move(d.rings);
  full.bearings = d.bearings;
  full.symmetric = all.bodies().symmetric(f);
  full.symmetric_stiffness = f.axial_force / full.symmetric.axial_displacement;
  return full;
}

/// Warns of contacts that open by more than the distance of the other flank.
void warn_of_openings(const FullDistribution& d, const Contacts& contacts, const PerInterface<ContactLaw>& laws,
                      std::vector<Warning>& warnings) {
  for (const Interface i : kInterfaces) {
    const double opening = d.largest_opening[i] / std::cos(laws[i].normal_angle);
    const contact::ContactPoint& point = contacts.interfaces[i].geometry.point;
    if (point.ok() && point.backlash > 0.0 && opening > point.backlash)
      warnings.push_back(Warning{"", fmt::format("{}_opening", name(i)),
                                 fmt::format("a {} contact opens by {{value}}, more than the backlash of "
                                             "{{limit}}: the other flank would touch, which the model leaves out",
                                             label(i))}
                             .with(opening, point.backlash, "mm"_unit));
  }
}

}  // namespace

FullDistribution full_distribution(const LoadCase& load_case, const Conditions& c, const Contacts& contacts,
                                   const PerInterface<ContactLaw>& laws, FullSolver& solver, Detail detail,
                                   const std::vector<RollerPush>& push) {
  const AllRollers all(load_case, c, contacts, laws, solver, push);
  return all.solved(all.model(), detail);
}

Orbit full_orbit(const LoadCase& load_case, const Conditions& c, const Contacts& contacts,
                 const PerInterface<ContactLaw>& laws, FullSolver& solver, const SpatialLoad::Orbit& wanted) {
  return AllRollers(load_case, c, contacts, laws, solver).turned(wanted);
}

Orbit full_orbit(const LoadCase& load_case, const Conditions& c, const Contacts& contacts,
                 const PerInterface<ContactLaw>& laws, const std::function<FullDistribution(double)>& solved,
                 const SpatialLoad::Orbit& wanted) {
  FullSolver none;
  return AllRollers(load_case, c, contacts, laws, none).turned(wanted, [&](const FullModel& f) {
    return solved(f.load.carrier_angle);
  });
}

std::string text(const Orbit::Failure& failure) {
  return fmt::format("{} (carrier at {:.4g} deg)", failure.why, failure.carrier_angle * 180.0 / std::numbers::pi);
}

bool travels(const LoadCaseResult& result) {
  return !result.full || !result.full->travel || result.full->travel->converged();
}

Warning no_orbit(const Orbit::Failure& failure) {
  return {"", "no_orbit", fmt::format("the orbit is left out: {}", text(failure))};
}

LoadCaseResult full_result(const LoadCase& load_case, const Conditions& c, const Contacts& contacts,
                           const PerInterface<ContactLaw>& laws, FullSolver& solver, Detail detail,
                           const std::vector<RollerPush>& push) {
  const SpatialLoad& load = load_case.spatial;
  const AllRollers all(load_case, c, contacts, laws, solver, push);
  const FullModel f = all.model();
  FullDistribution d = all.solved(f, load_case.modes ? Detail::complete : detail);
  LoadDistribution flattened;
  flattened.solve = d.solve;
  flattened.axial_displacement = d.axial_displacement;
  flattened.tangent_stiffness = d.tangent_stiffness;
  flattened.guides = d.guides;
  for (const Interface i : kInterfaces) {
    flattened.normal_load[i] = flat(d.normal_load[i]);
    flattened.approach[i] = flat(d.approach[i]);
  }
  LoadCaseResult result = solved_result(load_case, contacts, laws, std::move(flattened));
  std::vector<Warning>& warnings = result.warnings;
  if (!d.reason.empty()) warnings.push_back({"", "no_equilibrium", d.reason});
  if (!result.threads) return result;

  std::optional<ModesResult> found_modes;
  std::optional<TravelResult> moved;
  if ((load_case.travel && load_case.travel->turns != 0) || load_case.modes) {
    const AllRollers at_rest(load_case, c, contacts, laws, solver);
    if (load_case.travel && load_case.travel->turns != 0) moved = travelled(at_rest, load_case, contacts.mechanism);
    if (load_case.modes) {
      const FullModel still = at_rest.model();
      found_modes = vibrating(at_rest, still, push.empty() ? d : at_rest.solved(still, Detail::complete), load_case, c,
                              contacts.mechanism);
    }
  }
  FullLoads full = full_loads(all, f, d, load_case, c, contacts);
  for (const Interface i : kInterfaces) {
    InterfaceLoads& loads = (*result.threads)[i];
    loads.threads_per_roller = f.threads();
    loads.rollers = roller_shares(loads, f, full.symmetric.largest_normal_load[i]);
  }
  if (load.orbit && push.empty()) {
    Orbit turned = all.turned(*load.orbit);
    if (turned.converged())
      full.orbit = std::move(turned);
    else
      warnings.push_back(no_orbit(*turned.failure));
  }
  if (moved && !moved->converged())
    warnings.push_back({"", "no_travel",
                        fmt::format("the travel ends at {:.6g} deg: {}",
                                    moved->failure->angle * 180.0 / std::numbers::pi, moved->failure->why)});
  if (moved && moved->left_out_at)
    warnings.push_back({"", "no_travel_stiffness",
                        fmt::format("the stiffness over the travel is left out: there is none at "
                                    "{:.6g} deg",
                                    *moved->left_out_at * 180.0 / std::numbers::pi)});
  full.travel = std::move(moved);
  if (found_modes) {
    std::optional<double> speed = load_case.speed;
    if (!speed && c.operation) speed = c.operation->speed;
    warn_of_modes(*found_modes, *c.structure, speed, warnings);
    if (found_modes->left_out.empty()) full.modes = std::move(found_modes);
  }
  if (detail == Detail::complete && full.screw_end.compliance.size() == 0)
    warnings.push_back({"", "no_screw_end_stiffness",
                        fmt::format("the stiffness of the screw's end is left out: {}", full.screw_end.left_out)});
  if (result.axial_displacement && *result.axial_displacement < 0.0)
    warnings.push_back(Warning{"", "negative_stiffness",
                               "the loaded section moves {value} against the force, as side loads "
                               "or displaced parts have it, so that `axial_stiffness` is negative",
                               "take `tangent_stiffness`"}
                           .with(-*result.axial_displacement, {}, "mm"_unit));
  warn_of_openings(d, contacts, laws, warnings);
  if (std::optional<Warning> warning = forced_bearings(d.bearings, f.axial_force))
    warnings.push_back(std::move(*warning));
  if (all.bodies().shoulder_lifts())
    if (std::optional<Warning> warning = lifted_shoulder(c.structure->nut, d.nut))
      warnings.push_back(std::move(*warning));
  result.full = std::make_shared<const FullLoads>(std::move(full));
  return result;
}

}  // namespace prs
