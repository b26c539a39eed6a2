#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "prs/run/commands.h"
#include "prs/size/size.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

/// Name in `check` of a criterion of `size`, if different.
std::string name_in_check(const std::string& name) {
  if (name == "buckling") return "buckling_safety";
  return name == "critical_speed" ? "critical_speed_share" : name;
}

std::map<std::string, Json> criteria_of(const input::Source& source) {
  const Json document = run(analysis_of(Command::check), source).document(document_info(source, Command::check));
  std::map<std::string, Json> criteria;
  for (const Json& c : document["verdict"]["criteria"]) criteria[c["name"]] = c;
  return criteria;
}

/// State in `check` of a status in the list.
std::string state_of(CriterionStatus status) {
  if (status == CriterionStatus::pass) return "green";
  return status == CriterionStatus::fail ? "red" : std::string(name(status));
}

/// Checks that a candidate, written as a case, has in `check` the numbers, units, limits and states of the list, except
/// the interval of relubrication, which is not a number of the screw.
void expect_one_set_of_numbers(const input::Source& source) {
  const SizeResult result = size_screws(read_requirement(source));
  ASSERT_FALSE(result.candidates.empty());
  for (const SizedCandidate& candidate : result.candidates) {
    const auto found =
        criteria_of(input::source_of_text("written.yaml", written_candidate(result.input, candidate), {}));
    for (const SizeCriterion& c : candidate.criteria) {
      const auto own = found.find(name_in_check(std::string(c.name)));
      if (c.name == "relubrication") continue;
      ASSERT_NE(own, found.end()) << candidate.name << ": " << c.name;
      EXPECT_EQ(own->second["state"], state_of(c.status)) << candidate.name << ": " << c.name;
      EXPECT_EQ(own->second["unit"], c.unit) << c.name;
      for (const auto& [key, expected] : {std::pair("value", c.value), std::pair("limit", c.limit)}) {
        ASSERT_EQ(own->second.contains(key), expected.has_value()) << candidate.name << ": " << c.name;
        if (!expected) continue;
        EXPECT_NEAR(own->second[key].get<double>() / *expected, 1.0, 1e-9) << candidate.name << ": " << c.name;
      }
    }
  }
}

void expect_one_set_of_numbers(const std::string& text) {
  expect_one_set_of_numbers(input::source_of_text("need.yaml", text, {}));
}

const std::string kLimits =
    "limits: {stiffness: 100 N/um, efficiency: 70 %, weight: 9 kg, nut_length: 100 mm, nut_diameter: 90 mm}\n";
const std::string kPress =
    "motion:\n  segments:\n"
    "    - {name: down, duration: 0.5 s, end_speed: 200 mm/s}\n"
    "    - {name: press, duration: 1.4 s, end_speed: 30 mm/s, force: 30 kN}\n"
    "    - {name: stop, duration: 0.1 s, end_speed: 0 mm/s, force: 30 kN}\n"
    "    - {name: up, duration: 0.5 s, end_speed: -250 mm/s}\n"
    "    - {name: end, duration: 0.5 s, end_speed: 0 mm/s}\n"
    "    - {name: rest, duration: 1.5 s, end_speed: 0 mm/s}\n"
    "load: {moved_mass: 80 kg, inclination: -90 deg, resistance: 100 N, positive_force: compression}\n";

TEST(WrittenCandidate, HasOneSetOfNumbersInHours) {
  expect_one_set_of_numbers(kPress + kLimits + "life: {hours: 20000 h, reliability: 95 %}\n");
}

TEST(WrittenCandidate, HasOneSetOfNumbersInKilometresByThreads) {
  expect_one_set_of_numbers(kPress + kLimits + "life: {distance: 900 km, basis: threads}\n");
}

const std::string kMotor =
    "motor: {rated_torque: 30 N m, peak_torque: 70 N m, largest_speed: 2500 rpm, inertia: 10 kg cm^2, gear_ratio: 1.5, "
    "gear_efficiency: 95 %, torque_constant: 0.5 N m/A, resistance: 100 mOhm, supply: {voltage: 120 V, current: 100 "
    "A}, "
    "continuous_current: 40 A}\nbrake: {torque: 2 N m, safety: 2}\n";

