#include "prs/input/study_reader.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "prs/study/designs.h"
#include "tests/prs/input/abevi.h"

namespace prs::input {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr int kLine = 30;  // Line of the first factor.

Source source_of(const std::string& study) { return {"case.yaml", kAbevi + study, {}}; }

/// A study with one factor, on the line after `factors:`.
Source with_factor(const std::string& factor) {
  return source_of("study:\n  command: solve\n  factors:\n    - {" + factor + "}\n");
}

Factor read(const std::string& factor) { return read_study_input(with_factor(factor)).study.factors.at(0); }

/// A study of 100 samples; its first factor is on the same line.
Source with_samples(const std::string& factor, const std::string& plan = "latin_hypercube") {
  return source_of("study:\n  {command: solve, plan: " + plan + ", samples: 100,\n  factors: [\n      {" + factor +
                   "}]}\n");
}

Study drawn(const std::string& factor) { return read_study_input(with_samples(factor)).study; }

std::string error_of(const Source& source) {
  try {
    read_study_input(source);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}
std::string error_of(const std::string& factor) { return error_of(with_factor(factor)); }
std::string error_of_drawn(const std::string& factor) { return error_of(with_samples(factor)); }

std::vector<std::string> texts(const Factor& factor) {
  std::vector<std::string> all;
  for (const Level& level : factor.levels) all.push_back(level.text);
  return all;
}

std::vector<double> numbers(const Factor& factor) {
  std::vector<double> all;
  for (const Level& level : factor.levels) all.push_back(level.number.value_or(NAN));
  return all;
}

TEST(StudyReader, ListKeepsTextsAndHasNumbersInTheUnitOfTheFirst) {
  const Factor f = read("path: mechanism.lead, values: [5 mm, 6000 um], label: the lead");
  EXPECT_EQ(f.label, "the lead");
  EXPECT_EQ(f.unit, "mm");
  EXPECT_THAT(texts(f), ElementsAre("5 mm", "6000 um"));
  EXPECT_THAT(numbers(f), ElementsAre(5.0, 6.0));
  EXPECT_EQ(f.base->text, "5 mm");
}

TEST(StudyReader, RangeHasItsEndsAsWritten) {
  const Factor f = read("path: mechanism.lead, values: {from: 5.0 mm, to: 6 mm, steps: 3}");
  EXPECT_THAT(texts(f), ElementsAre("5.0 mm", "5.5 mm", "6 mm"));
  EXPECT_FALSE(f.logarithmic);
  EXPECT_EQ(f.label, "mechanism.lead");
}

TEST(StudyReader, LogarithmicRangeIsGeometric) {
  const Factor f = read("path: mechanism.lead, values: {from: 1 mm, to: 100 mm, steps: 3, spacing: logarithmic}");
  EXPECT_THAT(texts(f), ElementsAre("1 mm", "10 mm", "100 mm"));
  EXPECT_TRUE(f.logarithmic);
}

TEST(StudyReader, ProfilesHaveTheirCurvatureForNumber) {
  const Factor f = read("path: mechanism.profile.nut, values: [{concave: 50 mm}, straight, {convex: 2 cm}]");
  EXPECT_EQ(f.unit, "1/mm");
  EXPECT_THAT(texts(f), ElementsAre("{concave: 50 mm}", "straight", "{convex: 2 cm}"));
  EXPECT_THAT(numbers(f), ElementsAre(-0.02, 0.0, 0.05));
  EXPECT_EQ(f.base->number, 0.0);
}

TEST(StudyReader, FactorCarriesItsCompanions) {
  const Factor f = read(
      "path: mechanism.pitch_diameter.screw, values: {from: 20 mm, to: 22 mm, steps: 3}, with: "
      "[{path: mechanism.pitch_diameter.roller, values: {from: 7 mm, to: 8 mm, steps: 3}}, {path: "
      "mechanism.rollers, values: [11, 10, 9], label: rollers}]");
  ASSERT_EQ(f.companions.size(), 2U);
  EXPECT_THAT(texts(f.companions[0]), ElementsAre("7 mm", "7.5 mm", "8 mm"));
  EXPECT_EQ(f.companions[0].base->text, "7 mm");
  EXPECT_EQ(f.companions[1].label, "rollers");
  EXPECT_TRUE(f.continuous && f.companions[0].continuous);
  EXPECT_FALSE(f.companions[1].continuous);
}

TEST(StudyReader, LoadCasesGoByTheirNames) {
  const Factor by_name = read("path: \"load_cases[push].position\", values: [5 mm, 6 mm]");
  const Factor by_index = read("path: \"load_cases[1].position\", values: [5 mm, 6 mm]");
  EXPECT_EQ(by_name.path, by_index.path);
  EXPECT_EQ(by_name.label, "load_cases[push].position");
  EXPECT_EQ(by_name.base->text, by_index.base->text);
  EXPECT_THAT(error_of("path: \"load_cases[pish].position\", values: [5 mm]"), HasSubstr("did you mean `push`?"));
  // Responses count the points of a range, which the first load case is here.
  Source source = source_of(
      "study: {command: solve, factors: [{path: mechanism.rollers, values: [9]}], responses: "
      "[\"load_cases[push].axial_displacement_um\"]}\n");
  source.overrides = {"load_cases[pull].axial_force={from: 1 kN, to: 3 kN, steps: 3}"};
  EXPECT_EQ(read_study_input(source).study.responses.at(0), "load_cases[3].axial_displacement_um");
}

/// A name becomes an index, which is the same in every design.
TEST(StudyReader, LoadCasesOfResponsesKeepTheirPlace) {
  const auto study = [](const std::string& path, const std::string& values, const std::string& response) {
    Source source = source_of("study: {command: solve, factors: [{path: \"" + path + "\", values: [" + values +
                              "]}], responses: [\"" + response + "\"]}\n");
    source.overrides = {"load_cases[pull].axial_force={from: 1 kN, to: 3 kN, steps: 3}"};
    return error_of(source);
  };
  const std::string first = "load_cases[pull].axial_displacement_um", second = "load_cases[push].axial_displacement_um";
  EXPECT_THAT(
      study("load_cases[pull].axial_force.steps", "2, 3", second),
      HasSubstr("study.factors[0].path: got load_cases[0].axial_force.steps, which changes the number of load cases "
                "before that of load_cases[3].axial_displacement_um"));
  EXPECT_THAT(study("load_cases[pull].axial_force", "2 kN", second), HasSubstr("changes the number of load cases"));
  EXPECT_EQ(study("load_cases[pull].axial_force.steps", "2, 3", first), "");
  EXPECT_EQ(study("load_cases[push].axial_force.steps", "2, 3", second), "");
  EXPECT_EQ(study("load_cases[pull].axial_force.to", "2 kN, 4 kN", second), "");
}

TEST(StudyReader, SaysWhereARangeBelongs) {
  EXPECT_THAT(error_of("path: mechanism.lead, from: 4 mm, to: 6 mm, steps: 3"),
              HasSubstr("study.factors[0].from: unknown key; expected one of path, values, uniform, "
                        "log_uniform, normal, within, label, together, kept, with; write `values: {from: .., to: "
                        ".., steps: ..}`"));
}

TEST(StudyReader, RefusesCompanionsThatCannotGoAlong) {
  const std::string lead = "path: mechanism.lead, values: [5 mm, 6 mm], with: ";
  EXPECT_THAT(error_of(lead + "[{path: mechanism.rollers, values: [9]}]"),
              HasSubstr("study.factors[0].with[0].values: got 1 values; expected 2, one for each "
                        "of mechanism.lead"));
  EXPECT_THAT(error_of(lead + "[{path: mechanism.rollers, values: [9, 0]}]"),
              HasSubstr("mechanism.rollers: got 0; expected a whole number"));
  EXPECT_THAT(error_of(lead + "[{path: mechanism.rolers, values: [9, 10]}]"), HasSubstr("did you mean `rollers`?"));
  EXPECT_THAT(error_of(lead + "[{path: mechanism.lead, values: [5 mm, 6 mm]}]"),
              HasSubstr("with[0].path: got mechanism.lead a second time"));
  EXPECT_THAT(error_of(lead + "[{path: study.plan, values: [grid, sobol]}]"),
              HasSubstr("with[0].path: got study.plan; expected a value outside `study`"));
  EXPECT_THAT(error_of(lead + "[{path: mechanism.rollers, uniform: {from: 1, to: 2}}]"),
              HasSubstr("study.factors[0].with[0].uniform: unknown key"));
  EXPECT_THAT(error_of(lead + "[{path: mechanism.centre_distance, values: {from: 1 mm, to: 2 kN, "
                              "steps: 2}}]"),
              HasSubstr("with[0].values.to: got 2 kN; expected the unit of `from`"));
  EXPECT_THAT(error_of_drawn("path: mechanism.lead, within: 1 %, with: [{path: mechanism.rollers, "
                             "values: [9, 10]}]"),
              HasSubstr("study.factors[0].with: got"));
}

/// A grid over two lengths, or `second` in place of the other one, with an envelope.
Source with_envelope(
    const std::string& envelope,
    const std::string& second = "{path: structure.screw.bore, values: {from: 2 mm, to: 8 mm, steps: 4}}") {
  return source_of(
      "study:\n  command: solve\n  plan: grid\n  factors:\n    - {path: "
      "structure.nut.outer_diameter, values: {from: 44 mm, to: 48 mm, steps: 5}}\n    - " +
      second + "\n  envelope: {" + envelope + "}\n");
}

const std::string kMeasures =
    "measures: [{response: axial_stiffness_N_per_um, weight: 2}, {response: "
    "nut.peak_pressure_MPa.max, weight: -1}]";

TEST(StudyReader, EnvelopeRecordsWhatItNeeds) {
  const Study study =
      read_study_input(with_envelope(kMeasures +
                                     ", combine: sum, normalise: max, points: [{name: A, at: [4.5 cm, 2 mm]}, "
                                     "{name: B, wanted: best}, {name: C, reach: [{response: "
                                     "axial_displacement_um, value: 50}, {response: axial_stiffness_N_per_um, "
                                     "value: 900}]}]"))
          .study;
  EXPECT_THAT(study.responses,
              ElementsAre("axial_stiffness_N_per_um", "nut.peak_pressure_MPa.max", "axial_displacement_um"));
  ASSERT_TRUE(study.envelope);
  EXPECT_EQ(study.envelope->combine, Envelope::Combine::sum);
  EXPECT_EQ(study.envelope->normalise, Envelope::Normalise::max);
  EXPECT_EQ(study.envelope->measures.at(1).weight, -1.0);
  ASSERT_EQ(study.envelope->points.size(), 3U);
  EXPECT_NEAR(study.envelope->points[0].at->at(0), 45.0, 1e-12);
  EXPECT_EQ(study.envelope->points[0].at->at(1), 2.0);
  EXPECT_FALSE(study.envelope->points[1].at);
  EXPECT_EQ(study.envelope->points[2].reach.at(1).value, 900.0);
}

TEST(StudyReader, RefusesEnvelopesThatTheGridDoesNotHave) {
  const auto refused = [](const std::string& envelope, const std::string& message) {
    EXPECT_THAT(error_of(with_envelope(envelope)), HasSubstr(message)) << envelope;
  };
  const auto point = [](const std::string& p) { return kMeasures + ", points: [{" + p + "}]"; };
  refused("combine: product", "study.envelope.measures: missing");
  refused("measures: [{response: a}, {response: a}]", "study.envelope.measures[1].response: got a a second time");
  refused("measures: [{response: a, weight: 0}]", "study.envelope.measures[0].weight: got 0");
  refused(kMeasures + ", combine: quotient", "study.envelope.combine: got quotient");
  refused(point("name: A"), "study.envelope.points[0]: got none of at, wanted, reach");
  refused(point("name: A, wanted: best, at: [44 mm, 2 mm]"), "got several of at, wanted, reach");
  refused(point("name: A, at: [44 mm]"), "study.envelope.points[0].at: got");
  refused(point("name: A, at: [44 mm, 9 mm]"),
          "study.envelope.points[0].at[1]: got 9 mm; expected a value of structure.screw.bore from "
          "2 mm to 8 mm");
  refused(point("name: A, at: [44, 2 mm]"), "study.envelope.points[0].at[0]: got 44; expected");
  refused(point("name: A, wanted: best}, {name: A, wanted: best"),
          "study.envelope.points[1].name: got A a second time");
  refused(point("name: A, reach: [{response: a, value: 1}, {response: a, value: 2}]"),
          "study.envelope.points[0].reach[1].response: got a a second time");
  const std::string whole =
      error_of(with_envelope(point("name: A, reach: [{response: a, value: 1}, {response: b, value: "
                                   "2}]}, {name: B, at: [44 mm, 10.4]"),
                             "{path: mechanism.rollers, values: [9, 10, 11]}"));
  EXPECT_THAT(whole, HasSubstr("study.envelope.points[0].reach: got two responses; expected one, "
                               "since mechanism.rollers"));
  EXPECT_THAT(whole, HasSubstr("study.envelope.points[1].at[1]: got 10.4; expected a value of "
                               "mechanism.rollers from 9 to 11 that stands in the list"));
  EXPECT_THAT(whole, HasSubstr("write for example `10`"));
  EXPECT_THAT(error_of(with_envelope(kMeasures, "{path: model.roller, values: [flexible]}")),
              HasSubstr("study.factors[1].values: expected at least two different numbers"));
  EXPECT_THAT(error_of(source_of("study: {command: solve, plan: grid, factors: [{path: "
                                 "mechanism.rollers, values: [9, 10]}], envelope: {" +
                                 kMeasures + "}}\n")),
              HasSubstr("study.factors: got 1 factor; expected two with `envelope`"));
  EXPECT_THAT(error_of(source_of("study: {command: solve, factors: [{path: mechanism.rollers, "
                                 "values: [9, 10]}], envelope: {" +
                                 kMeasures + "}}\n")),
              HasSubstr("study.envelope: got"));
}

TEST(StudyReader, WordsHaveNoNumber) {
  const Factor f = read("path: model.roller, values: [flexible, rigid_bending]");
  EXPECT_FALSE(f.is_numeric());
  EXPECT_EQ(f.base->text, "flexible");  // The default.
}

TEST(StudyReader, WrongValueIsReportedWhereItStands) {
  const std::string line = "case.yaml:" + std::to_string(kLine);
  EXPECT_THAT(error_of("path: mechanism.rollers, values: [9, 0]"),
              StartsWith(line + ":45: error: mechanism.rollers: got 0; expected a whole number"));
  EXPECT_THAT(error_of("path: mechanism.lead, values: [5 kN]"), HasSubstr("`kN` is the unit of a force"));
  EXPECT_THAT(error_of("path: mechanism.lead, values: {from: 5 kN, to: 6 kN, steps: 2}"),
              StartsWith(line + ":45: error: mechanism.lead: got 5 kN"));
  EXPECT_THAT(error_of("path: mechanism.geometry, values: [design]"), StartsWith(line + ":43: error: mechanism."));
}

TEST(StudyReader, UnknownPathIsReportedOnceWhereItStands) {
  const std::string error = error_of("path: mechanism.rolers, values: [9, 10]");
  EXPECT_THAT(error, StartsWith("case.yaml:" + std::to_string(kLine) + ":14: error: "));
  EXPECT_THAT(error, HasSubstr("did you mean `rollers`?"));
  EXPECT_EQ(error.find('\n'), std::string::npos);
}

TEST(StudyReader, RefusesWhatIsNoStudy) {
  EXPECT_THAT(error_of(Source{"case.yaml", kAbevi, {}}), HasSubstr("study: missing; expected"));
  const std::pair<const char*, const char*> wrong[] = {
      {"path: mechanism.lead, values: []", "got a list of 0"},
      {"path: mechanism.lead, values: 5 mm", "expected a list of at least 1 value, or a range"},
      {"path: mechanism.lead, values: [~]", "got nothing"},
      {"path: mechanism.lead, values: {from: 1 mm, to: 1 cm, steps: 2}", "the unit of `from`, mm"},
      {"path: mechanism.lead, values: {from: 1 mm, to: 1 mm, steps: 2}", "another value"},
      {"path: mechanism.lead, values: {from: 1 mm, to: 2 mm, steps: 1}", "from 2 to 100000"},
      {"path: mechanism.lead, values: {from: a, to: 2 mm, steps: 2}", "got a; expected a number"},
      {"path: mechanism.lead, values: {from: -1 mm, to: 2 mm, steps: 2, spacing: logarithmic}", "neither of them 0"},
      {"path: mechanism.rollers, values: {from: 8, to: 9, steps: 3}", "got 8.5"},
      {"path: study.command, values: [slip]", "a value outside `study`"},
      {"path: mechanism..lead, values: [5 mm]", "got no path"},
      {"path: \"load_cases[7].position\", values: [5 mm]", "expected one below 2"},
      {"path: mechanism.lead, values: {from: 1 mm, to: 2 mm, steps: 100000}}\n    - {path: "
       "mechanism.rollers, values: [9]",
       "got 100001 values; expected at most 100000"},
  };
  for (const auto& [factor, message] : wrong) EXPECT_THAT(error_of(std::string(factor)), HasSubstr(message)) << factor;
  EXPECT_THAT(error_of("path: mechanism.lead, values: [5 mm]}\n    - {path: mechanism.lead, values: [6 mm]"),
              HasSubstr("a second time"));
}

TEST(StudyReader, SampledPlanHasSamplesAndSeed) {
  const std::string factors = ", factors: [{path: mechanism.lead, within: 3 %}]}\n";
  const Study study = read_study_input(source_of("study: {command: solve, plan: monte_carlo, samples: 500, seed: "
                                                 "9007199254740992" +
                                                 factors))
                          .study;
  EXPECT_EQ(study.plan, Plan::monte_carlo);
  EXPECT_EQ(study.samples, 500U);
  EXPECT_EQ(study.seed, std::uint64_t{1} << 53U);
  const auto error = [&](const std::string& keys) {
    return error_of(source_of("study: {command: solve, " + keys + factors));
  };
  EXPECT_THAT(error("plan: sobol"), HasSubstr("study.samples: missing; expected a whole number from 1 to 999999999"));
  EXPECT_THAT(error("plan: sobol, samples: 0"), HasSubstr("study.samples: got 0; expected"));
  EXPECT_THAT(error("plan: sobol, samples: 9, seed: -1"),
              HasSubstr("study.seed: got -1; expected a whole number from 0 to 9007199254740992"));
  EXPECT_THAT(error("samples: 9"), HasSubstr("study.samples: got 9; expected no such key here"));
  EXPECT_THAT(error("seed: 9"), HasSubstr("study.seed: got 9; expected no such key here"));
  EXPECT_THAT(error("plan: sobol_indices, samples: 400000000"),
              HasSubstr("study.samples: got 1.2e+09 designs; expected fewer than 1000000000"));
}

TEST(StudyReader, GridIsBounded) {
  const std::string range = "values: {from: 4 mm, to: 6 mm, steps: 40000}}";
  EXPECT_THAT(error_of(source_of("study:\n  command: solve\n  plan: grid\n  factors:\n    - {path: "
                                 "mechanism.lead, " +
                                 range + "\n    - {path: structure.screw.bore, " + range + "\n")),
              HasSubstr("study.factors: got 1.6e+09 designs; expected fewer than 1000000000 with the "
                        "base case; take "
                        "fewer values"));
}

void expect_distribution(const Factor& factor, const std::string& unit, Distribution::Kind kind, double first,
                         double second) {
  EXPECT_EQ(factor.unit, unit);
  EXPECT_EQ(factor.distribution.kind, kind);
  EXPECT_DOUBLE_EQ(factor.distribution.first, first);
  EXPECT_DOUBLE_EQ(factor.distribution.second, second);
  EXPECT_TRUE(factor.is_numeric());
}

TEST(StudyReader, DistributionIsInTheUnitInWhichItIsWritten) {
  using enum Distribution::Kind;
  const auto factor = [](const std::string& keys) { return drawn(keys).factors.at(0); };
  const Factor lead = factor("path: mechanism.lead, uniform: {from: 4900 um, to: 5100 um}");
  expect_distribution(lead, "um", uniform, 4900, 5100);
  EXPECT_EQ(lead.base->text, "5 mm");
  EXPECT_EQ(lead.base->number, 5000.0);
  expect_distribution(factor("path: \"load_cases[0].axial_force\", log_uniform: {from: 1 kN, to: 45 kN}"), "kN",
                      log_uniform, 1, 45);
  expect_distribution(factor("path: mechanism.centre_distance, normal: {mean: 14010 um, deviation: 0.002 mm}"), "um",
                      normal, 14010, 2);
}

TEST(StudyReader, DistributionAboutTheFileIsInTheUnitOfTheFile) {
  using enum Distribution::Kind;
  const auto factor = [](const std::string& keys) { return drawn(keys).factors.at(0); };
  expect_distribution(factor("path: mechanism.centre_distance, normal: {deviation: 2 um}"), "mm", normal, 14, 0.002);
  expect_distribution(factor("path: materials.youngs_modulus, within: 3 %"), "GPa", uniform, 209 * 0.97, 209 * 1.03);
  expect_distribution(factor("path: materials.poisson_ratio, within: 0.1"), "", uniform, 0.27, 0.33);
  expect_distribution(factor("path: mechanism.profile.roller.convex, within: 3%"), "mm", uniform, 4.949747468 * 0.97,
                      4.949747468 * 1.03);
  // A default.
  expect_distribution(factor("path: carrier.gear_pressure_angle, within: 10 %"), "deg", uniform, 18, 22);
  // A difference of temperatures does not depend on their zero.
  const Factor warm = factor("path: deviations.reference_temperature, normal: {deviation: 5 K, mean: 40 degC}");
  EXPECT_EQ(warm.unit, "degC");
  EXPECT_NEAR(warm.distribution.second, 5.0, 1e-12);
}

TEST(StudyReader, ToleranceIsAShareAHalfWidthOrTwoDeviations) {
  using enum Distribution::Kind;
  const auto factor = [](const std::string& keys) { return drawn(keys).factors.at(0); };
  expect_distribution(factor("path: mechanism.centre_distance, within: 20 um"), "mm", uniform, 13.98, 14.02);
  expect_distribution(factor("path: mechanism.centre_distance, within: [-0.01 mm, 30 um]"), "mm", uniform, 13.99,
                      14.03);
  // Limits of a fit: both deviations on one side.
  expect_distribution(factor("path: mechanism.centre_distance, within: [2 um, 15 um]"), "mm", uniform, 14.002, 14.015);
  expect_distribution(factor("path: materials.youngs_modulus, within: [-1 %, 2 %]"), "GPa", uniform, 209 * 0.99,
                      209 * 1.02);
  expect_distribution(factor("path: materials.youngs_modulus, within: [0, 2 %]"), "GPa", uniform, 209, 209 * 1.02);
  expect_distribution(factor("path: mechanism.centre_distance, within: 0.001 in"), "mm", uniform, 14 - 0.0254,
                      14 + 0.0254);
  // A nominal value of 0 has no share, but a width.
  expect_distribution(factor("path: deviations.pitch_error.screw.linear, within: 2 um"), "mm", uniform, -0.002, 0.002);
}

TEST(StudyReader, AToleranceOfATemperatureIsADifference) {
  Source source = with_samples("path: deviations.reference_temperature, within: 9 degF");
  const Factor f = read_study_input(source).study.factors.at(0);
  EXPECT_EQ(f.unit, "degC");
  EXPECT_NEAR(f.distribution.second - f.distribution.first, 10.0, 1e-9);
  EXPECT_NEAR(f.distribution.second + f.distribution.first, 2.0 * *f.base->number, 1e-9);
}

TEST(StudyReader, ValuesAreAChoiceInASampledPlan) {
  const Factor f = drawn("path: model.roller, values: [flexible, rigid_bending]").factors.at(0);
  EXPECT_EQ(f.distribution.kind, Distribution::Kind::levels);
  EXPECT_THAT(texts(f), ElementsAre("flexible", "rigid_bending"));
}

TEST(StudyReader, EveryEntryOfAListIsDrawnOnItsOwn) {
  const StudyInput in = read_study_input(
      with_samples("path: deviations.pitch_error.screw.list, normal: {deviation: 2 um}, label: pitch error"));
  ASSERT_EQ(in.study.factors.size(), 20U);  // Contacts of a roller.
  for (std::size_t i = 0; i < 20; ++i) {
    const Factor& f = in.study.factors[i];
    EXPECT_EQ(f.path, fmt::format("deviations.pitch_error.screw.list[{}]", i));
    EXPECT_EQ(f.label, fmt::format("pitch error[{}]", i));
    EXPECT_TRUE(f.entry_of_list);
    expect_distribution(f, "um", Distribution::Kind::normal, 0, 2);
  }
  EXPECT_EQ(read_design(in, {}).deviations.pitch_error.screw.list, std::vector<double>(20, 0.0));
  const std::vector<double> drawn_list =
      read_design(in, overrides(in.study, design(in.study, 7))).deviations.pitch_error.screw.list;
  const std::vector<Draw> numbers = draws(in.study, 7);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(drawn_list.at(i), numbers[i].number / 1e6);
}

TEST(StudyReader, EntriesOfAListInTheFileAreMeans) {
  Source source = with_samples("path: deviations.pitch_error.nut.list, normal: {deviation: 1 um}");
  std::string list = "1 um";
  for (int i = 1; i < 20; ++i) list += fmt::format(", {} um", i + 1);
  source.overrides = {"deviations.pitch_error.nut.list=[" + list + "]"};
  const Study study = read_study_input(source).study;
  ASSERT_EQ(study.factors.size(), 20U);
  expect_distribution(study.factors[4], "um", Distribution::Kind::normal, 5, 1);
}

TEST(StudyReader, DerivativesNameNumbersOfTheFile) {
  const auto source = [](const std::string& factor) {
    return source_of("study: {command: solve, plan: derivatives, factors: [{path: " + factor + "}]}\n");
  };
  const Factor f = read_study_input(source("mechanism.lead")).study.factors.at(0);
  EXPECT_EQ(f.unit, "mm");
  EXPECT_EQ(f.base->number, 5.0);
  EXPECT_EQ(read_study_input(source("deviations.pitch_error.screw.list")).study.factors.size(), 20U);
  EXPECT_THAT(error_of(source("mechanism.lead, values: [5 mm]")),
              HasSubstr("study.factors[0].values: got [5 mm]; expected a path only with `plan: "
                        "derivatives`"));
  EXPECT_THAT(error_of(source("mechanism.rollers")),
              HasSubstr("got mechanism.rollers; expected the path of a number that may have any "
                        "value between two; leave this factor out"));
  EXPECT_THAT(error_of(source("mechanism.rolers")), HasSubstr("did you mean `rollers`?"));
  EXPECT_THAT(error_of(source("operation.speed")), HasSubstr("which the file does not state"));
}

TEST(StudyReader, RefusesAResponseTwice) {
  EXPECT_THAT(error_of(source_of("study:\n  command: solve\n  factors: [{path: mechanism.rollers, "
                                 "values: [9]}]\n  responses: [a.b, c, a.b]\n")),
              StartsWith("case.yaml:30:23: error: study.responses[2]: got a.b a second time; "
                         "expected each path once"));
}

TEST(StudyReader, RefusesWhatCannotBeDrawn) {
  const std::pair<const char*, const char*> wrong[] = {
      {"path: mechanism.lead", "study.factors[0]: missing what values it takes; expected one of values, uniform"},
      {"path: mechanism.lead, within: 3 %, values: [5 mm]",
       "study.factors[0].within: got 3 %; expected one way to choose values, `values` stands"},
      {"path: mechanism.lead, uniform: 5 mm", "study.factors[0].uniform: got 5 mm; expected a map"},
      {"path: mechanism.lead, uniform: {from: 5 mm}", "uniform.to: missing"},
      {"path: mechanism.lead, uniform: {from: 5 mm, to: 4 mm}",
       "uniform.to: got 4 mm; expected more than `from`, 5 mm; swap the two"},
      {"path: mechanism.lead, uniform: {from: 5 mm, to: 1 cm}", "the unit of `from`, mm"},
      {"path: mechanism.lead, uniform: {from: a, to: 1 cm}", "got a; expected a number"},
      {"path: mechanism.lead, log_uniform: {from: -1 mm, to: 1 mm}",
       "log_uniform.from: got logarithmic from -1 mm to 1 mm; expected ends of one sign"},
      {"path: mechanism.lead, uniform: {from: 5 kN, to: 6 kN}", "`kN` is the unit of a force"},
      {"path: structure.screw.bore, uniform: {from: -1 mm, to: 6 mm}",
       "structure.screw.bore: got -1 mm; expected a length >= 0"},
      {"path: materials.poisson_ratio, within: 100 %",
       "materials.poisson_ratio: got 0.6; expected a number >= 0 and < 0.5"},
      {"path: mechanism.lead, within: 3", "within: got 3; expected a share > 0 and at most 100 %"},
      {"path: mechanism.lead, within: 0 %", "within: got 0 %; expected a share > 0"},
      {"path: mechanism.lead, within: 3 kN", "within: got 3 kN; expected a share"},
      {"path: mechanism.lead, within: 0 mm", "within: got 0 mm; expected a share"},
      {"path: mechanism.lead, within: -1 um", "within: got -1 um; expected a share"},
      {"path: mechanism.lead, within: [1 um]", "within: got [1 um]; expected a share"},
      {"path: mechanism.lead, within: [1 um, -1 um]",
       "within: got [1 um, -1 um]; expected the lower deviation, then the upper"},
      {"path: mechanism.lead, within: 6 um, uniform: {from: 4 mm, to: 6 mm}", "one way"},
      {"path: deviations.crowning, within: 2 um", "deviations.crowning: got -0.002 mm"},
      {"path: mechanism.lead, within: much", "within: got much; expected a share"},
      {"path: structure.screw.bore, within: 3 %}, {path: deviations.crowning, within: 3 %",
       "got 3 % of 0; expected a value other than 0 in the file, or a half width with its unit; "
       "write "
       "for example `within: 0.02 mm`"},
      {"path: operation.speed, within: 3 %", "got 3 % of no single value in the file"},
      {"path: deviations.reference_temperature, within: 3 %", "whose zero is a convention"},
      {"path: mechanism.lead, normal: {deviation: 0 mm}",
       "normal.deviation: got 0 mm; expected a number > 0 that goes with the unit mm"},
      {"path: mechanism.lead, normal: {deviation: 1 kN}", "goes with the unit mm"},
      {"path: mechanism.lead, normal: {deviation: 1 um, mean: wide}",
       "normal.mean: got wide; expected a number with its unit"},
      {"path: operation.speed, normal: {deviation: 1 rpm}",
       "normal: missing `mean`; expected it where the file does not state operation.speed; add "
       "for example `mean: 0 rpm`"},
      {"path: structure.screw.bore, normal: {deviation: 1 um, mean: -1 mm}", "structure.screw.bore: got -1 mm"},
      {"path: mechanism.rollers, uniform: {from: 8, to: 11}", "write the values that it may have, `values: [.., ..]`"},
      {"path: model.roller, within: 3 %", "expected the path of a number that may have any value"},
      {"path: \"load_cases[1].axial_force.steps\", within: 3 %", "expected the path of a number"},
      {"path: mechanism.rolers, within: 3 %", "did you mean `rollers`?"},
      {"path: \"load_cases[7].position\", within: 3 %", "expected one below 2"},
      {"path: study.samples, within: 3 %", "a value outside `study`"},
      {"path: mechanism.pitch_diameter, values: [~]}, {path: mechanism.pitch_diameter.nut, within: "
       "3 %",
       "got nothing"},
      {"path: mechanism.starts, values: [{screw: 3}]}, {path: mechanism.starts.screw, values: [3]",
       "got mechanism.starts.screw as well as mechanism.starts; expected factors of which none"},
  };
  for (const auto& [factor, message] : wrong) EXPECT_THAT(error_of_drawn(factor), HasSubstr(message)) << factor;
}

TEST(StudyReader, WrongDistributionIsReportedWhereItStands) {
  const std::string line = "case.yaml:" + std::to_string(kLine);
  EXPECT_THAT(error_of_drawn("path: mechanism.lead, uniform: {from: 4 mm, to: 6 kN}"),
              StartsWith(line + ":56: error: study.factors[0].uniform.to: got 6 kN"));
  EXPECT_THAT(error_of_drawn("path: structure.screw.bore, uniform: {from: -4 mm, to: 6 mm}"),
              StartsWith(line + ":52: error: structure.screw.bore: got -4 mm"));
  EXPECT_THAT(error_of_drawn("path: materials.poisson_ratio, within: 100 %"),
              StartsWith(line + ":47: error: materials.poisson_ratio: got 0.6"));
}

TEST(StudyReader, DistributionsAreForSampledPlans) {
  EXPECT_THAT(error_of("path: mechanism.lead, within: 3 %"),
              HasSubstr("study.factors[0].within: got 3 %; expected `values` with `plan: "
                        "one_at_a_time`, which lists its designs"));
  EXPECT_THAT(error_of("path: mechanism.lead"), HasSubstr("missing what values it takes; expected "
                                                          "`values`"));
}

TEST(StudyReader, SobolsSequenceHasSoManyDimensions) {
  const auto error = [](const std::string& plan, int contacts) {
    Source source = with_samples("path: deviations.pitch_error.screw.list, normal: {deviation: 1 nm}", plan);
    source.overrides = {fmt::format("mechanism.contacts_per_roller={}", contacts), "structure.nut.length=20 m"};
    return error_of(source);
  };
  EXPECT_EQ(error("sobol", 3667), "");
  EXPECT_THAT(error("sobol", 3668), HasSubstr("got 3668 factors; expected at most 3667 with `plan: "
                                              "sobol`; take `plan: latin_hypercube`"));
  EXPECT_THAT(error("sobol_indices", 1834), HasSubstr("expected at most 1833 with"));
}

TEST(StudyReader, BaseCaseMustMeetItsCommand) {
  const std::string study = "study: {command: slip, factors: [{path: mechanism.rollers, values: [9]}]}\n";
  EXPECT_THAT(error_of(source_of(study)), HasSubstr("operation"));
}

TEST(StudyReader, DesignIsTheFileWithItsOverrides) {
  const StudyInput in = read_study_input(with_factor("path: mechanism.rollers, values: [9]"));
  EXPECT_EQ(read_design(in, {}).mechanism.rollers, 11);
  EXPECT_EQ(read_design(in, {"mechanism.rollers=9"}).mechanism.rollers, 9);
  EXPECT_THROW(read_design(in, {"structure.nut.length=5 mm"}), InputError);
}

TEST(StudyReader, OverridesOfTheCommandLineReachFileAndStudy) {
  Source source = with_factor("path: mechanism.rollers, values: [9]");
  source.overrides = {"mechanism.rollers=10", "study.factors[0].values=[7, 8]"};
  const StudyInput in = read_study_input(source);
  EXPECT_EQ(read_design(in, {"mechanism.lead=5 mm"}).mechanism.rollers, 10);
  EXPECT_THAT(texts(in.study.factors[0]), ElementsAre("7", "8"));
  EXPECT_EQ(in.study.factors[0].base->text, "10");
}

TEST(FlowText, ReadsBackAsTheSameValue) {
  for (const char* text :
       {"5 mm", "\"5\"", "straight", "{convex: 6 mm}", "[a, {b: \"c, d\"}]", "\"say \\\"x\\\"\"", "~"}) {
    const Source source{"case.yaml", "a: ~\n", {std::string("a=") + text}};
    ErrorList errors(source);
    const Node root = read_document(source, errors);
    EXPECT_EQ(flow_text(*find(root, "a")), text);
  }
}

}  // namespace
}  // namespace prs::input
