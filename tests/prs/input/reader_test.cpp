#include "prs/input/reader.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "tests/prs/input/abevi.h"

namespace prs::input {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

Case read(const std::string& text, const std::vector<std::string>& overrides = {}, Command command = Command::solve) {
  return read_case_text(text, "case.yaml", overrides, command);
}

std::string error_of(const std::string& text, const std::vector<std::string>& overrides = {},
                     Command command = Command::solve) {
  try {
    read(text, overrides, command);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(ReadCase, ReadsTheScrewOfAbevi) {
  const Case c = read(kAbevi);
  EXPECT_EQ(c.mechanism.type, Mechanism::Type::inverted);
  EXPECT_EQ(c.mechanism.lead, 0.005);
  EXPECT_EQ(c.mechanism.starts.screw, 3);
  EXPECT_EQ(c.mechanism.flank_angle.roller, std::numbers::pi / 4);
  EXPECT_EQ(c.mechanism.pitch_diameter.nut, 0.035);
  EXPECT_EQ(c.mechanism.centre_distance, 0.014);
  EXPECT_EQ(c.mechanism.profile.screw.shape, Profile::Shape::straight);
  EXPECT_EQ(c.mechanism.profile.roller.shape, Profile::Shape::convex);
  EXPECT_EQ(c.mechanism.profile.roller.radius, 4.949747468e-3);
  EXPECT_EQ(c.mechanism.rollers, 11);
  ASSERT_TRUE(c.structure);
  EXPECT_EQ(c.structure->screw.bore, 0.006);
  ASSERT_EQ(c.structure->nut.flanges.size(), 2U);
  EXPECT_EQ(c.structure->nut.flanges[1].from, 0.080);
  EXPECT_EQ(c.structure->nut.thrust.compression, 0.080);
  ASSERT_TRUE(c.materials);
  EXPECT_EQ(c.materials->nut.youngs_modulus, 209e9);
  EXPECT_FALSE(c.materials->nut.density);
  EXPECT_FALSE(c.friction);
}

TEST(ReadCase, WhatIsAbsentHasItsDefault) {
  const Case c = read(abevi_with("  screw: {bore: 6 mm, free_length: 10 mm}\n", ""));
  EXPECT_EQ(c.mechanism.geometry, Mechanism::Geometry::simulation);
  EXPECT_EQ(c.mechanism.profile_plane, Mechanism::ProfilePlane::normal);
  EXPECT_EQ(c.structure->screw.bore, 0.0);
  EXPECT_EQ(c.structure->screw.free_length, 0.0);
  EXPECT_EQ(c.structure->roller.guidance.kind, Guidance::Kind::both_end_nodes);
  EXPECT_EQ(c.model.roller, ModelOptions::Roller::flexible);
  EXPECT_FALSE(c.model.roller_shear);
  EXPECT_EQ(c.model.patch_points, 21);
  EXPECT_EQ(c.carrier.nut_torque, 0.0);
}

TEST(ReadCase, TooFewPatchPointsAreRefusedWithTheReason) {
  EXPECT_EQ(error_of(kAbevi, {"model={patch_points: 9}"}), "");
  for (const char* points : {"8", "1"}) {
    const std::string message = error_of(kAbevi, {fmt::format("model={{patch_points: {}}}", points)});
    EXPECT_THAT(message, HasSubstr(fmt::format("model.patch_points: got {}; expected", points)));
    EXPECT_THAT(message, HasSubstr("from 9 to 1001, as fewer points carry"));
  }
}

TEST(ReadCase, ARangeMakesOneCaseAPoint) {
  const Case c = read(kAbevi);
  ASSERT_EQ(c.load_cases.size(), 46U);
  EXPECT_EQ(c.load_cases[0].name, "pull");
  EXPECT_EQ(c.load_cases[0].input_path, "load_cases[0]");
  EXPECT_EQ(c.load_cases[1].name, "push[0]");
  EXPECT_EQ(c.load_cases[45].name, "push[44]");
  EXPECT_EQ(c.load_cases[45].input_path, "load_cases[1]");
  for (int k = 0; k < 45; ++k) EXPECT_EQ(c.load_cases[static_cast<std::size_t>(k + 1)].axial_force, 1e3 * (k + 1));
}

TEST(ReadCase, TheEndsOfARangeAreExact) {
  const Case c = read(kAbevi, {"load_cases[1].axial_force={from: 0.1 kN, to: 0.7 kN, steps: 7}"});
  EXPECT_EQ(c.load_cases[1].axial_force, 100.0);
  EXPECT_EQ(c.load_cases.back().axial_force, 700.0);
  const Case one = read(kAbevi, {"load_cases[1].axial_force={from: 3 N, to: 3 N, steps: 1}"});
  EXPECT_EQ(one.load_cases.back().name, "push[0]");
  EXPECT_EQ(one.load_cases.back().axial_force, 3.0);
}

TEST(ReadCase, NamelessCasesAreNumbered) {
  const Case c = read(kAbevi, {"load_cases=[{axial_force: 1 kN, share: equal}, {axial_force: {from: "
                               "1 kN, to: 2 kN, steps: 2}, share: equal}]"});
  EXPECT_EQ(c.load_cases[0].name, "case-1");
  EXPECT_EQ(c.load_cases[2].name, "case-2[1]");
}

TEST(ReadCase, EqualSharesCarryTheSignOfTheForce) {
  const auto force = [](const std::string& load) {
    return read(kAbevi, {"load_cases=[{share: equal, " + load + "}]"}).load_cases[0].axial_force;
  };
  EXPECT_EQ(force("axial_force: 2 kN"), 2e3);
  EXPECT_EQ(force("axial_force: -2 kN"), -2e3);
  EXPECT_EQ(force("axial_force: 2 kN, direction: tension"), 2e3);
  EXPECT_EQ(force("axial_force: 2 kN, direction: compression"), 2e3);
  EXPECT_THAT(error_of(kAbevi, {"load_cases=[{share: equal, axial_force: -2 kN, direction: "
                                "compression}]"}),
              HasSubstr("got -2 kN in case `case-1`; expected a force > 0"));
}

TEST(ReadCase, OneMaterialOrOneForEachPart) {
  const Case c = read(kAbevi, {"materials={screw: {youngs_modulus: 200 GPa, poisson_ratio: 0.3}, "
                               "roller: {youngs_modulus: 210 GPa, poisson_ratio: 0.28, density: 7.8 "
                               "g/cm^3}, nut: {youngs_modulus: 100 GPa, poisson_ratio: 0}}"});
  EXPECT_EQ(c.materials->screw.youngs_modulus, 200e9);
  EXPECT_EQ(c.materials->roller.density, 7800.0);
  EXPECT_EQ(c.materials->nut.poisson_ratio, 0.0);
}

TEST(ReadCase, OneFlankAngleOrOneForEachPart) {
  const Case c = read(kAbevi, {"mechanism.flank_angle={screw: 45 deg, roller: 44 deg, nut: 1 rad}"});
  EXPECT_EQ(c.mechanism.flank_angle.nut, 1.0);
}

TEST(ReadCase, FrictionMayBeWrittenInThreeWays) {
  for (const char* text : {"{coulomb: 0.11}", "{model: {coulomb: 0.11}}"}) {
    const Case c = read(kAbevi, {std::string("friction=") + text});
    EXPECT_EQ(c.friction->kind, contact::kind_of<contact::Coulomb>) << text;
    EXPECT_EQ(c.friction->coefficient, at_both(0.11)) << text;
  }
  const std::vector<std::string> each = {"friction={coulomb: {screw: 0.12, nut: 0.08}}"};
  EXPECT_EQ(read(kAbevi, each).friction->coefficient, (PerInterface<double>{0.12, 0.08}));
  EXPECT_EQ(read(kAbevi, {"friction={model: jacod}"}).friction->kind, contact::kind_of<contact::Jacod>);
  EXPECT_DOUBLE_EQ(read(kAbevi, {"wear={coefficient: 2e-8 mm^3/(N m)}"}).wear->coefficient, 2e-17);
  for (const char* text :
       {"friction={model: {mixed: {boundary: 0.12}}}", "friction={mixed: {boundary: 0.12, exponent: 2}}"}) {
    const Friction mixed = *read(kAbevi, {text}).friction;
    EXPECT_EQ(mixed.kind, contact::kind_of<contact::Mixed>);
    EXPECT_EQ(mixed.boundary, at_both(0.12));
    EXPECT_EQ(mixed.exponent, at_both(2.0));
  }
}

const std::string kOil =
    "pressure_viscosity: 30 1/GPa, eyring_stress: 12 MPa, temperature: 60 degC, density: 870 "
    "kg/m^3, ";

TEST(ReadCase, TheLubricantMayFollowItsTemperature) {
  const Case points = read(kAbevi, {"lubricant={" + kOil +
                                    "viscosity_at: [{temperature: 40 degC, kinematic_viscosity: "
                                    "100 cSt}, {temperature: 100 °C, viscosity: 9.57 mPa s}]}"});
  EXPECT_FALSE(points.lubricant->viscosity);
  EXPECT_EQ(points.lubricant->temperature, 333.15);
  EXPECT_EQ(points.lubricant->density, 870.0);
  ASSERT_EQ(points.lubricant->viscosity_at.size(), 2U);
  EXPECT_EQ(points.lubricant->viscosity_at[0].kinematic_viscosity, 100e-6);
  EXPECT_FALSE(points.lubricant->viscosity_at[0].viscosity);
  EXPECT_EQ(points.lubricant->viscosity_at[1].temperature, 373.15);
  EXPECT_EQ(points.lubricant->viscosity_at[1].viscosity, 9.57e-3);
  const Case line = read(kAbevi, {"lubricant={" + kOil + "walther: {intercept: 9.5, slope: 3.7}}"});
  EXPECT_EQ(line.lubricant->walther->intercept, 9.5);
  EXPECT_EQ(line.lubricant->walther->slope, 3.7);
}

/// n = v/lead.
TEST(ReadCase, SpeedsMayBeAlongTheAxis) {
  const auto speed = [](const std::vector<std::string>& overrides) { return read(kAbevi, overrides).operation->speed; };
  const double turn = 2.0 * std::numbers::pi;
  EXPECT_DOUBLE_EQ(speed({"operation={speed: 200 mm/s}"}), 40.0 * turn);
  EXPECT_DOUBLE_EQ(speed({"operation={speed: -1 in/s}"}), -25.4 / 5.0 * turn);
  EXPECT_DOUBLE_EQ(speed({"operation={speed: 200 mm/s}", "mechanism.lead=-5 mm"}), -40.0 * turn);
  for (const char* lead : {"mechanism.lead=4 mm", "mechanism.lead=0.004 m"})
    EXPECT_DOUBLE_EQ(speed({"operation={speed: 200 mm/s}", lead}), 50.0 * turn);
  const Case c = read(kAbevi, {"load_cases[0].speed=3 m/min"});
  EXPECT_DOUBLE_EQ(*c.load_cases[0].speed, 10.0 * turn);
  EXPECT_THAT(error_of(kAbevi, {"operation={speed: 200 mm}"}),
              testing::HasSubstr("rpm, 1/min, rad/s, deg/s, mm/s, m/s, m/min"));
}

/// A page shows, and a study varies, the value as written.
TEST(ReadCase, TheEchoOfASpeedAlongTheAxisHasBoth) {
  const CaseInput in = read_case_input({"case.yaml", kAbevi, {"operation={speed: 200 mm/s}"}}, Command::solve);
  const auto entry = std::ranges::find(in.fields, "operation.speed", &EchoEntry::path);
  ASSERT_NE(entry, in.fields.end());
  EXPECT_EQ(entry->value, "2400 rpm");
  EXPECT_EQ(entry->written, "200 mm/s");
}

TEST(ReadCase, RoughnessIsOneOrOneForEachPart) {
  EXPECT_FALSE(read(kAbevi).roughness);
  EXPECT_EQ(read(kAbevi, {"roughness=0.2 um"}).roughness, (PerPart<double>{0.2 / 1e6, 0.2 / 1e6, 0.2 / 1e6}));
  EXPECT_EQ(read(kAbevi, {"roughness={screw: 0.2 um, roller: 0.1 um, nut: 0.4 um}"}).roughness,
            (PerPart<double>{0.2 / 1e6, 0.1 / 1e6, 0.4 / 1e6}));
}

TEST(ReadCase, SlipRatioBearingAndGearsAreOptional) {
  const Case plain = read(kAbevi, {"operation.speed=400 rpm"});
  EXPECT_FALSE(plain.operation->slip_ratio);
  EXPECT_FALSE(plain.carrier.bearing);
  EXPECT_EQ(plain.carrier.gear_pressure_angle, std::numbers::pi / 9);
  const Case c = read(kAbevi, {"operation={speed: 400 rpm, slip_ratio: 0.3}",
                               "carrier={gear_pressure_angle: 25 deg, bearing: {length: 4 mm, "
                               "diameter: 5 mm, radial_clearance: 15 um}}"});
  EXPECT_EQ(c.operation->slip_ratio, 0.3);
  EXPECT_EQ(c.carrier.bearing->length, 0.004);
  EXPECT_EQ(c.carrier.bearing->diameter, 0.005);
  EXPECT_EQ(c.carrier.bearing->radial_clearance, 15e-6);
  EXPECT_NEAR(c.carrier.gear_pressure_angle, 25 * std::numbers::pi / 180, 1e-16);
}

TEST(ReadCase, GuidanceMayBeARing) {
  const Case c = read(kAbevi, {"structure.roller.guidance={ring: 2e4 N/mm}"});
  EXPECT_EQ(c.structure->roller.guidance.kind, Guidance::Kind::ring);
  EXPECT_EQ(c.structure->roller.guidance.ring_stiffness, 2e7);
}

TEST(ReadCase, DesignModeTakesTheScrewAndTheBacklash) {
  const std::string text = abevi_with("{screw: 21 mm, roller: 7 mm, nut: 35 mm}", "{screw: 21 mm}");
  std::string design = text;
  const std::string distance = "  centre_distance: 14 mm\n";
  design.replace(design.find(distance), distance.size(), "  geometry: design\n");
  const Case c = read(design, {"mechanism.backlash={nut: 0.02 mm}"});
  EXPECT_FALSE(c.mechanism.pitch_diameter.nut);
  EXPECT_EQ(c.mechanism.backlash.screw, 0.0);
  EXPECT_EQ(c.mechanism.backlash.nut, 2e-5);
}

TEST(ReadCase, OverridesReplaceValuesOfTheFile) {
  const Case c = read(
      kAbevi, {"mechanism.rollers=9", "load_cases[0].axial_force=20 kN", "contact={}", "model.roller=rigid_bending"});
  EXPECT_EQ(c.mechanism.rollers, 9);
  EXPECT_EQ(c.load_cases[0].axial_force, 20e3);
  EXPECT_EQ(c.model.roller, ModelOptions::Roller::rigid_bending);
}

TEST(ReadCase, EchoTellsDefaultsFromGivenValues) {
  const CaseInput input = read_case_input({"case.yaml", kAbevi, {"friction={coulomb: 0.1}"}}, Command::check);
  const auto entry = [&](const std::string& path) {
    for (const EchoEntry& e : input.fields)
      if (e.path == path) return e.value + (e.is_default ? " (default)" : "");
    return std::string("absent");
  };
  EXPECT_EQ(entry("mechanism.lead"), "5 mm");
  EXPECT_EQ(entry("mechanism.geometry"), "simulation (default)");
  EXPECT_EQ(entry("mechanism.flank_angle"), "45 deg");
  EXPECT_EQ(entry("mechanism.profile.roller"), "{convex: 4.949747468 mm}");
  EXPECT_EQ(entry("mechanism.pitch.screw"), "absent");
  EXPECT_EQ(entry("mechanism.backlash.screw"), "absent");
  EXPECT_EQ(entry("structure.roller.guidance"), "both_end_nodes (default)");
  EXPECT_EQ(entry("load_cases[1].axial_force"), "{from: 1000 N, to: 45000 N, steps: 45}");
  EXPECT_EQ(entry("load_cases[1].share"), "solved (default)");
  EXPECT_EQ(entry("friction.model"), "{coulomb: 0.1}");
  EXPECT_EQ(entry("model.patch_points"), "21 (default)");
  EXPECT_EQ(entry("carrier.gear_pressure_angle"), "20 deg (default)");
  EXPECT_EQ(entry("carrier.bearing.length"), "absent");
  EXPECT_EQ(entry("operation.slip_ratio"), "absent");
  EXPECT_EQ(entry("roughness"), "absent");
  EXPECT_EQ(entry("lubricant.temperature"), "absent");
}

/// Checks that the echo of an input, read as an input, has the same echo.
void expect_echo_to_read_the_same(const std::vector<std::string>& others) {
  const CaseInput input = read_case_input({"case.yaml", kAbevi, others}, Command::solve);
  std::vector<std::string> overrides;
  for (const EchoEntry& e : input.fields) overrides.push_back(e.path + "=" + e.value);
  const CaseInput again = read_case_input({"echo.yaml", abevi_with("5 mm", "6 mm"), overrides}, Command::solve);
  ASSERT_EQ(again.fields.size(), input.fields.size());
  for (std::size_t i = 0; i < input.fields.size(); ++i)
    EXPECT_EQ(again.fields[i].value, input.fields[i].value) << input.fields[i].path;
  EXPECT_EQ(again.values.load_cases.size(), input.values.load_cases.size());
}

TEST(ReadCase, TheEchoIsAnInputThatReadsTheSame) {
  expect_echo_to_read_the_same(
      {"lubricant={viscosity: 0.1665 Pa s, pressure_viscosity: "
       "0.03 1/MPa, eyring_stress: 12 MPa}",
       "operation.speed=400 rpm", "friction.model=jacod"});
  expect_echo_to_read_the_same({"lubricant={" + kOil + "walther: {intercept: 9.5123, slope: 3.7}}",
                                "operation={speed: 400 rpm, slip_ratio: 0.3}", "roughness=0.2 um",
                                "carrier.bearing={length: 4 mm, diameter: 5 mm, radial_clearance: 15 um}"});
}

TEST(ReadCase, ALubricantByNameIsShownWithItsValuesAndWhereTheyComeFrom) {
  const CaseInput input = read_case_input(
      {"case.yaml", kAbevi, {"lubricant={name: iso-vg-100, temperature: 40 degC, eyring_stress: 8 MPa}"}},
      Command::check);
  const auto shown = [&](const std::string& path) -> std::string {
    for (const EchoEntry& e : input.fields)
      if (e.path == "lubricant." + path) return e.value + (e.is_default ? " (" + e.origin + ")" : "");
    return "absent";
  };
  EXPECT_EQ(shown("name"), "iso-vg-100");
  EXPECT_EQ(shown("viscosity"), "absent");
  EXPECT_EQ(shown("viscosity_at[1].kinematic_viscosity"), "11.07 mm^2/s (of iso-vg-100)");
  EXPECT_EQ(shown("density"), "891 kg/m^3 (of iso-vg-100)");
  EXPECT_EQ(shown("eyring_stress"), "8 MPa");
  EXPECT_THAT(shown("pressure_viscosity"), HasSubstr("18.78"));  // 9.904 100^0.139
  EXPECT_THAT(shown("pressure_viscosity"), HasSubstr("estimate"));
}

// Broken input ----------------------------------------------------------------------------------

/// Text of the case with a part replaced, an additional block or a lubricant, as in a row.
std::string wrong_case(const std::string& section, std::vector<std::string>& cells) {
  const std::string first = cells[0];
  cells.erase(cells.begin());
  if (section == "blocks") return abevi_with("materials:", first + "\nmaterials:");
  if (section == "lubricants")
    return abevi_with("materials:",
                      "lubricant: {pressure_viscosity: 30 1/GPa, eyring_stress: 12 MPa,\n  " + first + "}\nmaterials:");
  const std::string replacement = cells[0];
  cells.erase(cells.begin());
  return abevi_with(first, replacement);
}

TEST(ReadCase, WrongInputIsRefusedWithPlaceKeyAndFix) {
  for (const auto& section : YAML::LoadFile(PRS_SOURCE_DIR "/tests/prs/input/wrong_cases.yaml"))
    for (const auto& row : section.second) {
      SCOPED_TRACE(row.first.as<std::string>());
      auto cells = row.second.as<std::vector<std::string>>();
      const std::string message = error_of(wrong_case(section.first.as<std::string>(), cells));
      const std::size_t space = cells[0].find(' ');
      EXPECT_THAT(message, StartsWith("case.yaml:" + cells[0].substr(0, space) +
                                      ": error: " + cells[0].substr(space + 1) + ": "));
      for (std::size_t i = 1; i < cells.size(); ++i) EXPECT_THAT(message, HasSubstr(cells[i]));
    }
}

TEST(ReadCase, TheSecondCaseOfOneNameIsNamed) {
  EXPECT_THAT(error_of(kAbevi, {"load_cases[0].name=push[3]"}),
              StartsWith("case.yaml:26:12: error: load_cases[1].name: got `push[3]` a second time"));
}

TEST(ReadCase, AnEmptyListOfLoadCasesIsRefused) {
  EXPECT_THAT(error_of(kAbevi, {"load_cases=[]"}),
              testing::ContainsRegex("^case.yaml:24:1: error: load_cases: got a list of 0; expected a list of at "
                                     "least 1[^\n]*from --set load_cases=\\[\\]"));
}

TEST(ReadCase, TextsThatAreNoCaseAreRefused) {
  EXPECT_THAT(error_of(""), StartsWith("case.yaml:1:1: error: got an empty file"));
  EXPECT_THAT(error_of("# nothing\n"), StartsWith("case.yaml:1:1: error: got an empty file"));
  EXPECT_THAT(error_of("- 1\n"), StartsWith("case.yaml:1:1: error: got a list of 1; expected a map"));
  EXPECT_THAT(error_of("a: [1\nb: 2\n"), HasSubstr("error: malformed YAML"));
  for (const char* tab : {"a: 1\n\tb: 2\n", "a:\n  b: 1\n \tc: 2\n", "a:\n\t- 1\n"})
    EXPECT_THAT(error_of(tab), HasSubstr("error: got a tab before the key; expected blanks")) << tab;
  for (const char* glued : {"a:\n  b: 1\n  lead:5 mm  # it\n  c: 1\n", "a:\n  lead:5 mm\n  b: 1\n",
                            "a:\r\n  b: 1\r\n  lead:5 mm\r\n  c: 1\r\n"})
    EXPECT_THAT(error_of(glued), HasSubstr("error: got lead:5 mm; expected `key: value`; write a "
                                           "blank after the colon"))
        << glued;
  EXPECT_THAT(error_of(std::string("a: 1\nb: \0\n", 10)),
              StartsWith("case.yaml:2:4: error: got the byte 0x00; expected plain text in UTF-8"));
  EXPECT_THAT(error_of("a: \xFF\n"), StartsWith("case.yaml:1:4: error: got the byte 0xFF"));
  EXPECT_THAT(error_of(""), HasSubstr("`prs new FILE` writes a case"));
  EXPECT_THAT(error_of(kAbevi + "---\n" + kAbevi),
              StartsWith("case.yaml:27:1: error: got more text after the end of the document"));
}

TEST(ReadCase, AKeyWithoutItsPathIsToldIt) {
  const auto hint = [](const std::string& set) { return error_of(kAbevi, {set}); };
  EXPECT_THAT(hint("rollers=9"), HasSubstr("; did you mean `mechanism.rollers`? (from --set"));
  EXPECT_THAT(hint("speed=9 rpm"), HasSubstr("; did you mean `load_cases[0].speed` or `operation.speed`?"));
  EXPECT_THAT(hint("life.history.file=\"\""), HasSubstr("`file: forces.csv`"));
}

TEST(ReadCase, AKeyWithoutABlankBehindItIsNoUnknownWord) {
  EXPECT_THAT(error_of(abevi_with("contacts_per_roller: 20", "contacts_per_roller:20")),
              StartsWith("case.yaml:10:3: error: got contacts_per_roller:20; expected"));
  EXPECT_THAT(error_of(abevi_with("{screw: 3, roller: 1}", "{screw:3, roller: 1}")),
              HasSubstr("unknown key; expected one of screw, roller; write a blank after the colon: "
                        "`screw: 3`"));
}

TEST(ReadCase, LinesMayEndAsOnWindows) {
  std::string text;
  for (const char c : kAbevi) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(read(text).mechanism.lead, read(kAbevi).mechanism.lead);
  text.replace(text.find("rollers: 11"), 11, "rollers: 0");
  EXPECT_THAT(error_of(text), StartsWith("case.yaml:9:12: error: mechanism.rollers: got 0;"));
}

TEST(ReadCase, OneRunNamesManyErrorsInTheOrderOfTheFile) {
  std::string text = abevi_with("lead: 5 mm", "lead: 5");
  text.replace(text.find("rollers: 11"), 11, "rollers: 0");
  text.replace(text.find("poisson_ratio: 0.3"), 18, "poisson_ratio: x");
  const std::string message = error_of(text, {"model.bodies=beams"});
  EXPECT_THAT(message, testing::ContainsRegex("case.yaml:3:9: error: mechanism.lead: [^\n]*\n"
                                              "case.yaml:9:12: error: mechanism.rollers: [^\n]*\n"
                                              "case.yaml:23:18: error: materials.poisson[^\n]*\n"
                                              "case.yaml:1:1: error: model.bodies: [^\n]*from "
                                              "--set model.bodies=beams[^\n]*$"));
}

TEST(ReadCase, AWrongConditionIsToldAlone) {
  const std::string message = error_of(abevi_with("type: inverted", "geometry: desing"),
                                       {"mechanism.type=inverted", "mechanism.backlash={screw: 0 mm}"});
  EXPECT_THAT(message, StartsWith("case.yaml:2:13: error: mechanism.geometry: got desing"));
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(ReadCase, CommandsTellWhatTheyNeed) {
  const std::string mechanism = kAbevi.substr(0, kAbevi.find("structure:"));
  for (Command command : {Command::check, Command::contact, Command::measures})
    EXPECT_EQ(error_of(mechanism, {}, command), "");
  EXPECT_THAT(error_of(mechanism), HasSubstr("case.yaml:1:1: error: load_cases: missing"));
  EXPECT_THAT(error_of(mechanism), HasSubstr("case.yaml:1:1: error: materials: missing"));
  EXPECT_THAT(error_of(mechanism, {"load_cases=[{axial_force: 1 kN, share: equal}]"}),
              testing::Not(HasSubstr("structure")));
}

TEST(ReadCase, SlipTellsWhatIsWrongWithSpeedAndLubricant) {
  const std::vector<std::string> slip = {"friction={coulomb: 0.1}", "load_cases[1].speed=-400 rpm"};
  const auto message = [&](std::vector<std::string> more) {
    more.insert(more.begin(), slip.begin(), slip.end());
    return error_of(kAbevi, more, Command::slip);
  };
  EXPECT_EQ(message({"operation.speed=400 rpm"}), "");
  EXPECT_EQ(message({"operation.speed=1e-5 rpm"}), "");
  EXPECT_THAT(message({"operation.speed=-1e-8 rpm"}),
              HasSubstr("operation.speed: got -1e-08 rpm in case `pull`; expected 0 for a screw that stands still"));
  EXPECT_EQ(message({"operation.speed=0 rpm"}), "");  // held by static friction, which films do not have
  EXPECT_THAT(message({"operation.speed=0 rpm", "friction={model: jacod}",
                       "lubricant={name: iso-vg-100, "
                       "temperature: 60 degC}"}),
              StartsWith("case.yaml:1:1: error: operation.speed: got 0 rpm in case `pull`; expected "
                         "a speed other than 0 with `friction: {model: jacod}`"));
  EXPECT_EQ(message({"operation.speed=-400 rpm"}), "");  // the load drives
  EXPECT_THAT(message({"operation.speed=400 rpm",
                       "carrier.bearing={length: 4 mm, diameter: 5 mm, "
                       "radial_clearance: 15 um}"}),
              StartsWith("case.yaml:1:1: error: lubricant: missing; expected the lubricant of "
                         "`carrier.bearing`"));
}

TEST(ReadCase, DeviationsAreRead) {
  const Deviations d =
      read(kAbevi, {"deviations={pitch_error: {screw: {linear: 2 um}, nut: {periodic: {amplitude: 1 um, "
                    "period: 8, phase: 90 deg}}}, crowning: 3 um, end_relief: {drop: 4 um, threads: "
                    "2}, roller_diameter: -1 um, temperature: 50 degC}",
                    "materials.thermal_expansion=11.5 um/m/K"})
          .deviations;
  EXPECT_DOUBLE_EQ(d.pitch_error.screw.linear, 2e-6);
  EXPECT_FALSE(d.pitch_error.screw.periodic);
  EXPECT_DOUBLE_EQ(d.pitch_error.nut.periodic->phase, std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(d.crowning, 3e-6);
  EXPECT_EQ(d.end_relief->threads, 2);
  EXPECT_DOUBLE_EQ(d.roller_diameter, -1e-6);
  EXPECT_DOUBLE_EQ(d.temperature->nut, 323.15);
  EXPECT_DOUBLE_EQ(d.reference_temperature, 293.15);
}

TEST(ReadCase, DeviationsOutOfProportionAreRefused) {
  const auto message = [](const std::string& deviations) {
    return error_of(kAbevi, {"deviations=" + deviations}, Command::solve);
  };
  EXPECT_THAT(message("{crowning: 3 mm}"), HasSubstr("deviations.crowning: got 3 mm; expected at most"));
  EXPECT_THAT(message("{pitch_error: {nut: {linear: 2 mm}}}"), HasSubstr("deviations.pitch_error.nut: got up to 2 mm"));
  EXPECT_THAT(message("{pitch_error: {nut: {list: [1 um, 2 um]}}}"),
              HasSubstr("deviations.pitch_error.nut.list: got 2 values; expected 20"));
  EXPECT_THAT(message("{end_relief: {drop: 1 um, threads: 11}}"),
              HasSubstr("deviations.end_relief.threads: got 11; expected at most 10"));
  EXPECT_THAT(message("{temperature: {screw: 50 degC, roller: 20 degC, nut: 20 degC}}"),
              HasSubstr("the screw lacks `thermal_expansion`"));
}

TEST(ReadCase, ABareNumberHasTheUnitOfItsKey) {
  EXPECT_THAT(error_of(kAbevi, {"roughness=0.4"}, Command::check), HasSubstr("for example `0.4 um` (units"));
  EXPECT_THAT(error_of(kAbevi, {"measures={yield_strength: 700}"}, Command::check),
              HasSubstr("for example `700 MPa` (units"));
}

TEST(ReadCase, ALawOfFrictionIsExpectedAsItIsWritten) {
  EXPECT_THAT(error_of(kAbevi, {"friction=jacod"}, Command::check),
              HasSubstr("got jacod; expected {model: jacod} | {coulomb: ..} | {mixed: ..}"));
  EXPECT_THAT(error_of(kAbevi, {"friction={culomb: 0.1}"}, Command::check), HasSubstr("did you mean `coulomb`?"));
}

TEST(ReadCase, ExamplesLieWithinTheirBounds) {
  EXPECT_THAT(error_of(kAbevi, {"roughness=5 mm"}, Command::check), HasSubstr("write for example `roughness: 0.4 um`"));
  EXPECT_THAT(error_of(kAbevi, {"carrier={gear_pressure_angle: 60 deg}"}, Command::check),
              HasSubstr("write for example `gear_pressure_angle: 22.5 deg`"));
}

TEST(ReadCase, MutilatedTextsAreReadOrRefusedButNothingElse) {
  std::mt19937 random(20'25);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const std::string parts[] = {"{",  "}",     "[",    "]",     ":",        ", ",   "- ",
                               "\n", "  ",    "&a ",  "*a",    "!",        "<<",   "\"",
                               "'",  "#",     "|",    "---\n", "~",        ".nan", "1e999",
                               "-",  "0",     "mm",   "\t",    "\xC2\xB5", "\xFF", std::string(1, '\0'),
                               "? ", "screw", "equal"};
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string text = kAbevi;
    for (std::size_t k = 0; k <= below(4); ++k) {
      const std::size_t at = below(text.size());
      const std::string& part = parts[below(std::size(parts))];
      switch (below(4)) {
        case 0:
          text.insert(at, part);
          break;
        case 1:
          text.erase(at, 1 + below(8));
          break;
        case 2:
          text.replace(at, part.size(), part);
          break;
        default:
          text.insert(at, text.substr(below(text.size()), below(40)));
      }
    }
    try {
      read(text);
    } catch (const InputError& e) {
      ++refused;
      EXPECT_THAT("\n" + std::string(e.what()), testing::Not(testing::ContainsRegex("\n([^c]|c[^a]|ca[^s]|cas[^e])")));
    }
  }
  EXPECT_GT(refused, 1000);
}

const std::string kPreload = kAbevi + R"(preload:
  arrangement: double_nut
  force: 3 kN
  position: 29 mm
  spacer: {length: 10 mm, inner_diameter: 37 mm, outer_diameter: 46 mm}
  distance: 68 mm
  load: {from: -9 kN, to: 9 kN}
)";

TEST(ReadCase, ReadsAPreload) {
  const Case c = read(kPreload, {}, Command::preload);
  ASSERT_TRUE(c.preload);
  EXPECT_EQ(c.preload->arrangement, Preload::Arrangement::double_nut);
  EXPECT_EQ(c.preload->force, 3e3);
  EXPECT_FALSE(c.preload->interference || c.preload->backlash || c.preload->lost_motion_load);
  EXPECT_EQ(c.preload->position, 0.029);
  EXPECT_EQ(c.preload->spacer->inner_diameter, 0.037);
  EXPECT_EQ(c.preload->distance, 0.068);
  EXPECT_EQ(c.preload->load.from, -9e3);
  EXPECT_EQ(c.preload->load.steps, 41);
  EXPECT_FALSE(read(kAbevi).preload);
}

TEST(ReadCase, WhatAPreloadCannotBeIsAnErrorAtItsPlace) {
  struct Wrong {
    const char* override;
    const char* place;  ///< In kPreload, line 27 its first.
    const char* message;
  };
  for (const auto& [override, place, message] :
       {Wrong{"preload.force=3", "29:3", "expected a force > 0 with its unit"},
        Wrong{"preload.force=0 N", "29:3", "expected a force > 0"},
        Wrong{"preload.interference=3 um", "27:1", "it stands in place of `force`"},
        Wrong{"preload.backlash=3 um", "27:1", "in place of `force` or `interference`"},
        Wrong{"preload.arrangement=tripple_nut", "28:3", "expected single_nut | double_nut"},
        Wrong{"preload.arrangement=single_nut", "31:3", "only with `arrangement: double_nut`"},
        Wrong{"preload.interferance=3 um", "27:1", "did you mean `interference`"},
        Wrong{"preload.load={from: 9 kN, to: -9 kN}", "33:3", "more than `from`"},
        Wrong{"preload.load.steps=1", "33:3", "a whole number from 2 to"},
        Wrong{"preload.position=60 mm", "30:3", "all 20 contacts lie on the nut"},
        Wrong{"preload.distance=30 mm", "32:3", "lie on the second nut"},
        Wrong{"preload.spacer.outer_diameter=35 mm", "31:43", "less than its outer diameter"},
        Wrong{"preload.lost_motion_load=-1 N", "27:1", "expected a force > 0"},
        Wrong{"model.bodies=influence", "1:1", "expected bars | refined"}}) {
    const std::string error = error_of(kPreload, {override}, Command::preload);
    EXPECT_THAT(error, StartsWith(std::string("case.yaml:") + place + ": error: ")) << override;
    EXPECT_THAT(error, HasSubstr(message)) << override;
  }
  EXPECT_EQ(error_of(kPreload, {"model.bodies=influence"}), "");
}

}  // namespace
}  // namespace prs::input
