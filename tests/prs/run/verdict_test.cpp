#include "prs/run/check.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "prs/page/page.h"
#include "prs/run/commands.h"
#include "tests/support/program.h"
#include "tests/support/temporary_directory.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

using Overrides = std::vector<std::string>;

Json document(Command command, const std::string& lesson, const Overrides& overrides = {}) {
  const input::Source source = input::load_source(PRS_SOURCE_DIR "/configs/" + lesson, Overrides(overrides));
  return run(analysis_of(command), source).document(document_info(source, command));
}

Json verdict(const std::string& lesson, const Overrides& overrides = {}) {
  return document(Command::check, lesson, overrides)["verdict"];
}

/// Criterion with a name; null if there is none.
Json criterion(const Json& verdict, const std::string& name) {
  for (const Json& c : verdict["criteria"])
    if (c["name"] == name) return c;
  return {};
}

constexpr const char* kAbevi = "01_config_1_to_3.yaml";
constexpr const char* kMeasured = "18_design_measures.yaml";
constexpr const char* kDuty = "30_duty_cycle.yaml";

TEST(Verdict, StaticSafetyIsTheWorstOfAllLoadCasesWithTheirShares) {
  const Json c = criterion(verdict(kAbevi), "static_safety");
  double least = HUGE_VAL, equal = 0.0;
  std::string where;
  const Json measures = document(Command::measures, kAbevi);
  for (const Json& load_case : measures["load_cases"]) {
    equal = load_case["measures"]["static_safety"];
    if (const double own = load_case["measures"]["solved_static_safety"]; own < least)
      least = own, where = load_case["name"];
  }
  EXPECT_EQ(c["value"], least);
  EXPECT_EQ(c["load_case"], where);
  EXPECT_LT(least, 1.0);
  EXPECT_GT(equal, 1.5);  // Value that equal shares would have called green.
  EXPECT_EQ(c["state"], "red");
  EXPECT_EQ(c["limit"], 1.0);
  EXPECT_EQ(c["limit_source"], "physics");
}

/// The pressure limit and the static rating by pressure are one limit: both are exceeded at once.
TEST(Verdict, PressureIsThatOfTheMostLoadedThread) {
  const Json of_case = verdict(kAbevi), c = criterion(of_case, "peak_pressure");
  double largest = 0.0;
  const Json solve = document(Command::solve, kAbevi);
  for (const Json& load_case : solve["load_cases"])
    for (const char* side : {"screw", "nut"})
      for (const double p : load_case[side]["peak_pressure_MPa"]) largest = std::max(largest, p);
  EXPECT_DOUBLE_EQ(c["value"], largest);
  EXPECT_EQ(c["limit"], 4000.0);
  EXPECT_EQ(c["state"], largest > 4000.0 ? "red" : "green");
  EXPECT_EQ(of_case["state"], "red");
}

/// A soft nut bears less: the contact counts that is nearest to its own limit.
TEST(Verdict, APressureIsHeldAgainstTheLimitOfItsOwnContact) {
  const auto materials = [](const std::string& of_nut) {
    const std::string steel = "{youngs_modulus: 210 GPa, poisson_ratio: 0.3, density: 7800 kg/m^3}";
    return Overrides{
        fmt::format("materials={{screw: {0}, roller: {0}, nut: {{youngs_modulus: 110 GPa, poisson_ratio: "
                    "0.34, density: 8800 kg/m^3{1}}}}}",
                    steel, of_nut)};
  };
  const Json solve = document(Command::solve, kAbevi, materials(""));
  const auto largest = [&](const char* side) {
    double most = 0.0;
    for (const Json& load_case : solve["load_cases"])
      for (const double p : load_case[side]["peak_pressure_MPa"]) most = std::max(most, p);
    return most;
  };
  const double screw = largest("screw"), nut = largest("nut");
  ASSERT_LT(nut, screw);
  const auto pressure = [&](double limit) {
    return criterion(verdict(kAbevi, materials(fmt::format(", static_pressure_limit: {:.12g} MPa", limit))),
                     "peak_pressure");
  };
  const Json of_screw = pressure(2.0 * nut), of_nut = pressure(0.5 * nut);
  EXPECT_DOUBLE_EQ(of_screw["value"], screw);
  EXPECT_EQ(of_screw["limit"], 4000.0);
  EXPECT_DOUBLE_EQ(of_nut["value"], nut);
  EXPECT_NEAR(of_nut["limit"], 0.5 * nut, 1e-9 * nut);
  EXPECT_EQ(of_nut["state"], "red");
  Overrides unknown = materials("");
  for (int k = 0; k < 6; ++k) unknown.push_back(fmt::format("load_cases[{}].axial_force=5 kN", k));
  const Json v = verdict(kAbevi, unknown), of_unknown = criterion(v, "peak_pressure");
  EXPECT_EQ(of_unknown["state"], "no_limit");
  EXPECT_THAT(of_unknown["reason"].get<std::string>(), HasSubstr("roller-nut"));
  EXPECT_THAT(of_unknown["reason"].get<std::string>(), HasSubstr("add materials.nut.static_pressure_limit"));
  EXPECT_THAT(criterion(v, "static_safety")["reason"].get<std::string>(),
              HasSubstr("add materials.nut.static_pressure_limit"));
}

