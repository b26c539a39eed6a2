#include "prs/study/design_engine.h"
#include "prs/losses/slip_analysis.h"
#include "prs/losses/solve_analysis.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include "prs/heat/analyze_heat.h"
#include "prs/input/force_history.h"
#include "prs/input/reader.h"
#include "prs/life/analyze_life.h"
#include "prs/loads/analyze.h"
#include "prs/loads/load_analysis.h"
#include "prs/losses/life_analysis.h"
#include "prs/measures/measures.h"
#include "prs/measures/measures_analysis.h"
#include "prs/run/commands.h"
#include "prs/slip/slip.h"
#include "prs/study/designs.h"
#include "prs/study/response.h"
#include "tests/prs/input/abevi.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_directory.h"

namespace prs {
namespace {

using ::testing::HasSubstr;

input::StudyInput study_of(const std::string& study, const std::string& text = input::kAbevi) {
  return input::read_study_input({"case.yaml", text + "study: " + study + "\n", {}});
}

/// All designs at once.
RowBlock all(const DesignEngine& engine) { return engine.evaluate(0, design_count(engine.study())); }

std::optional<std::string> reason(const RowBlock& block, std::size_t row) {
  for (const RowBlock::Failure& failure : block.failures)
    if (failure.row == row) return failure.status.name + ": " + failure.status.reason;
  return std::nullopt;
}

/// Results of a command on a case, as documents and as responses.
struct Said {
  nlohmann::ordered_json document;
  std::function<std::optional<double>(const ResultNumber&)> read;
};

Said said_by(Command command, const Case& c, const input::Source& source) {
  if (command == Command::life) {
    std::optional<LoadHistory> history;
    if (c.life->history) history = input::read_force_history(*c.life->history, source);
    const auto lives = std::make_shared<LifeResult>(analyze_life(c, history));
    return {document_of(life_analysis(), *lives, {}), [lives](const ResultNumber& number) {
              return number.value({.contacts = lives->contacts, .life = &*lives});
            }};
  }
  const auto result = std::make_shared<MeasuresResult>();
  if (command == Command::measures)
    *result = analyze_measures(c);
  else
    result->analysis = command == Command::contact ? analyze_contacts(c)
                       : command == Command::slip  ? analyze_heat(c)
                                                   : analyze(c);
  const bool measures = command == Command::measures;
  return {measures ? document_of(measures_analysis(), *result, {})
                   : document_of(command == Command::slip ? slip_analysis() : solve_analysis(), result->analysis, {}),
          [result, measures](const ResultNumber& number) {
            const Result& analysis = result->analysis;
            Answer answer{.contacts = analysis.contacts};
            if (measures) answer.measures = &result->measures;
            if (analysis.heat_cycle) answer.cycle = &*analysis.heat_cycle;
            if (number.load_case) {
              const std::size_t k = *number.load_case;
              if (k >= analysis.load_cases.size()) return std::optional<double>();
              answer.load_case = &analysis.load_cases[k];
              if (measures && result->load_measures[k]) answer.load_measures = &*result->load_measures[k];
            }
            return number.value(answer);
          }};
}

TEST(DesignEngine, OfContactsAnswersTheFirstLoadCaseThatContactAnswers) {
  const std::string text = input::kAbeviThreads + R"(  rollers: 11
  contacts_per_roller: 4
materials: {youngs_modulus: 209 GPa, poisson_ratio: 0.3}
load_cases:
  - {axial_force: 20 kN, direction: tension, position: 10 mm}
  - {axial_force: 22 kN, share: equal}
  - {axial_force: 44 kN, share: equal}
)";
  const input::StudyInput in = study_of(
      "{command: contact, factors: [{path: 'load_cases[1].axial_force', values: [33 kN]}], "
      "responses: [axial_force_N, 'load_cases[1].axial_force_N', "
      "'screw.axial_load_N[3]']}",
      text);
  const RowBlock rows = all(DesignEngine(in));
  const double expected[] = {22e3, 44e3, 500.0, 33e3, 44e3, 750.0};  // Values as in the file, with 33 kN.
  ASSERT_EQ(rows.responses.size(), std::size(expected));
  EXPECT_TRUE(rows.failures.empty());
  for (std::size_t k = 0; k < std::size(expected); ++k) EXPECT_NEAR(rows.responses[k], expected[k], 1e-9 * expected[k]);
}

TEST(DesignEngine, StopsBetweenSlowDesignsAndKeepsThoseBefore) {
  const std::string text = test::content_of(PRS_SOURCE_DIR "/configs/09_slip_and_dissipation.yaml");
  for (const char* command : {"slip", "solve"}) {
    const bool full = std::string_view(command) == "solve";
    const input::StudyInput in =
        study_of(fmt::format("{{command: {}, factors: [{{path: mechanism.contacts_per_roller, values: [3, 4, "
                             "5, 6, 7]}}], responses: [screw.peak_pressure_MPa.max]}}",
                             command),
                 text + (full ? "model: {mechanism: full}\n" : ""));
    const DesignEngine engine(in);
    const RowBlock whole = all(engine);
    int asked = 0;
    const RowBlock some = engine.evaluate(1, 5, [&] { return ++asked >= 2; });
    ASSERT_EQ(some.rows, 2u) << command;
    ASSERT_EQ(some.responses.size(), 2u);
    EXPECT_EQ(some.responses[0], whole.responses[1]);
    EXPECT_EQ(some.responses[1], whole.responses[2]);
  }
}

/// Every number of a lesson's result for a command, those of further load cases, and summaries.
TEST(ResultNumber, SaysWhatTheDocumentSaysToEveryCommand) {
  const std::pair<const char*, Command> lessons[] = {
      {"07_contact_geometry", Command::contact}, {"03_load_sweep", Command::solve},
      {"14_flight_spectrum", Command::life},     {"18_design_measures", Command::measures},
      {"23_crowning", Command::measures},        {"26_unequal_rollers", Command::solve},
      {"28_driving_load", Command::slip},        {"30_duty_cycle", Command::slip}};
  // Numbers about the solution, not the design.
  const std::set<std::string> left{"iterations",       "relative_residual", "slip.evaluations", "slip.relative_residue",
                                   "heat.evaluations", "running.rounds",    "running.change"};
  std::size_t compared = 0;
  // Under sanitizers: contacts, measures, slip.
  for (std::size_t l = 0; l < std::size(lessons); l += test::sanitized() ? 3 : 1) {
    const auto& [lesson, command] = lessons[l];
    const input::Source source = input::load_source(std::string(PRS_SOURCE_DIR "/configs/") + lesson + ".yaml", {});
    const Said said = said_by(command, input::read_case_input(source, command).values, source);
    std::vector<std::string> paths = response_paths(said.document);
    for (std::size_t k = 0, count = paths.size(); k < count; ++k) {
      const std::string path = paths[k];
      if (!path.ends_with(".max")) continue;
      const std::string series = path.substr(0, path.size() - 4);
      for (const char* word : {".min", ".mean", "[0]", "[2]", "[0][1]", "[99]"}) paths.push_back(series + word);
    }
    for (std::size_t k = 0, count = paths.size(); k < count; ++k)
      for (const char* load_case : {"load_cases[0].", "load_cases[1].", "load_cases[77]."})
        paths.push_back(load_case + paths[k]);
    for (const char* more :
         {"life.cycles.matrix.count[1][2]", "life.cycles.matrix.count.max", "life.capacity.dynamic_capacity_range_N[1]",
          "contact.screw.normal[2]", "heat_cycle.temperature_degC.nut.mean"})
      paths.emplace_back(more);
    for (const std::string& path : paths) {
      const std::size_t end = path.starts_with("load_cases[") ? path.find('.') + 1 : 0;
      const std::optional<ResultNumber> number = result_number(path);
      if (left.contains(path.substr(end))) {
        EXPECT_FALSE(number) << path;
        continue;
      }
      const std::optional<double> documented = response(said.document, path);
      EXPECT_TRUE(number || !documented) << lesson << ": " << path;
      if (!number) continue;
      EXPECT_EQ(said.read(*number), documented) << lesson << ": " << path;
      compared += documented.has_value();
    }
  }
  EXPECT_GT(compared, test::sanitized() ? 300U : 3000U);
}

TEST(ResultNumber, SaysWhatTheDocumentSays) {
  for (const char* lesson : {"01_config_1_to_3", "05_standard_screw", "09_slip_and_dissipation"}) {
    const std::string file = std::string(PRS_SOURCE_DIR "/configs/") + lesson + ".yaml";
    const bool slips = lesson[0] == '0' && lesson[1] == '9';
    const Case c = input::read_case(file, {}, slips ? Command::slip : Command::solve);
    const Result result = slips ? analyze_slip(c) : analyze(c);
    const auto document = document_of(slips ? slip_analysis() : solve_analysis(), result, {});
    std::vector<std::string> paths = response_paths(document);
    for (const char* more : {"nut.peak_pressure_MPa.min", "screw.approach_um.mean", "nut.load_rate_percent[3]",
                             "load_cases[1].axial_displacement_um"})
      paths.emplace_back(more);
    std::size_t known = 0;
    for (const std::string& path : paths) {
      const std::optional<ResultNumber> number = result_number(path);
      if (!number) continue;
      ++known;
      const LoadCaseResult* of = number->load_case ? &result.load_cases.at(*number->load_case) : nullptr;
      EXPECT_EQ(number->value({result.contacts, of}), response(document, path)) << path;
    }
    EXPECT_GE(known, slips ? 75U : 45U) << lesson;
    for (const std::string& path : default_responses(slips ? Command::slip : Command::solve))
      EXPECT_TRUE(result_number(path)) << path;
  }
}

TEST(ResultNumber, LeavesToTheDocumentWhatNoTableKnows) {
  for (const char* path : {"name", "", ".", "screw", "screw.peak_pressure_MPa", "screw.peak_pressure_MPa.most",
                           "screw.peak_pressure_MPa[x]", "screw.peak_pressure_MPa[1].max", "load_cases",
                           "load_cases[0]", "load_cases[0]axial_displacement_um", "contact.screw", "contact.roller.x",
                           "slip.share_percent", "contact.screw.normal", "iterations"})
    EXPECT_FALSE(result_number(path)) << path;
}

TEST(DesignEngine, DesignGivesWhatTheCommandGives) {
  for (const char* bodies : {"bars", "refined"}) {
    const std::string text = input::kAbevi + "model: {bodies: " + bodies + "}\n";
    const input::StudyInput in = study_of(
        "{command: solve, plan: one_at_a_time, factors: [{path: mechanism.rollers, values: [9, "
        "60]}], responses: [axial_displacement_um, 'load_cases[3].nut.load_rate_percent[19]', "
        "contact.nut.normal_angle_deg, axial_stiffness_N_per_um]}",
        text);
    const DesignEngine engine(in);
    const RowBlock block = all(engine);
    const Result direct = analyze(input::read_case_text(text, "case.yaml", {"mechanism.rollers=9"}, Command::solve));
    const double* row = block.responses.data() + 4;
    const LoadCaseResult& pull = direct.load_cases[0];
    EXPECT_NEAR(row[0] / (*pull.axial_displacement * 1e6), 1.0, 1e-10);
    EXPECT_NEAR(row[1] / (100.0 * direct.load_cases[3].threads->nut.load_rate[19]), 1.0, 1e-10);
    EXPECT_NEAR(row[2] / 45.0592, 1.0, 1e-4);
    EXPECT_NEAR(row[3] / (*pull.axial_stiffness * 1e-6), 1.0, 1e-10);
    EXPECT_THAT(*reason(block, 2), testing::StartsWith("refused: mechanism.rollers: got 60"));
    EXPECT_TRUE(std::isnan(block.responses[8]));
    EXPECT_FALSE(reason(block, 1));
  }
}

/// If the chain has too few digits the study solves as the command does.
TEST(DesignEngine, DeliversWhateverTheCommandSolves) {
  const std::string factors[] = {"structure.roller.guidance={ring: 1 N/m}", "structure.screw.free_length=1e-12 mm"};
  for (const std::string& factor : factors) {
    const std::size_t equals = factor.find('=');
    const input::StudyInput in =
        study_of("{command: solve, plan: grid, factors: [{path: " + factor.substr(0, equals) + ", values: [" +
                 factor.substr(equals + 1) + "]}], responses: [axial_displacement_um, tangent_stiffness_N_per_um]}");
    const RowBlock block = all(DesignEngine(in));
    ASSERT_TRUE(block.failures.empty()) << *reason(block, 1);
    const double* row = block.responses.data() + 2;  // behind the base case
    const Result direct = analyze(input::read_case_text(input::kAbevi, "case.yaml", {factor}, Command::solve));
    const LoadCaseResult& pull = direct.load_cases[0];
    ASSERT_TRUE(pull.converged()) << factor;
    EXPECT_NEAR(row[0] / (*pull.axial_displacement * 1e6), 1.0, 1e-9) << factor;
    EXPECT_NEAR(row[1] / (*pull.tangent_stiffness * 1e-6), 1.0, 1e-9) << factor;
  }
}

TEST(DesignEngine, DocumentAndTablesGiveTheSame) {
  const std::string factors = "factors: [{path: mechanism.flank_angle, values: {from: 40 deg, to: 50 deg, steps: 5}}]";
  const input::StudyInput by_tables = study_of("{command: solve, plan: one_at_a_time, " + factors +
                                               ", responses: [axial_displacement_um, nut.peak_pressure_MPa.max]}");
  const input::StudyInput by_document =
      study_of("{command: solve, plan: one_at_a_time, " + factors +
               ", responses: [axial_displacement_um, nut.peak_pressure_MPa.max, iterations]}");
  const RowBlock a = all(DesignEngine(by_tables)), b = all(DesignEngine(by_document));
  for (std::size_t row = 0; row < a.rows; ++row)
    for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(a.responses[2 * row + k] / b.responses[3 * row + k], 1.0, 1e-10);
}

/// Responses of other load cases than the first, of stresses below the surface, and of lives.
TEST(DesignEngine, GivesWhatTheCommandGivesWhateverTheResponse) {
  const std::string measures = "measures: {friction_coefficient: 0.01}\n",
                    life =
                        "life: {position: 30 mm, spectrum: [{force: 20 kN, direction: tension, share: "
                        "0.3}, {force: 9 kN, direction: compression, share: 0.7}]}\n";
  struct Asked {
    Command command;
    std::string name, case_text;
    std::vector<std::string> responses;
  };
  const Asked asked[] = {
      {Command::solve,
       "solve",
       "",
       {"screw.max_shear_stress_MPa.max", "load_cases[7].nut.max_shear_depth_mm[3]",
        "contact.nut.max_shear_over_peak_pressure", "load_cases[2].axial_displacement_um"}},
      {Command::measures,
       "measures",
       measures,
       {"measures.largest_load_rate_percent", "load_cases[1].measures.largest_load_rate_percent",
        "load_cases[9].measures.thread_static_safety", "measures.dynamic_capacity_N",
        "load_cases[40].screw.peak_pressure_MPa.max"}},
      {Command::measures,
       "measures",
       measures,
       {"load_cases[3].measures.yang_largest_load_rate_percent", "load_cases[3].measures.yang_load_rate_percent[19]",
        "load_cases[3].measures.l10_revolutions", "screw.max_shear_stress_MPa.mean"}},
      {Command::life,
       "life",
       life,
       {"life.system.l10_revolutions", "life.tension.screw.l10_revolutions[3]", "life.weakest_thread.thread",
        "life.capacity.dynamic_capacity_range_N[0]", "life.compression.static_safety"}}};
  for (const Asked& a : asked) {
    std::string responses;
    for (const std::string& path : a.responses) responses += ", '" + path + "'";
    const input::StudyInput in =
        study_of("{command: " + a.name +
                     ", plan: one_at_a_time, factors: [{path: mechanism.flank_angle, values: [42 "
                     "deg, 48 deg]}, {path: mechanism.rollers, values: [60]}, {path: "
                     "deviations.crowning, values: [4 um]}], "
                     "responses: [" +
                     responses.substr(2) + "]}",
                 input::kAbevi + "deviations: {crowning: 0 um}\n" + a.case_text);
    const DesignEngine engine(in);
    const RowBlock block = all(engine);
    std::size_t answered = 0;
    for (std::size_t row = 0; row < block.rows; ++row) {
      if (reason(block, row)) continue;
      ++answered;
      const input::Source source{"case.yaml", in.source.text, overrides(engine.study(), draws(engine.study(), row))};
      const Said said = said_by(a.command, input::read_case_input(source, a.command).values, source);
      for (std::size_t k = 0; k < a.responses.size(); ++k) {
        const std::optional<double> expected = response(said.document, a.responses[k]);
        ASSERT_TRUE(expected) << a.responses[k];
        EXPECT_NEAR(block.responses[row * a.responses.size() + k] / *expected, 1.0, 1e-10)
            << a.responses[k] << " of row " << row;
      }
    }
    EXPECT_EQ(answered, block.rows - 1) << a.name;  // All except the sixty rollers.
  }
}

TEST(DesignEngine, CutsDoNotMatter) {
  for (const char* command : {"solve", "contact"}) {
    const input::StudyInput in =
        study_of(std::string("{command: ") + command +
                 ", plan: latin_hypercube, samples: 60, factors: [{path: mechanism.flank_angle, within: "
                 "0.2}, {path: mechanism.rollers, values: [9, 10, 11, 99]}, {path: "
                 "mechanism.contacts_per_roller, values: [8, 17, 20]}], responses: "
                 "[contact.screw.hertz_constant_N_per_mm1_5" +
                 (command[0] == 's' ? ", axial_displacement_um]}" : "]}"));
    const DesignEngine engine(in);
    const RowBlock whole = all(engine);
    EXPECT_FALSE(whole.failures.empty());
    EXPECT_LT(whole.failures.size(), 40U);
    const std::size_t responses = engine.study().responses.size();
    for (const std::size_t cut : {1U, 7U, 13U})
      for (std::size_t first = 0; first < whole.rows; first += cut) {
        const RowBlock part = engine.evaluate(first, std::min(cut, whole.rows - first));
        EXPECT_EQ(std::memcmp(part.responses.data(), whole.responses.data() + first * responses,
                              part.responses.size() * sizeof(double)),
                  0);
        for (std::size_t row = 0; row < part.rows; ++row) EXPECT_EQ(reason(part, row), reason(whole, first + row));
      }
  }
}

TEST(DesignEngine, DesignsByTheirDrawsGiveWhatTheyGiveByIndex) {
  for (const char* command : {"solve", "contact"}) {
    const input::StudyInput in =
        study_of(std::string("{command: ") + command +
                 ", plan: latin_hypercube, samples: 80, factors: [{path: mechanism.flank_angle, within: "
                 "0.2}, {path: mechanism.rollers, values: [9, 10, 99], with: [{path: "
                 "mechanism.contacts_per_roller, values: [8, 17, 20]}]}], responses: "
                 "[contact.screw.hertz_constant_N_per_mm1_5" +
                 (command[0] == 's' ? ", axial_displacement_um]}" : "]}"));
    const DesignEngine engine(in);
    const RowBlock by_index = all(engine);
    std::vector<std::vector<Draw>> designs;
    for (std::size_t k = 0; k < by_index.rows; ++k) designs.push_back(draws(engine.study(), k));
    const RowBlock by_draws = engine.evaluate(designs);
    EXPECT_FALSE(by_index.failures.empty());
    ASSERT_EQ(by_draws.responses.size(), by_index.responses.size());
    EXPECT_EQ(
        std::memcmp(by_draws.responses.data(), by_index.responses.data(), by_index.responses.size() * sizeof(double)),
        0);
    for (std::size_t row = 0; row < by_index.rows; ++row) EXPECT_EQ(reason(by_draws, row), reason(by_index, row));

    // A design that no plan drew, compared with the program's own reading of its texts.
    const std::vector<Draw> own{{.kind = Draw::Kind::number, .number = 44.25}, {.kind = Draw::Kind::level, .level = 1}};
    const Case c = input::read_case_text(input::kAbevi, "case.yaml", overrides(engine.study(), own), Command::solve);
    EXPECT_EQ(c.mechanism.rollers, 10);
    EXPECT_EQ(c.mechanism.contacts_per_roller, 17);
    const RowBlock one = engine.evaluate({designs[3], own});
    const std::size_t responses = engine.study().responses.size();
    EXPECT_EQ(std::memcmp(one.responses.data(), by_index.responses.data() + 3 * responses, responses * sizeof(double)),
              0);
    if (command[0] == 's') {
      EXPECT_NEAR(one.responses[responses + 1] / (*analyze(c).load_cases[0].axial_displacement * 1e6), 1.0, 1e-10);
    }
  }
}

TEST(DesignEngine, UnknownResponseNamesTheNearest) {
  const input::StudyInput in = study_of(
      "{command: solve, plan: one_at_a_time, factors: [{path: mechanism.rollers, values: [9]}], "
      "responses: [axial_displacement_um, nut.peak_pressure_MPa.mx]}");
  try {
    const DesignEngine engine(in);
    FAIL();
  } catch (const UnknownResponse& error) {
    EXPECT_EQ(error.index(), 1U);
    EXPECT_THAT(error.what(), HasSubstr("did you mean `nut.peak_pressure_MPa.max`?"));
  }
}

/// Lesson 33 with its first design only.
input::Source tolerances_of(const std::string& responses) {
  return input::load_source(
      PRS_SOURCE_DIR "/configs/33_tolerances.yaml",
      {"study.samples=1", "load_cases[1].modes.positions=1", "study.responses=[" + responses + "]"});
}

TEST(DesignEngine, ModesAreComputedWhereAResponseNeedsThem) {
  struct Asked {
    const char *command, *path;
    bool needed;
  };
  for (const auto& [command, path, needed] :
       {Asked{"solve", "load_cases[1].modes.mass_kg.x", true},
        {"solve", "travel.variation_one_turn_um", false},
        {"measures", "load_cases[1].measures.lowest_frequency_Hz", true},
        {"measures", "load_cases[1].measures.speeds_to_avoid_rpm[0]", true},
        {"measures", "load_cases[1].measures.thread_stiffness_N_per_um", false}}) {
    input::Source source = tolerances_of(fmt::format("\"{}\"", path));
    source.overrides.push_back(fmt::format("study.command={}", command));
    const input::StudyInput in = input::read_study_input(source);
    EXPECT_EQ(DesignEngine(in).needs_modes(), needed) << path;
  }
  const std::string frequency = "\"load_cases[table].modes.mode[0].frequency_Hz\"",
                    stiffness = "\"load_cases[table].axial_stiffness_N_per_um\"";
  const auto numbers = [](const std::string& responses) {
    const input::StudyInput in = input::read_study_input(tolerances_of(responses));
    return DesignEngine(in).evaluate(0, 1).responses;
  };
  const std::vector<double> with = numbers(frequency + ", " + stiffness), without = numbers(stiffness);
  const Json solved = run(analysis_of(Command::solve), tolerances_of(stiffness)).document({});
  EXPECT_DOUBLE_EQ(with.at(0), solved.at("load_cases").at(1).at("modes").at("mode").at(0).at("frequency_Hz"));
  EXPECT_EQ(with.at(1), without.at(0));
}

TEST(DesignEngine, TheComplianceOfTheScrewsEndIsThatOfTheDocument) {
  const std::string path = "screw_end.compliance_SI[0][0]";
  const input::StudyInput in = input::read_study_input(tolerances_of('"' + path + '"'));
  const std::vector<double> found = DesignEngine(in).evaluate(0, 1).responses;
  const Json solved = run(analysis_of(Command::solve), in.source).document({});
  EXPECT_NEAR(found.at(0) / solved.at("load_cases").at(0).at("screw_end").at("compliance_SI").at(0).at(0).get<double>(),
              1.0, 1e-9);
}

/// The lesson, compared with the thesis.
class ParametricStudy : public testing::Test {
 protected:
  ParametricStudy()
      : input_(input::read_study_input(input::load_source(PRS_SOURCE_DIR "/configs/10_parametric_study.yaml", {}))),
        engine_(input_),
        block_(all(engine_)) {}

