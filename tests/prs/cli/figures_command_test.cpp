#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "support/program.h"
#include "support/sanitized.h"
#include "support/temporary_directory.h"

namespace prs {
namespace {

using testing::HasSubstr;

/// Whether each picture of the documents conforms to the schema, by jsonschema.
bool agree(const std::filesystem::path& schema, const std::filesystem::path& documents) {
  const std::string command =
      "python3 -c 'import json, sys; from jsonschema import Draft202012Validator as V\n"
      "V.check_schema(schema := json.load(open(sys.argv[1])))\n"
      "for file in sys.argv[2:]:\n"
      "  for figure in json.load(open(file))[\"figures\"]: V(schema).validate(figure)' '" +
      schema.string() + "' '" + documents.string() + "'/*";
  return std::system(command.c_str()) == 0;
}

TEST(FiguresCommand, DocumentsHoldThemAsTheirSchemaSays) {
  SKIP_UNDER_SANITIZERS();
  const test::TemporaryDirectory temporary;
  ASSERT_EQ(test::run_prs("schema figures --quiet --output '" + temporary.path().string() + "'").status, 0);
  const std::filesystem::path documents = temporary.path() / "documents";
  std::filesystem::create_directory(documents);
  const auto expect = [&](const std::string& arguments, const std::set<std::string>& wanted) {
    const test::Outcome run = test::run_prs(arguments + " --figures --json --quiet");
    ASSERT_EQ(run.status, 0) << run.err;
    std::set<std::string> names;
    const auto parsed = nlohmann::json::parse(run.out);
    for (const auto& figure : parsed.at("figures")) names.insert(figure.at("name"));
    for (const std::string& name : wanted) EXPECT_TRUE(names.contains(name)) << name;
    std::ofstream(documents / (arguments.substr(0, arguments.find(' ')) + ".json")) << run.out;
  };
  expect("contact configs/07_contact_geometry.yaml", {"contact_xy", "contact_ellipses"});
  expect("solve configs/03_load_sweep.yaml", {"load_distribution", "stiffness", "butterfly"});
  expect("slip configs/09_slip_and_dissipation.yaml", {"power_by_source", "slip_patches_1"});
  expect("preload configs/12_preload.yaml", {"preload"});
  expect("life configs/14_flight_spectrum.yaml", {"rainflow", "thread_lives"});
  expect("measures configs/18_design_measures.yaml", {"yang", "stiffness_terms"});
  expect("study configs/17_derivatives.yaml", {});
  EXPECT_TRUE(agree(temporary.path() / "prs.figures.json", documents));
}

TEST(FiguresCommand, WithoutTheFlagDocumentsHoldNone) {
  const test::Outcome run = test::run_prs("solve configs/01_config_1_to_3.yaml --json --quiet");
  EXPECT_FALSE(nlohmann::json::parse(run.out).contains("figures"));
}

TEST(FiguresCommand, TheFlagNeedsADocumentAndTakesNoValue) {
  const test::Outcome table = test::run_prs("solve configs/01_config_1_to_3.yaml --figures");
  EXPECT_EQ(table.status, 0);
  EXPECT_THAT(table.err, HasSubstr("--figures has no effect without a document; add --json or"));
  EXPECT_EQ(test::run_prs("solve configs/01_config_1_to_3.yaml --json --figures=no").status, 2);
  EXPECT_EQ(test::run_prs("schema result").status, 2);
}

}  // namespace
}  // namespace prs