/// A load case without force, which `measures` refuses, takes nothing from the verdict on the others.
TEST(Verdict, ALoadCaseWithoutForceHidesNoOther) {
  const auto loads = [](const std::string& more) {
    const auto load = [](const char* of_case, const char* force, const char* direction) {
      return fmt::format("{{name: {}, axial_force: {}, direction: {}, position: 29 mm}}", of_case, force, direction);
    };
    return fmt::format("load_cases=[{}, {}{}]", load("pull", "40 kN", "tension"), load("push", "20 kN", "compression"),
                       more.empty() ? "" : ", " + load(more.c_str(), "0 N", "tension"));
  };
  const Overrides friction{"friction.model.coulomb=0.1", "operation.speed=300 rpm",
                           "measures.shaft={length: 300 mm, ends: fixed_supported}"};
  const auto of = [&](const std::string& more) {
    Overrides all = friction;
    all.push_back(loads(more));
    return verdict("12_preload.yaml", all);
  };
  const Json with = of("idle"), without = of("");
  for (const char* name : {"static_safety", "flank_edge", "peak_pressure", "buckling_safety"}) {
    ASSERT_TRUE(criterion(without, name).contains("value")) << name;
    for (const char* key : {"value", "limit", "state", "load_case"})
      EXPECT_EQ(criterion(with, name)[key], criterion(without, name)[key]) << name;
  }
}

/// Errors that only an analysis finds stand in the verdict of such a case too.
TEST(Verdict, ALoadCaseWithoutForceHidesNoError) {
  const Overrides straight{"mechanism.profile.roller=straight",
                           "load_cases=[{name: pull, axial_force: 20 kN, direction: tension, position: 29 mm}, {name: "
                           "idle, axial_force: 0 N, direction: tension, position: 29 mm}]"};
  const Json v = verdict("12_preload.yaml", straight);
  EXPECT_EQ(v["state"], "red");
  EXPECT_THAT(criterion(v, "input")["reason"].get<std::string>(), HasSubstr("mechanism.profile"));
}

struct Limited {
  const char *name, *unit;
  double factor = 1.0;  ///< Ratio of the value in the file to that in the document.
};

/// Checks that limits slightly to either side of the values change the states.
void expect_turn(const std::string& lesson, const std::vector<Limited>& limits, const Overrides& overrides = {}) {
  const auto with = [&](auto limit_of) {
    std::string block;
    for (const Limited& l : limits)
      block += fmt::format("{}{}: {:.12g}{}", block.empty() ? "" : ", ", l.name, l.factor * limit_of(l), l.unit);
    Overrides all = overrides;
    all.push_back("limits={" + block + "}");
    return verdict(lesson, all);
  };
  const Json known = with([](const Limited& l) { return l.unit == std::string(" degC") ? 50 : 0.5; });
  const auto value = [&](const Limited& l) { return criterion(known, l.name)["value"].get<double>(); };
  for (const Limited& l : limits) ASSERT_TRUE(criterion(known, l.name).contains("value")) << l.name;
  const Json lower = with([&](const Limited& l) { return 0.999 * value(l); });
  const Json upper = with([&](const Limited& l) { return 1.001 * value(l); });
  for (const Limited& l : limits) {
    const Json below = criterion(lower, l.name), above = criterion(upper, l.name);
    const bool least = below["sense"] == "least";
    EXPECT_EQ(below["state"], least ? "green" : "red") << below;
    EXPECT_EQ(above["state"], least ? "red" : "green") << above;
    EXPECT_EQ(below["limit_source"], "case");
  }
}

