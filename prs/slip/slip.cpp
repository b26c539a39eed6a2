#include "prs/slip/slip.h"

#include <numeric>

#include "prs/indices.h"
#include "prs/model/check_case.h"
#include "prs/model/quantity_text.h"
#include "prs/slip/running.h"
#include "prs/slip/slip_warnings.h"

namespace prs {
namespace {

/// Relative difference of power densities that is only rounding: the first one counts.
constexpr double kEqualPower = 1e-9;

/// The body whose threads leave the grooves of the rollers: at the last contact they lag by half a pitch.
std::optional<Part> out_of_mesh(const Mechanism& m) {
  const PerPart<double> pitch = axial_pitches(m);
  for (const Interface i : kInterfaces) {
    const double lag = (m.contacts_per_roller - 1) * std::abs(pitch[body_of(i)] - pitch.roller);
    if (lag >= 0.5 * std::min(pitch[body_of(i)], pitch.roller)) return body_of(i);
  }
  return std::nullopt;
}

void require_mesh(const Mechanism& m) {
  const std::optional<Part> part = out_of_mesh(m);
  if (!part) return;
  const PerPart<double> pitch = axial_pitches(m);
  throw CaseError(fmt::format("mechanism.pitch.{}", name(m.pitch[*part] ? *part : Part::roller)),
                  fmt::format("got pitches of {} ({}) and {} (roller), which over {} contacts differ by half a pitch; "
                              "expected the threads of both in the same grooves; check the pitches and the lead",
                              mm(pitch[*part]), name(*part), mm(pitch.roller), m.contacts_per_roller));
}

/// `value_of_patch` of each patch, copied to the threads that it represents.
template <class Value>
void set_values(std::vector<double>& values, const LoadedThreads& threads, Value value_of_patch) {
  values.clear();
  std::optional<std::size_t> last;
  double value = 0.0;
  for (const std::optional<std::size_t>& k : threads.patch_of_thread) {
    if (k && k != last) value = value_of_patch(*k), last = k;
    values.push_back(k ? value : 0.0);
  }
}

/// Roller and body with the motion of their surfaces through the contact, which the carrier holds in place.
std::array<contact::HeatedBody, 2> moving(std::array<contact::HeatedBody, 2> bodies, const Kinematics& parts,
                                          const KinematicGeometry& geometry, const ContactFrameOf<double>& frame,
                                          Interface i) {
  const ContactMotion motion = contact_motion(geometry, parts, i);
  for (const auto k : up_to(2)) {
    const double sense = k == 0 ? -1.0 : 1.0;  // Sign of the sliding of the body against the roller.
    const auto along = [&](const contact::Vector3<double>& axis) {
      return 0.5 * (dot(motion.rolling, axis) + sense * dot(motion.sliding, axis));
    };
    bodies[k].speed_major = along(frame.major_axis);
    bodies[k].speed_minor = along(frame.minor_axis);
  }
  return bodies;
}

constexpr auto all_values() {
  return std::array{
      &InterfaceSlip::power,          &InterfaceSlip::power_density,    &InterfaceSlip::friction_coefficient,
      &InterfaceSlip::spin_torque,    &InterfaceSlip::sliding_speed,    &InterfaceSlip::max_sliding_speed,
      &InterfaceSlip::film_thickness, &InterfaceSlip::central_film,     &InterfaceSlip::film_factor,
      &InterfaceSlip::film_ratio,     &InterfaceSlip::boundary_share,   &InterfaceSlip::dynamic_normal_load,
      &InterfaceSlip::wear,           &InterfaceSlip::flash_temperature};
}

void clear_values(InterfaceSlip& slip) {
  for (const auto values : all_values()) (slip.*values).clear();
}

/// Sets the values of an interface, all of which must be empty.
void set_interface_slip(InterfaceSlip& slip, const SlipModel& model, const SlipBalance& balance, Interface i,
                        const SlipDetail& detail) {
  const LoadedThreads& threads = model.threads[i];
  const PatchBalance& b = balance.patches[i];
  const auto motion = [&](std::size_t k) -> const contact::PatchMotion& {
    return balance.motion_of(i, threads.contacts[k]);
  };
  const auto sliding = [&](std::size_t k) { return std::hypot(motion(k).sliding_major, motion(k).sliding_minor); };
  slip.threads_per_roller = threads.threads_per_roller;
  slip.along_major = balance.sliding[i].along_major;
  const auto add = [&](std::vector<double>& values, auto value_of_patch) {
    set_values(values, threads, value_of_patch);
  };
  const auto power = [&](std::size_t k) { return b.normal_load[k] * b.friction[k].power_per_load; };

  if (detail.threads) {
    add(slip.power, power);
    add(slip.power_density, [&](std::size_t k) {
      const contact::HertzContact& e = threads.contacts[k].ellipse;
      return power(k) / (std::numbers::pi * e.semi_major * e.semi_minor);
    });
    add(slip.friction_coefficient, [&](std::size_t k) { return b.friction[k].mean_friction; });
    add(slip.spin_torque, [&](std::size_t k) { return b.normal_load[k] * b.friction[k].spin_arm; });
    add(slip.sliding_speed, sliding);
    add(slip.max_sliding_speed, [&](std::size_t k) { return b.friction[k].max_sliding_speed; });
    add(slip.dynamic_normal_load, [&](std::size_t k) { return b.normal_load[k]; });
  }
  if (model.wear && detail.threads) {
    const double travel = std::abs(model.geometry.lead * model.speed) / (2.0 * std::numbers::pi);
    add(slip.wear, [&](std::size_t k) {
      return model.wear->coefficient * b.normal_load[k] * b.friction[k].sliding_under_pressure / travel;
    });
  }
  if (model.heated[i] && detail.threads) {
    add(slip.flash_temperature, [&](std::size_t k) {
      const LoadedThreads::Contact& c = threads.contacts[k];
      return contact::flash_temperature(
          c.ellipse,
          moving(*model.heated[i], balance.motion, c.other_flank ? model.other_flank->geometry : model.geometry,
                 model.frame(i, c), i),
          power(k));
    });
  }
  if (!model.oils.threads[i] || !detail.films) return;
  const contact::Lubricant& oil = *model.oils.threads[i];
  add(slip.film_thickness, [&](std::size_t k) {
    return contact::sandu_film(oil, threads.contacts[k].friction.film, motion(k).rolling_speed).thickness;
  });
  const auto central_film = [&](std::size_t k) {
    return contact::central_film(oil, threads.contacts[k].friction.film, motion(k).rolling_speed,
                                 motion(k).along_major);
  };
  add(slip.central_film, central_film);
  const auto film_factor = [&](std::size_t k) {
    const LoadedThreads::Contact& c = threads.contacts[k];
    return contact::film_factor(oil, c.friction.film, c.ellipse.peak_pressure, motion(k).rolling_speed, sliding(k));
  };
  add(slip.film_factor, film_factor);
  const std::optional<double>& roughness = model.roughness[i];
  if (!roughness) return;
  const auto film_ratio = [&](std::size_t k) { return film_factor(k) * central_film(k) / *roughness; };
  add(slip.film_ratio, film_ratio);
  const contact::Mixed<PerInterface<double>>& touching = model.friction;
  add(slip.boundary_share, [&](std::size_t k) { return contact::boundary_share(film_ratio(k), touching.exponent[i]); });
}

void find_hottest(SlipResult& slip) {
  double hottest = -1.0;
  for (const Interface i : kInterfaces)
    for (const auto k : indices(slip.threads[i].power)) {
      const double density = slip.threads[i].power_density[k];
      if (density > hottest * (1.0 + kEqualPower)) hottest = density, slip.hottest = ThreadOf{i, static_cast<int>(k)};
    }
}

EqualShareSlip summary_of(const SlipResult& equal) {
  EqualShareSlip s;
  s.slip_ratio = equal.slip_ratio;
  s.power_loss = equal.power.total();
  s.efficiency = equal.efficiency;
  for (const Interface i : kInterfaces) {
    s.thread_power[i] = equal.threads[i].power.front();
    s.max_power_density = std::max(s.max_power_density, equal.threads[i].power_density.front());
  }
  return s;
}

/// (3.55) with B_1 = 98.1 % and B_2 = 0.32 %; absent outside the range of the lubricants of Sandu's study.
std::optional<double> sandu_efficiency_fit(const contact::Lubricant& lubricant) {
  const double millipascal_seconds = lubricant.viscosity * 1e3;
  const double megapascals = lubricant.eyring_stress * 1e-6;
  if (millipascal_seconds < 4.0 || millipascal_seconds > 1000.0 || megapascals > 20.0) return std::nullopt;
  return 0.981 - 0.0032 * megapascals * std::log(millipascal_seconds);
}

/// Sets the results that follow from the flow of power under an axial force; set torques first.
void set_drive(SlipResult& slip, const PowerFlow& flow, double axial_force, double lead) {
  slip.efficiency = flow.efficiency();
  slip.driven_by = driven_by(axial_force, slip.speed, lead);
  slip.self_locking.reset();
  slip.holding_torque.reset();
  if (slip.driven_by == DrivenBy::screw) return;
  slip.self_locking = !slip.efficiency;
  slip.holding_torque = std::copysign(1.0, slip.speed) * slip.torque_screw;
}

/// Loads at rest for slip: solved ones, and equal shares by the geometry. Those of a running screw are still to be
/// solved.
Result loaded_threads_of(const Conditions& c, Contacts contacts, AnalysisOptions options) {
  const auto equal = [](const LoadCase& load) { return load.share == LoadCase::Share::equal; };
  if (std::ranges::all_of(c.load_cases, equal)) return analyze_contacts(c, std::move(contacts), options.detail);
  require_contacts(c, contacts);
  Result result = analyze(c, std::move(contacts), options,
                          [&](const LoadCase& load) { return runs(c, load) || has_both_flanks(c, load.share); });
  for (LoadCaseResult& loaded : result.load_cases) {
    if (!equal(loaded.load_case)) continue;
    loaded = equal_share_result(loaded.load_case, result.contacts);
    if (options.detail == Detail::complete) add_warnings(loaded, result.contacts);
  }
  return result;
}

/// A screw held at rest: the limits of slow motion in both senses, with Coulomb's friction, or that of touching flanks
/// without a film.
SlipResult held(const Conditions& c, const Contacts& contacts, const LoadCase& load, const std::optional<Oils>& oils) {
  constexpr double kCreep = 1e-3;  // Friction does not depend on it, inertia is far below rounding [rad/s].
  Conditions creeping = c;
  creeping.friction = friction_by(contact::Coulomb{PerInterface<double>{
      friction_at_rest(c.friction->at(Interface::screw)), friction_at_rest(c.friction->at(Interface::nut))}});
  if (creeping.operation) creeping.operation->slip_ratio.reset();
  LoadCase at = load;
  const double sense = std::copysign(1.0, axial_force_on_nut(load) * contacts.threads.screw.lead);
  SlipResult result;
  const auto bound = [&](double speed) {
    at.speed = speed;
    const std::optional<SlipResult> slip = slip_alone(creeping, contacts, at, oils);
    if (!slip || !slip->converged()) {
      result.status = slip ? slip->status : SlipStatus::no_equilibrium;
      return Holding::Bound{};
    }
    const SlipResult& nut = slip->of_nut_that_carries(load);
    return Holding::Bound{sense * slip->torque_screw, slip->torque_screw, slip->torque_nut, nut.slip_ratio, nut.forces};
  };
  result.status = SlipStatus::held;
  result.gear_ratio = gear_ratio(contacts.mechanism);
  const Holding holding{bound(sense * kCreep), bound(-sense * kCreep)};
  if (result.status == SlipStatus::held) result.holding = holding;
  return result;
}

/// Keeps threads of the flank that the load names in the lists, and moves the power of the other one to it.
void part_flanks(LoadCaseResult& loaded) {
  if (!loaded.other_flank || !loaded.slip->converged()) return;
  SlipResult& slip = *loaded.slip;
  for (const Interface i : kInterfaces) {
    const auto count = static_cast<std::ptrdiff_t>((*loaded.threads)[i].normal_load.size());
    std::vector<double>& power = loaded.other_flank->threads[i].power;
    if (slip.second_nut) {
      const bool first = loaded.load_case.direction == Direction::tension;
      power = (first ? slip.threads : slip.second_nut->threads)[i].power;
      continue;
    }
    power.assign(slip.threads[i].power.begin() + count, slip.threads[i].power.end());
    for (const auto values : all_values())
      if (std::vector<double>& all = slip.threads[i].*values; !all.empty()) all.resize(static_cast<std::size_t>(count));
  }
  find_hottest(slip);
}

/// Sums the effects of both nuts on the screw, powers and torques of the second one added, under the force F_N of the
/// load case.
void add_second_nut(SlipResult& slip, SlipResult second, const SlipModel& first_model, double force) {
  if (slip.converged() && second.converged()) {
    slip.power.screw += second.power.screw;
    slip.power.nut += second.power.nut;
    slip.power.carrier_roller += second.power.carrier_roller;
    slip.power.carrier_screw += second.power.carrier_screw;
    slip.power.carrier_nut += second.power.carrier_nut;
    slip.power_loss_input_output += second.power_loss_input_output;
    slip.torque_screw += second.torque_screw;
    slip.torque_nut += second.torque_nut;
    const double advance = -first_model.geometry.lead / (2.0 * std::numbers::pi) * slip.speed;
    const double turned = first_model.geometry.carrier_on_nut() ? slip.torque_screw : slip.torque_nut;
    const PowerFlow flow{turned * turning_speed(first_model.geometry.type, slip.speed), force * advance};
    set_drive(slip, flow, force, first_model.geometry.lead);
    slip.efficiency_fit.reset();
  } else if (slip.converged()) {
    slip.status = second.status;
  }
  slip.second_nut = std::make_shared<SecondNut>(SecondNut{std::move(second)});
}

}  // namespace

bool rolls(const Mechanism& mechanism) { return !out_of_mesh(mechanism); }

void require_rolling(const Conditions& c, const Contacts& contacts) {
  require_contacts(c, contacts);
  require_mesh(contacts.mechanism);
}

SlipResult slip_result(const SlipModel& model) {
  SlipResult slip;
  set_slip_result(slip, model, find_slip_equilibrium(model), {});
  return slip;
}

void set_slip_result(SlipResult& slip, const SlipModel& model, const SlipEquilibrium& found, const SlipDetail& detail) {
  const SlipRange range = slip_range(model.geometry);
  const SlipBalance& b = found.balance;
  PerInterface<InterfaceSlip> memory = std::move(slip.threads);
  std::vector<std::array<RollerHead, 2>> heads = std::move(slip.heads);
  slip = {};
  slip.threads = std::move(memory);
  slip.heads = std::move(heads);
  slip.heads.clear();
  for (const Interface i : kInterfaces) clear_values(slip.threads[i]);
  slip.status = found.status;
  slip.evaluations = found.evaluations;
  slip.speed = model.speed;
  slip.gear_ratio = model.geometry.gear_ratio;
  slip.ideal_slip_ratio = range.ideal;
  slip.estimates = slip_estimates(model.geometry);
  if (slip.status != SlipStatus::jammed) slip.relative_residue = relative_residue(model, b);
  if (!slip.converged()) return;
  slip.moments = b.moments;

  slip.slip_ratio = b.motion.slip_ratio;
  slip.optimality = optimality(range, slip.slip_ratio);
  const double turns = geared_turns(model.geometry, slip.slip_ratio);
  slip.travel_per_turn = std::abs(travel_per_turn(model.geometry, slip.slip_ratio));
  slip.migration_per_turn = std::copysign(1.0, model.geometry.lead) * turns * model.geometry.migration_lead;
  slip.pitch_sliding_per_turn = 2.0 * std::numbers::pi * turns * model.pitch_excess;
  for (const Interface i : kInterfaces) set_interface_slip(slip.threads[i], model, b, i, detail);
  slip.power = lost_power(model, b);
  const DriveTorques torques = drive_torques(model, b);
  const PowerFlow flow = power_flow(model, b);
  slip.torque_screw = torques.screw;
  slip.torque_nut = torques.nut;
  slip.power_loss_input_output = flow.lost();
  set_drive(slip, flow, model.axial_force, model.geometry.lead);
  if (model.friction.is(contact::Lubrication::film) && slip.status == SlipStatus::converged &&
      slip.driven_by == DrivenBy::screw)
    slip.efficiency_fit = sandu_efficiency_fit(*model.oils.carrier);
  if (model.oils.carrier) slip.viscosity = model.oils.carrier->viscosity;
  slip.forces = b.forces;
  set_heads(slip.heads, model, b);
  if (model.bearing_viscosity > 0.0) slip.bearing_eccentricity = b.bearing.eccentricity_ratio;
  find_hottest(slip);
}

std::optional<SlipResult> slip_alone(Conditions c, const Contacts& contacts, const LoadCase& load,
                                     const std::optional<Oils>& oils) {
  c.load_cases = {load};
  c.load_cases.front().travel.reset();
  c.load_cases.front().modes.reset();
  return analyze_slip(c, contacts, {.detail = Detail::numbers}, oils).load_cases.front().slip;
}

Result analyze_slip(const Conditions& c, Contacts contacts, AnalysisOptions options, const std::optional<Oils>& oils) {
  if (const auto stated = with_slip_ratios(c, contacts))
    return analyze_slip(*stated, std::move(contacts), options, oils);
  Result result = loaded_threads_of(c, std::move(contacts), options);
  require_mesh(result.contacts.mechanism);
  if (options.detail == Detail::complete)
    if (std::optional<Warning> note = unknown_film_ratio(c)) result.warnings.push_back(std::move(*note));
  const SlipModels models(c, result.contacts, oils);
  RunningSolver running(c, result.contacts, models);
  std::optional<FlankSolver> flanks;
  if (some_load_has_both_flanks(c)) flanks.emplace(c, result.contacts);
  for (LoadCaseResult& loaded : result.load_cases) {
    std::optional<SlipEquilibrium> found;
    if (runs(c, loaded.load_case) || has_both_flanks(c, loaded.load_case.share)) {
      loaded = runs(c, loaded.load_case) ? running.solve(loaded.load_case, options.detail, found)
                                         : flanks->solve(loaded.load_case);
      if (options.detail == Detail::complete) add_warnings(loaded, result.contacts);
    }
    if (!loaded.threads) continue;
    if (is_held(c, loaded.load_case)) {
      loaded.slip = held(c, result.contacts, loaded.load_case, oils);
      if (options.detail == Detail::complete) add_slip_warnings(c, result.contacts, nullptr, loaded);
      continue;
    }
    const std::vector<SlipModel> nuts = models.of_nuts(loaded);
    const SlipModel& model = nuts.front();
    loaded.slip.emplace();
    set_slip_result(*loaded.slip, model, found ? *found : find_slip_equilibrium(model), {});
    if (nuts.size() == 2) {
      SlipResult second;
      const std::optional<SlipEquilibrium>& known = running.second_nut();
      set_slip_result(second, nuts[1], known ? *known : find_slip_equilibrium(nuts[1]), {});
      add_second_nut(*loaded.slip, std::move(second), nuts[0], axial_force_on_nut(loaded.load_case));
    }
    part_flanks(loaded);
    if (loaded.load_case.share == LoadCase::Share::solved && loaded.slip->converged() && !loaded.other_flank) {
      const SlipResult equal = slip_result(models.equal_shares(loaded.load_case));
      if (equal.converged()) loaded.slip->equal_shares = summary_of(equal);
    }
    if (options.detail != Detail::complete) continue;
    const bool second = &loaded.slip->of_nut_that_carries(loaded.load_case) != &*loaded.slip;
    add_slip_warnings(c, result.contacts, &nuts[second ? 1 : 0], loaded);
  }
  return result;
}

}  // namespace prs
