#include "modules/response/response.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <complex>
#include <fstream>

#include "modules/response/response_analysis.h"
#include "prs/export/robot.h"
#include "prs/input/echo.h"
#include "prs/record/table_units.h"
#include "prs/run/commands.h"

namespace prs {
namespace {

const Json& solved() {
  static const Json all = Json::parse(std::ifstream(PRS_SOURCE_DIR "/tests/prs/response/response_cases.json"));
  return all;
}

input::Source source_of(const Json& given, std::vector<std::string> overrides = {}) {
  return {"case.yaml", given["input"].dump(), std::move(overrides)};
}

Json response_of(const input::Source& source) {
  return run(analysis_of(Command::response), source).document({})["response"];
}

/// Tolerances, times `slack`: 5e-4 for extremes and scalars, 3e-4 for pressures and for the range of a series, 1e-3 for
/// impacts, losses and damping, 2e-3 over frequency.
void expect_near(const Json& found, const Json& expected, const std::string& path, double slack) {
  if (expected.is_object()) {
    for (const auto& [key, value] : expected.items()) {
      ASSERT_TRUE(found.contains(key)) << path << '.' << key;
      if (key == "residual" || key == "residual_relative") continue;
      expect_near(found[key], value, path + '.' + key, slack);
    }
  } else if (expected.is_array() && !expected.empty() && expected[0].is_number()) {
    ASSERT_EQ(found.size(), expected.size()) << path;
    const std::vector<double> values = expected;
    const auto [least, most] = std::ranges::minmax(values);
    for (std::size_t k = 0; k < values.size(); ++k)
      EXPECT_NEAR(
          found[k].get<double>(), values[k],
          slack * (path.find("frequency") == path.npos ? 3e-4 * (most - least) : 2e-3 * std::abs(values[k])) + 1e-12)
          << path << ' ' << k;
  } else if (expected.is_array()) {
    ASSERT_EQ(found.size(), expected.size()) << path;
    for (std::size_t k = 0; k < expected.size(); ++k) expect_near(found[k], expected[k], path, slack);
  } else if (expected.is_number_float()) {
    const auto in = [&](const char* part) { return path.find(part) != path.npos; };
    const double share = in("impacts") || in(".lost") || in("damping") ? 1e-3 : in("pressure") ? 3e-4 : 5e-4;
    EXPECT_NEAR(found.get<double>(), expected.get<double>(), slack * share * std::abs(expected.get<double>()) + 1e-9)
        << path;
  } else {
    EXPECT_EQ(found, expected) << path;
  }
}

TEST(Response, SolvedCasesComeOut) {
  for (const Json& given : solved()["cases"]) {
    SCOPED_TRACE(given["name"]);
    const Json found = response_of(source_of(given));
    const double slack = given.value("slack", 1.0);
    expect_near(found, given["result"], "response", slack);
    EXPECT_LT(found["energy_J"]["residual_relative"], 1e-6);
  }
}

TEST(Response, ATenthOfTheToleranceChangesNothing) {
  for (const Json& given : solved()["cases"]) {
    SCOPED_TRACE(given["name"]);
    const Json one = response_of(source_of(given));
    const Json tenth = response_of(source_of(given, {"response.tolerance=1e-9"}));
    for (const char* key : {"position_mm", "speed_mm_per_s", "force_N", "motor_torque_Nm", "deflection_um"}) {
      const std::vector<double> a = one[key], b = tenth[key];
      const auto [least, most] = std::ranges::minmax(a);
      for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-5 * (most - least)) << key << ' ' << k;
    }
  }
}

TEST(Response, SamplesDoNotMoveScalars) {
  const Json& given = solved()["cases"][0];
  const Json one = response_of(source_of(given)),
             other = response_of(source_of(given, {"response.sample_interval=7 ms"}));
  EXPECT_EQ(one["energy_J"], other["energy_J"]);
  EXPECT_EQ(one["largest"], other["largest"]);
  EXPECT_EQ(one["impacts"], other["impacts"]);
}

TEST(Response, WrongInputNamesItsKey) {
  for (const Json& given : solved()["errors"]) {
    SCOPED_TRACE(given["name"]);
    try {
      response_of(source_of(given));
      ADD_FAILURE();
    } catch (const input::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(given["error"].get<std::string>()), std::string::npos) << error.what();
      EXPECT_TRUE(std::string_view(error.what()).starts_with("case.yaml:1:")) << error.what();
    }
  }
}