TEST(Verdict, ADriveCountsForPressureSpeedAndBuckling) {
  const Overrides drive{"measures={shaft: {length: 2 m, ends: fixed_free}}", "operation.speed=10 rpm",
                        "response.load.force={steps: [{at: 90 ms, value: -30 kN}]}"};
  const Json v = verdict("36_servo_axis.yaml", drive);
  const Json response = document(Command::response, "36_servo_axis.yaml", drive)["response"];
  const Json measures = document(Command::measures, "36_servo_axis.yaml", drive)["measures"];
  const Json speed = criterion(v, "critical_speed_share"), buckling = criterion(v, "buckling_safety");
  double fastest = 0.0;
  for (const double rpm : response["screw_speed_rpm"]) fastest = std::max(fastest, std::abs(rpm));
  EXPECT_GT(fastest, 100.0);
  EXPECT_NEAR(speed["value"].get<double>() / (fastest / measures["critical_speed_rpm"].get<double>()), 1.0, 1e-3);
  EXPECT_EQ(speed["load_case"], "response");
  EXPECT_EQ(speed["state"], "red");
  EXPECT_NEAR(buckling["value"].get<double>() * response["largest"]["compression"]["force_N"].get<double>() /
                  measures["buckling_load_N"].get<double>(),
              1.0, 1e-12);
  EXPECT_EQ(buckling["state"], "red");
}

/// Forces of a spectrum count although `life` has no result, and nothing is met without it.
TEST(Verdict, ASpectrumWithoutLifeIsNotLost) {
  const Overrides own{"materials.youngs_modulus=110 GPa", "measures.shaft={length: 2 m, ends: fixed_free}",
                      "life={position: 10 mm, spectrum: [{force: 10 kN, direction: tension, share: 0.5}, {force: 300 "
                      "kN, direction: compression, share: 0.5}]}",
                      "bearings={fixed: {dynamic_capacity: 20 kN, static_capacity: 40 kN}}",
                      "limits={peak_pressure: 3 GPa}"};
  const Json v = verdict(kMeasured, own);
  EXPECT_EQ(v["failed"], Json({"life"}));
  const Json measures = document(Command::measures, kMeasured, own)["measures"];
  const Json buckling = criterion(v, "buckling_safety"), bearing = criterion(v, "bearing_static_safety"),
             pressure = criterion(v, "peak_pressure");
  EXPECT_NEAR(buckling["value"].get<double>(), measures["buckling_load_N"].get<double>() / 300e3, 1e-12);
  EXPECT_EQ(buckling["load_case"], "life.spectrum");
  EXPECT_NEAR(bearing["value"].get<double>(), 40.0 / 300.0, 1e-12);
  EXPECT_THAT(pressure["reason"].get<std::string>(), HasSubstr("without `life`"));
  EXPECT_LT(pressure["value"].get<double>(), pressure["limit"].get<double>());
  EXPECT_EQ(pressure["state"], "not_computed");
}

/// A history that was not read may compress the screw.
TEST(Verdict, AHistoryWithoutLifeIsNotMet) {
  const Json of_screw = criterion(
      verdict("14_flight_spectrum.yaml",
              {"measures={shaft: {length: 500 mm, ends: supported_supported}}", "materials.youngs_modulus=150 GPa"}),
      "buckling_safety");
  EXPECT_EQ(of_screw["state"], "not_computed");
}

/// Values that hardly any screw has are named.
TEST(Verdict, UnusualCapacitiesAreAmber) {
  for (const Overrides& odd : {Overrides{"life.dynamic_capacity=60 N"}, Overrides{"life.static_capacity=3e9 N"},
                               Overrides{"life.dynamic_capacity=90 kN", "life.static_capacity=60 kN"}}) {
    Overrides all = odd;
    all.insert(all.begin(), "life={position: 10 mm, spectrum: [{force: 1 kN, direction: tension, share: 1}]}");
    const Json input = criterion(verdict(kMeasured, all), "input");
    ASSERT_FALSE(input.is_null()) << odd[0];
    EXPECT_EQ(input["state"], "amber");
    EXPECT_THAT(input["reason"].get<std::string>(), HasSubstr("capacity"));
  }
}

/// Ends as thick as a screw cannot stand beside it.
TEST(Verdict, RollerEndsInTheScrewAreRed) {
  EXPECT_TRUE(criterion(verdict(kMeasured), "roller_ends").is_null());
  const Json ends = criterion(verdict(kMeasured, {"structure.roller.end_diameter=20 mm"}), "roller_ends");
  EXPECT_EQ(ends["state"], "red");
  EXPECT_EQ(ends["value"], 20.0);
}

TEST(Verdict, AShaftShorterThanItsNutIsRed) {
  const auto between = [](const char* length) {
    return criterion(verdict(kMeasured, {fmt::format("measures.shaft={{length: {}, ends: fixed_free}}", length)}),
                     "shaft_length");
  };
  EXPECT_TRUE(between("500 mm").is_null());
  EXPECT_EQ(between("20 mm")["state"], "red");
}