  double at(std::size_t row, const std::string& path) const {
    const std::vector<std::string>& paths = engine_.study().responses;
    const auto k = static_cast<std::size_t>(std::ranges::find(paths, path) - paths.begin());
    return block_.responses[row * paths.size() + k];
  }
  std::vector<std::size_t> rows(const std::string& path) const {
    std::vector<std::size_t> found;
    for (std::size_t row = 1; row < block_.rows; ++row) {
      const Design d = design(engine_.study(), row);
      if (!reason(block_, row) && engine_.study().factors[d.settings.at(0).factor].path == path) found.push_back(row);
    }
    return found;
  }

  input::StudyInput input_;
  DesignEngine engine_;
  RowBlock block_;
};

TEST_F(ParametricStudy, ReproducesSandu) {
  EXPECT_NEAR(at(0, "slip.efficiency"), 0.786, 0.002);  // Sandu 2018, section 3.3.
  EXPECT_GT(at(0, "slip.share_percent.screw"), 90.0);
  const auto spread = [&](const std::string& path) {
    double least = 1.0, largest = 0.0;
    for (const std::size_t row : rows(path)) {
      least = std::min(least, at(row, "slip.efficiency"));
      largest = std::max(largest, at(row, "slip.efficiency"));
    }
    return largest - least;
  };
  for (const char* path : {"mechanism.pitch_diameter.screw", "mechanism.lead", "mechanism.rollers",
                           "mechanism.profile.screw", "mechanism.profile.roller"})
    EXPECT_LT(spread(path), 0.012) << path;
  EXPECT_GT(spread("lubricant.viscosity"), 0.15);
  EXPECT_GT(spread("lubricant.eyring_stress"), 0.25);

  // Power is proportional to the speed, within the effect of the film.
  for (const std::size_t row : rows("operation.speed")) {
    const double speed = *design(engine_.study(), row).settings[0].level.number / 400.0;
    EXPECT_NEAR(at(row, "slip.power_loss_W") / speed / at(0, "slip.power_loss_W"), 1.0, 0.03);
  }
  // The fit (3.55) is close.
  for (const std::size_t row : rows("lubricant.viscosity"))
    EXPECT_NEAR(at(row, "slip.efficiency_fit"), at(row, "slip.efficiency"), 0.006);
}

TEST_F(ParametricStudy, LevelOfTheFileGivesTheBaseCase) {
  int found = 0;
  for (std::size_t row = 1; row < block_.rows; ++row) {
    if (!is_base(engine_.study(), design(engine_.study(), row))) continue;
    ++found;
    EXPECT_NEAR(at(row, "slip.efficiency"), at(0, "slip.efficiency"), 1e-12);
  }
  EXPECT_GE(found, 9);
}

}  // namespace
}  // namespace prs
