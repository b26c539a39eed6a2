#include "prs/study/design_reader.h"
#include "prs/study/design_engine.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

#include "prs/input/field.h"
#include "prs/input/reader.h"
#include "prs/input/varied_input.h"
#include "tests/prs/input/abevi.h"
#include "tests/support/count.h"
#include "tests/support/sanitized.h"

namespace prs::input {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Every value of a case with its key, compared bit by bit.
struct Values {
  std::vector<std::string> all;

  void list(std::string_view key, const Value& value) {
    std::visit([&](const auto& v) { list(key, v); }, value.as);
  }

  void list(std::string_view, const MapValue& map) {
    map.for_each([&](const Field& field) {
      if (field.has_value()) list(field.key, field.value());
    });
  }

 private:
  template <class Kind, class T>
  void list(std::string_view key, const Leaf<Kind, T>& leaf) {
    if constexpr (std::is_same_v<T, double>)
      all.push_back(fmt::format("{}={:a}", key, leaf.value));
    else if constexpr (std::is_same_v<T, LeastLife>)
      all.push_back(
          fmt::format("{}={:a} {:a}", key, leaf.value.duration.value_or(-1.0), leaf.value.travel.value_or(-1.0)));
    else
      all.push_back(fmt::format("{}={}", key, leaf.value));
  }
  void list(std::string_view key, const ChoiceValue& choice) {
    for (const Alternative& a : choice.alternatives())
      if (a.holds) {
        all.push_back(fmt::format("{}={}", key, a.name));
        if (a.content) list(a.name, a.content());
      }
  }
  void list(std::string_view, const ChoiceUnderKey& under) { list(under.key, under.choice); }
  void list(std::string_view key, const ListValue& items) {
    for (std::size_t i = 0; i < items.size(); ++i) list(key, items.entry(i));
  }
  void list(std::string_view key, const OneOr& value) {
    using Form = OneOr::Form;
    const bool whole =
        value.form == Form::parts || value.form == Form::ends || value.form == Form::word || value.are_several;
    list(key, whole ? value.several() : value.one());
  }
};

std::vector<std::string> values_of(const Case& c) {
  CaseFile file;
  file.values = c;
  Values values;
  values.list("", map_of([&file](const Fields& io) { fields(io, file); }));
  for (const LoadCase& l : c.load_cases)
    values.all.push_back(fmt::format("{} {:a} {} {:a} {} {:a} {}", l.name, l.axial_force,
                                     l.direction ? name(*l.direction) : "", l.position.value_or(0),
                                     static_cast<int>(l.share), l.speed.value_or(0), l.input_path));
  return values.all;
}

/// Result of reading a design: its values, or the error.
template <class Read>
std::vector<std::string> outcome(const Read& read) {
  try {
    return values_of(read());
  } catch (const InputError& error) {
    return {error.what()};
  }
}

/// Number of designs that are read like their texts; fails at the first one that is not.
int refused_of(const StudyInput& input, std::size_t designs) {
  int refused = 0;
  DesignReader reader(input), by_draws(input);
  for (std::size_t k = 0; k < std::min(designs, design_count(input.study)); ++k) {
    const std::vector<std::string> texts = overrides(input.study, design(input.study, k));
    const auto expected = outcome([&] { return read_design(input, texts); });
    const auto read = outcome([&] { return reader.read(k); });
    refused += expected.size() == 1 ? 1 : 0;
    EXPECT_EQ(read, expected) << fmt::format("{}", fmt::join(texts, "\n"));
    EXPECT_EQ(outcome([&] { return by_draws.read(draws(input.study, k)); }), expected);
    EXPECT_EQ(overrides(input.study, draws(input.study, k)), texts);
    if (read != expected) break;
  }
  return refused;
}

/// A lesson without its own study.
Source lesson(const std::string& name, const std::string& study) {
  Source source = load_source(PRS_SOURCE_DIR "/configs/" + name + ".yaml", {});
  source.text = source.text.substr(0, source.text.find("\nstudy:")) + '\n' + study;
  return source;
}

struct Lesson {
  const char* name;
  Command command;
};
constexpr Lesson kLessons[] = {{"01_config_1_to_3", Command::solve},
                               {"03_load_sweep", Command::solve},
                               {"05_standard_screw", Command::solve},
                               {"06_roller_guidance", Command::solve},
                               {"08_design_by_backlash", Command::contact},
                               {"09_slip_and_dissipation", Command::slip},
                               {"10_parametric_study", Command::slip},
                               {"11_real_parts", Command::solve},
                               {"12_preload", Command::contact},
                               {"13_three_models", Command::solve},
                               {"14_flight_spectrum", Command::life}};

/// Paths of all numbers of a file, as `prs check` lists them, that a study can draw.
std::vector<std::string> numeric_paths(const std::string& name, Command command) {
  const Source source = lesson(name, "");
  const CaseInput in = read_case_input(source, command);
  ErrorList errors(source);
  const CaseFile file = read_case_file(read_document(source, errors), errors);
  std::vector<std::string> paths;
  for (const EchoEntry& entry : in.fields) {
    CaseFile scratch = file;
    if (find_slot(scratch, entry.path).kind == Slot::Kind::number && split_unit(entry.value))
      paths.push_back(entry.path);
  }
  return paths;
}

std::string study_of(Command command, const std::string& plan, const std::vector<std::string>& paths,
                     const std::string& way) {
  std::string study = fmt::format("study:\n  command: {}\n  {}\n  factors:\n", name(command), plan);
  for (const std::string& path : paths) study += fmt::format("    - {{path: \"{}\", {}}}\n", path, way);
  return study;
}

/// Study over all numbers of a lesson, except those that `way` does not suit.
StudyInput all_numbers(const Lesson& l, const std::string& plan, const std::string& way) {
  std::vector<std::string> paths;
  for (const std::string& path : numeric_paths(l.name, l.command)) {
    try {
      read_study_input(lesson(l.name, study_of(l.command, plan, {path}, way)));
      paths.push_back(path);
    } catch (const InputError&) {
    }
  }
  EXPECT_GE(paths.size(), 5U) << l.name;
  return read_study_input(lesson(l.name, study_of(l.command, plan, paths, way)));
}

/// Every third lesson under sanitizers: common parts are read alike.
std::vector<Lesson> some_lessons() {
  std::vector<Lesson> lessons;
  for (std::size_t k = 0; k < std::size(kLessons); k += test::sanitized() ? 3 : 1) lessons.push_back(kLessons[k]);
  return lessons;
}

TEST(DesignReader, ReadsEveryNumberAsItsText) {
  const auto designs = static_cast<std::size_t>(test::samples(40, 1000));
  for (const Lesson& l : some_lessons()) {
    const int refused = refused_of(all_numbers(l, "plan: latin_hypercube\n  samples: 1000", "within: 0.01 %"), designs);
    EXPECT_LT(refused, static_cast<int>(designs)) << l.name;
  }
}

// 30 % leads to values out of bounds and to contradictions, one and several at once.
TEST(DesignReader, RefusesAsTheTextIsRefused) {
  const auto designs = static_cast<std::size_t>(test::samples(40, 1000));
  const std::vector<Lesson> lessons = some_lessons();
  int refused = 0;
  for (const Lesson& l : lessons)
    refused += refused_of(all_numbers(l, "plan: monte_carlo\n  samples: 1000", "within: 30 %"), designs);
  EXPECT_GT(3 * refused, static_cast<int>(designs * lessons.size()));
}

// Load cases that agree in all except name and force are checked once, those that vary each.
TEST(DesignReader, LoadCasesAreRefusedWhetherTheyVaryOrNot) {
  for (const char* lesson_name : {"03_load_sweep", "04_contacts_from_geometry"}) {
    const StudyInput in =
        read_study_input(lesson(lesson_name,
                                "study:\n  command: solve\n  plan: monte_carlo\n  samples: 200\n  factors:\n"
                                "    - {path: structure.nut.length, uniform: {from: 80 mm, to: 92 mm}}\n"
                                "    - {path: \"load_cases[0].position\", uniform: {from: 0 mm, to: 90 mm}}\n"));
    EXPECT_GT(refused_of(in, 60), 5) << lesson_name;
  }
}

/// The lesson on real parts with some factors.
StudyInput real_parts(const std::string& plan, const std::string& factors) {
  return read_study_input(lesson("11_real_parts", "study:\n  command: solve\n  " + plan + "\n  factors:\n" + factors));
}

const std::string kMixed = R"(
    - {path: deviations.pitch_error.screw.list, normal: {deviation: 2 um}}
    - {path: deviations.crowning, uniform: {from: 0 um, to: 20 um}}
    - {path: deviations.temperature.screw, normal: {deviation: 5 K}}
    - {path: materials.youngs_modulus, within: 3 %}
    - {path: mechanism.profile.roller, values: [{convex: 4.9 mm}, {convex: 5.1 mm}, straight]}
    - {path: model.roller, values: [flexible, rigid_bending]}
    - {path: mechanism.rollers, values: [9, 10, 11, 12, 60]}
    - {path: structure.nut.outer_diameter, values: {from: 45 mm, to: 48 mm, steps: 7}}
    - {path: "load_cases[1].axial_force", log_uniform: {from: 1 kN, to: 45 kN}}
    - {path: "structure.nut.flanges[1].outer_diameter", values: [60 mm, 6.1 cm, 62000 um]}
)";

