#include "prs/engine/engine.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "prs/input/reader.h"
#include "prs/run/commands.h"
#include "tests/support/program.h"
#include "tests/support/temporary_directory.h"

namespace prs {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using Json = nlohmann::ordered_json;

std::string lesson_text(const std::string& name) { return test::content_of(PRS_SOURCE_DIR "/configs/" + name); }

/// A question on a lesson by the file name that the program gets.
Json question_of(const std::string& command, const std::string& lesson) {
  return {{"command", command}, {"yaml", lesson_text(lesson)}, {"file", "configs/" + lesson}};
}

Json pairs(const std::vector<std::pair<std::string, std::string>>& values) { return values; }

Json answer_of(const Json& question) { return Json::parse(answer(question.dump())); }

/// The text between `"document": ` and the figures.
std::string document_text(const Json& question) {
  const std::string text = answer(question.dump());
  constexpr std::string_view kBefore = "\"document\": ", kAfter = ",\n\"figures\": ";
  const std::size_t begin = text.find(kBefore) + kBefore.size();
  return text.substr(begin, text.rfind(kAfter) - begin);
}

std::string only_message(const Json& question) {
  const Json answer = answer_of(question);
  EXPECT_EQ(answer["status"], 2);
  EXPECT_TRUE(answer["document"].is_null());
  EXPECT_EQ(answer["figures"], Json::array());
  EXPECT_EQ(answer["messages"].size(), 1u);
  return answer["messages"].at(0);
}

struct Asked {
  std::string command, lesson;
};
void PrintTo(const Asked& asked, std::ostream* out) { *out << asked.command << ' ' << asked.lesson; }

/// Lines that are not empty.
std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

class EngineAnswer : public testing::TestWithParam<Asked> {};

/// The program without matrices kept by earlier runs.
test::Outcome run_program(const std::string& arguments) {
  return test::run_prs(arguments, PRS_SOURCE_DIR, "env PRS_CACHE_DIR=");
}

/// The program's document without the path of the history, of which the engine knows only the name.
std::string without_place(std::string document, const std::string& history) {
  const std::string place = std::string(PRS_SOURCE_DIR "/configs/") + history;
  if (const std::size_t at = document.find(place); at != document.npos) document.replace(at, place.size(), history);
  return document;
}

/// The program prints the same bytes and messages and ends with the same status.
TEST_P(EngineAnswer, IsWhatTheProgramPrints) {
  const auto& [command, lesson] = GetParam();
  Json question = question_of(command, lesson);
  const std::string history = "14_flight_spectrum.csv";
  question["histories"] = {{history, lesson_text(history)}};
  const test::Outcome run = run_program(command + " configs/" + lesson + " --json");
  const Json answer = answer_of(question);
  EXPECT_EQ(document_text(question), without_place(run.out, history));
  EXPECT_EQ(answer["status"], run.status);
  EXPECT_EQ(answer["messages"].get<std::vector<std::string>>(), lines_of(run.err));
}

INSTANTIATE_TEST_SUITE_P(Lessons, EngineAnswer,
                         testing::Values(Asked{"check", "05_standard_screw.yaml"},
                                         Asked{"contact", "07_contact_geometry.yaml"},
                                         Asked{"solve", "03_load_sweep.yaml"}, Asked{"solve", "13_three_models.yaml"},
                                         Asked{"solve", "25_side_load.yaml"}, Asked{"slip", "30_duty_cycle.yaml"},
                                         Asked{"compare", "26_unequal_rollers.yaml"},
                                         Asked{"preload", "12_preload.yaml"}, Asked{"life", "14_flight_spectrum.yaml"},
                                         Asked{"measures", "18_design_measures.yaml"}),
                         [](const auto& of) { return of.param.command + of.param.lesson.substr(0, 2); });

TEST(Engine, SetsValuesAsTheProgramDoes) {
  Json question = question_of("solve", "01_config_1_to_3.yaml");
  question["set"] = pairs({{"mechanism.rollers", "9"}, {"load_cases[0].axial_force", "20 kN"}});
  const test::Outcome run = run_program(
      "solve configs/01_config_1_to_3.yaml --json --set mechanism.rollers=9 "
      "--set 'load_cases[0].axial_force=20 kN'");
  EXPECT_EQ(document_text(question), run.out);
}

TEST(Engine, HasTheFiguresOfTheProgram) {
  Json question = question_of("contact", "07_contact_geometry.yaml");
  question["figures"] = true;
  const test::Outcome run = run_program("contact configs/07_contact_geometry.yaml --json --figures");
  const Json answer = answer_of(question);
  EXPECT_FALSE(answer["figures"].empty());
  EXPECT_EQ(answer["figures"], Json::parse(run.out)["figures"]);
}

TEST(Engine, RefusesAsTheProgramDoes) {
  Json question = question_of("solve", "01_config_1_to_3.yaml");
  question["set"] = pairs({{"mechanism.rollers", "no"}, {"structure.nut.bore", "3"}});
  const test::Outcome run = run_program(
      "solve configs/01_config_1_to_3.yaml --json --set mechanism.rollers=no "
      "--set structure.nut.bore=3");
  const Json answer = answer_of(question);
  EXPECT_EQ(answer["status"], 2);
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(answer["document"].is_null());
  ASSERT_EQ(answer["messages"].size(), 2u);
  EXPECT_EQ(answer["messages"][0].get<std::string>() + '\n' + answer["messages"][1].get<std::string>() + '\n', run.err);
  EXPECT_THAT(answer["messages"][0], StartsWith("configs/01_config_1_to_3.yaml:"));
}

TEST(Engine, TellsThatALoadCaseHasNoEquilibrium) {
  Json question = question_of("slip", "09_slip_and_dissipation.yaml");
  question["set"] = pairs({{"carrier.nut_torque", "150 N m"}, {"load_cases[0].axial_force", "80 kN"}});
  const Json answer = answer_of(question);
  EXPECT_EQ(answer["status"], 3);
  EXPECT_TRUE(answer["document"]["load_cases"][0]["slip"]["converged"]);
  EXPECT_FALSE(answer["document"]["load_cases"][2]["slip"]["converged"]);
}

TEST(Engine, ReadsNoFile) {
  Json question = question_of("life", "14_flight_spectrum.yaml");
  question["file"] = PRS_SOURCE_DIR "/configs/14_flight_spectrum.yaml";  // The file is beside it.
  EXPECT_THAT(only_message(question),
              AllOf(HasSubstr("life.history.file: got 14_flight"), HasSubstr("give its text under this name")));
}

TEST(Engine, SolvesTheLoadCasesThatAreAskedFor) {
  Json question = question_of("solve", "03_load_sweep.yaml");
  const Json all = answer_of(question)["document"]["load_cases"];
  ASSERT_GT(all.size(), 2u);
  question["load_cases"] = Json::array({all[1]["name"]});
  const Json one = answer_of(question)["document"]["load_cases"];
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0]["name"], all[1]["name"]);
  EXPECT_EQ(one[0]["screw"], all[1]["screw"]);
  const std::string name = all[1]["name"];
  question["load_cases"] = {name.substr(0, name.find('['))};
  EXPECT_GT(answer_of(question)["document"]["load_cases"].size(), 1u);
}