/// Static safeties under the drive's largest force, which no load case has, are those of a spectrum with it.
TEST(Verdict, ADriveCountsForStaticSafety) {
  const Overrides drive{"bearings={fixed: {dynamic_capacity: 20 kN, static_capacity: 40 kN}}",
                        "response.load.force={steps: [{at: 90 ms, value: -60 kN}]}"};
  const Json v = verdict("36_servo_axis.yaml", drive);
  const double force =
      document(Command::response, "36_servo_axis.yaml", drive)["response"]["largest"]["compression"]["force_N"];
  const Json bearing = criterion(v, "bearing_static_safety"), own = criterion(v, "static_safety");
  EXPECT_NEAR(bearing["value"].get<double>() * force / 40e3, 1.0, 1e-12);
  const Json life = document(
      Command::life, "36_servo_axis.yaml",
      {fmt::format("life={{position: 12 mm, dynamic_capacity: 30 kN, spectrum: [{{force: {:.17g} N, direction: "
                   "compression, share: 1}}]}}",
                   force)})["life"];
  EXPECT_NEAR(own["value"].get<double>() / life["static_safety"].get<double>(), 1.0, 1e-9);
  for (const Json& c : {bearing, own}) {
    EXPECT_EQ(c["load_case"], "response");
    EXPECT_EQ(c["state"], "red");
  }
}

/// Also if only `preload` takes it into account.
TEST(Verdict, PressureIsThatUnderPreload) {
  const Overrides strong{"preload.force=90 kN", "preload.load={from: 2 kN, to: 4 kN, steps: 2}",
                         "load_cases=[{name: pull, axial_force: 2 kN, direction: tension, position: 29.1666667 mm}]"};
  const Json v = verdict("12_preload.yaml", strong);
  const Json point = document(Command::preload, "12_preload.yaml", strong)["preload"]["loads"][0];
  double pressure = 0.0;
  for (const char* side : {"tension", "compression"})
    pressure = std::max(pressure, point.at("sides").at(side).at("peak_pressure_MPa").get<double>());
  EXPECT_GT(pressure, 4000.0);
  const Json c = criterion(v, "peak_pressure");
  EXPECT_NEAR(c["value"].get<double>() / pressure, 1.0, 1e-9) << point;
  EXPECT_EQ(c["state"], "red");
  const Json safety = criterion(v, "static_safety");
  EXPECT_EQ(safety["value"], 0.0);
  EXPECT_THAT(safety["reason"].get<std::string>(), HasSubstr("under preload"));
}

/// Force over the displacement from the unloaded state, of both flanks; the shaft in series where a limit stands.
TEST(Verdict, StiffnessIsThatUnderPreload) {
  const Overrides both{"preload.load={from: 6 kN, to: 7 kN, steps: 2}",
                       "load_cases=[{name: pull, axial_force: 6 kN, direction: tension, position: 29.1666667 mm}]"};
  const Json point = document(Command::preload, "12_preload.yaml", both)["preload"]["loads"][0];
  const double secant = 6000.0 / point.at("axial_displacement_um").get<double>();
  const Json c = criterion(verdict("12_preload.yaml", both), "stiffness");
  EXPECT_NEAR(c["value"].get<double>() / secant, 1.0, 1e-9);
  EXPECT_EQ(c["reason"], "largest force, at rest under preload");
  Overrides with_shaft = both;
  with_shaft.insert(with_shaft.end(),
                    {"limits={stiffness: 100 N/um}", "measures={shaft: {length: 500 mm, ends: fixed_free}}"});
  const double area = std::numbers::pi / 4.0 * (21.0 * 21.0 - 6.0 * 6.0), shaft = 209.0 * area / 500.0;
  EXPECT_NEAR(criterion(verdict("12_preload.yaml", with_shaft), "stiffness")["value"].get<double>() *
                  (1.0 / secant + 1.0 / shaft),
              1.0, 1e-9);
}

/// Remainder of the limit under a strong preload: none, if the preload alone exceeds it.
TEST(Verdict, StaticSafetyUnderStrongPreloadIsThatOfThePreloadCurve) {
  const auto strong = [](const char* preload, const std::string& range = "{from: 1 kN, to: 2 kN, steps: 2}") {
    return Overrides{std::string("preload.force=") + preload, "preload.load=" + range,
                     "life={position: 29.1666667 mm, spectrum: [{force: 2 kN, direction: tension, share: 1}]}"};
  };
  const Json life = document(Command::life, "12_preload.yaml", strong("68 kN"))["life"];
  EXPECT_EQ(life["static_safety_limit"], "pressure");
  const double force = 2.0 * life["static_safety"].get<double>();  // [kN]
  const std::string there = fmt::format("{{from: {:.12g} kN, to: {:.12g} kN, steps: 2}}", force, force + 1.0);
  const Json point = document(Command::preload, "12_preload.yaml", strong("68 kN", there))["preload"]["loads"][0];
  EXPECT_NEAR(point.at("sides").at("tension").at("peak_pressure_MPa").get<double>(), 4000.0, 1e-4) << force;
  const Json none = document(Command::life, "12_preload.yaml", strong("90 kN"));
  EXPECT_EQ(none["life"]["static_safety"], 0.0);
  EXPECT_THAT(none["warnings"].dump(), HasSubstr("is exceeded without any axial load"));
}