TEST(Response, EachWrongValueIsRefused) {
  const Json &torque = solved()["cases"][0], &servo = solved()["cases"][4], &shaker = solved()["cases"][3];
  struct Wrong {
    const Json& given;
    const char* override;
    const char* names;
  };
  const Wrong all[] = {
      {torque, "response.duration=0 s", "response.duration"},
      {torque, "response.load.mass=40", "response.load.mass"},
      {torque, "response.load.mass=0 kg", "response.load.mass"},
      {torque, "response.tolerance=1e-2", "response.tolerance"},
      {torque, "response.sample_interval=1e-9 s", "response.sample_interval"},
      {torque, "response.coupling.stiffness=0 N m/rad", "response.coupling.stiffness"},
      {torque, "response.screw.inertia=0 kg m^2", "response.screw.inertia"},
      {torque, "response.motor.inertia=0 kg m^2", "response.motor.inertia"},
      {torque, "response.brake={torque: -1 N m, at: 1 ms}", "response.brake.torque"},
      {torque, "response.load.force=[]", "response.load.force"},
      {torque, "response.load={linkage: {base: 500 mm, arm: 300 mm}, inertia: 2 kg m^2}",
       "response.start.angle: missing"},
      {torque, "response.load={linkage: {base: 500 mm, arm: 300 mm}, inertia: 2 kg m^2, mass: 9 kg}",
       "response.load.mass"},
      {torque, "response.load={linkage: {base: 500 mm, arm: 300 mm}}", "response.load.inertia"},
      {torque, "response.load={linkage: {base: 500 mm, arm: 0 mm}, inertia: 2 kg m^2}", "response.load.linkage.arm"},
      {torque, "response.load.torque=9 N m", "response.load.torque"},
      {torque, "response.start.angle=60 deg", "response.start.angle: belongs to a lever"},
      {torque, "response.load.force={}", "response.load.force: got no form"},
      {torque, "response.load.force={steps: []}", "response.load.force.steps"},
      {torque, "response.load.force={square: 3 N}", "response.load.force.square"},
      {torque, "response.load.force={points: [{at: 0 s, value: 1 N}], sine: {amplitude: 1 N, frequency: 2 Hz}}",
       "response.load.force.sine"},
      {torque, "response.settling={after: 1 s, band: 1 um}", "response.settling.after"},
      {torque, "response.end_stops={upper: {at: 0 mm, stiffness: 1 N/um}, lower: {at: 1 mm, stiffness: 1 N/um}}",
       "response.end_stops"},
      {torque, "response.end_stops={upper: {at: -1 mm, stiffness: 1 N/um}}",
       "response.start.position: got 0 mm, beyond an end stop; expected a start between the stops, the nearest is -1 "
       "mm"},
      {servo,
       "response={start: {position: -3 mm}, end_stops: {lower: {at: -2 mm, stiffness: 1 N/um}}, duration: 1 s, "
       "motor: {inertia: 1 kg cm^2, torque: 1 N m}, load: {mass: 1 kg}}",
       "response.start.position: got -3 mm, beyond an end stop; expected a start between the stops, the nearest is -2 "
       "mm"},
      {torque, "response.shaft={length: 1 m, ends: fixed_fixed}", "response.shaft.span"},
      {torque, "response.shaft={length: 1 m, span: 2 m}", "response.shaft.span"},
      {torque, "response.material_damping={time: 1 us, loss_factor: 3 %}", "response.material_damping"},
      {servo, "response.motor.controller.feedback=nut", "response.motor.controller.feedback"},
      {servo, "response.motor.controller.largest_speed=0 rpm", "response.motor.controller.largest_speed"},
      {servo, "response.motor.controller.speed=3 rpm", "response.motor.controller"},
      {servo, "response.motor.current_loop={}", "response.motor.current_loop"},
      {servo, "response.frequency_response.speed=0 rpm", "response.frequency_response.speed"},
      {servo, "response.frequency_response.to=1 Hz", "response.frequency_response"},
      {servo, "response.frequency_response.points=1", "response.frequency_response"},
      {shaker, "response.motor.cut_at=10 ms", "response.motor.cut_at"},
      {shaker, "response.motor.speed={steps: [{at: 0 s, value: -240 rpm}, {at: 1 ms, value: 0 rpm}]}",
       "response.motor.speed"},
      {shaker, "response.frequency_response.speed=3 rpm", "response.frequency_response.speed"},
      {shaker, "response.frequency_response.spacing=even", "response.frequency_response.spacing"},
  };
  for (const Wrong& wrong : all) {
    try {
      response_of(source_of(wrong.given, {wrong.override}));
      ADD_FAILURE() << wrong.override;
    } catch (const input::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(wrong.names), std::string::npos) << wrong.override << error.what();
    }
  }
}