TEST(WrittenCandidate, HasMotorBrakeAndTemperaturesOfACatalogue) {
  expect_one_set_of_numbers(kPress + kMotor +
                            "limits: {back_driving: forbidden, temperature: 80 degC, relubrication: 100 h}\n"
                            "heat: {ambient: 30 degC, conductance: {screw_ambient: 3 W/K, nut_ambient: 8 W/K}}\n");
}

TEST(WrittenCandidate, HasMotorAndTemperaturesOfDesigns) {
  expect_one_set_of_numbers(kPress + kMotor +
                            "limits: {back_driving: required, temperature: 60 degC}\nlife: {hours: 5000 h}\n"
                            "heat: {ambient: 30 degC, conductance: {screw_ambient: 3 W/K, nut_ambient: 8 W/K}}\n"
                            "candidates: {designs: {screw_diameter: [30 mm, 40 mm], lead: [5 mm, 10 mm]}}\n");
}

TEST(WrittenCandidate, HasTheMissionAndTheBearing) {
  expect_one_set_of_numbers(
      kPress + kMotor +
      "limits: {temperature: 80 degC, efficiency: 60 %, stiffness: 80 N/um}\nlife: {hours: 500 h, basis: threads}\n"
      "bearings: {fixed: {dynamic_capacity: 60 kN, static_capacity: 110 kN, preload: 6 kN, stiffness: 900 N/um}}\n"
      "heat: {ambient: 30 degC, conductance: {screw_ambient: 3 W/K, nut_ambient: 8 W/K}, cycles: 20, start: 10 degC}\n"
      "candidates: {designs: {screw_diameter: 40 mm, lead: 10 mm, starts: 5}}\n");
}

TEST(WrittenCandidate, HasTheStiffnessUnderPreload) {
  expect_one_set_of_numbers(kPress + "limits: {stiffness: 80 N/um}\nlife: {hours: 50 h}\npreload: {share: 5 %}\n" +
                            "model: {loads: static}\n"
                            "candidates: {designs: {screw_diameter: 40 mm, lead: 10 mm, starts: 5}}\n");
}

TEST(WrittenCandidate, HasARecirculatingScrew) {
  expect_one_set_of_numbers(
      kPress + kMotor + "limits: {temperature: 80 degC, efficiency: 60 %, stiffness: 80 N/um}\nlife: {hours: 500 h}\n" +
      "heat: {ambient: 30 degC, conductance: {screw_ambient: 3 W/K, nut_ambient: 8 W/K}}\n"
      "candidates: {designs: {type: recirculating, screw_diameter: 30 mm, lead: 4 mm}}\n");
}

TEST(WrittenCandidate, HasALever) {
  expect_one_set_of_numbers(
      "linkage: {base: 500 mm, arm: 300 mm}\n"
      "motion:\n  start_angle: 60 deg\n  segments:\n"
      "    - {duration: 0.5 s, end_speed: 20 deg/s, torque: 900 N m}\n"
      "    - {duration: 0.5 s, end_speed: 0 deg/s, torque: 900 N m}\n"
      "    - {duration: 0.5 s, end_speed: -20 deg/s, torque: 900 N m}\n"
      "    - {duration: 0.5 s, end_speed: 0 deg/s, torque: 900 N m}\n"
      "load: {inertia: 20 kg m^2}\nmodel: {loads: static}\n" +
      kMotor + "candidates: {designs: {screw_diameter: 30 mm, lead: 10 mm, starts: 5}}\n");
}

TEST(WrittenCandidate, HasNoTemperatureWithoutHeat) {
  expect_one_set_of_numbers(kPress +
                            "limits: {temperature: 60 degC}\n"
                            "candidates: {designs: {screw_diameter: 30 mm, lead: 10 mm}}\n");
}

