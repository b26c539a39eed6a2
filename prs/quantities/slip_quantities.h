#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "prs/quantities/quantities.h"
#include "prs/model/units.h"
#include "prs/loads/result.h"

namespace prs {

/// Friction with one value a thread, as documents and files show it: key with unit, shown = SI *
/// factor.
struct SlipThreadQuantity {
  std::string_view key;
  std::vector<double> InterfaceSlip::*values;
  double factor;
};

inline constexpr SlipThreadQuantity kSlipThreadQuantities[] = {
    {"power_W", &InterfaceSlip::power, 1.0},
    {"power_density_W_per_mm2", &InterfaceSlip::power_density, per_si::per_square_millimetre},
    {"friction_coefficient", &InterfaceSlip::friction_coefficient, 1.0},
    {"spin_torque_Nmm", &InterfaceSlip::spin_torque, per_si::newton_millimetre},
    {"sliding_speed_mm_per_s", &InterfaceSlip::sliding_speed, per_si::millimetre},
    {"max_sliding_speed_mm_per_s", &InterfaceSlip::max_sliding_speed, per_si::millimetre},
    {"film_thickness_nm", &InterfaceSlip::film_thickness, per_si::nanometre},
    {"central_film_nm", &InterfaceSlip::central_film, per_si::nanometre},
    {"film_ratio", &InterfaceSlip::film_ratio, 1.0},
    {"dynamic_normal_load_N", &InterfaceSlip::dynamic_normal_load, 1.0},
};

/// A number of a slip result, absent where the case does not define it.
struct SlipQuantity {
  std::string_view key;
  std::optional<double> (*value)(const SlipResult&);
  double factor;
};

template <auto member>
std::optional<double> slip_member(const SlipResult& slip) {
  return slip.*member;
}

inline std::optional<double> total_power(const SlipResult& slip) { return slip.power.total(); }

inline constexpr SlipQuantity kSlipQuantities[] = {
    {"speed_rpm", slip_member<&SlipResult::speed>, per_si::revolution_per_minute},
    {"gear_ratio", slip_member<&SlipResult::gear_ratio>, 1.0},
    {"slip_ratio", slip_member<&SlipResult::slip_ratio>, 1.0},
    {"ideal_slip_ratio", slip_member<&SlipResult::ideal_slip_ratio>, 1.0},
    {"optimality_percent", slip_member<&SlipResult::optimality>, per_si::percent},
    {"efficiency", slip_member<&SlipResult::efficiency>, 1.0},
    {"efficiency_fit", slip_member<&SlipResult::efficiency_fit>, 1.0},
    {"power_loss_W", total_power, 1.0},
    {"power_loss_input_output_W", slip_member<&SlipResult::power_loss_input_output>, 1.0},
    {"torque_screw_Nm", slip_member<&SlipResult::torque_screw>, 1.0},
    {"torque_nut_Nm", slip_member<&SlipResult::torque_nut>, 1.0},
    {"viscosity_mPas", slip_member<&SlipResult::viscosity>, per_si::millipascal_second},
    {"bearing_eccentricity_ratio", slip_member<&SlipResult::bearing_eccentricity>, 1.0},
};

inline constexpr SlipQuantity kSlipEstimates[] = {
    {"simple",
     [](const SlipResult& slip) -> std::optional<double> { return slip.estimates.simple; }, 1.0},
    {"jones", [](const SlipResult& slip) { return slip.estimates.jones; }, 1.0},
};

/// A number of a part of the slip result.
template <class Owner>
struct MemberQuantity {
  std::string_view key;
  double Owner::*value;
};

/// The sources of friction, in the order of the documents; titles are those of tables and figures.
struct PowerSource {
  std::string_view key;
  std::string_view title;
  double PowerBySource::*value;
};

inline constexpr PowerSource kPowerSources[] = {
    {"screw", "roller-screw", &PowerBySource::screw},
    {"nut", "roller-nut", &PowerBySource::nut},
    {"carrier_roller", "roller-carrier", &PowerBySource::carrier_roller},
    {"carrier_screw", "carrier-screw", &PowerBySource::carrier_screw},
    {"carrier_nut", "carrier-nut", &PowerBySource::carrier_nut},
};

inline constexpr MemberQuantity<RollerMoments> kRollerMoments[] = {
    {"contacts", &RollerMoments::contacts},
    {"spin", &RollerMoments::spin},
    {"carrier", &RollerMoments::carrier},
    {"gears", &RollerMoments::gears},
};

inline constexpr MemberQuantity<RollerForces> kRollerForces[] = {
    {"contacts_x", &RollerForces::contacts_x}, {"contacts_y", &RollerForces::contacts_y},
    {"gears_x", &RollerForces::gears_x},       {"gears_y", &RollerForces::gears_y},
    {"carrier_x", &RollerForces::carrier_x},   {"carrier_y", &RollerForces::carrier_y},
};

/// A number of the result with equal shares.
struct EqualShareQuantity {
  std::string_view key;
  std::optional<double> (*value)(const EqualShareSlip&);
  double factor;
};

template <auto member>
std::optional<double> equal_share_member(const EqualShareSlip& equal) {
  return equal.*member;
}

inline constexpr EqualShareQuantity kEqualShareQuantities[] = {
    {"slip_ratio", equal_share_member<&EqualShareSlip::slip_ratio>, 1.0},
    {"power_loss_W", equal_share_member<&EqualShareSlip::power_loss>, 1.0},
    {"efficiency", equal_share_member<&EqualShareSlip::efficiency>, 1.0},
    {"max_thread_power_W",
     [](const EqualShareSlip& equal) -> std::optional<double> {
       return std::max(equal.thread_power.screw, equal.thread_power.nut);
     },
     1.0},
    {"max_power_density_W_per_mm2", equal_share_member<&EqualShareSlip::max_power_density>,
     per_si::per_square_millimetre},
};

/// Whether a load case has an answer to slip.
inline bool has_slip(const LoadCaseResult& result) {
  return result.slip && result.slip->converged();
}

/// How the search for the slip ratio ended or, where the loads are not known, their solve.
inline std::string_view slip_status_name(const LoadCaseResult& result) {
  if (result.slip) return name(result.slip->status);
  return result.converged() ? name(SlipStatus::not_computed) : status_name(result);
}

/// Thread of the largest power density: its value, absent where there are no densities.
inline std::optional<double> at_hottest(const SlipResult& slip,
                                        std::vector<double> InterfaceSlip::*values) {
  return entry(slip.threads[slip.hottest.interface].*values,
               static_cast<std::size_t>(slip.hottest.thread));
}

}  // namespace prs
