#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <filesystem>
#include <future>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "prs/engine/engine.h"
#include "prs/input/optimize_reader.h"
#include "prs/input/reader.h"
#include "prs/run/study.h"
#include "prs/sector/influence/influence_solver.h"
#include "prs/study/designs.h"
#include "prs/study/study_run.h"
#include "prs/threads/contacts.h"
#include "tests/prs/input/abevi.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_directory.h"

// Parallel work in one process: `scripts/test.sh --threads` runs these tests under the thread sanitizer.
namespace prs {
namespace {

using Json = nlohmann::ordered_json;

/// Runs the same work on two threads at once.
template <class Work>
void expect_same_on_two_threads(const Work& work) {
  auto other = std::async(std::launch::async, work);
  const auto here = work();
  EXPECT_EQ(other.get(), here);
  EXPECT_EQ(work(), here);
}

/// The CSV files of the lessons, by name.
Json tables() {
  Json texts = Json::object();
  for (const auto& entry : std::filesystem::directory_iterator(PRS_SOURCE_DIR "/configs"))
    if (entry.path().extension() == ".csv") texts[entry.path().filename().string()] = test::content_of(entry.path());
  return texts;
}

TEST(EngineThreads, TwoThatAskAtOnceGetTheAnswerOfOne) {
  SKIP_UNDER_SANITIZERS();  // Except under the thread sanitizer (scripts/test.sh --threads).
  const Json histories = tables();
  for (const auto& [command, lesson] :
       std::vector<std::pair<const char*, const char*>>{{"check", "11_real_parts"},
                                                        {"solve", "05_standard_screw"},
                                                        {"slip", "09_slip_and_dissipation"},
                                                        {"slip", "30_duty_cycle"},
                                                        {"solve", "26_unequal_rollers"},
                                                        {"solve", "33_tolerances"},
                                                        {"response", "34_reversal"},
                                                        {"size", "32_press"},
                                                        {"fit", "37_bench"},
                                                        {"preload", "12_preload"},
                                                        {"measures", "18_design_measures"},
                                                        {"report", "05_standard_screw"}}) {
    SCOPED_TRACE(lesson);
    const std::string yaml = test::content_of(PRS_SOURCE_DIR "/configs/" + std::string(lesson) + ".yaml");
    const std::string question = Json{{"command", command}, {"yaml", yaml}, {"histories", histories}}.dump();
    EXPECT_EQ(Json::parse(answer(question))["status"], 0);
    expect_same_on_two_threads([&] { return answer(question); });
  }
}

/// Numbers of all designs, bit by bit.
std::vector<std::uint64_t> bits_of(const StoredRows& rows) {
  std::vector<std::uint64_t> bits;
  for (std::size_t k = 0; k < rows.block_count(); ++k)
    for (const double number : rows.block(k).responses) bits.push_back(std::bit_cast<std::uint64_t>(number));
  return bits;
}

std::vector<std::uint64_t> studied(const input::StudyInput& in, std::size_t threads) {
  const DesignEngine engine = study_engine(in);
  const RunDesigns run = [&](const NextRange& next, const TakeRecord& take) {
    run_schedule(threads, 2, next, evaluate_with(engine), take);
  };
  return bits_of(
      run_study({"key", in.source, engine.study().responses, design_count(engine.study()), Shard{}}, nullptr, run, {}));
}

TEST(EngineThreads, StudiesOnTwoThreadsAreThoseOnOne) {
  SKIP_UNDER_SANITIZERS();  // Except under the thread sanitizer (scripts/test.sh --threads).
  for (const char* overrides :
       {"study.command=solve", "study.command=slip", "model={bodies: refined}", "model={mechanism: full}"}) {
    const std::string text = test::content_of(PRS_SOURCE_DIR "/configs/10_parametric_study.yaml");
    const input::StudyInput in = input::read_study_input(
        input::source_of_text("case.yaml", text,
                              {"study.command=solve", "mechanism.contacts_per_roller=4", overrides,
                               "study.factors=[{path: mechanism.rollers, values: [5, 6, 7, 8, 9]}, "
                               "{path: mechanism.lead, "
                               "values: [4 mm, 5 mm, 6 mm, 7 mm]}, {path: "
                               "\"load_cases[0].axial_force\", values: {from: 5 "
                               "kN, to: 60 kN, steps: 6}}]"}));
    EXPECT_EQ(studied(in, 2), studied(in, 1)) << overrides;
  }
}

TEST(EngineThreads, OptimizationsOnTwoThreadsAreThoseOnOne) {
  SKIP_UNDER_SANITIZERS();  // Except under the thread sanitizer (scripts/test.sh --threads).
  const std::string text = test::content_of(PRS_SOURCE_DIR "/configs/22_yao_optimum.yaml");
  const input::OptimizeInput in = input::read_optimize_input(
      input::source_of_text("case.yaml", text, {"optimize.generations=3", "optimize.population=12"}));
  const auto found = [&](std::size_t threads) {
    const auto result =
        run_optimization(in, threads, [](const JournalHeader& header) { return Journal::temporary(header); }, {});
    std::vector<std::uint64_t> bits;
    for (const EvaluatedDesign& design : result->search.designs)
      for (const double number : design.responses) bits.push_back(std::bit_cast<std::uint64_t>(number));
    return bits;
  };
  EXPECT_EQ(found(2), found(1));
}

TEST(EngineThreads, TwoThatShareACacheOfMatricesComputeTheSame) {
  SKIP_UNDER_SANITIZERS();  // Except under the thread sanitizer (scripts/test.sh --threads).
  const Case c = input::read_case_text(
      input::kAbevi, "case.yaml", {"mechanism.contacts_per_roller=2", "model={bodies: influence}"}, Command::solve);
  const Contacts contacts = find_contacts(c.mechanism, c.materials);
  const PerInterface<ContactLaw> laws = contact_laws(c, contacts);
  MatrixCache cache;
  expect_same_on_two_threads([&] {
    return influence_solver(c, contacts, laws, Direction::tension, *c.load_cases[0].position, cache)
        .solve(1000.0)
        .normal_load.screw;
  });
}

}  // namespace
}  // namespace prs
