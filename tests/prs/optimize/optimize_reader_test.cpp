#include "prs/input/optimize_reader.h"
#include "prs/run/study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "yao_file.h"

namespace prs::input {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

OptimizeInput read(const std::string& optimize, const std::vector<std::string>& overrides = {}) {
  return read_optimize_input({"case.yaml", test::yao_mechanism() + optimize, overrides});
}

/// Error of an optimization.
std::string refusal(const std::string& optimize) {
  try {
    read(optimize);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(OptimizeReader, ResponsesTakeNamesOfLoadCases) {
  const std::string search = R"(
optimize:
  command: contact
  variables: [{path: mechanism.rollers, from: 8, to: 11}]
  objectives: [{minimize: "load_cases[PLACE].screw.peak_pressure_MPa.max"}]
  constraints: [{response: "load_cases[0].screw.peak_pressure_MPa.max", at_most: 5000}]
)";
  const auto named = [&](std::string place) {
    std::string text = search;
    return read(text.replace(text.find("PLACE"), 5, place), {"load_cases[0].name=push"}).optimization.study.responses;
  };
  EXPECT_THAT(named("push"), ElementsAre("load_cases[0].screw.peak_pressure_MPa.max"));
}

TEST(OptimizeReader, ReadsVariablesAimsAndHow) {
  const OptimizeInput input = read(R"(
optimize:
  command: contact
  variables:
    - {path: mechanism.flank_angle.screw, from: 40 deg, to: 50 deg, label: angle}
    - {path: mechanism.rollers, from: 8, to: 11}
    - {path: mechanism.profile.roller, values: [centred, {convex: 11 mm}],
       with: [{path: mechanism.pitch_diameter.roller, values: [16 mm, 16.1 mm]}]}
  objectives:
    - {minimize: screw.peak_pressure_MPa.max}
    - {maximize: contact.nut.radius_on_body_mm}
  constraints:
    - {response: nut.peak_pressure_MPa.max, at_most: {initial: 1.1}, at_least: 3}
    - {response: contact.nut.radius_on_body_mm, at_least: {response: contact.screw.radius_on_body_mm}}
  check: moead
  population: 24
  generations: 7
  seed: 5
  compromise: {by: weights, weights: [2, 1]}
)");
  const Optimization& o = input.optimization;
  ASSERT_THAT(o.study.factors, SizeIs(3));
  const Factor& angle = o.study.factors[0];
  EXPECT_EQ(angle.distribution.kind, Distribution::Kind::uniform);
  EXPECT_EQ(angle.distribution.first, 40.0);
  EXPECT_EQ(angle.distribution.second, 50.0);
  EXPECT_EQ(angle.unit, "deg");
  EXPECT_EQ(angle.base->number, 45.0);
  const Factor& rollers = o.study.factors[1];
  ASSERT_THAT(rollers.levels, SizeIs(4));
  EXPECT_EQ(rollers.levels[3].text, "11");
  EXPECT_EQ(rollers.base->number, 10.0);
  const Factor& profile = o.study.factors[2];
  EXPECT_EQ(profile.levels.at(1).text, "{convex: 11 mm}");
  EXPECT_EQ(profile.companions.at(0).levels.at(1).number, 16.1);
  EXPECT_THAT(o.study.responses, ElementsAre("screw.peak_pressure_MPa.max", "contact.nut.radius_on_body_mm",
                                             "nut.peak_pressure_MPa.max", "contact.screw.radius_on_body_mm"));
  EXPECT_EQ(input.asked_at[3], "optimize.constraints[1].at_least");
  EXPECT_FALSE(o.objectives.at(0).maximize);
  EXPECT_TRUE(o.objectives.at(1).maximize);
  ASSERT_THAT(o.constraints, SizeIs(3));
  EXPECT_EQ(o.constraints[1].limit.kind, Limit::Kind::initial);
  EXPECT_EQ(o.constraints[1].limit.value, 1.1);
  EXPECT_EQ(o.constraints[1].sense, Constraint::Sense::at_most);
  EXPECT_EQ(o.constraints[2].limit.response, 3);
  EXPECT_EQ(o.algorithm, Algorithm::nsga2);
  EXPECT_EQ(o.check, Algorithm::moead);
  EXPECT_EQ(o.population, 24);
  EXPECT_EQ(o.generations, 7);
  EXPECT_EQ(o.seed, 5);
  EXPECT_EQ(o.compromise.by, Compromise::By::weights);
  EXPECT_THAT(o.compromise.weights, ElementsAre(2.0, 1.0));
  EXPECT_EQ(find(input.start.base, "optimize"), nullptr);
}

TEST(OptimizeReader, OneObjectiveHasAnAlgorithmOfItsOwn) {
  EXPECT_EQ(read(test::yao_optimize("  objectives: [{minimize: screw.peak_pressure_MPa.max}]")).optimization.algorithm,
            Algorithm::sade);
}

TEST(OptimizeReader, ThreadConstraintsAreThoseOfYao) {
  const Optimization o = read(test::yao_optimize("  objectives: [{minimize: screw.peak_pressure_MPa.max}]\n"
                                                 "  thread_constraints: true"))
                             .optimization;
  // (61): three root widths, three crests, two clearances of flanks, four of crests.
  ASSERT_THAT(o.constraints, SizeIs(12));
  std::size_t roots = 0;
  for (const Constraint& constraint : o.constraints) {
    if (!o.study.responses[constraint.response].ends_with("root_width_mm")) continue;
    ++roots;
    EXPECT_EQ(constraint.limit.value, 5.0);  // The pitch.
    EXPECT_EQ(constraint.sense, Constraint::Sense::at_most);
  }
  EXPECT_EQ(roots, 3);
}

TEST(OptimizeReader, SaysWhatIsWrongWhereItStands) {
  const std::string objective = "  objectives: [{minimize: screw.peak_pressure_MPa.max}]\n";
  const auto with_variable = [&](const std::string& variable) {
    return refusal("optimize:\n  command: contact\n  variables: [" + variable + "]\n" + objective);
  };
  const std::string line = "case.yaml:" + std::to_string(test::yao_lines() + 3) + ":";
  EXPECT_THAT(refusal(""), HasSubstr("optimize: missing"));
  EXPECT_THAT(with_variable("{path: mechanism.flank_angle.screw, from: 50 deg, to: 40 deg}"),
              AllOf(HasSubstr(line), HasSubstr("optimize.variables[0].to: got 40 deg; expected more "
                                               "than `from`, 50 deg")));
  EXPECT_THAT(with_variable("{path: mechanism.flank_angle.screw, from: 40 deg, to: 0.8 rad}"),
              HasSubstr("expected the unit of `from`, deg"));
  EXPECT_THAT(with_variable("{path: mechanism.flank_angle.screw, from: 40 deg, to: 95 deg}"),
              AllOf(HasSubstr(line), HasSubstr("got 95 deg; expected an angle")));
  EXPECT_THAT(with_variable("{path: mechanism.flank_angle.screw, from: low, to: 40 deg}"),
              HasSubstr("got low; expected a number with its unit"));
  EXPECT_THAT(with_variable("{path: mechanism.flank_angle.screw, from: 40 deg}"),
              HasSubstr("optimize.variables[0].to: missing"));
  EXPECT_THAT(with_variable("{path: mechanism.profile.nut, from: 1 mm, to: 2 mm}"), HasSubstr("mechanism.profile.nut"));
  EXPECT_THAT(with_variable("{path: mechanism.nothing, from: 1 mm, to: 2 mm}"), HasSubstr("nothing: unknown key"));
  EXPECT_THAT(with_variable("{path: mechanism.rollers, from: 8, to: 12.5}"),
              HasSubstr("got 12.5; expected a whole number"));
  EXPECT_THAT(with_variable("{path: study.seed, from: 1, to: 2}"), HasSubstr("expected a value outside `study`"));
  EXPECT_THAT(with_variable("{path: mechanism.rollers, values: [8, 9], with: [{path: "
                            "mechanism.contacts_per_roller, values: [1, 2, 3]}]}"),
              HasSubstr("got 3 values; expected 2"));
  EXPECT_THAT(with_variable("{path: mechanism.rollers, from: 8, to: 9}, {path: mechanism.rollers, "
                            "from: 8, to: 9}"),
              HasSubstr("a second time; expected each path once; put all its values into one variable"));
  const auto with = [](const std::string& rest) { return refusal(test::yao_optimize(rest)); };
  EXPECT_THAT(with("  objectives: [{}]"), HasSubstr("minimize"));
  EXPECT_THAT(with("  objectives: [{minimize: a, maximize: b}]"), HasSubstr("minimize"));
  EXPECT_THAT(with(objective + "  algorithm: nsga2"),
              HasSubstr("got nsga2 with 1 objective; expected one for a single one"));
  EXPECT_THAT(with(objective + "  check: sade"), HasSubstr("which searches already"));
  EXPECT_THAT(with(objective + "  constraints: [{response: screw.peak_pressure_MPa.max, at_least: 5, at_most: 3}]"),
              HasSubstr("constraints[0].at_most: got 3 beside at_least 5; expected limits between which"));
  EXPECT_THAT(with("  objectives: [{minimize: a}, {minimize: b}]\n  population: 21"),
              HasSubstr("got 21; expected a multiple of 4"));
  EXPECT_THAT(with("  objectives: [{minimize: a}, {minimize: a}]"), HasSubstr("a second time"));
  EXPECT_THAT(with(objective + "  constraints: [{response: a}]"), HasSubstr("at_most: missing"));
  EXPECT_THAT(with(objective + "  constraints: [{response: a, at_most: 5 MPa}]"),
              HasSubstr("optimize.constraints[0].at_most: got 5 MPa; expected a number in the unit "
                        "of the path"));
  EXPECT_THAT(with(objective + "  constraints: [{response: a, at_most: {initially: 5}}]"),
              HasSubstr("{initial: number}"));
  EXPECT_THAT(with(objective + "  compromise: {by: weights, weights: [1, 2]}"), HasSubstr("got 2 weights; expected 1"));
  EXPECT_THAT(with(objective + "  compromise: {by: best, of: a}"), HasSubstr("`of: screw.peak_pressure_MPa.max`"));
  EXPECT_THAT(with(objective + "  compromise: {by: best}"), HasSubstr("of: missing"));
  EXPECT_THAT(refusal("optimize:\n  command: contact\n  thread_constraints: true\n  variables: "
                      "[{path: mechanism.lead, from: 20 mm, to: 25 mm}]\n" +
                      objective),
              HasSubstr("expected a pitch that stays as it is"));
}

TEST(OptimizeReader, RelativeLimitsNeedAnAnswerOfTheFilesOwnDesign) {
  const OptimizeInput input =
      read(test::yao_optimize("  objectives: [{minimize: screw.peak_pressure_MPa.max}]\n"
                              "  constraints: [{response: screw.peak_pressure_MPa.max, at_most: "
                              "{initial: 1}}]"));
  EXPECT_NO_THROW(check_initial(input, {{}, {2000.0}, {}, 0.0}));
  try {
    check_initial(input, {{}, {kNoResponse}, {"refused", "no contact"}, 0.0});
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("case.yaml:"), HasSubstr("no contact")));
  }
}

}  // namespace
}  // namespace prs::input
