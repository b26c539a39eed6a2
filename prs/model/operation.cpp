#include "prs/model/operation.h"

#include <fmt/format.h>

#include <algorithm>

namespace prs {
namespace {

/// Kinematic viscosity [m^2/s] of a point.
double kinematic(const ViscosityPoint& point, double density) {
  return point.viscosity ? *point.viscosity / density : *point.kinematic_viscosity;
}

/// Density for Walther's line. Two dynamic viscosities may lack it: it only shifts the 0.7 mm^2/s of the line there; 10
/// % of it change the result by less than 0.5 % between 40 and 100 degC, and 20 K above if the points lie at these two.
double density_of(const Lubricant& l) {
  return l.density.value_or(l.name ? data_of(*l.name).density : contact::kTypicalOilDensity);
}

/// Walther line of the oil.
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

using enum contact::BaseOil;

/// Midpoints of the grades; at 100 degC the viscosity for the index of 95 with which the annex of ISO 3448 tabulates
/// the grades. Densities are typical of such oils, not from a data sheet, where the source says so.
constexpr std::string_view kIso = "midpoints of ISO 3448, viscosity index 95 by ASTM D2270; density: typical";
constexpr std::string_view kAeroShell = "The AeroShell Book, 19th edition (2012): base oil, typical; density: typical";
constexpr std::string_view kSkf =
    "SKF bearing grease selection chart: base oil at 40 degC; at 100 degC viscosity index 95 by "
    "ASTM D2270; density: typical";

constexpr NamedLubricant kLubricants[] = {
    {"iso-vg-32", "mineral oil", mineral, 32e-6, 5.29e-6, 875.0, kIso},
    {"iso-vg-46", "mineral oil", mineral, 46e-6, 6.64e-6, 879.0, kIso},
    {"iso-vg-68", "mineral oil", mineral, 68e-6, 8.53e-6, 887.0, kIso},
    {"iso-vg-100", "mineral oil", mineral, 100e-6, 11.07e-6, 891.0, kIso},
    {"iso-vg-150", "mineral oil", mineral, 150e-6, 14.54e-6, 897.0, kIso},
    {"iso-vg-220", "mineral oil", mineral, 220e-6, 18.75e-6, 899.0, kIso},
    {"iso-vg-320", "mineral oil", mineral, 320e-6, 23.95e-6, 903.0, kIso},
    {"iso-vg-460", "mineral oil", mineral, 460e-6, 30.34e-6, 904.0, kIso},
    {"mil-prf-23699", "turbine oil, ester: Mobil Jet Oil II", ester, 27.6e-6, 5.1e-6, 1003.5,
     "Mobil Jet Oil II, product data sheet: typical values"},
    {"mil-prf-7808", "turbine oil, ester: grade 3", ester, 11.5e-6, 3.0e-6, 950.0,
     "MIL-PRF-7808L, least viscosities of grade 3; density: typical"},
    {"mil-prf-83282", "hydraulic fluid, polyalphaolefin", polyalphaolefin, 14.0e-6, 3.45e-6, 850.0,
     "MIL-PRF-83282D, least viscosities; density: typical"},
    {"mil-prf-23827", "grease for screws and gears: AeroShell Grease 33", polyalphaolefin, 14.2e-6, 3.4e-6, 850.0,
     kAeroShell},
    {"mil-prf-81322", "grease, wide temperature range: AeroShell Grease 22", polyalphaolefin, 30.5e-6, 5.7e-6, 830.0,
     kAeroShell},
    {"skf-lgmt-2", "grease, lithium soap: SKF LGMT 2", mineral, 110e-6, 11.80e-6, 890.0, kSkf},
    {"skf-lgep-2", "grease, lithium soap, EP: SKF LGEP 2", mineral, 200e-6, 17.61e-6, 898.0, kSkf},
    {"skf-lgwa-2", "grease, lithium complex, EP: SKF LGWA 2", mineral, 185e-6, 16.73e-6, 898.0, kSkf},
    {"skf-lghb-2", "grease, calcium sulphonate: SKF LGHB 2", mineral, 400e-6, 27.69e-6, 904.0, kSkf},
};

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
  contact::Lubricant oil =
      with_viscosity(lubricant, density_of(lubricant) * contact::kinematic_viscosity(line, temperature));
  oil.temperature = temperature;
  if (!stated_coefficient(lubricant)) oil.temperature_coefficient = contact::temperature_coefficient(line, temperature);
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
  const auto add = [](std::string& list, const std::string& item) { list += list.empty() ? item : " and " + item; };
  if (!l.pressure_viscosity) {
    add(values, has_operating_point(l) ? fmt::format("pressure-viscosity {:.3g} 1/GPa (Gold 2001)",
                                                     1e9 * in_operation(l).pressure_viscosity)
                                       : "pressure-viscosity (Gold 2001)");
    add(keys, "`pressure_viscosity`");
  }
  if (!l.eyring_stress) {
    add(values, fmt::format("Eyring stress {{{:.3g} MPa}} (oils have 2 to 10)", 1e-6 * kTypicalEyringStress));
    add(keys, "`eyring_stress`");
  }
  return Warning{"lubricant", "estimated_lubricant",
                 fmt::format("{} of {} by estimate; efficiency follows them", values, data_of(*l.name).name),
                 fmt::format("state {} where measured", keys)};
}

std::span<const NamedLubricant> named_lubricants() { return kLubricants; }

const NamedLubricant& data_of(LubricantName name) { return kLubricants[static_cast<std::size_t>(name)]; }

contact::FrictionLaw Friction::at(Interface i) const {
  PerInterface<contact::LawParametersOf<double>> laws;
  simd::deliver(static_cast<const contact::LawParametersOf<PerInterface<double>>&>(*this), &laws.screw, 2);
  return {laws[i], kind};
}

}  // namespace prs