TEST(Engine, WritesTheCaseThatNewWrites) {
  const Json asked{
      {"type", "inverted"}, {"screw_diameter", "21 mm"}, {"lead", "5 mm"}, {"starts", 3}, {"lubricant", "iso-vg-46"}};
  const test::Outcome run =
      run_program("new inverted --screw-diameter '21 mm' --lead '5 mm' --starts 3 --lubricant iso-vg-46");
  const Json answer = answer_of({{"command", "new"}, {"new", asked}});
  EXPECT_EQ(answer["status"], 0);
  EXPECT_EQ(answer["document"]["yaml"], run.out);
  EXPECT_THAT(answer["document"]["assumed"].get<std::string>(), HasSubstr("rollers"));
  EXPECT_THAT(only_message({{"command", "new"}, {"new", {{"lead", "5 mm"}}}}),
              StartsWith("prs: error: --screw-diameter: missing"));
}

TEST(Engine, RefusesAWrongNewCase) {
  const auto message = [](const char* key, const Json& value) {
    Json asked{{"screw_diameter", "30 mm"}, {"lead", "10 mm"}};
    asked[key] = value;
    return only_message({{"command", "new"}, {"new", asked}});
  };
  EXPECT_THAT(message("diameter", "30 mm"), HasSubstr("new: got diameter; expected the keys type"));
  EXPECT_THAT(message("lead", 10), HasSubstr("lead: got 10; expected a text"));
  EXPECT_THAT(message("starts", "five"), HasSubstr("starts: got \"five\"; expected a whole number"));
  EXPECT_THAT(message("type", "upright"),
              HasSubstr("--type: got upright; expected standard, inverted or recirculating"));
  EXPECT_THAT(message("mechanism", "half"), HasSubstr("--mechanism: got half; expected sector or"));
  for (const char* lead : {"nan mm", "10", "10 kN", "inf mm", "0 mm", "1 km"})
    EXPECT_THAT(message("lead", lead), HasSubstr("--lead: got")) << lead;
}

