#include "prs/export/fmu.h"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>

#include "prs/export/zip.h"
#include "tests/support/program.h"

namespace prs {
namespace {

using test::Outcome;
using test::run_prs;
using testing::HasSubstr;

SystemModel standard_screw(std::vector<std::string> overrides = {}) {
  return system_model(input::load_source(PRS_SOURCE_DIR "/configs/05_standard_screw.yaml", std::move(overrides)), {});
}

TEST(Zip, IsWhatOthersRead) {
  const test::TemporaryDirectory folder;
  const std::vector<OutputFile> files{{"a.txt", "one\n"}, {"b/c.bin", std::string("\0\xff", 2)}};
  std::ofstream(folder.path() / "x.zip", std::ios::binary) << zip(files);
  const std::string in = "cd '" + folder.path().string() + "' && python3 -m zipfile ";
  ASSERT_EQ(std::system((in + "-t x.zip >out").c_str()), 0);
  ASSERT_EQ(std::system((in + "-e x.zip . >>out").c_str()), 0);
  for (const OutputFile& file : files) EXPECT_EQ(test::content_of(folder.path() / file.name), file.content);
}

TEST(SystemModel, TheSameCaseGivesTheSameBytes) {
  const SystemModel a = standard_screw(), b = standard_screw();
  EXPECT_EQ(functional_mockup_unit(a), functional_mockup_unit(b));
  const SystemModel other = standard_screw({"mechanism.rollers=9"});
  EXPECT_NE(functional_mockup_unit(a), functional_mockup_unit(other));
}

TEST(SystemModel, NamesAreIdentifiers) {
  EXPECT_EQ(model_name("a/12_pre-load.v2.yaml"), "screw_12_pre_load_v2");
  EXPECT_EQ(model_name("Screw.yaml"), "Screw");
  EXPECT_EQ(model_name("<stdin>"), "screw__stdin_");
  EXPECT_EQ(model_name("model.yaml"), "screw_model");  // A reserved word of Modelica.
}

/// The numbers of a list in a Modelica package.
std::vector<double> list_of(const std::string& package, const std::string& name) {
  const std::size_t start = package.find('{', package.find(" " + name + "[:]"));
  const std::string text = package.substr(start + 1, package.find('}', start) - start - 1);
  std::vector<double> numbers;
  static const std::regex number("[^,\\s]+");
  for (auto at = std::sregex_iterator(text.begin(), text.end(), number); at != std::sregex_iterator(); ++at)
    numbers.push_back(std::stod(at->str()));
  return numbers;
}

TEST(SystemModel, ModelicaHasTheNodesToTheLastDigit) {
  const SystemModel model = standard_screw();
  const std::string package = modelica_package(model.curves, model.text);
  EXPECT_EQ(list_of(package, "tension_at"), model.curves.senses.tension.at);
  EXPECT_EQ(list_of(package, "tension_force"), model.curves.senses.tension.force);
  EXPECT_EQ(list_of(package, "compression_slope"), model.curves.senses.compression.slope);
}

TEST(Export, WritesFilesOrIntoFolders) {
  const test::TemporaryDirectory folder;
  const std::string of = "export '" PRS_SOURCE_DIR "/configs/05_standard_screw.yaml' --quiet ";
  const auto run = [&](const std::string& options) { return run_prs(of + options, folder.path()); };
  EXPECT_EQ(run("--fmu").status, 0);
  EXPECT_EQ(run("--fmu --modelica --output models").status, 0);
  EXPECT_EQ(run("--modelica --output one.mo").status, 0);
  for (const char* file : {"screw_05_standard_screw.fmu", "models/screw_05_standard_screw.fmu",
                           "models/screw_05_standard_screw.mo", "one.mo"})
    EXPECT_TRUE(std::filesystem::is_regular_file(folder.path() / file)) << file;
  EXPECT_EQ(test::content_of(folder.path() / "one.mo"),
            test::content_of(folder.path() / "models/screw_05_standard_screw.mo"));
}

TEST(Export, AFileThatCannotBeWrittenIsNamed) {
  const test::TemporaryDirectory folder;
  std::filesystem::create_directory(folder.path() / "screw_05_standard_screw.mo");
  const Outcome run =
      run_prs("export '" PRS_SOURCE_DIR "/configs/05_standard_screw.yaml' --fmu --modelica --output .", folder.path());
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.err, HasSubstr("cannot write './screw_05_standard_screw.mo'"));
}

TEST(Export, DocumentHasTheCurvesAndTheFiles) {
  const Outcome run = run_prs("export configs/05_standard_screw.yaml --json --force 30kN");
  ASSERT_EQ(run.status, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["command"], "export");
  EXPECT_NEAR(json["export"]["tension"]["force_N"].back(), 30e3, 1e-9);
  EXPECT_NEAR(json["export"]["compression"]["force_N"].back(), -30e3, 1e-9);
  EXPECT_LT(json["export"]["force_error"], kForceTolerance);
}

struct WrongExport {
  std::string arguments;
  std::vector<std::string> words;
};

TEST(Export, WrongInputIsToldAndNothingIsWritten) {
  const test::TemporaryDirectory folder;
  const std::string lessons = "'" PRS_SOURCE_DIR "/configs'/";
  const std::string screw = lessons + "05_standard_screw.yaml";
  for (const auto& [arguments, words] : std::vector<WrongExport>{
           {screw, {"--fmu, --modelica"}},
           {screw + " --step", {"Python package", "rollerscrew[cad]", "rs.export_step"}},
           {screw + " --fmu --modelica --output x.fmu", {"one file, for several forms", "a folder"}},
           {screw + " --fmu --output x.mo", {"x.mo for --fmu", "a file that ends in .fmu"}},
           {screw + " --fmu --output ''", {"--output: got nothing", "a file or a folder"}},
           {screw + " --modelica --output " + screw, {"which is a file", "another name"}},
           {screw + " --fmu --force 30", {"--force: got 30", "a force with its unit", "`30 kN`"}},
           {screw + " --fmu --force '0 N'", {"--force: got 0 N", "more than 0 N"}},
           {screw + " --fmu --speed '-3 rpm'", {"--speed: got -3 rpm", "more than 0 rpm"}},
           {screw + " --fmu --load-case push", {"none called `push`", "expected one of"}},
           {lessons + "28_driving_load.yaml --fmu", {"load_cases: got equal thread loads in each"}},
           {lessons + "08_design_by_backlash.yaml --fmu", {"load_cases: got equal thread loads in each"}}}) {
    const Outcome run = run_prs("export " + arguments, folder.path());
    EXPECT_EQ(run.status, 2) << arguments << run.err;
    for (const std::string& word : words) EXPECT_THAT(run.err, HasSubstr(word)) << arguments;
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace prs
