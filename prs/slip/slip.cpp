#include "prs/slip/slip.h"

#include <numeric>

#include "prs/model/check_case.h"
#include "prs/model/quantity_text.h"
#include "prs/slip/running.h"

namespace prs {
namespace {

/// Coulomb's coefficient from which surfaces are taken to touch.
constexpr double kTouchingFriction = 0.05;

/// Flash temperature from which it is told [K].
constexpr double kHotFlash = 50.0;

/// Power densities that differ by less than this share differ by rounding: the first one counts.
constexpr double kEqualPower = 1e-9;

/// Temperatures of parts that run warm and of what is around them, for an estimate [K].
constexpr double kWarmParts = 353.15, kSurroundings = 298.15;

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

/// `value_of_patch` of each patch, handed out to the threads that it stands for.
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

/// Roller and body as their surfaces move through the contact, which the carrier holds.
std::array<contact::HeatedBody, 2> moving(std::array<contact::HeatedBody, 2> bodies, const Kinematics& parts,
                                          const KinematicGeometry& geometry, const ContactFrameOf<double>& frame,
                                          Interface i) {
  const ContactMotion motion = contact_motion(geometry, parts, i);
  for (std::size_t k = 0; k < 2; ++k) {
    const double sense = k == 0 ? -1.0 : 1.0;  // Sliding: of the body against the roller.
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

/// Values of an interface that are all empty so far.
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
    return contact::sandu_film(oil, threads.contacts[k].film, motion(k).rolling_speed).thickness;
  });
  const auto central_film = [&](std::size_t k) {
    return contact::central_film(oil, threads.contacts[k].film, motion(k).rolling_speed, motion(k).along_major);
  };
  add(slip.central_film, central_film);
  const auto film_factor = [&](std::size_t k) {
    const LoadedThreads::Contact& c = threads.contacts[k];
    return contact::film_factor(oil, c.film, c.ellipse.peak_pressure, motion(k).rolling_speed, sliding(k));
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
    for (std::size_t k = 0; k < slip.threads[i].power.size(); ++k) {
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

/// (3.55) with B_1 = 98.1 % and B_2 = 0.32 %, for the lubricants that Sandu varied it over.
std::optional<double> sandu_efficiency_fit(const contact::Lubricant& lubricant) {
  const double millipascal_seconds = lubricant.viscosity * 1e3;
  const double megapascals = lubricant.eyring_stress * 1e-6;
  if (millipascal_seconds < 4.0 || millipascal_seconds > 1000.0 || megapascals > 20.0) return std::nullopt;
  return 0.981 - 0.0032 * megapascals * std::log(millipascal_seconds);
}

DrivenBy driven_by(double axial_force, double speed, double lead) {
  return axial_force * speed * lead < 0.0 ? DrivenBy::load : DrivenBy::screw;
}

/// What the flow of power under an axial force says; torques come first.
void set_drive(SlipResult& slip, const PowerFlow& flow, double axial_force, double lead) {
  slip.efficiency = flow.efficiency();
  slip.driven_by = driven_by(axial_force, slip.speed, lead);
  slip.self_locking.reset();
  slip.holding_torque.reset();
  if (slip.driven_by == DrivenBy::screw) return;
  slip.self_locking = !slip.efficiency;
  slip.holding_torque = std::copysign(1.0, slip.speed) * slip.torque_screw;
}

void warn_of_lubrication(const SlipResult& slip, const Friction& friction, std::vector<Warning>& warnings) {
  if (friction.is(contact::Lubrication::mixed)) return;
  const bool film = friction.facts().has_film();
  for (const Interface i : kInterfaces) {
    const std::vector<double>& mu = slip.threads[i].friction_coefficient;
    if (!film && (mu.empty() || std::ranges::max(mu) >= kTouchingFriction * (1.0 - 1e-9))) continue;
    double least = std::numeric_limits<double>::infinity();
    for (const double ratio : slip.threads[i].film_ratio)
      if (ratio > 0.0) least = std::min(least, ratio);
    if (least < kFullFilm)
      warnings.push_back(Warning{"roughness", fmt::format("{}_lubrication", name(i)),
                                 fmt::format("{} lubrication at the {} contacts: film over roughness is {{value}} "
                                             "at the least",
                                             lubrication(least), label(i)),
                                 film ? "real friction is higher than that of the full film computed here: take "
                                        "`friction: {model: {mixed: {boundary: 0.11}}}`"
                                      : "take a friction coefficient of surfaces that touch"}
                             .with(least, kFullFilm, {}, Warning::Worse::smaller));
  }
}

void warn_of_flashes(const SlipResult& slip, std::vector<Warning>& warnings) {
  for (const Interface i : kInterfaces) {
    const std::vector<double>& flashes = slip.threads[i].flash_temperature;
    const double hottest = flashes.empty() ? 0.0 : std::ranges::max(flashes);
    if (hottest > kHotFlash)
      warnings.push_back(Warning{"friction", fmt::format("{}_flash_temperature", name(i)),
                                 fmt::format("the {} contacts flash {{value}} above their parts, more than "
                                             "{{limit}}: films there are thinner than computed, and scuffing is "
                                             "near",
                                             label(i)),
                                 "less speed or load, or an oil with less friction"}
                             .with(hottest, kHotFlash, text_unit::kelvin));
  }
}

/// Warns if centrifugal force lifts the rollers off the screw.
void warn_of_lifted_rollers(const LoadCaseResult& loaded, std::vector<Warning>& warnings) {
  const PerInterface<InterfaceLoads>& threads = *loaded.threads;
  int lifted = 0;
  for (std::size_t k = 0; k < threads.screw.normal_load.size(); ++k)
    lifted += threads.screw.normal_load[k] == 0.0 && threads.nut.normal_load[k] > 0.0;
  const double centrifugal = loaded.slip->forces.centrifugal;
  if (!loaded.running || lifted == 0 || !(centrifugal > 0.0)) return;
  warnings.push_back(Warning{loaded.load_case.speed ? path_in(loaded.load_case, "speed") : "operation.speed",
                             "lifted_rollers",
                             fmt::format("rollers leave the screw at {} of {} contacts: centrifugal force presses "
                                         "each with {{value}} to the nut, against {:.4g} N on all of them along "
                                         "the axis",
                                         lifted, threads.screw.normal_load.size(), loaded.load_case.axial_force),
                             "take less speed, more load or a preload"}
                         .with(centrifugal, {}, text_unit::newton));
}

/// Warns if the formula of the central film does not know the way that an interface rolls.
void warn_of_film(const SlipModel& model, const SlipResult& slip, std::vector<Warning>& warnings) {
  for (const Interface i : kInterfaces) {
    const double along_major = slip.threads[i].along_major;
    if (slip.threads[i].central_film.empty() || model.threads[i].contacts.empty()) continue;
    const double off_major = 90.0 - std::asin(std::sqrt(along_major)) * 180.0 / std::numbers::pi;
    const double ratio = contact::rolling_radius_ratio(model.threads[i].contacts.front().film, along_major);
    const bool follows = model.film_direction == contact::FilmDirection::rolling;
    if (!follows && along_major > 0.5)
      warnings.push_back(Warning{"lubricant.film", fmt::format("{}_film_direction", name(i)),
                                 fmt::format("the {} contacts roll {:.0f} deg off the major axis of their "
                                             "ellipse, and their central film is that of rolling along the minor "
                                             "one; pressures do not depend on it",
                                             label(i), off_major),
                                 "for the true direction take `film: {direction: rolling}`, another formula, "
                                 "whose films are about 20 % thinner at this contact"}
                             .with(off_major / per_si::degree, {}, text_unit::degree, Warning::Worse::smaller)
                             .as_assumption());
    const bool low = ratio < contact::kLeastRollingRatio;
    if (follows && (low || ratio > contact::kGreatestRollingRatio))
      warnings.push_back(
          Warning{"lubricant.film", fmt::format("{}_film_range", name(i)),
                  fmt::format("the {} contacts roll {:.0f} deg off the major axis of their "
                              "ellipse, with {{value}} times the radius across it as along it; "
                              "the film's formula is made for {:g} to {:g}",
                              label(i), off_major, contact::kLeastRollingRatio, contact::kGreatestRollingRatio),
                  "take it as an estimate"}
              .with(ratio, low ? contact::kLeastRollingRatio : contact::kGreatestRollingRatio, {},
                    low ? Warning::Worse::smaller : Warning::Worse::larger));
  }
}

/// Without friction the normal loads are axial/cos(psi).
OverStatic common_over_static(const InterfaceLoads& running) {
  const auto sum = [](const std::vector<double>& loads) { return std::accumulate(loads.begin(), loads.end(), 0.0); };
  const double axial = sum(running.axial_load);
  return {running.running_over_static.value_or(1.0),
          axial > 0.0 ? sum(running.normal_load) * std::cos(running.normal_angle) / axial : 1.0};
}

/// A warning where friction takes more power than still air around a nut takes from it, and nothing
/// says where that goes.
std::optional<Warning> unknown_heat_flow(const Conditions& c, const Mechanism& m, double power) {
  if (c.heat) return std::nullopt;
  const double bore = *m.pitch_diameter.nut, diameter = c.structure ? c.structure->nut.outer_diameter : bore;
  const double length = c.structure ? c.structure->nut.length : m.contacts_per_roller * axial_pitch(m);
  const double in_air = nut_in_still_air(diameter, bore, length);
  const double needed = power / (kWarmParts - kSurroundings);
  if (needed <= in_air) return std::nullopt;
  return Warning{"heat", "unknown_temperatures",
                 fmt::format("missing, so that temperatures are not known: to stay at {:.0f} degC in "
                             "{:.0f} degC, the mechanism must pass its {:.0f} W on by {{value}}, and "
                             "still air takes {{limit}} from a bare nut; loads, films and life are those "
                             "of the stated temperature",
                             kWarmParts - 273.15, kSurroundings - 273.15, power),
                 "add `heat`"}
      .with(needed, in_air, text_unit::watt_per_kelvin)
      .as_assumption();
}

/// Warns of rollers that migrate and of pitch cylinders that slide, for diameters and pitches as measured.
void warn_of_measured_parts(const Contacts& contacts, const SlipResult& slip, std::vector<Warning>& warnings) {
  const Part geared = geared_part(contacts.mechanism.type);
  if (slip.migration_per_turn != 0.0)
    warnings.push_back(Warning{"mechanism.pitch", "roller_migration",
                               fmt::format("the rollers run {} the {} by {{value}} per turn of the screw, if nothing "
                                           "stops them",
                                           slip.migration_per_turn > 0.0 ? "ahead of" : "behind", name(geared)),
                               "the model ends where they meet their stops: correct the pitches"}
                           .with(std::abs(slip.migration_per_turn), {}, text_unit::micrometre));
  if (has_gear_ratio(contacts)) return;
  warnings.push_back(Warning{"mechanism.pitch_diameter", "pitch_sliding",
                             fmt::format("off the ratio of the gears, the pitch cylinders of rollers and {} slide by "
                                         "{{value}} per turn of the screw",
                                         name(geared))}
                         .with(slip.pitch_sliding_per_turn, {}, text_unit::micrometre));
}

void warn_of_running_pressure(const PerInterface<InterfaceLoads>& threads, const LoadCase& load,
                              const Contacts& contacts, std::vector<Warning>& warnings) {
  for (const Interface i : kInterfaces)
    if (const auto& pressure = threads[i].peak_pressure; !pressure.empty())
      if (auto warning =
              running_pressure_warning(path_in(load, "axial_force"), i, std::ranges::max(pressure), contacts))
        warnings.push_back(std::move(*warning));
}

void warn(const SlipResult& slip, const Friction& friction, const LoadCase& load, std::vector<Warning>& warnings) {
  const std::string speed = load.speed ? path_in(load, "speed") : "operation.speed";
  if (slip.status == SlipStatus::held) return;
  if (!slip.converged()) {
    const bool jammed = slip.status == SlipStatus::jammed;
    warnings.push_back(no_slip(jammed, jammed ? "slip" : fmt::format("slip: {}", name(slip.status))));
    return;
  }
  if (slip.self_locking.value_or(false))
    warnings.push_back(Warning{speed, "self_locking",
                               "the load helps, but the screw is self-locking: only a torque of "
                               "{value} in the sense of the motion turns it, and there is no "
                               "efficiency"}
                           .with(*slip.holding_torque, {}, text_unit::newton_metre));
  if (slip.optimality > 1.0 + 1e-12) {
    const bool imposed = slip.status == SlipStatus::imposed;
    warnings.push_back(Warning{imposed ? "operation.slip_ratio" : "carrier",
                               imposed ? "beyond_ideal_slip_ratio" : "driven_carrier",
                               imposed ? "the slip ratio {value} lies beyond the ideal one, {limit}: friction alone "
                                         "does not drive the carrier that fast"
                                       : "the carrier is driven by its torques: the slip ratio {value} lies "
                                         "beyond the ideal one, {limit}",
                               imposed ? "check how it was measured" : ""}
                           .with(slip.slip_ratio, slip.ideal_slip_ratio));
  }
  if (std::ranges::all_of(kInterfaces, [&](Interface i) {
        return std::ranges::max(slip.threads[i].max_sliding_speed) < contact::kNoDirection;
      }))
    warnings.push_back(Warning{speed, "no_sliding",
                               "nothing slides faster than {limit}, where friction has no "
                               "direction any more: the power lost is not that of a moving screw"}
                           .with({}, contact::kNoDirection, text_unit::metre_per_second));
  warn_of_lubrication(slip, friction, warnings);
}

bool is_held(const Conditions& c, const LoadCase& load) { return screw_speed(c, load) == 0.0; }

bool runs(const Conditions& c, const LoadCase& load) {
  return slip_takes_running_loads(c.model, load.share) && !is_held(c, load);
}

/// Loads at rest as slip takes them: solved ones, and equal shares by the geometry. Those of a
/// running screw are still to be solved.
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

struct SlipOfSpeed {
  SlipModel model;
  SlipEquilibrium slip;
};

/// Slip of a load case at another speed: loads of a running screw are found anew, those at rest
/// stay. None where there is no equilibrium.
std::optional<SlipOfSpeed> slip_at_speed(const Conditions& c, const Contacts& contacts, const SlipModels& models,
                                         const LoadCaseResult& loaded, const LoadCase& at) {
  std::optional<SlipEquilibrium> slip;
  if (runs(c, loaded.load_case)) {
    const LoadCaseResult found = RunningSolver(c, contacts, models).solve(at, Detail::numbers, slip);
    if (!found.threads) return std::nullopt;
    return SlipOfSpeed{models.of(found), std::move(*slip)};
  }
  SlipModel model = models.of(loaded);
  model.speed = *at.speed;
  slip = find_slip_equilibrium(model);
  if (!slip->ok()) return std::nullopt;
  return SlipOfSpeed{std::move(model), std::move(*slip)};
}

/// A screw held at rest: the ends of a creeping motion in both senses, with Coulomb's friction, or that of
/// flanks that touch without a film.
SlipResult held(const Conditions& c, const Contacts& contacts, const LoadCase& load, const std::optional<Oils>& oils) {
  constexpr double kCreep = 1e-3;  // Friction does not depend on it, inertia is far below rounding [rad/s].
  Conditions creeping = c;
  creeping.friction = friction_by(contact::Coulomb{PerInterface<double>{
      friction_at_rest(c.friction->at(Interface::screw)), friction_at_rest(c.friction->at(Interface::nut))}});
  if (creeping.operation) creeping.operation->slip_ratio.reset();
  creeping.load_cases = {load};
  creeping.load_cases.front().travel.reset();
  creeping.load_cases.front().modes.reset();
  const double sense = std::copysign(1.0, axial_force_on_nut(load) * contacts.threads.screw.lead);
  SlipResult result;
  const auto bound = [&](double speed) {
    creeping.load_cases.front().speed = speed;
    const Result at = analyze_slip(creeping, contacts, {.detail = Detail::numbers}, oils);
    const std::optional<SlipResult>& slip = at.load_cases.front().slip;
    if (!slip || !slip->converged()) {
      result.status = slip ? slip->status : SlipStatus::no_equilibrium;
      return Holding::Bound{};
    }
    return Holding::Bound{sense * slip->torque_screw, slip->torque_screw, slip->torque_nut, slip->slip_ratio,
                          slip->forces};
  };
  result.status = SlipStatus::held;
  result.gear_ratio = gear_ratio(contacts.mechanism);
  const Holding holding{bound(sense * kCreep), bound(-sense * kCreep)};
  if (result.status == SlipStatus::held) result.holding = holding;
  return result;
}

ResidueCurve residue_curve(const SlipModel& model, double from, double to) {
  constexpr int kPoints = 121;
  ResidueCurve curve;
  SlipBalance balance;
  for (int k = 0; k < kPoints; ++k) {
    const double slip_ratio = from + (to - from) * k / (kPoints - 1);
    if (!balance_at(model, slip_ratio, balance)) continue;
    curve.slip_ratio.push_back(slip_ratio);
    curve.moments.push_back(balance.moments);
  }
  return curve;
}

std::vector<double> numbers(const Eigen::ArrayXd& values) { return {values.data(), values.data() + values.size()}; }

PatchField patch_field(const contact::PatchGrid& grid, const contact::Patch& patch, const contact::PatchMotion& motion,
                       int points_along_axis) {
  const contact::HertzContact& e = patch.ellipse();
  return {e.semi_major,
          e.semi_minor,
          points_along_axis,
          numbers(e.semi_major * grid.along_major()),
          numbers(e.semi_minor * grid.along_minor()),
          numbers(patch.sliding_major(motion)),
          numbers(patch.sliding_minor(motion)),
          numbers(patch.friction_coefficient(motion))};
}

/// Threads of the flank that the load names stay in the lists, power of the other one goes to it.
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

/// What both nuts do to the screw, powers and torques of the second one on top, under the force F_N
/// of the load case.
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
    const double turned = first_model.geometry.is_standard() ? slip.torque_screw : slip.torque_nut;
    const PowerFlow flow{turned * turning_speed(first_model.geometry.type, slip.speed), force * advance};
    set_drive(slip, flow, force, first_model.geometry.lead);
    slip.efficiency_fit.reset();
  } else if (slip.converged()) {
    slip.status = second.status;
  }
  slip.second_nut = std::make_shared<SecondNut>(SecondNut{std::move(second)});
}

}  // namespace

Warning no_slip(bool jammed, const std::string& where) {
  if (jammed)
    return {"friction", "jammed",
            where +
                ": a contact jams: its friction takes more of the axial load than its normal "
                "load gives; expect the screw to stick"};
  return {"carrier", "no_slip_ratio", where + ": no slip ratio balances the moment on a roller",
          "check the carrier's torques"};
}

std::string_view lubrication(double film_ratio) {
  return film_ratio < kTouchingFlanks ? "boundary" : film_ratio < kFullFilm ? "mixed" : "full film";
}

std::optional<Warning> unknown_film_ratio(const Conditions& c) {
  if (!c.lubricant || c.roughness) return std::nullopt;
  return Warning{"roughness", "unknown_film_ratio",
                 "missing, so that film over roughness, and with it the kind of lubrication, is not "
                 "known",
                 "add `roughness: 0.4 um`, for example: the Rq of the ground flanks"};
}

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
  const PowerFlow flow = power_flow(model, b, torques);
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
      if (options.detail == Detail::complete) warn(*loaded.slip, *c.friction, loaded.load_case, loaded.warnings);
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
    warn(*loaded.slip, *c.friction, loaded.load_case, loaded.warnings);
    if (loaded.running)
      if (auto note =
              guides_press(c, {common_over_static(loaded.threads->screw), common_over_static(loaded.threads->nut)}))
        loaded.warnings.push_back(std::move(*note));
    if (loaded.slip->converged()) {
      warn_of_measured_parts(result.contacts, *loaded.slip, loaded.warnings);
      warn_of_film(model, *loaded.slip, loaded.warnings);
      warn_of_flashes(*loaded.slip, loaded.warnings);
      warn_of_lifted_rollers(loaded, loaded.warnings);
      if (loaded.load_case.name != kBackDriving)
        if (auto note = unknown_heat_flow(c, result.contacts.mechanism, loaded.slip->power.total()))
          loaded.warnings.push_back(std::move(*note));
    }
    warn_of_running_pressure(*loaded.threads, loaded.load_case, result.contacts, loaded.warnings);
  }
  return result;
}