TEST(DesignReader, MixesWordsListsWholeNumbersAndQuantities) {
  for (const char* plan : {"latin_hypercube", "sobol", "monte_carlo", "sobol_indices"})
    refused_of(real_parts(fmt::format("plan: {}\n  samples: 1000", plan), kMixed),
               static_cast<std::size_t>(test::count(50, 2000)));
}

TEST(DesignReader, DrawsOutOfBoundsAreRefused) {
  const std::string factors = R"(
    - {path: structure.screw.bore, normal: {mean: 1 mm, deviation: 1 mm}}
    - {path: materials.poisson_ratio, normal: {deviation: 0.2}}
)";
  // P(bore < 0) = 0.16, P(ratio < 0 or > 0.5) = 0.23: 140 of 400 within 3 deviations.
  const int refused = refused_of(real_parts("plan: monte_carlo\n  samples: 400", factors), 401);
  EXPECT_NEAR(refused, 140, 29);
}

TEST(DesignReader, ReadsListedPlans) {
  const std::string factors = R"(
    - {path: deviations.end_relief, values: [{drop: 1 um, threads: 2}, {drop: 1 um, threads: 11}]}
    - {path: deviations.pitch_error.screw.periodic, values: [{amplitude: 1 um, period: 4}]}
    - {path: structure.screw, values: [{bore: 4 mm}, {bore: 40 mm}]}
    - {path: mechanism.rollers, values: [9, 60]}
    - {path: mechanism.flank_angle, values: [44 deg, 0.8 rad]}
    - {path: "load_cases[0].axial_force", values: [-5 kN, {from: 1 kN, to: 45 kN, steps: 3}]}
    - {path: "load_cases[0].speed", values: [100 rpm]}
)";
  EXPECT_GT(refused_of(real_parts("plan: one_at_a_time", factors), 1000), 3);
  EXPECT_GT(refused_of(real_parts("plan: grid", factors.substr(factors.find("    - {path: st"))), 1000), 10);
}

