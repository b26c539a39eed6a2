#include "prs/slip/slip_warnings.h"

#include <numeric>

#include "prs/indices.h"
#include "prs/loads/load_case_result.h"
#include "prs/model/quantity_text.h"

namespace prs {
namespace {

/// Coulomb's coefficient from which surfaces are taken to touch.
constexpr double kTouchingFriction = 0.05;

/// Flash temperature above which a warning is given [K].
constexpr double kHotFlash = 50.0;

/// Temperatures of parts that run warm and of what is around them, for an estimate [K].
constexpr double kWarmParts = 353.15, kSurroundings = 298.15;

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
                                 fmt::format("{} lubrication at the {} contacts: the least film over roughness is "
                                             "{{value}}",
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
      warnings.push_back(
          Warning{"friction", fmt::format("{}_flash_temperature", name(i)),
                  fmt::format("flash temperatures at the {} contacts are {{value}} above the parts, more than "
                              "{{limit}}: films there are thinner than computed, and scuffing is "
                              "near",
                              label(i)),
                  "less speed or load, or an oil with less friction"}
              .with(hottest, kHotFlash, "K"_unit));
  }
}

/// Warns if centrifugal force lifts the rollers off the screw.
void warn_of_lifted_rollers(const LoadCaseResult& loaded, std::vector<Warning>& warnings) {
  const PerInterface<InterfaceLoads>& threads = *loaded.threads;
  int lifted = 0;
  for (const auto k : indices(threads.screw.normal_load))
    lifted += threads.screw.normal_load[k] == 0.0 && threads.nut.normal_load[k] > 0.0;
  const double centrifugal = loaded.slip->forces.centrifugal;
  if (!loaded.running || lifted == 0 || !(centrifugal > 0.0)) return;
  warnings.push_back(Warning{loaded.load_case.speed ? path_in(loaded.load_case, "speed") : "operation.speed",
                             "lifted_rollers",
                             fmt::format("rollers leave the screw at {} of {} contacts: centrifugal force presses "
                                         "each with {{value}} to the nut, against {{{:.4g} N}} on all of them along "
                                         "the axis",
                                         lifted, threads.screw.normal_load.size(), loaded.load_case.axial_force),
                             "take less speed, more load or a preload"}
                         .with(centrifugal, {}, "N"_unit));
}

/// Warns if the formula of the central film does not know the way that an interface rolls.
void warn_of_film(const SlipModel& model, const SlipResult& slip, std::vector<Warning>& warnings) {
  for (const Interface i : kInterfaces) {
    const double along_major = slip.threads[i].along_major;
    if (slip.threads[i].central_film.empty() || model.threads[i].contacts.empty()) continue;
    const double off_major = 90.0 - std::asin(std::sqrt(along_major)) * 180.0 / std::numbers::pi;
    const double ratio = contact::rolling_radius_ratio(model.threads[i].contacts.front().friction.film, along_major);
    const bool follows = model.film_direction == contact::FilmDirection::rolling;
    if (!follows && along_major > 0.5)
      warnings.push_back(Warning{"lubricant.film", fmt::format("{}_film_direction", name(i)),
                                 fmt::format("the {} contacts roll {:.0f} deg off the major axis of their "
                                             "ellipse, and their central film is that of rolling along the minor "
                                             "one; pressures do not depend on it",
                                             label(i), off_major),
                                 "for the true direction take `film: {direction: rolling}`, another formula, "
                                 "whose films are about 20 % thinner at this contact"}
                             .with(off_major / "deg"_per_si, {}, "deg"_unit, Warning::Worse::smaller)
                             .as_assumption());
    const bool low = ratio < contact::kLeastRollingRatio;
    if (follows && (low || ratio > contact::kGreatestRollingRatio))
      warnings.push_back(
          Warning{"lubricant.film", fmt::format("{}_film_range", name(i)),
                  fmt::format("the {} contacts roll {:.0f} deg off the major axis of their "
                              "ellipse; their radius across the rolling is {{value}} times that "
                              "along it, and the film's formula is made for {:g} to {:g}",
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
                             "surroundings of {:.0f} degC, the {:.0f} W lost to friction need a thermal "
                             "conductance of {{value}}, and a bare nut in still air has {{limit}}; loads, films "
                             "and life are those of the stated temperature",
                             kWarmParts - 273.15, kSurroundings - 273.15, power),
                 "add `heat`"}
      .with(needed, in_air, "W/K"_unit)
      .as_assumption();
}

/// Warns of rollers that migrate and of pitch cylinders that slide, for diameters and pitches as measured.
void warn_of_measured_parts(const Contacts& contacts, const SlipResult& slip, std::vector<Warning>& warnings) {
  if (contact::is_grooved(contacts.mechanism.type)) return;
  const Part geared = carrier_part(contacts.mechanism.type);
  if (slip.migration_per_turn != 0.0)
    warnings.push_back(Warning{"mechanism.pitch", "roller_migration",
                               fmt::format("the rollers run {} the {} by {{value}} per turn of the screw, if nothing "
                                           "stops them",
                                           slip.migration_per_turn > 0.0 ? "ahead of" : "behind", name(geared)),
                               "the model ends where they meet their stops: correct the pitches"}
                           .with(std::abs(slip.migration_per_turn), {}, "µm"_unit));
  if (has_gear_ratio(contacts)) return;
  warnings.push_back(
      Warning{"mechanism.pitch_diameter", "pitch_sliding",
              fmt::format("the pitch cylinders of rollers and {} are not in the ratio of the gears: they "
                          "slide by {{value}} per turn of the screw",
                          name(geared))}
          .with(slip.pitch_sliding_per_turn, {}, "µm"_unit));
}

/// Warns of how slip ended, and of what its numbers say by themselves.
void warn_of_result(const Conditions& c, LoadCaseResult& loaded) {
  const SlipResult& slip = *loaded.slip;
  const LoadCase& load = loaded.load_case;
  std::vector<Warning>& warnings = loaded.warnings;
  const std::string speed = load.speed ? path_in(load, "speed") : "operation.speed";
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
                           .with(*slip.holding_torque, {}, "N m"_unit));
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
  const auto is_still = [](const SlipResult& of) {
    return std::ranges::all_of(kInterfaces, [&](Interface i) {
      return std::ranges::max(of.threads[i].max_sliding_speed) < contact::kNoDirection;
    });
  };
  if (is_still(slip) && (!slip.second_nut || is_still(*slip.second_nut)))
    warnings.push_back(Warning{speed, "no_sliding",
                               "nothing slides faster than {limit}, where friction has no "
                               "direction any more: the power lost is not that of a moving screw"}
                           .with({}, contact::kNoDirection, "m/s"_unit));
  warn_of_lubrication(slip.of_nut_that_carries(load), *c.friction, warnings);
}

}  // namespace

Warning no_slip(bool jammed, const std::string& where) {
  if (jammed)
    return {"friction", "jammed",
            where +
                ": a contact jams: its friction takes more of the axial load than its normal "
                "load gives; expect the screw to stick"};
  return {"carrier", "no_slip_ratio", where + ": no slip ratio balances the moment on a roller",
          "check friction and the carrier's torques: threads without load, as of an open nut, or with little "
          "friction cannot overcome them"};
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

std::optional<Warning> guides_press(const Conditions& c, const PerInterface<OverStatic>& over_static) {
  const Interface i = is_worse(over_static.nut, over_static.screw) ? Interface::nut : Interface::screw;
  const double change = over_static[i].largest - 1.0;
  if (std::abs(change) <= kMuchOverStatic) return std::nullopt;
  constexpr std::string_view kGuidance[] = {"both_end_nodes", "outer_node", "ring"};
  const Guidance& guidance = c.structure->roller.guidance;
  const std::string_view kind = item_at(kGuidance, guidance.kind);
  const bool loose = guidance.clearance > 0.0;
  const double all = over_static[i].all, taken = 1.0 - std::pow(all, -3.0);
  return Warning{
      "structure.roller.guidance", loose ? "guides_with_clearance" : "guides_without_play",
      fmt::format(
          "friction moves the largest load of a {} thread by {:+.1f} %: the mean of all by {:+.1f} %{}, whatever "
          "guides the rollers; the rest because friction presses them against their guides, {} {}; other guides give "
          "another rest",
          name(i), change * "%"_per_si, (all - 1.0) * "%"_per_si,
          taken > 0.0 ? fmt::format(", which takes {:.0f} % of its life", taken * "%"_per_si) : "", kind,
          loose ? fmt::format("with a clearance of {{{:g} um}}", guidance.clearance * "µm"_per_si)
                : "taken without play")}
      .with(std::abs(change), kMuchOverStatic, "%"_unit)
      .as_assumption();
}

void add_slip_warnings(const Conditions& c, const Contacts& contacts, const SlipModel* model, LoadCaseResult& loaded) {
  const SlipResult& slip = *loaded.slip;
  const LoadCase& load = loaded.load_case;
  std::vector<Warning>& warnings = loaded.warnings;
  const auto add = [&](std::optional<Warning> warning) {
    if (warning) warnings.push_back(std::move(*warning));
  };
  if (slip.status != SlipStatus::held) warn_of_result(c, loaded);
  if (!model) return;
  if (loaded.running)
    add(guides_press(c, {common_over_static(loaded.threads->screw), common_over_static(loaded.threads->nut)}));
  if (slip.converged()) {
    warn_of_measured_parts(contacts, slip, warnings);
    warn_of_film(*model, slip.of_nut_that_carries(load), warnings);
    warn_of_flashes(slip.of_nut_that_carries(load), warnings);
    warn_of_lifted_rollers(loaded, warnings);
    if (load.name != kBackDriving) add(unknown_heat_flow(c, contacts.mechanism, slip.power.total()));
  }
  for (const Interface i : kInterfaces)
    if (const auto& pressure = (*loaded.threads)[i].peak_pressure; !pressure.empty())
      add(running_pressure_warning(path_in(load, "axial_force"), i, std::ranges::max(pressure), contacts));
}

}  // namespace prs