TEST(WrittenCandidate, HasTheCapacitiesThatCatalogueFormulasTook) {
  expect_one_set_of_numbers(kPress +
                            "life: {hours: 5000 h, basis: maker}\n"
                            "candidates: {designs: {screw_diameter: 30 mm, lead: 10 mm}}\n");
}

/// A history, of more samples than have load cases of their own.
void expect_one_set_of_a_history(const std::string& more_of_heat) {
  std::string csv = "time,speed,force\n";
  for (int k = 0; k <= 120; ++k)
    csv += fmt::format("{},{},{}\n", 0.02 * k, 100.0 * std::sin(0.05236 * k), 6.0 + 3.0 * std::cos(0.1 * k));
  input::Source source = input::source_of_text(
      "need.yaml",
      "motion: {history: {file: cycle.csv, time: {unit: s}, speed: {unit: mm/s}, force: {unit: kN}}}\n"
      "candidates: {designs: {screw_diameter: 30 mm, lead: 10 mm, starts: 5}}\nlimits: {temperature: 80 degC}\n"
      "heat: {ambient: 30 degC, conductance: {screw_ambient: 3 W/K, nut_ambient: 8 W/K}" +
          more_of_heat + "}\n" + kMotor,
      {});
  source.files.emplace()["cycle.csv"] = csv;
  expect_one_set_of_numbers(source);
}

TEST(WrittenCandidate, HasTheMotorOfAHistory) { expect_one_set_of_a_history(""); }

TEST(WrittenCandidate, HasTheMissionOfAHistory) { expect_one_set_of_a_history(", cycles: 20, start: 10 degC"); }

