#include "prs/size/sized_screw.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "prs/configurations/screw_case.h"
#include "prs/input/units.h"
#include "prs/size/motion.h"

namespace prs {
namespace {

using input::format_quantity;
namespace unit = input::unit;

constexpr double kNoTravel = 1e-3;  ///< Stands for the travel where nothing moves under load [m].

/// Travel of a segment in the spectrum [m].
double spectrum_travel(const MotionCycle& cycle, const MotionSegment& s) {
  return cycle.mean_load ? std::abs(s.travel()) : kNoTravel;
}

DrivenBy driven_by(const MotionSegment& s) {
  return s.force * s.sense() < 0.0 ? DrivenBy::load : DrivenBy::screw;
}

/// As a text of YAML, whatever it holds.
std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

double shaft_length(const Requirement& r, const CompleteScrew& s) {
  if (r.measures.shaft.length) return *r.measures.shaft.length;
  const double d = s.data.screw_diameter, nut = s.c.structure->nut.length;
  if (!r.stroke) return 20.0 * d;
  return (s.data.type == Mechanism::Type::standard ? *r.stroke : 0.0) + nut + 2.0 * d;
}

LoadCase load_case(const SizeInput& in, const CompleteScrew& s, std::string name, double force,
                   double speed) {
  LoadCase load;
  load.name = std::move(name);
  load.axial_force = std::abs(force);
  load.direction = direction_of(in.values, force);
  load.position = s.position;
  load.speed = input::rotation(written_speed(in.values, force, speed), s.c.mechanism.lead);
  return load;
}

/// Force and speed of the case that the load drives.
std::pair<double, double> back_driving(const MotionCycle& cycle) {
  return {cycle.largest_sign * cycle.driving_force(), -cycle.largest_sign * cycle.driving_speed()};
}

}  // namespace

double written_speed(const Requirement& r, double force, double speed) {
  const bool tension = direction_of(r, force) == Direction::tension;
  return (force > 0.0) == tension ? speed : -speed;
}

SizedCase sized_case(const SizeInput& in, const CandidateData& candidate) {
  const Requirement& r = in.values;
  const MotionCycle& cycle = in.cycle;
  SizedCase sized;
  sized.screw = screw_of(candidate, r.stroke);
  const CompleteScrew& s = sized.screw;
  sized.shaft_length = shaft_length(r, s);
  Case& c = sized.c;
  c = s.c;
  c.model.bodies = ModelOptions::Bodies::refined;
  if (r.model.loads == Requirement::Loads::at_rest) c.model.loads = ModelOptions::Loads::at_rest;
  Life& life = c.life.emplace();
  life.position = s.position;
  life.reliability = r.life.reliability;
  life.modification_factor = r.life.modification_factor;
  for (const MotionSegment& segment : cycle.shown) {
    const bool moves = segment.sense() != 0;
    std::optional<std::size_t>& place = sized.load_case_of.emplace_back();
    if (!segment.is_loaded()) continue;
    life.spectrum.push_back({.force = std::abs(segment.force),
                             .direction = direction_of(r, segment.force),
                             .distance = spectrum_travel(cycle, segment),
                             .driven_by = driven_by(segment)});
    if (!moves) continue;
    place = c.load_cases.size();
    c.load_cases.push_back(
        load_case(in, s, segment.name, segment.force, segment.sense() * segment.mean_speed()));
  }
  const auto [force, speed] = back_driving(cycle);
  c.load_cases.push_back(load_case(in, s, std::string(kBackDriving), force, speed));
  c.operation = Operation{.speed = input::rotation(cycle.driving_speed(), s.c.mechanism.lead)};
  c.friction = r.friction;
  c.lubricant = r.lubricant;
  c.roughness = r.roughness;
  c.carrier = r.carrier;
  MeasureOptions& measures = c.measures.emplace();
  measures.loaded_width = r.measures.loaded_width;
  measures.friction_coefficient = r.measures.friction_coefficient;
  measures.yield_strength = r.measures.yield_strength;
  measures.shaft = MeasureOptions::Shaft{sized.shaft_length, r.measures.shaft.ends};
  return sized;
}

namespace {

std::string load_cases_text(const SizeInput& in, const SizedCase& sized) {
  std::string text = "load_cases:\n";
  const auto add = [&](const LoadCase& load, double speed) {
    text += fmt::format(
        "  - {{name: {}, axial_force: {}, direction: {}, position: {},\n     speed: {}}}\n",
        quoted(load.name), format_quantity(load.axial_force, unit::force), name(*load.direction),
        format_quantity(*load.position, unit::length), format_quantity(speed, unit::travel_speed));
  };
  for (std::size_t k = 0; k < in.cycle.shown.size(); ++k)
    if (const auto& place = sized.load_case_of[k]) {
      const MotionSegment& s = in.cycle.shown[k];
      add(sized.c.load_cases[*place],
          written_speed(in.values, s.force, s.sense() * s.mean_speed()));
    }
  const auto [force, speed] = back_driving(in.cycle);
  add(sized.c.load_cases[sized.back_driving()], written_speed(in.values, force, speed));
  return text;
}

std::string life_text(const CandidateData& candidate, const SizedCase& sized, bool by_maker) {
  const Life& life = *sized.c.life;
  std::string text = fmt::format(
      "life:\n  position: {}\n  reliability: {}\n  modification_factor: {}\n  spectrum:\n",
      format_quantity(*life.position, unit::length), format_quantity(life.reliability, unit::share),
      life.modification_factor);
  for (const SpectrumLoad& load : life.spectrum)
    text += fmt::format("    - {{force: {}, direction: {}, distance: {}, driven_by: {}}}\n",
                        format_quantity(load.force, unit::force), name(load.direction),
                        format_quantity(*load.distance, unit::length), name(load.driven_by));
  if (!by_maker || !candidate.dynamic_capacity) return text;
  text += fmt::format(
      "  # As the maker prints them; without these lines life is that by threads.\n"
      "  dynamic_capacity: {}\n",
      format_quantity(*candidate.dynamic_capacity, unit::force));
  if (candidate.static_capacity)
    text += fmt::format("  static_capacity: {}\n",
                        format_quantity(*candidate.static_capacity, unit::force));
  return text;
}

std::string measures_text(const Case& c) {
  const MeasureOptions& m = *c.measures;
  constexpr const char* kEnds[] = {"fixed_free", "supported_supported", "fixed_supported",
                                   "fixed_fixed"};
  return fmt::format(
      "measures:\n{}  friction_coefficient: {}\n  yield_strength: {}\n  shaft: {{length: {}, ends: "
      "{}}}\n",
      m.loaded_width
          ? fmt::format("  loaded_width: {}\n", format_quantity(*m.loaded_width, unit::length))
          : "",
      *m.friction_coefficient, format_quantity(*m.yield_strength, unit::pressure),
      format_quantity(m.shaft->length, unit::length), kEnds[static_cast<int>(m.shaft->ends)]);
}

std::string limits_text(const SizeInput& in) {
  const Requirement::Limits& l = in.values.limits;
  const Requirement::Life& life = in.values.life;
  std::string text = "limits:\n";
  const auto add = [&](const char* key, const std::optional<double>& value,
                       const input::Dimension& dimension) {
    if (value) text += fmt::format("  {}: {}\n", key, format_quantity(*value, dimension));
  };
  if (in.cycle.mean_load && (life.hours || life.distance)) {
    const double cycles =
        life.hours ? *life.hours / in.cycle.duration : *life.distance / in.cycle.travel;
    text += fmt::format("  life: {}   # of travel under load\n",
                        format_quantity(cycles * in.cycle.loaded_travel, unit::distance));
  }
  text += fmt::format("  static_safety: {}\n  buckling_safety: {}\n", l.static_safety,
                      l.buckling_safety);
  add("critical_speed_share", l.critical_speed_share, unit::share);
  add("speed_times_diameter", l.speed_times_diameter, unit::speed);
  add("nut_diameter", l.nut_diameter, unit::length);
  add("nut_length", l.nut_length, unit::length);
  add("weight", l.weight, unit::mass);
  add("stiffness", l.stiffness, unit::stiffness);
  add("efficiency", l.efficiency, unit::share);
  return text;
}

std::string heat_text(const SizeInput& in, const SizedCase& sized, const Heat::Conductance& k) {
  const auto conductance = [](double value) {
    return format_quantity(value, unit::thermal_conductance);
  };
  std::string text = fmt::format(
      "# Temperatures that follow from the losses, with `prs slip`; the list took the mean of the\n"
      "# cycle at the lubricant's temperature:\n# heat:\n#   ambient: {}\n"
      "#   conductance: {{screw_ambient: {}, nut_ambient: {}, rollers_ambient: {},\n"
      "#     screw_rollers: {}, rollers_nut: {}}}\n#   specific_heat: 460 J/(kg K)\n#   duty:\n",
      format_quantity(in.values.heat.ambient, unit::temperature), conductance(k.screw_ambient),
      conductance(k.nut_ambient), conductance(k.rollers_ambient), conductance(k.screw_rollers),
      conductance(k.rollers_nut));
  for (std::size_t j = 0; j < in.cycle.shown.size(); ++j) {
    const MotionSegment& s = in.cycle.shown[j];
    const std::string time = format_quantity(s.duration, unit::duration);
    text += sized.load_case_of[j]
                ? fmt::format("#     - {{load_case: {}, duration: {}}}\n", quoted(s.name), time)
                : fmt::format("#     - {{rest: {}}}\n", time);
  }
  return text;
}

}  // namespace

std::string sized_case_text(const SizeInput& in, const CandidateData& candidate,
                            const SizedCase& sized, const Heat::Conductance& conductance,
                            bool by_maker) {
  const std::string origin =
      fmt::format("Chosen by `prs size` for {}: {}, {} {}.", in.source.name, candidate.name,
                  candidate.is_row ? "row of the catalogue" : "design", candidate.number);
  return screw_text(sized.screw, origin) +
         fmt::format("\nmodel: {{bodies: refined{}}}\n",
                     sized.c.model.loads ? ", loads: static" : "") +
         "# One load case per segment of the motion, at its mean speed; the load drives the "
         "last.\n" +
         load_cases_text(in, sized) +
         fmt::format("\noperation: {{speed: {}}}   # mean of the time in motion\n",
                     format_quantity(in.cycle.driving_speed(), unit::travel_speed)) +
         friction_text(in.values) + "\n" + lubricant_text(in.values) + "\n" +
         roughness_text(in.values) + "\n" + carrier_text(in.values) + "\n" +
         heat_text(in, sized, conductance) + "\n" + life_text(candidate, sized, by_maker) + "\n" +
         measures_text(sized.c) + "\n" + limits_text(in);
}

}  // namespace prs