/// Pressure over force has a hump: 4.0 GPa from 1.26 kN to 2.4 kN, and again from 10 kN on.
TEST(Verdict, TheStaticLimitOfATiltedScrewIsTheSmallestForceWhateverTheSpectrum) {
  const auto capacity = [](const char* force) {
    const Overrides tilted{
        "load_cases=[{name: t, axial_force: 9 kN, direction: tension, position: 29.1666667 mm, "
        "misalignment: {nut_tilt: {z: 0.13 deg}}}]",
        std::string("life={position: 29.1666667 mm, spectrum: [{force: ") + force +
            ", direction: tension, share: 1}]}"};
    return document(Command::life, "24_misalignment.yaml", tilted)["life"]["tension"]["static_capacity_N"]
        .get<double>();
  };
  const double least = capacity("2 kN");
  EXPECT_LT(least, 1500.0);
  EXPECT_NEAR(capacity("45 kN") / least, 1.0, 1e-6);
}

TEST(Verdict, StiffnessOfATiltedNutIsTheTangent) {
  const Overrides tilted{
      "load_cases=[{name: t, axial_force: 9.3 kN, direction: tension, position: 29.1666667 mm, "
      "misalignment: {nut_tilt: {z: 0.1 deg}}}]",
      "limits={stiffness: 1500 N/um}"};
  const Json c = criterion(verdict("24_misalignment.yaml", tilted), "stiffness");
  const Json solved = document(Command::solve, "24_misalignment.yaml", tilted)["load_cases"][0];
  EXPECT_EQ(c["value"], solved["tangent_stiffness_N_per_um"]);
  EXPECT_EQ(c["state"], "red");
}

TEST(Verdict, StatedLimitsAreMetOrMissed) {
  expect_turn(kMeasured,
              {{"life", " h"},
               {"static_safety", ""},
               {"peak_pressure", " MPa"},
               {"buckling_safety", ""},
               {"critical_speed_share", " %", 100.0},
               {"speed_times_diameter", " mm/min"},
               {"nut_diameter", " mm"},
               {"nut_length", " mm"},
               {"weight", " kg"},
               {"stiffness", " N/um"}},
              {"life={position: 11 mm, spectrum: [{force: 30 kN, direction: compression, share: 1}]}"});
  expect_turn(kDuty, {{"efficiency", " %", 100.0}, {"temperature", " degC"}});
}

/// d = 30 mm at 1000 rpm; the nut as in the file.
TEST(Verdict, PlainValuesAreThoseOfTheFile) {
  const Json all = verdict(kMeasured, {"limits={speed_times_diameter: 150000 mm/min, "
                                       "nut_diameter: 80 mm, nut_length: 120 mm}"});
  EXPECT_NEAR(criterion(all, "speed_times_diameter")["value"], 30000.0, 1e-8);
  EXPECT_NEAR(criterion(all, "nut_diameter")["value"], 68.0, 1e-12);
  EXPECT_NEAR(criterion(all, "nut_length")["value"], 60.0, 1e-12);
}

TEST(Verdict, WhatCannotBeComputedIsNeverMet) {
  const Overrides gentle = {"load_cases[0].axial_force=5 kN", "load_cases[1].axial_force=5 kN"};
  EXPECT_EQ(criterion(verdict(kMeasured, gentle), "static_safety")["state"], "green");
  Overrides limited = gentle;
  limited.emplace_back("limits={temperature: 80 degC, life: 20000 h, efficiency: 75 %}");
  const Json all = verdict(kMeasured, limited);
  for (const char* name : {"temperature", "life", "efficiency"}) {
    const Json c = criterion(all, name);
    EXPECT_EQ(c["state"], "not_computed");
    EXPECT_FALSE(c.contains("value"));
    EXPECT_THAT(c["reason"].get<std::string>(), HasSubstr("add "));
  }
  EXPECT_NE(all["state"], "green");
  const Json without_shaft = criterion(verdict(kAbevi), "buckling_safety");
  EXPECT_EQ(without_shaft["state"], "not_computed");
  EXPECT_EQ(without_shaft["reason"], "add measures.shaft");
  EXPECT_EQ(criterion(verdict(kAbevi), "critical_speed_share")["state"], "not_applicable");
}

