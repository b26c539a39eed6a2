#include "prs/model/operation.h"

#include <fmt/format.h>

#include <algorithm>

#include "prs/model/viscosity_points.h"

namespace prs {
namespace {

/// Kinematic viscosity [m^2/s] of a point.
double kinematic(const ViscosityPoint& point, double density) {
  return point.viscosity ? *point.viscosity / density : *point.kinematic_viscosity;
}

/// The density, which two dynamic viscosities may do without, only shifts the 0.7 mm^2/s of the
/// line there: 10 % of it change the result by less than 0.5 % between 40 and 100 degC and 20 K
/// above where the points lie at these two.
double density_of(const Lubricant& l) {
  return l.density.value_or(l.name ? data_of(*l.name).density : contact::kTypicalOilDensity);
}

/// The oil's own law.
contact::WaltherLine line_of(const Lubricant& l) {
  if (l.walther) return *l.walther;
  const double density = density_of(l);
  std::array<ViscosityPoint, 2> points;
  if (l.viscosity_at.empty() && l.name)
    points = viscosities_of(*l.name);
  else
    std::copy_n(l.viscosity_at.begin(), 2, points.begin());
  const auto& [first, second] = points;
  return contact::walther_line(first.temperature, kinematic(first, density), second.temperature,
                               kinematic(second, density));
}

std::optional<double> stated_coefficient(const Lubricant& l) {
  return l.film.inlet_heating ? l.film.inlet_heating->temperature_coefficient : std::nullopt;
}

contact::Lubricant with_viscosity(const Lubricant& l, double viscosity) {
  assert(l.name || (l.pressure_viscosity && l.eyring_stress));
  const auto estimate = [&] {
    return contact::gold_pressure_viscosity(data_of(*l.name).base, viscosity / density_of(l));
  };
  return {.viscosity = viscosity,
          .pressure_viscosity = l.pressure_viscosity ? *l.pressure_viscosity : estimate(),
          .eyring_stress = l.eyring_stress.value_or(kTypicalEyringStress),
          .temperature_coefficient = stated_coefficient(l).value_or(0.0)};
}

}  // namespace

std::array<ViscosityPoint, 2> viscosities_of(LubricantName name) {
  const NamedLubricant& oil = data_of(name);
  return {{{313.15, {}, oil.viscosity_40}, {373.15, {}, oil.viscosity_100}}};
}

Lubricant with_data_of_name(Lubricant l) {
  if (!l.name) return l;
  l.density = density_of(l);
  if (!l.viscosity && !l.walther && l.viscosity_at.empty()) {
    const auto points = viscosities_of(*l.name);
    l.viscosity_at.assign(points.begin(), points.end());
  }
  return l;
}

contact::Lubricant at_temperature(const Lubricant& lubricant, double temperature) {
  const contact::WaltherLine line = line_of(lubricant);
  contact::Lubricant oil = with_viscosity(
      lubricant, density_of(lubricant) * contact::kinematic_viscosity(line, temperature));
  if (!stated_coefficient(lubricant))
    oil.temperature_coefficient = contact::temperature_coefficient(line, temperature);
  return oil;
}

contact::Lubricant in_operation(const Lubricant& lubricant) {
  assert(lubricant.viscosity.has_value() != lubricant.temperature.has_value());
  return lubricant.viscosity ? with_viscosity(lubricant, *lubricant.viscosity)
                             : at_temperature(lubricant, *lubricant.temperature);
}

bool has_operating_point(const Lubricant& l) { return l.viscosity || l.temperature; }

Lubricant resolved(const Lubricant& lubricant) {
  if (!lubricant.name) return lubricant;
  Lubricant l = with_data_of_name(lubricant);
  l.eyring_stress = l.eyring_stress.value_or(kTypicalEyringStress);
  if (!has_operating_point(l)) return l;
  const contact::Lubricant in = in_operation(l);
  l.pressure_viscosity = in.pressure_viscosity;
  return l;
}

std::string origin_of(std::string_view key, LubricantName name) {
  if (key == "pressure_viscosity") return "estimate from the viscosity, Gold 2001";
  if (key == "eyring_stress") return "estimate, typical of oils";
  if (key.starts_with("film.")) return {};
  return fmt::format("of {}", data_of(name).name);
}

std::optional<Warning> estimated_lubricant(const Lubricant& l) {
  if (!l.name || (l.pressure_viscosity && l.eyring_stress)) return {};
  std::string values, keys;
  const auto add = [](std::string& list, const std::string& item) {
    list += list.empty() ? item : " and " + item;
  };
  if (!l.pressure_viscosity) {
    add(values, has_operating_point(l) ? fmt::format("pressure-viscosity {:.3g} 1/GPa (Gold 2001)",
                                                     1e9 * in_operation(l).pressure_viscosity)
                                       : "pressure-viscosity (Gold 2001)");
    add(keys, "`pressure_viscosity`");
  }
  if (!l.eyring_stress) {
    add(values,
        fmt::format("Eyring stress {:.3g} MPa (oils have 2 to 10)", 1e-6 * kTypicalEyringStress));
    add(keys, "`eyring_stress`");
  }
  return Warning{
      "lubricant", "estimated_lubricant",
      fmt::format("{} of {} by estimate; efficiency follows them", values, data_of(*l.name).name),
      fmt::format("state {} where measured", keys)};
}

}  // namespace prs