/// Values that the requirement states have no mark, those left to defaults have one, and defaults of the case have no
/// line.
TEST(WrittenCandidate, MarksWhatTheRequirementLeavesToDefaults) {
  const SizeResult result = size_screws(read_requirement(input::source_of_text(
      "need.yaml", kPress + "stroke: 250 mm\nlife: {reliability: 95 %}\nlimits: {static_safety: 2}\n", {})));
  const std::string text = written_candidate(result.input, result.candidates.front());
  const auto has = [&](const char* part) { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(has("friction: {model: {coulomb: 0.1}}  # assumed {model: {coulomb: 0.1}}: default of `prs size`\n"));
  EXPECT_TRUE(has("  reliability: 95 %\n"));
  EXPECT_TRUE(has("  static_safety: 2\n"));
  EXPECT_TRUE(has("  buckling_safety: 2  # assumed 2: default of `prs size`\n"));
  EXPECT_TRUE(has(", ends: fixed_supported}: default of `prs size`\n"));  // The stroke is stated in the requirement.
  EXPECT_FALSE(has("modification_factor"));
}

/// The duty names load cases, of which only the largest are solved for the warnings of the case.
TEST(WrittenCandidate, HeatHidesNoAssumption) {
  const SizeResult result = size_screws(read_requirement(input::source_of_text(
      "need.yaml", kPress + "heat: {ambient: 30 degC, conductance: {screw_ambient: 3 W/K, nut_ambient: 8 W/K}}\n",
      {})));
  const input::Source source =
      input::source_of_text("written.yaml", written_candidate(result.input, result.candidates.front()), {});
  const Json document = run(analysis_of(Command::check), source).document(document_info(source, Command::check));
  EXPECT_NE(document["assumptions"].dump().find("parts are perfect"), std::string::npos);
}

TEST(WrittenCandidate, OfAShaftShorterThanStrokeAndNutIsRefused) {
  const SizeResult result = size_screws(read_requirement(input::source_of_text("need.yaml", kPress, {})));
  const std::string text = written_candidate(result.input, result.candidates.front());
  EXPECT_THROW(criteria_of(input::source_of_text("written.yaml", text, {"measures.shaft.length=150 mm"})),
               input::InputError);
}

TEST(WrittenCandidate, HasWaysWithoutForceUnderPreload) {
  expect_one_set_of_numbers(
      "motion: {segments: [{name: a, duration: 1 s, end_speed: 50 mm/s, force: 8 kN}, {name: b, duration: 1 s, "
      "end_speed: 50 mm/s, force: 0 N}, {name: c, duration: 1 s, end_speed: 0 mm/s, force: 8 kN}]}\n"
      "preload: {force: 2 kN}\nlife: {hours: 9000 h}\ncandidates: {designs: {screw_diameter: 32 mm, lead: 10 mm, "
      "starts: 5}}\n");
}

/// The larger of two forces may compress the screw, if the requirement does not state their sense.
TEST(WrittenCandidate, HasTheBucklingOfForcesOfUnknownSense) {
  expect_one_set_of_numbers(
      "motion: {segments: [{name: a, duration: 0.5 s, end_speed: 100 mm/s, force: 2.5 kN}, {name: b, duration: 0.5 s, "
      "end_speed: 100 mm/s, force: 0 N}, {name: c, duration: 1 s, end_speed: 0 mm/s, force: -3 kN}]}\n"
      "limits: {buckling_safety: 2}\ncandidates: {designs: {screw_diameter: 32 mm, lead: 10 mm, starts: 5}}\n");
}

/// A preload that grows with the temperatures leaves no steady state, and nothing that depends on it is delivered.
TEST(WrittenCandidate, WithoutASteadyStateHasNoTemperatures) {
  const SizeResult result = size_screws(read_requirement(
      input::source_of_text("need.yaml",
                            "motion: {loads: [{force: 8 kN, speed: 100 mm/s, share: 100 %}]}\n"
                            "heat: {conductance: {nut_ambient: 10 W/K, screw_ambient: 3 W/K}}\npreload: {force: 2 kN}\n"
                            "limits: {temperature: 80 degC, efficiency: 50 %}\nmodel: {loads: static}\n"
                            "candidates: {designs: {screw_diameter: 30 mm, lead: 10 mm, starts: 5}}\n",
                            {})));
  const SizedCandidate& candidate = result.candidates.front();
  EXPECT_FALSE(candidate.passes);
  EXPECT_FALSE(candidate.temperature || candidate.parts_at || candidate.power_lost || candidate.efficiency ||
               candidate.life.revolutions || candidate.static_safety || candidate.self_locking);
  EXPECT_EQ(candidate.preload_force, 2000.0);
  for (const SizeCriterion& c : candidate.criteria)
    if (c.name == "temperature" || c.name == "efficiency") {
      EXPECT_EQ(c.status, CriterionStatus::not_computed) << c.name;
      EXPECT_TRUE(c.reason.starts_with("no_steady_state: the parts heat up beyond 726.85 degC")) << c.reason;
    }
  const auto found = criteria_of(input::source_of_text("written.yaml", written_candidate(result.input, candidate), {}));
  for (const char* name : {"temperature", "efficiency", "life", "static_safety", "convergence"})
    EXPECT_NE(found.at(name)["state"], "green") << name;
}

/// Efficiencies of classes of segments count alike in both.
TEST(WrittenCandidate, HasTheEfficiencyOfClasses) {
  std::string csv = "time,speed,force\n";
  for (int k = 0; k <= 200; ++k)
    csv += fmt::format("{},{},{}\n", 0.01 * k, 100.0 * std::sin(std::numbers::pi * k / 100.0),
                       3.0 + std::cos(std::numbers::pi * k / 50.0));
  input::Source source = input::source_of_text(
      "need.yaml",
      "motion: {history: {file: cycle.csv, time: {unit: s}, speed: {unit: mm/s}, force: {unit: kN}}}\n"
      "limits: {efficiency: 50 %}\nmodel: {loads: static}\n"
      "candidates: {designs: {screw_diameter: 30 mm, lead: 10 mm, starts: 5}}\n",
      {});
  source.files.emplace()["cycle.csv"] = csv;
  expect_one_set_of_numbers(source);
}

}  // namespace
}  // namespace prs