/// The check makes no matrices; it reports equal shares that the case states.
/// A stated slip ratio takes a force that is no loss, and a screw at rest has no film.
TEST(Verdict, AStatedSlipRatioHasNoEfficiencyAndRestNoFilm) {
  const Json imposed = criterion(verdict("09_slip_and_dissipation.yaml", {"operation.slip_ratio=0.37"}), "efficiency");
  EXPECT_EQ(imposed["state"], "not_computed");
  EXPECT_THAT(imposed["reason"], HasSubstr("stated slip ratio"));
  const Json film =
      criterion(verdict("09_slip_and_dissipation.yaml",
                        {"operation.speed=0 rpm", "friction.model={coulomb: 0.1}", "roughness=0.4 um",
                         "load_cases=[{name: hold, axial_force: 10 kN, direction: tension, position: 29 mm}]"}),
                "film");
  EXPECT_THAT(film["reason"], HasSubstr("at rest"));
}

TEST(Verdict, SaysWhereThreadLoadsAreNotSolved) {
  const Json equal = criterion(verdict("07_contact_geometry.yaml"), "static_safety");
  EXPECT_THAT(equal["reason"].get<std::string>(), testing::StartsWith("equal thread loads, "));
  const Json influence = criterion(verdict(kAbevi, {"model.bodies=influence"}), "static_safety");
  EXPECT_EQ(influence["state"], "not_computed");
  EXPECT_THAT(influence["reason"].get<std::string>(), HasSubstr("influence"));
}

/// Matrices take long: what was not run is never green, a reference's tolerance included.
TEST(Verdict, WhatWasSkippedIsNotGreen) {
  const Json free = verdict(kAbevi, {"model.bodies=influence"});
  EXPECT_NE(free["state"], "green");
  EXPECT_THAT(free["skipped"], testing::Contains("solve"));
  EXPECT_TRUE(criterion(free, "references").is_null());
  const Json judged = verdict("38_reference.yaml", {"model.bodies=influence"});
  const Json references = criterion(judged, "references");
  EXPECT_EQ(references["state"], "not_computed");
  EXPECT_EQ(references["limit"], 1.0);
  EXPECT_FALSE(verdict("38_reference.yaml").contains("skipped"));
}

TEST(Verdict, TheStrokeOfAnInvertedScrewIsOverTheRollersThreads) {
  const Json c = criterion(verdict("14_flight_spectrum.yaml", {"life.stroke=900 mm"}), "stroke");
  EXPECT_EQ(c["title"], "Stroke over rollers' threads");
  EXPECT_NEAR(c["value"], 900.0 / (20 * 5.0 / 3.0), 1e-9);
  EXPECT_EQ(criterion(verdict(kMeasured), "stroke")["title"], "Stroke over the nut's length");
}

/// Between the physical and the recommended limit.
TEST(Verdict, EachLoadIsThatAtRestOrRunning) {
  const Json v = verdict("31_running_screw.yaml");
  const auto reason = [&](const char* name) { return criterion(v, name)["reason"].get<std::string>(); };
  const auto largest = [](Command command) {
    double most = 0.0;
    const Json of = document(command, "31_running_screw.yaml");
    for (const Json& load_case : of["load_cases"])
      for (const char* side : {"screw", "nut"})
        for (const Json& pressure : load_case[side]["peak_pressure_MPa"]) most = std::max(most, pressure.get<double>());
    return most;
  };
  EXPECT_GT(largest(Command::slip), largest(Command::solve));
  EXPECT_NEAR(criterion(v, "peak_pressure")["value"].get<double>(), largest(Command::slip),
              1e-8 * largest(Command::slip));
  EXPECT_THAT(reason("peak_pressure"), testing::EndsWith(", running"));
  EXPECT_THAT(reason("static_safety"), HasSubstr("at rest"));
  EXPECT_THAT(reason("stiffness"), HasSubstr("at rest"));
}

TEST(Verdict, AmberIsShortOfWhatIsRecommended) {
  const double force = 30.0;  // [kN]
  const double safety = criterion(verdict(kMeasured), "static_safety")["value"];
  const auto at = [&](double wanted) {
    const std::string kn = fmt::format("{:.12g} kN", force * safety / wanted);
    return criterion(verdict(kMeasured, {"load_cases[0].axial_force=" + kn, "load_cases[1].axial_force=" + kn}),
                     "static_safety");
  };
  EXPECT_EQ(at(0.99)["state"], "red");
  EXPECT_EQ(at(1.01)["state"], "amber");
  EXPECT_EQ(at(1.49)["limit"], 1.5);
  EXPECT_EQ(at(1.51)["state"], "green");
  EXPECT_EQ(at(1.51)["limit_source"], "recommended");
}