std::optional<double> back_driving_efficiency(const Conditions& c, const Contacts& contacts,
                                              const LoadCaseResult& loaded) {
  Problems lacking;
  require_slip(c, lacking);
  if (!std::move(lacking).take().empty() || !loaded.threads) return std::nullopt;
  for (const Interface i : kInterfaces)
    if (!contacts.interfaces[i].geometry.ok() || !contacts.interfaces[i].has_hertz()) return std::nullopt;
  if (!rolls(contacts.mechanism)) return std::nullopt;
  Oils oils = oils_in_operation(c);
  const bool oiled = c.friction->facts().has_film() || c.carrier.is_oiled();
  if (oiled && !oils.carrier) return std::nullopt;  // only heat would tell its temperature
  Conditions free = c;
  if (free.operation) free.operation->slip_ratio.reset();
  const SlipModels models(free, contacts, std::move(oils));
  LoadCase driving = loaded.load_case;
  const SlipModel as_stated = models.unloaded(driving);
  const bool by_screw = driven_by(as_stated.axial_force, as_stated.speed, as_stated.geometry.lead) == DrivenBy::screw;
  driving.speed = by_screw ? -as_stated.speed : as_stated.speed;
  const std::optional<SlipOfSpeed> found = slip_at_speed(free, contacts, models, loaded, driving);
  if (!found) return std::nullopt;
  const SlipBalance& balance = found->slip.balance;
  return power_flow(found->model, balance, drive_torques(found->model, balance)).efficiency();
}

