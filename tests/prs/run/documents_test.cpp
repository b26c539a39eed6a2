#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "fe/cholesky.h"
#include "prs/run/analyses.h"
#include "prs/run/document_schema.h"
#include "support/program.h"
#include "support/sanitized.h"
#include "support/temporary_directory.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

const std::filesystem::path kConfigs = PRS_SOURCE_DIR "/configs";

std::vector<std::filesystem::path> all_lessons() {
  std::vector<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(kConfigs))
    if (file.path().extension() == ".yaml") files.push_back(file.path());
  return files;
}

Json document_of(const AnyAnalysis& row, const input::Source& source) {
  return run(row, source).document(document_info(source, row.command));
}

/// Runs `use` on every lesson and command for which it is complete.
void for_each_run(const auto& use) {
  for (const std::filesystem::path& file : all_lessons()) {
    const input::Source source = input::load_source(file.string(), {});
    if (other_file(source)) continue;
    const input::CaseInput in = input::read_case_input(source, Command::check);
    for (const AnyAnalysis& row : analyses())
      if (row.run && input::missing(in, row.command).empty()) use(row, source);
  }
}

/// The document of a study or an optimization.
Json printed(const std::string& arguments) {
  const test::Outcome run = test::run_prs(arguments + " --json --quiet");
  EXPECT_TRUE(run.status == 0 || run.status == 3) << arguments << run.err;
  return Json::parse(run.out);
}

double largest(const Json& value) {
  if (value.is_number()) return std::abs(value.get<double>());
  double size = 0.0;
  if (value.is_structured())
    for (const Json& item : value) size = std::max(size, largest(item));
  return size;
}

/// Compares numbers to 1e-12 relative, in a list and among reactions, which nearly cancel, relative to the largest;
/// values of a travel and modes are small against displacements of 50 um and 50 kg; on a flat curve the highest point
/// moves by the root of its values. The history of the solver is ignored.
void expect_agreement(const Json& a, const Json& b, const std::string& path, double scale = 0.0) {
  static const std::set<std::string> of_the_way = {"newton_history",    "factorization",    "iterations",
                                                   "relative_residual", "relative_residue", "interpolation_error",
                                                   "axial_error_um",    "rounds",           "change"};
  if (a.is_number() && b.is_number()) {
    const bool moves = path.find("/travel/") != path.npos || path.find("/modes/") != path.npos;
    if (moves) scale = std::max(scale, 50.0);
    const bool of_a_duty = path.find("heat_cycle") != path.npos || path.find("duty_cycle.yaml check") != path.npos;
    const double share = path.find("depth") != path.npos ? 1e-7 : moves || of_a_duty ? 1e-11 : 1e-12;
    const double x = a.get<double>(), y = b.get<double>();
    EXPECT_LE(std::abs(x - y), share * std::max(scale, std::abs(y))) << path << ' ' << x;
    return;
  }
  ASSERT_EQ(a.type(), b.type()) << path;
  if (!a.is_structured()) {
    EXPECT_EQ(a, b) << path;
    return;
  }
  ASSERT_EQ(a.size(), b.size()) << path;
  const bool shared = a.is_array() || path.ends_with("/reactions");
  const bool within = path.find("/reactions") != path.npos || path.ends_with("/friction_force_N");
  const double of_all = shared ? std::max(scale, largest(b)) : within ? scale : 0.0;
  for (const auto& [key, value] : a.items())
    if (!of_the_way.contains(key)) {
      ASSERT_TRUE(a.is_array() || b.contains(key)) << path << '/' << key;
      const Json& other = a.is_array() ? b[std::stoul(key)] : b[key];
      // Friction of contacts that roll is rounding of their loads.
      expect_agreement(value, other, path + '/' + key,
                       !a.is_array() && key == "friction_force_N" ? largest(b["normal_load_N"]) : of_all);
    }
}

constexpr const char* kLongRuns[] = {
    "study configs/10_parametric_study.yaml",
    "study configs/15_sensitivity.yaml --set study.samples=40",
    "study configs/15_sensitivity.yaml --set study.plan=sobol_indices --set study.samples=16",
    "study configs/17_derivatives.yaml",
    "study configs/21_jung_envelope.yaml",
    "optimize configs/22_yao_optimum.yaml --set optimize.generations=3 --set optimize.check=nspso",
    "optimize configs/23_crowning.yaml --set optimize.generations=2 --set optimize.population=8",
    "configurations --screw-diameter 21mm --lead 5mm",
};

/// Keeps three items of each long list: hundreds of the same kind follow.
void shorten(Json& document) {
  if (document.is_array() && document.size() > 20) document.erase(document.begin() + 3, document.end());
  for (Json& item : document)
    if (item.is_structured()) shorten(item);
}