/// A screw of 19 overlapping rollers: a warning, a red verdict, and no page.
TEST(Verdict, AnImpossibleScrewIsRedAndEndsAsWrongInput) {
  const Overrides crowded{"mechanism.rollers=19"};
  const Json v = verdict("31_running_screw.yaml", crowded);
  EXPECT_EQ(v["state"], "red");
  EXPECT_THAT(criterion(v, "input")["reason"].get<std::string>(), HasSubstr("mechanism.rollers"));
  EXPECT_THAT(v["failed"].dump(), HasSubstr("slip"));
  const input::Source source = input::load_source(PRS_SOURCE_DIR "/configs/31_running_screw.yaml", Overrides(crowded));
  EXPECT_THAT(run(analysis_of(Command::check), source).wrong_input, HasSubstr("mechanism.rollers"));
  EXPECT_THROW(make_report(source, {.live = false}), input::InputError);
}

TEST(Verdict, FewContactsThinFilmsAndShortStrokesAreAmber) {
  const Overrides few{"mechanism.contacts_per_roller=4", "load_cases[0].axial_force=1 kN",
                      "load_cases[1].axial_force=1 kN"};
  const Json v = verdict("05_standard_screw.yaml", few);
  EXPECT_EQ(criterion(v, "contacts_per_roller")["state"], "amber");
  EXPECT_EQ(criterion(verdict("05_standard_screw.yaml", {"mechanism.rollers=2"}), "rollers")["state"], "amber");
  const std::string life =
      "life={position: 12 mm, stroke: 146 mm, spectrum: [{force: 2 kN, direction: tension, share: 1}]}";
  const Json thick = verdict("31_running_screw.yaml",
                             {life, "lubricant={name: iso-vg-460, temperature: 20 degC}", "roughness=0.1 um"});
  const Json thin =
      verdict("31_running_screw.yaml", {life, "lubricant={name: iso-vg-32, temperature: 90 degC}", "roughness=0.8 um"});
  EXPECT_GT(criterion(thick, "film")["value"], 1.0);
  EXPECT_EQ(criterion(thick, "film")["state"], "green");
  EXPECT_LT(criterion(thin, "film")["value"], 1.0);
  EXPECT_EQ(criterion(thin, "film")["state"], "amber");
  EXPECT_NEAR(criterion(thin, "stroke")["value"], 146.0 / 73.0, 1e-12);
  EXPECT_EQ(criterion(thin, "stroke")["state"], "green");
  EXPECT_EQ(criterion(verdict("05_standard_screw.yaml"), "contacts_per_roller"), Json());
}

/// An ellipse over the edge of a flank is an edge stress: amber, and static safety does not include it.
TEST(Verdict, TheFlanksEdgeIsACriterionOfItsOwn) {
  const double margin = criterion(verdict(kMeasured), "flank_edge")["value"];
  const Overrides over{fmt::format("load_cases[0].axial_force={:.12g} kN", 30.0 * 1.01 * margin),
                       fmt::format("load_cases[1].axial_force={:.12g} kN", 30.0 * 1.01 * margin),
                       "life={position: 11 mm, static_capacity: 900 kN, "
                       "spectrum: [{force: 1 kN, direction: tension, share: 1}]}"};
  const Json v = verdict(kMeasured, over);
  EXPECT_NEAR(criterion(v, "flank_edge")["value"], 1.0 / 1.01, 1e-8);
  EXPECT_EQ(criterion(v, "flank_edge")["state"], "amber");
  EXPECT_NEAR(criterion(v, "static_safety")["value"], 900.0 / (30.0 * 1.01 * margin), 1e-9);
}