StribeckCurve stribeck_curve(const Conditions& c, const Result& result, std::size_t load_case) {
  constexpr int kDecades = 4, kPerDecade = 10;
  const LoadCaseResult& loaded = result.load_cases[load_case];
  Conditions warm = c;
  if (loaded.heat && warms(c.heat)) warm.deviations.temperature = loaded.heat->temperature;
  const SlipModels models(warm, result.contacts, oils_of(c, loaded));
  LoadCase at = loaded.load_case;
  const double speed = models.unloaded(at).speed;
  StribeckCurve curve;
  for (int k = 0; k <= kDecades * kPerDecade; ++k) {
    // From a thousandth to ten times the speed.
    at.speed = speed * std::pow(10.0, static_cast<double>(k) / kPerDecade - 3.0);
    const auto found = slip_at_speed(warm, result.contacts, models, loaded, at);
    if (!found) continue;
    SlipResult slip;
    set_slip_result(slip, found->model, found->slip, {});
    curve.speed.push_back(std::abs(*at.speed));
    curve.power.push_back(slip.power.total());
    curve.efficiency.push_back(slip.efficiency);
    for (const Interface i : kInterfaces) {
      const InterfaceSlip& threads = slip.threads[i];
      const auto most = static_cast<std::size_t>(std::ranges::max_element(threads.dynamic_normal_load) -
                                                 threads.dynamic_normal_load.begin());
      curve.friction[i].push_back(threads.friction_coefficient[most]);
      if (!threads.film_ratio.empty()) curve.film_ratio[i].push_back(threads.film_ratio[most]);
    }
  }
  return curve;
}

