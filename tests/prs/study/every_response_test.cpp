#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "prs/bodies/meshed.h"
#include "prs/input/document.h"
#include "prs/input/reader.h"
#include "prs/run/analyses.h"
#include "prs/study/design_engine.h"
#include "prs/study/response.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_directory.h"

namespace prs {
namespace {

constexpr Command kChains[] = {Command::contact, Command::solve, Command::slip, Command::life, Command::measures};

/// A study of the case of a source that varies nothing.
input::StudyInput study_of_base(const input::Source& source, Command command) {
  input::ErrorList errors(source);
  input::StudyInput in{source, input::read_document(source, errors), {}};
  std::erase_if(in.base.children, [](const input::Node& child) { return child.key == "study"; });
  in.study.command = command;
  in.study.plan = Plan::grid;
  return in;
}

/// Whether designs of a case are answered side by side, so that parts of their results are left out.
bool has_columns(const Case& c, Command command) {
  const bool equal = !c.load_cases.empty() && c.load_cases[0].share == LoadCase::Share::equal;
  if (command == Command::slip) return equal && !c.heat;
  return command == Command::solve && !equal && c.model.bodies == &kBars &&
         c.model.mechanism == ModelOptions::Mechanism::sector && c.model.loads == ModelOptions::Loads::at_rest;
}

/// Paths that are recorded together: those of one quantity, or all.
std::map<std::string, std::vector<std::string>> groups(const Json& document, bool one_by_one) {
  std::map<std::string, std::vector<std::string>> groups;
  for (const std::string& path : response_paths(document)) {
    const bool series = path.ends_with(".max");
    const std::string key = series ? path.substr(0, path.size() - 4) : path;
    std::vector<std::string>& group = groups[one_by_one ? key : ""];
    group.push_back(path);
    if (!series) continue;
    for (const char* word : {".min", ".mean", "[0]", "[0][0]"})
      if (response(document, key + word)) group.push_back(key + word);
  }
  return groups;
}

/// The study's row of the file's own design, its batches and its single runs against the document.
void expect_documented(const input::Source& source, Command command, const Json& document,
                       const std::vector<std::string>& paths, std::size_t& compared) {
  input::StudyInput in = study_of_base(source, command);
  in.study.responses = paths;
  const RowBlock row = DesignEngine(in).evaluate(0, 1);
  ASSERT_TRUE(row.failures.empty()) << row.failures[0].status.reason;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const double documented = *response(document, paths[k]);
    EXPECT_LE(std::abs(row.responses[k] - documented), 1e-7 * std::abs(documented) + 1e-12)
        << name(command) << ' ' << paths[k] << ": " << row.responses[k] << " of " << documented;
    ++compared;
  }
}

/// A response that a batch does not compute would be NaN in each row.
TEST(EveryResponse, OfEveryLessonIsTheSameInAStudyAndInTheDocument) {
  std::set<std::filesystem::path> lessons;
  for (const auto& entry : std::filesystem::directory_iterator(PRS_SOURCE_DIR "/configs"))
    if (entry.path().extension() == ".yaml") lessons.insert(entry.path());
  std::size_t compared = 0, lesson = 0;
  for (const std::filesystem::path& path : lessons) {
    if (test::content_of(path).find("\nmotion:") != std::string::npos) continue;  // A requirement, no case.
    if (test::sanitized() && lesson++ % 9 != 0) continue;
    SCOPED_TRACE(path.filename().string());
    const input::Source source = input::load_source(path.string(), {});
    const input::CaseInput in = input::read_case_input(source, Command::check);
    if (in.values.model.bodies == &kInfluence) continue;
    for (const AnyAnalysis& analysis : analyses()) {
      if (std::ranges::find(kChains, analysis.command) == std::end(kChains)) continue;
      if (!input::missing(in, analysis.command).empty()) continue;
      const Delivery found = run(analysis, source);
      if (!found.converged) continue;
      const Json document = found.document({});
      for (const auto& [key, group] : groups(document, has_columns(in.values, analysis.command)))
        expect_documented(source, analysis.command, document, group, compared);
    }
  }
  EXPECT_GT(compared, test::sanitized() ? 1000U : 10'000U);
}

}  // namespace
}  // namespace prs
