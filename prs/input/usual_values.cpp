#include "prs/input/echo.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "prs/input/schema.h"
#include "prs/model/part.h"

namespace prs::input {
namespace {

/// Magnitudes of a value that are usual, ends included, as they would stand in a file; one without
/// an end has no limit there. The path stands for that of each part and each entry of a list.
struct UsualValue {
  std::string_view path;
  std::string_view least;
  std::string_view greatest;
  std::string_view example;  ///< What most have.
};

constexpr UsualValue kUsual[] = {
    // Screws in catalogues have 3.5 to 150 mm and leads of 0.5 to 50 mm; lessons have 25 mm.
    {"mechanism.lead", "0.2 mm", "100 mm", "catalogues have 1 mm to 50 mm"},
    {"mechanism.pitch_diameter", "1 mm", "500 mm", "screws in catalogues have 3.5 mm to 150 mm"},
    {"mechanism.centre_distance", "2 mm", "500 mm", "two thirds of the screw's diameter"},
    // From polymers of nuts (polyoxymethylene, polyether ether ketone) to tungsten carbide.
    {"materials.youngs_modulus", "1 GPa", "700 GPa", "steel has 190 GPa to 215 GPa"},
    {"materials.poisson_ratio", "0.15", "0.44", "steel has 0.27 to 0.3"},
    {"materials.density", "900 kg/m^3", "16000 kg/m^3", "steel has 7700 kg/m^3 to 8000 kg/m^3"},
    {"materials.thermal_expansion", "2 um/m/K", "150 um/m/K", "steel has 10 um/m/K to 17 um/m/K"},
    // From a nut on springs to a block of steel.
    {"structure.nut.housing.axial", "100 N/mm", "1e6 kN/mm",
     "housings have 10 kN/mm to 10000 kN/mm"},
    {"structure.nut.housing.lateral", "1 N/mm", "1e6 kN/mm",
     "housings have 10 kN/mm to 10000 kN/mm"},
    // The largest static capacities in catalogues are about 3 MN.
    {"load_cases.axial_force", "", "10 MN", "catalogues end at static capacities of 3 MN"},
    {"life.spectrum.force", "", "10 MN", "catalogues end at static capacities of 3 MN"},
    {"life.dynamic_capacity", "", "10 MN", "catalogues end at 2 MN"},
    {"life.static_capacity", "", "10 MN", "catalogues end at 3 MN"},
    {"preload.force", "", "1 MN", "some 5 % of the dynamic capacity"},
    {"preload.load.from", "", "10 MN", "catalogues end at static capacities of 3 MN"},
    {"preload.load.to", "", "10 MN", "catalogues end at static capacities of 3 MN"},
    // n d of 150,000 mm/min is 37,500 rpm of the smallest screw.
    {"load_cases.speed", "", "40000 rpm", "n d is at most 150000 mm/min"},
    {"operation.speed", "", "40000 rpm", "n d is at most 150000 mm/min"},
    // From lathe-turned to superfinished flanks.
    {"roughness", "0.01 um", "5 um", "ground flanks have Rq 0.2 um to 0.8 um"},
    // Thin oil when hot to the base oil of a stiff grease when cold.
    {"lubricant.viscosity", "1 mPa s", "50 Pa s", "oil in operation has 5 mPa s to 500 mPa s"},
    {"lubricant.viscosity_at.viscosity", "1 mPa s", "50 Pa s", "oil has 5 mPa s to 500 mPa s"},
    {"lubricant.viscosity_at.kinematic_viscosity", "1 mm^2/s", "50000 mm^2/s",
     "ISO VG grades have 2 mm^2/s to 1500 mm^2/s at 40 degC"},
    // Below lie cold space hardware and superconductors, above no oil lives.
    {"lubricant.temperature", "200 K", "570 K", "-50 degC to 200 degC"},
    {"lubricant.viscosity_at.temperature", "200 K", "570 K", "40 degC and 100 degC"},
    {"deviations.temperature", "200 K", "570 K", "-50 degC to 200 degC"},
    {"deviations.reference_temperature", "200 K", "570 K", "20 degC"},
    // Hydrocarbons to perfluoropolyethers.
    {"lubricant.density", "600 kg/m^3", "2100 kg/m^3", "mineral oil has 860 kg/m^3 to 900 kg/m^3"},
    {"lubricant.pressure_viscosity", "3 1/GPa", "60 1/GPa", "oils have 10 1/GPa to 35 1/GPa"},
    {"lubricant.eyring_stress", "0.5 MPa", "50 MPa", "oils have 2 MPa to 20 MPa"},
    // From full films to steel on steel without oil.
    {"wear.coefficient", "1e-13 mm^3/(N m)", "1e-2 mm^3/(N m)",
     "lubricated steel has about 1e-8 mm^3/(N m)"},
    // From water-like oils to filled greases; from titanium and austenite to copper alloys.
    {"lubricant.film.inlet_heating.conductivity", "0.05 W/(m K)", "0.7 W/(m K)",
     "oils have 0.12 W/(m K) to 0.16 W/(m K)"},
    {"lubricant.film.inlet_heating.temperature_coefficient", "0.005 1/K", "0.2 1/K",
     "oils have 0.02 1/K to 0.06 1/K"},
    {"materials.conductivity", "0.1 W/(m K)", "430 W/(m K)", "bearing steel has 45 W/(m K)"},
    {"materials.specific_heat", "100 J/(kg K)", "3000 J/(kg K)", "steel has 460 J/(kg K)"},
    {"heat.ambient", "200 K", "570 K", "-50 degC to 200 degC"},
    // From a nut of a few mm in still air to one cooled by oil.
    {"heat.conductance.screw_ambient", "", "1000 W/K", "some W/K through bearings and housing"},
    {"heat.conductance.nut_ambient", "", "1000 W/K", "some W/K through seat and housing"},
    {"heat.conductance.rollers_ambient", "", "1000 W/K", "none, in a closed nut"},
    {"heat.specific_heat", "100 J/(kg K)", "3000 J/(kg K)", "steel has 460 J/(kg K)"},
    {"carrier.roller_torque", "", "50 N m", "some mN m"},
    {"measures.friction_coefficient", "0.001", "0.3", "catalogues have 0.01"},
    {"measures.yield_strength", "100 MPa", "4 GPa", "steel has 300 MPa to 2 GPa"},
    {"measures.system.shaft.length", "5 mm", "20 m", "ten to a hundred screw diameters"},
    {"measures.system.support_bearing", "1 N/um", "100 kN/um", "bearings have 100 N/um to 3 kN/um"},
    {"measures.system.housing", "1 N/um", "1000 kN/um", "housings have 10 N/um to 10 kN/um"},
    {"measures.shaft.length", "5 mm", "20 m", "ten to a hundred screw diameters"},
};

/// Whether the path is that of the row, or of one of its parts.
bool is_of(std::string_view path, std::string_view row) {
  if (path == row) return true;
  for (const Part p : kParts) {
    const std::string part = fmt::format(".{}", name(p));
    const std::size_t at = path.find(part);
    if (at == std::string_view::npos || path.size() != row.size() + part.size()) continue;
    if (path.substr(0, at) == row.substr(0, at) && path.substr(at + part.size()) == row.substr(at))
      return true;
  }
  return false;
}

double end_of(std::string_view text, const Dimension* dimension, double where_absent) {
  if (text.empty()) return where_absent;
  return dimension ? parse_quantity(text, *dimension).value.value() : parse_number(text).value();
}

/// The same number in a unit in which it is usual; empty where there is none.
std::string usual_unit(const EchoEntry& field, double least, double greatest) {
  const auto written = split_unit(field.written);
  if (!written || !field.dimension) return {};
  for (const Unit& unit : field.dimension->units)
    if (const auto si = to_si(written->number, unit);
        si && std::abs(*si) >= least && std::abs(*si) <= greatest)
      return fmt::format("{:.10g} {}", written->number, unit.spellings[0]);
  return {};
}

std::string range_text(const UsualValue& row) {
  if (row.least.empty()) return fmt::format("up to {}", row.greatest);
  return fmt::format("{} to {}", row.least, row.greatest);
}

}  // namespace

std::vector<Warning> unusual_values(const std::vector<EchoEntry>& fields) {
  std::vector<Warning> warnings;
  for (const EchoEntry& field : fields) {
    if (field.is_default || !field.number) continue;
    const std::string path = without_places(field.path);
    const auto row =
        std::ranges::find_if(kUsual, [&](const UsualValue& u) { return is_of(path, u.path); });
    if (row == std::end(kUsual)) continue;
    const double least = end_of(row->least, field.dimension, 0.0);
    const double greatest =
        end_of(row->greatest, field.dimension, std::numeric_limits<double>::infinity());
    const double size = std::abs(*field.number);
    if (size >= least && size <= greatest) continue;
    const std::string unit = usual_unit(field, least, greatest);
    warnings.push_back(Warning{
        field.path, "unusual_value",
        fmt::format("got {}; usual is {} ({})", field.written, range_text(*row), row->example),
        unit.empty() ? "check value and unit" : fmt::format("check the unit: `{}`?", unit)}
                           .with(size, size < least ? least : greatest, {},
                                 size < least ? Warning::Worse::smaller : Warning::Worse::larger));
  }
  return warnings;
}

}  // namespace prs::input