/// Temperature is the hottest of slip and life; quantities that depend on loads are those of running parts.
TEST(Verdict, HeatCountsInEveryCriterion) {
  const Json v = verdict(kDuty);
  const Json cycle = document(Command::slip, kDuty)["heat_cycle"];
  double hottest = 0.0;
  for (const double t : cycle["peak_degC"]) hottest = std::max(hottest, t);
  EXPECT_DOUBLE_EQ(criterion(v, "temperature")["value"], hottest);
  Json mean = cycle["mean_degC"];
  const std::string warm =
      fmt::format("deviations.temperature={{screw: {:.15g} degC, roller: {:.15g} degC, nut: {:.15g} degC}}",
                  mean["screw"].get<double>(), mean["rollers"].get<double>(), mean["nut"].get<double>());
  std::string text = test::content_of(PRS_SOURCE_DIR "/configs/" + std::string(kDuty));
  text.resize(text.find("\nheat:"));
  const input::Source cold = input::source_of_text("cold.yaml", text, {warm, "lubricant.temperature=60 degC"});
  const Json solved =
      run(analysis_of(Command::solve), cold).document(document_info(cold, Command::solve))["load_cases"];
  double largest = 0.0, stiffness = 0.0;
  for (const Json& load_case : solved) largest = std::max(largest, std::abs(load_case["axial_force_N"].get<double>()));
  for (const Json& load_case : solved)
    if (load_case["axial_force_N"] == largest && stiffness == 0.0) stiffness = load_case["axial_stiffness_N_per_um"];
  EXPECT_NEAR(criterion(v, "stiffness")["value"].get<double>() / stiffness, 1.0, 1e-9);
}

/// The pressure is that of the worst position of a turn, p ~ N^(1/3), wherever the turn begins.
TEST(Verdict, ATurnOfTheCarrierCounts) {
  const Overrides turn{"load_cases[0].orbit={steps: 8}"};
  const Json solved = document(Command::solve, "26_unequal_rollers.yaml", turn)["load_cases"][0];
  double expected = 0.0, here = 0.0;
  for (const char* side : {"screw", "nut"}) {
    double pressure = 0.0;
    for (const Json& roller : solved[side]["peak_pressure_MPa"])
      for (const double p : roller) pressure = std::max(pressure, p);
    const double normal = solved[side]["largest_normal_load_N"];
    const double of_turn = solved["orbit"][side]["largest_normal_load_N"];
    here = std::max(here, pressure);
    expected = std::max(expected, pressure * std::cbrt(of_turn / normal));
  }
  EXPECT_GT(expected, 1.01 * here);
  const Json c = criterion(verdict("26_unequal_rollers.yaml", turn), "peak_pressure");
  EXPECT_NEAR(c["value"].get<double>() / expected, 1.0, 1e-9);
}

TEST(Verdict, ThreadsThatInterfereAndLoadsThatDoNotConvergeAreRed) {
  EXPECT_EQ(
      criterion(verdict("08_design_by_backlash.yaml", {"mechanism.backlash.nut=-0.01 mm"}), "axial_play")["state"],
      "red");
  const Json jammed =
      verdict("09_slip_and_dissipation.yaml", {"carrier.nut_torque=150 N m", "load_cases[0].axial_force=80 kN"});
  EXPECT_EQ(criterion(jammed, "convergence")["state"], "red");
  EXPECT_EQ(jammed["state"], "red");
}

TEST(Verdict, AStatedCapacityHasTheCataloguesLife) {
  const std::string life =
      "life={dynamic_capacity: 100 kN, position: 11 mm, spectrum: [{force: 30 kN, direction: "
      "tension, share: 1}]}";
  // L10 = 10^6 (C_a/F)^3 revolutions at 1000 rpm.
  EXPECT_NEAR(criterion(verdict(kMeasured, {life}), "life")["value"], 1e6 * std::pow(100.0 / 30.0, 3) / 1000.0 / 60.0,
              1e-6);
}

TEST(Verdict, TheTableNamesLimitAndLoadCase) {
  const std::string table = test::run_prs("check configs/01_config_1_to_3.yaml").out;
  EXPECT_THAT(table, AllOf(HasSubstr("Not met: static safety"), HasSubstr(">= 1 (physical limit)"),
                           HasSubstr("No value: "), HasSubstr("temperature (add heat)")));
  EXPECT_LT(table.find("Not met: "), table.find("\nWarnings"));
}

/// One number for each quantity: estimates are shown on request only.
TEST(Headlines, EstimatesStandInTheFullTablesAlone) {
  const test::TemporaryDirectory folder;
  const std::string file = folder.path() / "screw.yaml";
  ASSERT_EQ(test::run_prs("new standard " + file + " --screw-diameter 25mm --lead 5mm").status, 0);
  for (const auto& [command, estimate] :
       {std::pair("measures", "(estimate"), std::pair("life", "estimate: equal thread loads"),
        std::pair("slip", "  thread loads                           equal")}) {
    const std::string own = std::string(command) + ' ' + file;
    EXPECT_THAT(test::run_prs(own).out, Not(HasSubstr(estimate))) << command;
    EXPECT_THAT(test::run_prs(own + " --all").out, HasSubstr(estimate)) << command;
  }
}

}  // namespace
}  // namespace prs