std::optional<PerInterface<PatchField>> thread_patches(const Conditions& c, const Result& result, std::size_t load_case,
                                                       std::size_t thread) {
  const LoadCaseResult& loaded = result.load_cases[load_case];
  const SlipModels models(c, result.contacts, oils_of(c, loaded));
  const SlipModel model = models.of(loaded);
  SlipBalance balance;
  balance_at(model, loaded.slip->slip_ratio, balance);
  PerInterface<PatchField> fields;
  for (const Interface i : kInterfaces) {
    const std::optional<std::size_t> patch = model.threads[i].patch_of_thread[thread];
    if (!patch) return std::nullopt;
    fields[i] = patch_field(models.grid(), model.threads[i].patches[*patch], balance.sliding[i], c.model.patch_points);
  }
  return fields;
}

SlipPictures slip_pictures(const Conditions& c, const Result& result, std::size_t load_case) {
  const LoadCaseResult& loaded = result.load_cases[load_case];
  const SlipModels models(c, result.contacts, oils_of(c, loaded));
  const SlipModel model = models.of(loaded);
  const SlipRange range = slip_range(model.geometry);
  // Far enough to both sides of the ideal slip ratio to show where the moment changes sign.
  const double reach =
      std::min({std::max(2.0 * std::abs(loaded.slip->slip_ratio - range.ideal), 1e-4), range.ideal, 1.0 - range.ideal});
  SlipPictures pictures;
  pictures.residue = residue_curve(model, range.pure_sliding, range.ideal);
  pictures.residue_near_root = residue_curve(model, range.ideal - reach, range.ideal + reach);
  SlipBalance balance;
  balance_at(model, loaded.slip->slip_ratio, balance);
  for (const Interface i : kInterfaces) {
    const LoadedThreads& threads = model.threads[i];
    const auto most =
        std::ranges::max_element(threads.contacts, {}, &LoadedThreads::Contact::axial_load) - threads.contacts.begin();
    pictures.most_loaded_thread[i] = patch_field(models.grid(), threads.patches[static_cast<std::size_t>(most)],
                                                 balance.sliding[i], c.model.patch_points);
  }
  return pictures;
}

}  // namespace prs