/// A requirement with the rows of a catalogue only, which are few.
Json question_on_catalogue(const std::string& command) {
  Json question = question_of(command, "32_press.yaml");
  question["histories"] = {{"32_press.csv", lesson_text("32_press.csv")}};
  question["set"] = pairs({{"candidates", "{catalogue: {file: 32_press.csv}}"}});
  return question;
}

TEST(Engine, WritesACandidateAsTheProgramDoes) {
  const test::TemporaryDirectory folder;
  const std::string file = (folder.path() / "screw.yaml").string();
  const test::Outcome run = run_program(
      "size configs/32_press.yaml --set 'candidates={catalogue: {file: 32_press.csv}}' --write 2 "
      "'" +
      file + "'");
  ASSERT_EQ(run.status, 0) << run.err;
  Json question = question_on_catalogue("write");
  question["rank"] = 2;
  EXPECT_EQ(answer_of(question)["document"]["yaml"], test::content_of(file));
  question["rank"] = 1000;
  EXPECT_THAT(only_message(question), HasSubstr("rank: got 1000; expected a rank of the list"));
}

TEST(Engine, ReportsOnARequirement) {
  const Json sections = answer_of(question_on_catalogue("report"))["document"]["sections"];
  EXPECT_THAT(sections["candidates"].get<std::string>(), HasSubstr("<table"));
}

/// An error in a question, and a part of its message.
TEST(Engine, RefusesQuestionsThatItDoesNotKnow) {
  const Json good = question_of("solve", "01_config_1_to_3.yaml");
  const auto with = [&](const char* key, const Json& value) {
    Json question = good;
    question[key] = value;
    return question;
  };
  const std::vector<std::pair<Json, std::string>> cases = {
      {Json::array(), "question: got []; expected a JSON object"},
      {with("command", "study"), "command: got study; expected one of check, contact"},
      {with("command", 3), "command: got 3; expected a text"},
      {with("yaml", Json::array()), "yaml: got []; expected a text"},
      {with("set", Json::array({Json::array({"a", 3})})), "set: got [\"a\",3]; expected a pair of path and value"},
      {with("set", Json::array({Json::array({"a"})})), "set: got [\"a\"]; expected a pair"},
      {with("set", 3), "set: got 3; expected a list of pairs"},
      {with("figures", "yes"), "figures: got \"yes\"; expected true or false"},
      {with("speed", 1), "question: got speed; expected the keys command"},
      {with("load_cases", {"none"}), "load_cases: got none; expected the name of a load case"},
      {{{"command", "solve"}}, "yaml: got nothing; expected a text"},
  };
  for (const auto& [question, text] : cases)
    EXPECT_THAT(only_message(question), AllOf(StartsWith("prs: error: question"), HasSubstr(text)));
  Json life = question_of("life", "14_flight_spectrum.yaml");
  life["load_cases"] = {"hold"};
  EXPECT_THAT(only_message(life), HasSubstr("leave `load_cases` out"));
}

TEST(Engine, AnswersWhatIsNoJson) {
  for (const std::string text : {"", "{", "nonsense", "{\"yaml\": \"\xff\"}"})
    EXPECT_EQ(Json::parse(answer(text))["status"], 2) << text;
  EXPECT_EQ(Json::parse(answer(std::string(100'000, '[')))["status"], 2);
}

}  // namespace
}  // namespace prs