/// Errors found by jsonschema: one line per document with the name of its schema.
std::string verdict(const std::vector<std::pair<std::string, Json>>& documents) {
  const test::TemporaryDirectory folder;
  const auto save = [&](const std::string& name, const Json& json) {
    std::ofstream(folder.path() / name) << json.dump();
  };
  Json list = Json::array();
  std::set<std::string> saved;
  for (const auto& [command, document] : documents) {
    if (saved.insert(command).second) save(command, document_schema(command));
    list.push_back({command, document});
  }
  save("documents", list);
  std::ofstream(folder.path() / "check.py") << "import json\n"
                                               "from functools import cache\n"
                                               "from jsonschema import Draft202012Validator as Validator\n"
                                               "@cache\n"
                                               "def schema(name):\n"
                                               "    Validator.check_schema(read := json.load(open(name)))\n"
                                               "    return Validator(read)\n"
                                               "for name, document in json.load(open('documents')):\n"
                                               "    for error in list(schema(name).iter_errors(document))[:1]:\n"
                                               "        print(name, error.json_path, error.message[:300])\n";
  const std::string command =
      "cd '" + folder.path().string() + "' && python3 check.py >found 2>&1 || echo failed >>found";
  EXPECT_EQ(std::system(command.c_str()), 0);
  return test::content_of(folder.path() / "found");
}

/// Compares each whole document, computed once: CHOLMOD's and Eigen's factorizations give the same. The resolved input
/// states overrides and defaults; files that it refers to keep their places.
TEST(Documents, OfEveryLessonAndCommandAreAsTheirSchemaSaysAndComeAgainFromTheirResolvedInput) {
  SKIP_UNDER_SANITIZERS();  // `LessonReport` covers all lessons under sanitizers.
  std::vector<std::pair<std::string, Json>> documents;
  int factorized = 0;
  for_each_run([&](const AnyAnalysis& row, const input::Source& source) {
    Json document = document_of(row, source);
    const std::string text = document["resolved_input"].dump();
    Json again = document_of(row, input::source_of_text("again", text, {}, kConfigs));
    Json first = document;
    for (Json* d : {&first, &again})
      for (const char* key : {"case_file", "input_sha256", "overrides", "input"}) d->erase(key);
    EXPECT_TRUE(first == again) << source.name << ' ' << name(row.command);
    fe::factorize_by_eigen(true);
    const Json by_eigen = document_of(row, source);
    fe::factorize_by_eigen(false);
    // Impacts amplify rounding, and so do the differences of a fit.
    if (row.command != Command::response && row.command != Command::fit)
      expect_agreement(document, by_eigen, source.name + ' ' + std::string(name(row.command)));
    factorized += document.dump().find("\"factorization\":\"CHOLMOD") != std::string::npos &&
                  by_eigen.dump().find("\"factorization\":\"Eigen") != std::string::npos;
    shorten(document);
    documents.emplace_back(name(row.command), std::move(document));
  });
  EXPECT_GT(factorized, 50);
  const test::TemporaryDirectory folder;
  const std::filesystem::path file = folder.path() / "again.yaml";
  for (const std::string run : kLongRuns) {
    const std::string command = run.substr(0, run.find(' '));
    Json document = printed(run);
    documents.emplace_back(command, document);
    shorten(documents.back().second);
    if (command == "configurations") continue;
    std::ofstream(file) << document["resolved_input"];
    Json again = printed(command + " '" + file.string() + "'");
    for (Json* d : {&document, &again})
      for (const char* key : {"case_file", "input_sha256", "overrides"}) d->erase(key);
    EXPECT_TRUE(document == again) << run;
  }
  documents.emplace_back("solve", printed("solve configs/01_config_1_to_3.yaml --figures"));
  shorten(documents.back().second);
  EXPECT_EQ(verdict(documents), "");
}

TEST(Documents, TheirSchemasKnowEveryKeyAndTheTypeOfItsValue) {
  const input::Source source = input::load_source((kConfigs / "09_slip_and_dissipation.yaml").string(), {});
  const Json document = document_of(analysis_of(Command::slip), source);
  const auto with = [&](const char* pointer, Json value) {
    Json changed = document;
    changed[Json::json_pointer(pointer)] = std::move(value);
    return std::pair<std::string, Json>("slip", std::move(changed));
  };
  Json headless = document;
  headless.erase("command");
  const std::string found = verdict({with("/efficiency", 0.9),
                                     with("/load_cases/0/slip/efficency", 0.9),
                                     with("/load_cases/0/slip/efficiency", "90 %"),
                                     with("/command", "solve"),
                                     with("/load_cases/0/screw/axial_load_N/0", "1 N"),
                                     with("/resolved_input/mechanism/lead", 5),
                                     {"slip", headless}});
  EXPECT_EQ(std::ranges::count(found, '\n'), 7) << found;
  EXPECT_THAT(found, testing::HasSubstr("efficency"));
}

TEST(Documents, SayWhichCommandMadeThemOfWhichFile) {
  const Json document = printed("solve configs/01_config_1_to_3.yaml --set mechanism.rollers=9");
  EXPECT_EQ(document["command"], "solve");
  EXPECT_EQ(document["case_file"], "configs/01_config_1_to_3.yaml");
  EXPECT_EQ(document["resolved_input"]["mechanism"]["rollers"], 9);
  EXPECT_EQ(document["resolved_input"]["mechanism"]["geometry"], "simulation");
  EXPECT_EQ(document["resolved_input"]["load_cases"][0]["axial_force"], "45 kN");
}

}  // namespace
}  // namespace prs