/// The angle at the start, the force of the torque there, and energies that close over its own equation.
TEST(Response, ALeverHasItsAngleTorqueAndEnergy) {
  const auto run = [](const char* start, const char* inertia) {
    return response_of(source_of(
        solved()["cases"][0],
        {fmt::format("response.load={{linkage: {{base: 500 mm, arm: 300 mm}}, inertia: {}, torque: 300 N m}}", inertia),
         fmt::format("response.start={{angle: {}}}", start),
         "response.motor={inertia: 4 kg cm^2, speed: {points: [{at: 0 s, value: 0 rpm}, {at: 5 ms, value: 900 "
         "rpm}]}}"}));
  };
  const Json found = run("60 deg", "2 kg m^2");
  EXPECT_NEAR(found["lever_angle_deg"][0].get<double>(), 60.0, 1e-12);
  EXPECT_NEAR(found["external_force_N"][0].get<double>(), 1006.644591, 5.1e-7);
  EXPECT_NEAR(found["lever_torque_Nm"].back().get<double>(), 300.0, 1e-10);
  EXPECT_GT(found["lever_angle_deg"].back().get<double>(), 60.5);
  EXPECT_LT(found["energy_J"]["residual_relative"], 1e-6);
  try {
    run("178.6 deg", "0.001 kg m^2");
    FAIL() << "passed its dead centre";
  } catch (const input::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("response.load.linkage: the lever reaches 179 deg"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(run("179.5 deg", "2 kg m^2"), input::InputError);
}

/// Ratio and reflection over the angle, by their definition.
TEST(Response, ALeverIsExportedOverItsAngle) {
  ResponseInput in;
  in.load.linkage = PrsLinkage{0.5, 0.3};
  in.load.inertia = 2.0;
  in.start.angle = std::numbers::pi / 3.0;
  const LeverMotion all = *lever_motion(in, 0.005);
  EXPECT_NEAR(all.angles[0] * 180.0 / std::numbers::pi, 1.0, 1e-12);
  EXPECT_NEAR(all.angles[1] * 180.0 / std::numbers::pi, 179.0, 1e-12);
  const PrsLever lever = prs_lever(&*in.load.linkage, std::numbers::pi / 3.0);
  EXPECT_NEAR(all.reflected_mass(lever), 22.518519, 5e-7);
  EXPECT_NEAR(all.gear_ratio(lever), 0.298019780 * 2.0 * std::numbers::pi / 0.005, 1e-6);
  const std::string csv = linkage_csv(all, {});
  EXPECT_EQ(std::ranges::count(csv, '\n'), 182);
  EXPECT_TRUE(
      csv.starts_with("angle_deg,length_mm,ratio_mm_per_rad,reflected_mass_kg,gear_ratio,reflected_inertia_kg_mm2\n"));
  in.end_stops.upper = ResponseInput::EndStop{.at = lever.length * 0.1, .stiffness = 1e6};
  EXPECT_NEAR(prs_lever(&*in.load.linkage, lever_motion(in, 0.0)->angles[1]).length, 1.1 * lever.length, 1e-12);
}

TEST(Response, ASumOfSignalsIsWhatItsTermsAre) {
  const Json& given = solved()["cases"][2];
  const Json sum = response_of(source_of(given));
  const std::string sine =
      "response.load.force=[{steps: [{at: 60 ms, value: 1500 N}]}, {sine: {amplitude: 75 N, "
      "frequency: 90 Hz}}, {sine: {amplitude: 75 N, frequency: 90 Hz}}]";
  const std::vector<double> one = sum["external_force_N"],
                            two = response_of(source_of(given, {sine}))["external_force_N"];
  for (std::size_t k = 0; k < one.size(); ++k) EXPECT_NEAR(one[k], two[k], 1e-9);
}

TEST(Response, SignalsFromFilesAreThoseOfTheirPoints) {
  input::Source source = source_of(solved()["cases"][0]);
  const Json points = response_of(source);
  source.overrides = {
      "response.motor.torque=[{file: {name: torque.csv, time: {column: t, unit: ms}, value: {column: torque, unit: N "
      "m}}}, 1 N m]"};
  source.files.emplace().emplace("torque.csv", "t,torque\n0,3\n15,3\n25,-6\n50,-6\n");
  EXPECT_EQ(response_of(source)["motor_torque_Nm"], points["motor_torque_Nm"]);
}

bool warns(const input::Source& source, std::string_view text) {
  const Json document = run(analysis_of(Command::response), source).document({});
  return std::ranges::any_of(document["warnings"],
                             [&](const Json& w) { return w.get<std::string>().find(text) != std::string::npos; });
}

TEST(Response, APreloadIsSaidToTakeTheTorqueOfSlipAtZeroLoad) {
  const Json& given = solved()["cases"][2];
  const Json slip = run(analysis_of(Command::slip), source_of(given, {"load_cases[0].axial_force=0 N"}))
                        .document({})["load_cases"][0]["slip"];
  EXPECT_TRUE(warns(source_of(given), fmt::format("{:.2f} N m by `prs slip`", slip["torque_screw_Nm"].get<double>())));
  EXPECT_FALSE(warns(source_of(solved()["cases"][0]), "`prs slip`"));  // Play costs nothing.
}

TEST(Response, SpeedsAlongTheAxisAreTurnedByTheLead) {
  const Json& given = solved()["cases"][4];
  const std::string controller = "response.motor.controller={speed_gain: 0.5 N m s/rad, largest_torque: 5 N m, ";
  const auto speeds = [&](const std::string& speed) {
    return response_of(source_of(given, {controller + speed + "}"}))["motor_speed_rpm"];
  };
  EXPECT_EQ(speeds("speed: [{steps: [{at: 0 s, value: 25 mm/s}]}, 50 mm/s]"),
            speeds("speed: [{steps: [{at: 0 s, value: 300 rpm}]}, 600 rpm]"));
}

TEST(Response, PressureAboveTheStaticLimitIsAWarning) {
  const Json& given = solved()["cases"][0];
  constexpr const char* kText = "exceeds 4 GPa, under";
  EXPECT_FALSE(warns(source_of(given), kText));
  EXPECT_TRUE(warns(source_of(given, {"response.load.force={steps: [{at: 20 ms, value: 60 kN}]}"}), kText));
}

TEST(Response, HashOfTheInputCoversFilesOfSignals) {
  input::Source source = source_of(solved()["cases"][0]);
  source.overrides = {
      "response.load.force={file: {name: force.csv, time: {column: t, unit: s}, value: {column: f, unit: N}}}"};
  source.files.emplace().emplace("force.csv", "t,f\n0,50\n1,50\n");
  const std::string one = input::input_sha256(source);
  source.files.emplace().emplace("force.csv", "t,f\n0,50\n1,51\n");
  EXPECT_NE(input::input_sha256(source), one);
}

/// Steady rolling needs the torque of `prs slip` for that force and speed.
TEST(Response, SteadyRollingTakesTheTorqueOfSlip) {
  for (const char* friction : {"friction={coulomb: 0.08}", "friction={model: {mixed: {boundary: 0.11, exponent: 2}}}"})
    for (const auto& [force, speed] : {std::pair{9e3, -700.0}, std::pair{-4e3, -300.0}}) {
      Json given = solved()["cases"][1];
      given["input"]["load_cases"] = {{{"name", "rolls"},
                                       {"axial_force", fmt::format("{} N", std::abs(force))},
                                       {"direction", force < 0.0 ? "compression" : "tension"},
                                       {"position", "12 mm"},
                                       {"speed", fmt::format("{} rpm", speed)}}};
      given["input"]["response"] = {
          {"duration", "30 ms"},
          {"motor", {{"speed", fmt::format("{} rpm", speed)}}},
          {"load", {{"mass", "30 kg"}, {"force", fmt::format("{} N", force)}}},
          {"start", {{"speed", fmt::format("{:.17g} mm/s", speed / 12.0)}}},
          {"curves", {{"force", "15 kN"}, {"speed", "1500 rpm"}}},
      };
      const double found = response_of(source_of(given, {friction}))["motor_torque_Nm"].back();
      const Json slip = run(analysis_of(Command::slip), source_of(given, {friction, "model={loads: static}"}))
                            .document({})["load_cases"][0]["slip"];
      const double largest = 15e3 * 0.005 / (2.0 * std::numbers::pi);
      EXPECT_NEAR(found, slip["torque_screw_Nm"].get<double>(), 1e-4 * largest) << friction << force << ' ' << speed;
    }
}

TEST(Response, WhatIsNotSelfLockingRunsAwayWithoutABrake) {
  Json given = solved()["cases"][0];
  Json& block = given["input"]["response"];
  block["motor"]["torque"] = "0 N m";
  block["load"]["force"] = "3 kN";
  const Json free = response_of(source_of(given));
  EXPECT_LT(free["position_mm"].back().get<double>(), -1.0);
  const Json held = response_of(source_of(given, {"response.brake={torque: 5 N m, at: 0 ms}"}));
  EXPECT_EQ(held["motor_speed_rpm"].back(), 0.0);
  EXPECT_GT(held["position_mm"].back().get<double>(), -0.01);
}

TEST(Response, SettlingWithoutAControllerIsAboutTheLastSample) {
  const Json response =
      response_of(source_of(solved()["cases"][0], {"response.settling={after: 10 ms, band: 0.4 mm}"}));
  const std::vector<double> time = response["time_s"], x = response["position_mm"];
  std::size_t last = 0;
  for (std::size_t k = 0; k < x.size(); ++k)
    if (time[k] >= 10e-3 && std::abs(x[k] - x.back()) > 0.4) last = k;
  ASSERT_GT(last, 0U);
  EXPECT_EQ(response["settling"], (Json{{"final_position_mm", x.back()}, {"time_s", time[last + 1] - 10e-3}}));
}

TEST(Response, EnergiesOfEachLessonClose) {
  for (const char* lesson : {"34_reversal", "35_emergency_stop", "36_servo_axis"}) {
    SCOPED_TRACE(lesson);
    const std::string file = fmt::format("{}/configs/{}.yaml", PRS_SOURCE_DIR, lesson);
    EXPECT_LT(response_of(input::load_source(file, {}))["energy_J"]["residual_relative"], 1e-6);
  }
}

TEST(Response, ALeftHandedScrewTurnsTheOtherWay) {
  const Json& given = solved()["cases"][0];
  const Json right = response_of(source_of(given));
  const Json left = response_of(
      source_of(given, {"mechanism.lead=-5 mm",
                        "response.motor.torque={points: [{at: 0 ms, value: -4 N m}, {at: 15 ms, value: -4 N m}, "
                        "{at: 25 ms, value: 5 N m}, {at: 50 ms, value: 5 N m}]}"}));
  for (std::size_t k = 0; k < right["time_s"].size(); k += 10) {
    EXPECT_NEAR(left["position_mm"][k], right["position_mm"][k].get<double>(), 1e-4);
    EXPECT_NEAR(left["screw_speed_rpm"][k], -right["screw_speed_rpm"][k].get<double>(), 0.05);
    EXPECT_NEAR(left["coupling_torque_Nm"][k], -right["coupling_torque_Nm"][k].get<double>(), 0.01);
    EXPECT_NEAR(left["force_N"][k], right["force_N"][k].get<double>(), 10.0);
  }
}

TEST(Response, ResonancesAreWhereTheComplianceIsLargest) {
  const Json response =
      response_of(source_of(solved()["cases"][3], {"response.frequency_response.points=2000"}))["frequency_response"];
  const std::vector<double> compliance = response["compliance_um_per_N"];
  const auto most = static_cast<std::size_t>(std::ranges::max_element(compliance) - compliance.begin());
  const double resonance = response["resonances"][0]["frequency_Hz"],
               zeta = response["resonances"][0]["damping_percent"];
  EXPECT_NEAR(response["frequency_Hz"][most], resonance * std::sqrt(1.0 - 2e-4 * zeta * zeta), 0.5);
  // Frequency of one mass on a held screw.
  const double k = 1e6 * response["tangent_stiffness_N_per_um"].get<double>(), m = 80.0;
  const double w = std::sqrt(k / m), damping = 60e-6 * k + 150.0;
  EXPECT_NEAR(resonance, w / (2.0 * std::numbers::pi), 1e-9 * resonance);
  EXPECT_NEAR(zeta, 100.0 * damping / (2.0 * m * w), 1e-9 * zeta);
}

/// The friction of a preloaded screw is smooth at no force, and so are the resonances.
TEST(Response, ResonancesWithoutForceAreThoseOfASmallOne) {
  const auto resonances = [](const std::string& force) {
    const Json found = response_of(input::load_source(PRS_SOURCE_DIR "/configs/36_servo_axis.yaml",
                                                      {"response.frequency_response.force=" + force}));
    return found["frequency_response"]["resonances"];
  };
  const Json without = resonances("0 N"), small = resonances("1 N");
  ASSERT_EQ(without.size(), small.size());
  for (std::size_t k = 0; k < small.size(); ++k)
    EXPECT_NEAR(without[k]["frequency_Hz"], small[k]["frequency_Hz"].get<double>(),
                0.005 * small[k]["frequency_Hz"].get<double>());
}

/// Three masses in a row have two natural vibrations.
TEST(Response, AFreeRigidMotionIsNoResonance) {
  for (const char* force : {"100 N", "500 N", "5 kN", "20 kN"}) {
    const Json found = response_of(input::load_source(
        PRS_SOURCE_DIR "/configs/34_reversal.yaml",
        {"friction={coulomb: 0}", "response.coupling.damping=0 N m s/rad",
         fmt::format("response.frequency_response={{from: 5 Hz, to: 2 kHz, force: {}, screw: rolling, speed: 240 rpm, "
                     "input: motor_torque}}",
                     force)}));
    EXPECT_EQ(found["frequency_response"]["resonances"].size(), 2u) << force;
  }
}

TEST(Response, PanelsOverFrequencyMarkTheResonances) {
  const auto found = [](std::vector<std::string> overrides) {
    const Delivery delivery =
        run(analysis_of(Command::response), source_of(solved()["cases"][3], std::move(overrides)));
    const double resonance = delivery.document({})["response"]["frequency_response"]["resonances"][0]["frequency_Hz"];
    return std::pair(figure(delivery.pictures(), "response_frequency", {}), resonance);
  };
  const auto [shown, resonance] = found({});
  ASSERT_FALSE(shown.panels.empty());
  for (const Panel& panel : shown.panels) {
    ASSERT_EQ(panel.references.size(), 1u);
    EXPECT_TRUE(panel.references[0].vertical);
    EXPECT_EQ(panel.references[0].at, resonance);
    EXPECT_EQ(shown.styles.at(panel.references[0].style).dash, Dash::dotted);
  }
  const auto [below, same] = found({fmt::format("response.frequency_response.to={:.9g} Hz", 0.9 * resonance),
                                    fmt::format("response.frequency_response.from={:.9g} Hz", 0.1 * resonance)});
  ASSERT_FALSE(below.panels.empty());
  for (const Panel& panel : below.panels) EXPECT_TRUE(panel.references.empty());
}

/// The number in front of a unit in the line of a table.
double number_before(const std::string& table, std::string_view line, std::string_view unit) {
  const std::size_t from = table.find(line), at = table.find(unit, from);
  if (from == table.npos || at == table.npos) return std::numeric_limits<double>::quiet_NaN();
  return std::stod(table.substr(table.rfind(' ', at - 2) + 1));
}

TEST(Response, SpeedsAreInTheUnitsOfTables) {
  const Delivery delivery = run(analysis_of(Command::response), source_of(solved()["cases"][0]));
  const Json response = delivery.document({})["response"];
  double fastest = 0.0, impact = 0.0;
  for (const double speed : response["speed_mm_per_s"]) fastest = std::max(fastest, std::abs(speed));
  for (const Json& i : response["impacts"]) impact = std::max(impact, i["speed_mm_per_s"].get<double>());
  ASSERT_GT(impact, 0.0);
  const auto four_digits = [](double value) { return std::stod(fmt::format("{:.4g}", value)); };  // Rounded once.
  const auto expect = [&](const char* unit, double factor) {
    const std::string table = delivery.table();
    EXPECT_DOUBLE_EQ(number_before(table, "  position", unit), four_digits(factor * fastest)) << table;
    EXPECT_DOUBLE_EQ(number_before(table, "  fastest", unit), four_digits(factor * impact)) << table;
  };
  expect(" mm/s", 1.0);
  const TableUnits us(UnitSystem::us);
  expect(" in/s", 1.0 / 25.4);
}

/// Amplitude and phase of a series at a frequency over its second half.
std::complex<double> swing(const Json& response, const char* key, double frequency) {
  const std::vector<double> t = response["time_s"], y = response[key];
  Eigen::MatrixXd columns(static_cast<Eigen::Index>(t.size() / 2), 4);
  Eigen::VectorXd values(columns.rows());
  for (Eigen::Index k = 0; k < columns.rows(); ++k) {
    const auto at = t.size() - static_cast<std::size_t>(columns.rows()) + static_cast<std::size_t>(k);
    const double angle = 2.0 * std::numbers::pi * frequency * t[at];
    columns.row(k) << std::sin(angle), std::cos(angle), 1.0, t[at];
    values(k) = y[at];
  }
  const Eigen::VectorXd fit = columns.colPivHouseholderQr().solve(values);
  return {fit(0), fit(1)};
}

TEST(Response, FrequencyResponseIsThatOfASmallSine) {
  for (const double frequency : {150.0, 700.0}) {
    Json given = solved()["cases"][2];
    Json& block = given["input"]["response"];
    const std::string f = fmt::format("{} Hz", frequency);
    block.erase("coupling");
    block["motor"] = {{"speed", "0 rpm"}};
    block["load"] = {{"mass", "45 kg"},
                     {"force", Json::array({"2 kN", {{"sine", {{"amplitude", "1 N"}, {"frequency", f}}}}})}};
    block["material_damping"] = {{"time", "60 us"}};
    block["frequency_response"] = {{"from", f}, {"to", "2 kHz"}, {"points", 2}, {"force", "2 kN"}};
    block["sample_interval"] = "0.1 ms";
    const Json response = response_of(source_of(given));
    const std::complex<double> found = -swing(response, "position_mm", frequency) * 1e3;  // A force to -x.
    const Json& expected = response["frequency_response"];
    const double size = expected["compliance_um_per_N"][0], phase = expected["phase_deg"][0];
    const double angle = phase * std::numbers::pi / 180.0;
    EXPECT_NEAR(std::abs(found - std::polar(size, angle)), 0.0, 1e-3 * size) << frequency;
  }
}

TEST(Response, FrequencyResponseOfTheMotorIsThatOfASmallSine) {
  // Rolling under a constant torque, without dry friction except in the threads.
  Json given = solved()["cases"][2];
  Json& block = given["input"]["response"];
  const double frequency = 300.0;
  block["duration"] = "0.3 s";
  block["sample_interval"] = "0.1 ms";
  block["motor"] = {{"inertia", "4 kg cm^2"}, {"damping", "0.02 N m s/rad"}, {"torque", "0 N m"}};
  block["screw"] = {{"inertia", "3.5 kg cm^2"}};
  block["load"] = {{"mass", "45 kg"}, {"force", "2 kN"}, {"damping", "500 N s/m"}};
  block["start"] = {{"speed", "20 mm/s"}};
  block.erase("settling");
  block["frequency_response"] = {{"from", "300 Hz"},       {"to", "2 kHz"},      {"points", 2},
                                 {"force", "2 kN"},        {"screw", "rolling"}, {"speed", "240 rpm"},
                                 {"input", "motor_torque"}};
  // The torque that holds this speed, from a run with a prescribed one.
  Json even = given;
  even["input"]["response"]["motor"] = {{"speed", "240 rpm"}, {"damping", "0.02 N m s/rad"}};
  even["input"]["response"].erase("frequency_response");
  const double torque = response_of(source_of(even))["motor_torque_Nm"].back();
  block["motor"]["torque"] = Json::array(
      {fmt::format("{:.15g} N m", torque), {{"sine", {{"amplitude", "0.002 N m"}, {"frequency", "300 Hz"}}}}});
  const Json response = response_of(source_of(given));
  const auto expect = [&](const char* series, double factor, const char* size_key, const char* phase_key) {
    const std::complex<double> found = swing(response, series, frequency) * factor / 0.002;
    const Json& expected = response["frequency_response"];
    const double size = expected[size_key][0], phase = expected[phase_key][0];
    EXPECT_NEAR(std::abs(found - std::polar(size, phase * std::numbers::pi / 180.0)), 0.0, 5e-3 * size) << series;
  };
  expect("motor_speed_rpm", std::numbers::pi / 30.0, "motor_speed_rad_per_s_per_Nm", "motor_speed_phase_deg");
  expect("position_mm", 1e3, "position_um_per_Nm", "position_phase_deg");
}

TEST(Response, RobotConstantsComeOut) {
  const Json& given = solved()["robot"][0];
  const SystemModel model = system_model(source_of(given), {}, WithDrive::needed);
  const Json robot = robot_constants(model, 6000.0, false);
  expect_near(robot, given["result"], "robot", 1.0);
}

}  // namespace
}  // namespace prs