const std::string kTogether = R"(
    - path: mechanism.pitch_diameter.screw
      values: {from: 20.9 mm, to: 21.1 mm, steps: 5}
      with:
        - {path: mechanism.pitch_diameter.roller, values: {from: 6.9 mm, to: 7.1 mm, steps: 5}}
        - {path: mechanism.flank_angle, values: {from: 44.5 deg, to: 45.5 deg, steps: 5}}
        - {path: mechanism.rollers, values: [9, 10, 11, 12, 60]}
        - {path: mechanism.profile.roller, values: [straight, {convex: 5 mm}, straight, {convex: 5 mm}, {convex: 6 mm}]}
    - {path: structure.screw.bore, values: [4 mm, 40 mm]}
)";

TEST(DesignReader, SetsCompanionsAsTheirTextsDo) {
  for (const char* plan : {"plan: one_at_a_time", "plan: grid", "plan: sobol\n  samples: 40"}) {
    const StudyInput in = real_parts(plan, kTogether);
    EXPECT_GT(refused_of(in, 100), 1) << plan;
    EXPECT_LT(refused_of(in, 100), 40) << plan;
  }
}

TEST(DesignReader, CompanionsTakeTheLevelOfTheirFactor) {
  const StudyInput in =
      read_study_input(lesson("11_real_parts",
                              "study:\n  command: solve\n  plan: grid\n  factors:\n    - {path: mechanism.rollers, "
                              "values: [9, 11], with: [{path: materials.youngs_modulus, values: [200 GPa, 210 "
                              "GPa]}]}\n    - {path: structure.screw.bore, values: [4 mm, 5 mm]}\n"));
  ASSERT_EQ(design_count(in.study), 5U);
  EXPECT_THAT(overrides(in.study, design(in.study, 2)),
              ElementsAre("mechanism.rollers=9", "materials.youngs_modulus=200 GPa", "structure.screw.bore=5 mm"));
  DesignReader reader(in);
  EXPECT_EQ(reader.read(1).materials->screw.youngs_modulus, 200e9);
  const Case& c = reader.read(3);
  EXPECT_EQ(c.mechanism.rollers, 11);
  EXPECT_EQ(c.materials->screw.youngs_modulus, 210e9);
  EXPECT_EQ(c.structure->screw.bore, 0.004);
}

