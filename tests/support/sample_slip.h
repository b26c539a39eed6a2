#pragma once

#include <cmath>
#include <numbers>
#include <utility>

#include "prs/slip/slip.h"
#include "prs/slip/slip_pictures.h"
#include "support/sample_result.h"

namespace test {

using prs::InterfaceSlip, prs::PatchField, prs::SlipPictures, prs::SlipResult, prs::SlipStatus;

/// Friction of about Sandu's reference example, in proportion to the loads.
inline InterfaceSlip sample_threads(const InterfaceLoads& loads, double friction, double speed) {
  InterfaceSlip slip;
  for (std::size_t k = 0; k < loads.normal_load.size(); ++k) {
    const double load = loads.normal_load[k];
    const double mu = friction * std::pow(load / 290.0, 0.1);
    const double radius = 2.9e-5 * std::cbrt(load);
    slip.power.push_back(mu * load * speed);
    slip.power_density.push_back(mu * load * speed / (std::numbers::pi * 0.8 * radius * radius));
    slip.friction_coefficient.push_back(mu);
    slip.spin_torque.push_back(-0.4 * mu * load * radius);
    slip.sliding_speed.push_back(speed);
    slip.max_sliding_speed.push_back(1.1 * speed);
    slip.film_thickness.push_back(310e-9);
    slip.central_film.push_back(260e-9);
    slip.film_ratio.push_back(0.62);
    slip.boundary_share.push_back(1.0 / (1.62 * 1.62));
    slip.dynamic_normal_load.push_back(1.01 * load);
    slip.wear.push_back(1e-12 * load);
  }
  return slip;
}

/// Slip of a case whose loads are known.
inline SlipResult sample_slip(const LoadCaseResult& result) {
  SlipResult slip;
  slip.status = SlipStatus::converged;
  slip.evaluations = 41;
  slip.relative_residue = 1e-15;
  slip.speed = 400.0 * std::numbers::pi / 30.0;
  slip.gear_ratio = 3.0;
  slip.slip_ratio = 0.372956;
  slip.ideal_slip_ratio = 0.373134;
  slip.estimates = {0.375, 0.3742};
  slip.optimality = 0.995;
  slip.threads = {sample_threads(result.threads->screw, 0.111, 0.107),
                  sample_threads(result.threads->nut, 0.083, 0.0093)};
  for (const prs::Interface i : prs::kInterfaces)
    for (const double power : slip.threads[i].power)
      (i == prs::Interface::screw ? slip.power.screw : slip.power.nut) += 11 * power;
  slip.power.carrier_roller = 0.1 * slip.power.screw;
  slip.power.carrier_screw = 0.5;
  slip.power_loss_input_output = slip.power.total();
  slip.efficiency = 0.7 + 0.1 * std::cbrt(result.load_case.axial_force / 45e3);
  slip.efficiency_fit = 0.79;
  slip.torque_screw = 12.5;
  slip.torque_nut = -12.25;
  slip.moments = {0.030, -0.020, -0.006, -0.004};
  slip.forces = {1.0, 2.0, 3.0, 4.0, -4.0, -6.0, 0.0};
  slip.bearing_eccentricity = 0.25;
  slip.hottest = {prs::Interface::screw, 0};
  slip.equal_shares =
      prs::EqualShareSlip{.slip_ratio = 0.372950,
                          .power_loss = 0.98 * slip.power.total(),
                          .efficiency = *slip.efficiency + 0.002,
                          .thread_power = {0.7 * slip.threads.screw.power[0], 0.7 * slip.threads.nut.power[0]},
                          .max_power_density = 0.75 * slip.threads.screw.power_density[0]};
  return slip;
}

inline LoadCaseResult with_slip(LoadCaseResult result) {
  result.slip = sample_slip(result);
  return result;
}

/// A case whose loads are known, without slip.
inline LoadCaseResult without_equilibrium(LoadCaseResult result) {
  result.slip = SlipResult{};
  result.slip->status = SlipStatus::no_equilibrium;
  result.slip->evaluations = 2;
  result.slip->relative_residue = 0.25;
  return result;
}

/// Uniform sliding with spin, on the grid of the patch integrals.
inline PatchField sample_patch(double semi_major, double sliding, double spin, int points = 21) {
  PatchField field;
  field.semi_major = semi_major;
  field.semi_minor = 0.8 * semi_major;
  field.points = points;
  for (int j = 0; j < points; ++j)
    for (int k = 0; k < points; ++k) {
      const double x = (2.0 * j + 1.0) / points - 1.0;
      const double y = (2.0 * k + 1.0) / points - 1.0;
      if (x * x + y * y >= 1.0) continue;
      field.along_major.push_back(x * field.semi_major);
      field.along_minor.push_back(y * field.semi_minor);
      field.sliding_major.push_back(0.8 * sliding - spin * y * field.semi_minor);
      field.sliding_minor.push_back(0.6 * sliding + spin * x * field.semi_major);
      const double speed = std::hypot(field.sliding_major.back(), field.sliding_minor.back());
      field.friction_coefficient.push_back(0.02 + 0.1 * std::sqrt(1 - x * x - y * y) * std::asinh(speed / 0.002) / 4.7);
    }
  return field;
}

inline prs::ResidueCurve sample_curve(double from, double to) {
  prs::ResidueCurve curve;
  for (int k = 0; k <= 60; ++k) {
    const double slip_ratio = from + (to - from) * k / 60;
    curve.slip_ratio.push_back(slip_ratio);
    curve.moments.push_back(
        {-0.8 * std::tanh((slip_ratio - 0.373134) / 0.002), -0.02, -0.03, -0.0211 - 0.05 * (slip_ratio - 0.373134)});
  }
  return curve;
}

inline SlipPictures sample_pictures() {
  return {sample_curve(0.25, 0.5), sample_curve(0.372956, 0.373312),
          prs::PerInterface<prs::PatchField>{sample_patch(0.19e-3, 0.1, 60.0), sample_patch(0.22e-3, 0.0, 60.0)}};
}

}  // namespace test
