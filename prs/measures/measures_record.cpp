#include "prs/measures/measures_record.h"

#include <initializer_list>

#include "prs/input/document.h"

namespace prs {

std::string_view measures_texts();  // measures.yaml

namespace {

/// The larger load rate of both interfaces.
std::optional<double> largest_load_rate(const LoadMeasures& m) {
  const auto& [screw, nut] = m.largest_load_rate;
  return screw && nut ? std::optional(std::max(*screw, *nut)) : std::nullopt;
}

constexpr Quantity<SystemStiffness::Contribution> kContribution[] = {
    {.key = "stiffness_N_per_um",
     .value = of<&SystemStiffness::Contribution::stiffness>,
     .meaning = "of this part alone"},
    {.key = "percent",
     .value = of<&SystemStiffness::Contribution::share>,
     .meaning = "of the total compliance; all sum to 100",
     .unit = unit_of("share_percent")},
};

constexpr Quantity<SystemStiffness::Contributions> kContributions[] = {
    {"mechanism", of<&SystemStiffness::Contributions::mechanism>,
     "threads and bodies, the secant stiffness of the load case at rest"},
    {"shaft", of<&SystemStiffness::Contributions::shaft>, "stretch of the screw's shaft"},
    {"wind_up", of<&SystemStiffness::Contributions::wind_up>, "travel by which the shaft twists, without friction"},
    {"support_bearing", of<&SystemStiffness::Contributions::support_bearing>, "all bearings of the shaft together"},
    {"housing", of<&SystemStiffness::Contributions::housing>, "what holds the nut"},
};

constexpr Quantity<SystemStiffness> kSystemStiffness[] = {
    {"total_N_per_um", of<&SystemStiffness::total>, "of all in series"},
    {"contributions", of<&SystemStiffness::contributions>, "by what gives way"},
};

constexpr Quantity<Measures> kMeasures[] = {
    {"velocity_ratio_mm_per_rad", of<&Measures::velocity_ratio>},
    {"roller_ratio", of<&Measures::roller_ratio>},
    {"carrier_ratio", of<&Measures::carrier_ratio>},
    {"efficiency", of<&Measures::efficiency>},
    {"back_driving_efficiency", of<&Measures::back_driving_efficiency>},
    {"section_stiffness_screw_N_per_um", of_side<&Measures::section_stiffness, Part::screw>},
    {"section_stiffness_roller_N_per_um", of_side<&Measures::section_stiffness, Part::roller>},
    {"section_stiffness_nut_N_per_um", of_side<&Measures::section_stiffness, Part::nut>},
    {"tooth_stiffness_screw_N_per_um", of_side<&Measures::tooth_stiffness, Part::screw>},
    {"tooth_stiffness_roller_N_per_um", of_side<&Measures::tooth_stiffness, Part::roller>},
    {"tooth_stiffness_nut_N_per_um", of_side<&Measures::tooth_stiffness, Part::nut>},
    {"geometry_factor", of<&Measures::geometry_factor>},
    {"element_diameter_mm", of<&Measures::element_diameter>},
    {"dynamic_capacity_N", of<&Measures::dynamic_capacity>},
    {"dynamic_capacity_low_N", of<&Measures::dynamic_capacity_low>},
    {"dynamic_capacity_high_N", of<&Measures::dynamic_capacity_high>},
    {"static_capacity_N", of<&Measures::static_capacity>},
    {"deformation_capacity_screw_N", of_side<&Measures::deformation_capacity, Interface::screw>},
    {"deformation_capacity_nut_N", of_side<&Measures::deformation_capacity, Interface::nut>},
    {"pressure_capacity_screw_N", of_side<&Measures::pressure_capacity, Interface::screw>},
    {"pressure_capacity_nut_N", of_side<&Measures::pressure_capacity, Interface::nut>},
    {"flank_edge_load_N", of<&Measures::flank_edge_load>},
    {"flank_edge_load_screw_N", of_side<&Measures::interface_flank_edge_load, Interface::screw>},
    {"flank_edge_load_nut_N", of_side<&Measures::interface_flank_edge_load, Interface::nut>},
    {"roller_weight_kg", of<&Measures::roller_weight>},
    {"nut_weight_kg", of<&Measures::nut_weight>},
    {"weight_kg", of<&Measures::weight>},
    {"screw_weight_kg_per_m", of<&Measures::screw_weight_per_length>},
    {"material_volume_cm3", of<&Measures::material_volume>},
    {"envelope_volume_cm3", of<&Measures::envelope_volume>},
    {"force_density_kN_per_kg", of<&Measures::force_density>},
    {"roller_inertia_kg_mm2", of<&Measures::roller_inertia>},
    {"travel_inertia_kg_mm2", of<&Measures::travel_inertia>},
    {"screw_inertia_kg_mm2", of<&Measures::screw_inertia>},
    {"nut_inertia_kg_mm2", of<&Measures::nut_inertia>},
    {"equivalent_inertia_kg_mm2", of<&Measures::equivalent_inertia>},
    {"shaft_stiffness_N_per_um", of<&Measures::shaft_stiffness>},
    {"buckling_load_N", of<&Measures::buckling_load>},
    {"critical_speed_rpm", of<&Measures::critical_speed>},
};

constexpr Quantity<LoadMeasures> kLoadMeasures[] = {
    {"lowest_frequency_Hz", of<&LoadMeasures::lowest_frequency>},
    {"speeds_to_avoid_rpm", filled<&LoadMeasures::speeds_to_avoid>},
    {"hertz_stiffness_screw_N_per_um", of_side<&LoadMeasures::hertz_stiffness, Interface::screw>},
    {"hertz_stiffness_nut_N_per_um", of_side<&LoadMeasures::hertz_stiffness, Interface::nut>},
    {"thread_stiffness_N_per_um", of<&LoadMeasures::thread_stiffness>},
    {"system_stiffness", of<&LoadMeasures::system_stiffness>},
    {.key = "yang_largest_load_rate_percent",
     .value = of<&LoadMeasures::yang_largest_load_rate>,
     .delivery = Reach::complete},
    {"largest_load_rate_screw_percent", of_side<&LoadMeasures::largest_load_rate, Interface::screw>},
    {"largest_load_rate_nut_percent", of_side<&LoadMeasures::largest_load_rate, Interface::nut>},
    {"largest_load_rate_percent", of<&largest_load_rate>},
    {"mean_peak_pressure_screw_MPa", of_side<&LoadMeasures::mean_peak_pressure, Interface::screw>},
    {"mean_peak_pressure_nut_MPa", of_side<&LoadMeasures::mean_peak_pressure, Interface::nut>},
    {"largest_peak_pressure_screw_MPa", of_side<&LoadMeasures::largest_peak_pressure, Interface::screw>},
    {"largest_peak_pressure_nut_MPa", of_side<&LoadMeasures::largest_peak_pressure, Interface::nut>},
    {"root_shear_stress_screw_MPa", of_side<&LoadMeasures::root_shear_stress, Part::screw>},
    {"root_shear_stress_roller_MPa", of_side<&LoadMeasures::root_shear_stress, Part::roller>},
    {"root_shear_stress_nut_MPa", of_side<&LoadMeasures::root_shear_stress, Part::nut>},
    {"root_bending_stress_screw_MPa", of_side<&LoadMeasures::root_bending_stress, Part::screw>},
    {"root_bending_stress_roller_MPa", of_side<&LoadMeasures::root_bending_stress, Part::roller>},
    {"root_bending_stress_nut_MPa", of_side<&LoadMeasures::root_bending_stress, Part::nut>},
    {.key = "solved_static_safety", .value = of<&LoadMeasures::solved_static_safety>, .delivery = Reach::complete},
    {.key = "flank_edge_margin", .value = of<&LoadMeasures::flank_edge_margin>, .delivery = Reach::complete},
    {"static_safety", of<&LoadMeasures::static_safety>},
    {"thread_static_safety", of<&LoadMeasures::thread_static_safety>},
    {"buckling_safety", of<&LoadMeasures::buckling_safety>},
    {"l10_revolutions", of<&LoadMeasures::life>},
    {"l10_hours", of<&LoadMeasures::life_hours>},
    {"l10_travel_km", of<&LoadMeasures::life_travel>},
    {"drive_torque_Nm", of<&LoadMeasures::drive_torque>},
    {.key = "back_driving_efficiency_by_slip",
     .value = of<&LoadMeasures::back_driving_efficiency>,
     .delivery = Reach::complete},
    {"speed_safety", of<&LoadMeasures::speed_safety>},
    {.key = "solved_static_safety_limit",
     .value = of<&LoadMeasures::solved_static_safety_limit>,
     .delivery = Reach::complete},
    {"static_safety_limit", of<&LoadMeasures::static_safety_limit>},
    {"thread_static_safety_limit", of<&LoadMeasures::thread_static_safety_limit>},
    {.key = "yang_load_rate_percent", .value = filled<&LoadMeasures::yang_load_rate>, .delivery = Reach::complete},
};

/// Texts by groups and keys.
const input::Node& texts() {
  static const input::Node root = [] {
    const input::Source source = input::source_of_text("measures.yaml", std::string(measures_texts()), {});
    input::ErrorList errors(source);
    input::Node read = input::read_document(source, errors);
    errors.throw_if_any();
    return read;
  }();
  return root;
}

/// Quantities with their texts from measures.yaml.
template <class Owner, std::size_t n>
std::span<const Quantity<Owner>> with_texts(const Quantity<Owner> (&quantities)[n]) {
  static const std::vector<Quantity<Owner>> all = [&] {
    std::vector<Quantity<Owner>> told;
    for (const Quantity<Owner>& q : quantities)
      for (const input::Node& group : texts().children)
        if (const input::Node* of = input::find(group, q.key)) {
          const auto text = [&](const char* key) -> std::string_view {
            const input::Node* found = input::find(*of, key);
            return found ? std::string_view(found->text) : "";
          };
          told.push_back({q.key, q.value, text("meaning"), text("source"), text("title"), group.key, text("validity"),
                          q.delivery});
        }
    return told;
  }();
  return all;
}

}  // namespace

std::vector<std::string> estimates_beside(const Computed& computed) {
  std::vector<std::string> keys;
  const auto add = [&](bool is_computed, std::initializer_list<const char*> estimates) {
    if (is_computed) keys.insert(keys.end(), estimates.begin(), estimates.end());
  };
  add(computed.slip, {"efficiency", "back_driving_efficiency", "drive_torque_Nm"});
  add(computed.life, {"static_capacity_N", "flank_edge_load_N", "l10_revolutions", "l10_hours", "l10_travel_km"});
  add(computed.thread_safety, {"static_safety", "static_safety_limit"});
  add(computed.static_safety,
      {"thread_static_safety", "thread_static_safety_limit", "static_capacity_N", "deformation_capacity_screw_N",
       "deformation_capacity_nut_N", "pressure_capacity_screw_N", "pressure_capacity_nut_N", "flank_edge_load_N",
       "flank_edge_load_screw_N", "flank_edge_load_nut_N"});
  add(computed.thread_loads,
      {"mean_peak_pressure_screw_MPa", "mean_peak_pressure_nut_MPa", "yang_largest_load_rate_percent"});
  return keys;
}

PRS_RECORD(SystemStiffness::Contribution, "StiffnessContribution", "A part of an axis and its share of what gives way.",
           kContribution);
PRS_RECORD(SystemStiffness::Contributions, "StiffnessContributions", "Parts of an axis in series.", kContributions);
PRS_RECORD(SystemStiffness, "SystemStiffness", "Axial stiffness of an axis.", kSystemStiffness);
PRS_RECORD(Measures, "Measures", "Design measures of the mechanism that no load changes.", with_texts(kMeasures));
PRS_RECORD(LoadMeasures, "LoadMeasures", "Design measures under one load.", with_texts(kLoadMeasures));

}  // namespace prs