/// A speed along the axis stays where a study changes the lead, and may be a factor itself.
TEST(DesignReader, SpeedsAlongTheAxisFollowTheLead) {
  Source source = lesson("09_slip_and_dissipation",
                         "study: {command: slip, plan: grid, factors: [{path: mechanism.lead, "
                         "values: [5 mm, 8 mm]}, {path: operation.speed, values: [100 mm/s, 3 in/s, "
                         "500 rpm]}]}");
  source.overrides = {"load_cases[1].speed=-40 mm/s"};
  const StudyInput input = read_study_input(source);
  ASSERT_EQ(design_count(input.study), 7U);  // The first is that of the file.
  EXPECT_EQ(refused_of(input, 7), 0);
  DesignReader reader(input);
  const double turn = 2.0 * std::numbers::pi;
  const double speeds[] = {0.1 / 5e-3 * turn, 0.0762 / 5e-3 * turn, 500.0 / 60.0 * turn,
                           0.1 / 8e-3 * turn, 0.0762 / 8e-3 * turn, 500.0 / 60.0 * turn};
  for (std::size_t k = 0; k < 6; ++k) {
    const Case& c = reader.read(k + 1);
    EXPECT_DOUBLE_EQ(c.operation->speed, speeds[k]) << k;
    EXPECT_DOUBLE_EQ(*c.load_cases[1].speed, -0.04 / c.mechanism.lead * turn) << k;
  }
}

TEST(DesignReader, RangeOfForcesIsExpandedAnew) {
  const StudyInput in =
      read_study_input({"case.yaml",
                        kAbevi + "study:\n  command: solve\n  plan: sobol\n  samples: 20\n  factors:\n    - {path: "
                                 "\"load_cases[1].axial_force.to\", uniform: {from: 30 kN, to: 45 kN}}\n    - "
                                 "{path: \"load_cases[1].position\", within: 5 %}\n",
                        {}});
  EXPECT_EQ(refused_of(in, 21), 0);
}

TEST(DesignReader, OrderDoesNotMatter) {
  const StudyInput in = real_parts("plan: monte_carlo\n  samples: 40", kMixed);
  DesignReader forwards(in), backwards(in);
  std::vector<std::vector<std::string>> read;
  for (std::size_t k = 0; k < 40; ++k) read.push_back(outcome([&] { return forwards.read(k); }));
  for (std::size_t k = 40; k-- > 0;) EXPECT_EQ(outcome([&] { return backwards.read(k); }), read[k]);
}

TEST(Slot, OneValueForAllPartsIsThreeNumbers) {
  CaseFile file;
  const Slot all = find_slot(file, "mechanism.flank_angle");
  EXPECT_EQ(all.kind, Slot::Kind::number);
  EXPECT_THAT(all.numbers,
              ElementsAre(&file.values.mechanism.flank_angle.screw, &file.values.mechanism.flank_angle.roller,
                          &file.values.mechanism.flank_angle.nut));
  EXPECT_THAT(find_slot(file, "mechanism.flank_angle.nut").numbers,
              ElementsAre(&file.values.mechanism.flank_angle.nut));
}

TEST(Slot, KnowsWhatStandsAtAPath) {
  CaseFile file;
  file.load_cases.resize(1);
  const std::pair<const char*, Slot::Kind> kinds[] = {
      {"mechanism.lead", Slot::Kind::number},
      {"materials.screw.poisson_ratio", Slot::Kind::number},
      {"friction.coulomb", Slot::Kind::none},  // Jacod by default.
      {"load_cases[0].position", Slot::Kind::number},
      {"load_cases[1].position", Slot::Kind::none},
      {"load_cases[0].axial_force", Slot::Kind::number},
      {"load_cases[0].axial_force.steps", Slot::Kind::other},
      {"mechanism.rollers", Slot::Kind::whole},
      {"mechanism.type", Slot::Kind::other},
      {"mechanism", Slot::Kind::other},
      {"mechanism.lead.x", Slot::Kind::none},
      {"mechanism.leed", Slot::Kind::none},
      {"deviations.pitch_error.nut.list", Slot::Kind::numbers},
      {"study.samples", Slot::Kind::none},
  };
  for (const auto& [path, kind] : kinds) EXPECT_EQ(find_slot(file, path).kind, kind) << path;
}

TEST(Slot, TakesWhatTheReaderTakes) {
  CaseFile file;
  const Slot lead = find_slot(file, "mechanism.lead");
  EXPECT_EQ(slot_value(lead, "5 mm"), 0.005);
  EXPECT_EQ(slot_value(lead, 5.0, find_unit("mm", unit::length)), 0.005);
  for (const char* text : {"0 mm", "5", "5 kN", "\"5 mm\"", "", "1e40 m"}) EXPECT_FALSE(slot_value(lead, text)) << text;
  const Slot rollers = find_slot(file, "mechanism.rollers");
  EXPECT_EQ(slot_value(rollers, "9"), 9.0);
  for (const char* text : {"0", "9.5", "9 mm", "1001", "nine"}) EXPECT_FALSE(slot_value(rollers, text)) << text;
}

}  // namespace
}  // namespace prs::input
