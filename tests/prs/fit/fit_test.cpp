#include "modules/fit/fit_analysis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "prs/run/commands.h"
#include "prs/study/response.h"

namespace prs {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* kFolder = PRS_SOURCE_DIR "/tests/prs/fit";

/// Solved cases of an independent program.
json fit_case_named(const std::string& name) {
  static const json all = json::parse(std::ifstream(std::string(kFolder) + "/fit_cases.json"));
  for (const json& c : all["cases"])
    if (c["name"] == name) return c;
  throw std::invalid_argument(name);
}

json input_of(const std::string& name) { return fit_case_named(name)["input"]; }

input::Source bench_source(const json& input, std::map<std::string, std::string> files = {}) {
  input::Source source{.name = "bench.yaml", .text = input.dump(1), .overrides = {}};
  for (const char* file : {"bench_torque.csv", "bench_loss.csv", "bench_play.csv", "bench_oil.csv"}) {
    std::ifstream in(std::string(kFolder) + "/" + file);
    files.emplace(file, std::string(std::istreambuf_iterator<char>(in), {}));
  }
  source.files = std::move(files);
  return source;
}

json document(const FitResult& r) {
  Json d;
  fit_analysis().put(d, r);
  return json::parse(d.dump())["fit"];
}

json fitted_document(const json& input, std::map<std::string, std::string> files = {}) {
  return document(fit_case(bench_source(input, std::move(files)), {.threads = 1}));
}

/// All that the solved case has, numbers to 2e-5.
void expect_same(const json& found, const json& expected, const std::string& at) {
  if (expected.is_object()) {
    for (const auto& [key, value] : expected.items()) {
      ASSERT_TRUE(found.contains(key)) << at << "." << key;
      expect_same(found[key], value, at + "." + key);
    }
  } else if (expected.is_array()) {
    ASSERT_EQ(found.size(), expected.size()) << at;
    for (std::size_t k = 0; k < expected.size(); ++k) expect_same(found[k], expected[k], fmt::format("{}[{}]", at, k));
  } else if (expected.is_number_float()) {
    const double size = std::abs(expected.get<double>());
    EXPECT_NEAR(found.get<double>(), expected.get<double>(), 2e-5 * std::max(size, 1e-3)) << at;
  } else {
    EXPECT_EQ(found, expected) << at;
  }
}

TEST(FitCase, SolvedCasesOfAnotherProgram) {
  for (const char* name : {"friction-on-the-bench", "play-on-the-bench", "density-and-viscosity"}) {
    const json expected = fit_case_named(name);
    expect_same(fitted_document(expected["input"]), expected["result"], name);
  }
}

std::string refusal(const json& input, std::map<std::string, std::string> files = {}) {
  try {
    fit_case(bench_source(input, std::move(files)), {.threads = 1});
  } catch (const input::InputError& error) {
    return error.what();
  }
  return "none";
}

struct Wrong {
  const char* pointer;
  json value;
  const char* key;
  const char* told;
};

TEST(FitCase, WrongInputSaysWhereAndWhatIsAllowed) {
  const std::vector<Wrong> all{
      {"/fit/curves/0/use", "compare", "none", "none"},
      {"/fit/parameters/0/path", "friction.coulom", "parameters[0].path", "did you mean `friction.coulomb`"},
      {"/fit/parameters/0/path", "mechanism.type", "mechanism.type", "standard | inverted"},
      {"/fit/parameters/0/from", 0.5, "parameters[0].from", "less than `to`"},
      {"/fit/parameters/0/start", 0.5, "parameters[0].start", "0.02 to 0.4"},
      {"/fit/parameters/1/scale", "log", "parameters[1].from", "more than 0"},
      {"/fit/parameters/1/from", 0, "carrier.screw_torque", "write the unit"},
      {"/fit/parameters/0/prior/deviation", "0 %", "prior.deviation", "more than 0"},
      {"/fit/parameters/0/prior/mean", -1, "prior.mean", "more than 0"},
      {"/fit/parameters/0/scale", "ln", "parameters[0].scale", "linear | log"},
      {"/fit/curves/0/file", "none.csv", "curves[0].file", "file that was given"},
      {"/fit/curves/0/measured/column", "q", "measured.column", "force_kN, torque_Nm"},
      {"/fit/curves/0/measured/unit", "W", "measured.unit", "N m, N mm"},
      {"/fit/curves/0/conditions/0/unit", "rpm", "conditions[0].unit", "a force: N, kN"},
      {"/fit/curves/0/conditions/0/path", "operation.sped", "conditions[0].path", "did you mean `speed`"},
      {"/fit/curves/0/deviation", "-1 N m", "curves[0].deviation", "more than 0"},
      {"/fit/curves/0/deviation", "1 W", "curves[0].deviation", "N m, N mm"},
      {"/fit/curves/0/response", "slip.torque_srew_Nm", "curves[0].response", "did you mean `slip.torque_screw_Nm`"},
      {"/fit/curves/0/response", "preload.loads[].axial_displacement_um", "curves[0].response", "without `along`"},
      {"/fit/curves/0/command", "solve", "curves[0].response", "prs list responses"},
      {"/fit/curves/0/along",
       {{"response", "heat_cycle.time_s"}, {"column", "force_kN"}, {"unit", "s"}},
       "curves[0].along",
       "no series"},
      {"/fit/curves/1/name", "torque", "curves[1].name", "of its own"},
      {"/fit/curves/0/loss", "hubert", "curves[0].loss", "squares, huber, cauchy"},
      {"/fit/curves/0/loss", {{"huber", 0}}, "curves[0].loss", "above 0"},
      {"/fit/level", "20 %", "fit.level", "50 %"},
      {"/fit/starts", 0, "fit.starts", "from 1 to 1000"},
      {"/fit/profile", true, "fit.profile", "robust loss of loss"},
      {"/fit/bands/0/response", "slip.efficency", "bands[0].response", "did you mean `slip.efficiency`"},
      {"/fit/bands/0/conditions/1", {{"path", "operation.speed"}, {"values", {"1 rpm"}}}, "values", "expected 3"},
      {"/fit/parameters/2",
       {{"path", "materials.density"}, {"from", "7000 kg/m^3"}, {"to", "8000 kg/m^3"}},
       "parameters[2].path",
       "no curve depends"},
      {"/fit/parameters/2",
       {{"path", "operation.speed"}, {"from", "10 rpm"}, {"to", "900 rpm"}},
       "conditions[1].path",
       "a parameter too"},
      {"/fit/parameters/2", {{"path", "roughness"}, {"from", "0.1 um"}, {"to", "1 um"}}, "parameters[2].path", "start"},
  };
  for (std::size_t k = 1; k < all.size(); ++k) {
    json input = input_of("friction-on-the-bench");
    input[json::json_pointer(all[k].pointer)] = all[k].value;
    const std::string told = refusal(input);
    EXPECT_THAT(told, testing::StartsWith("bench.yaml:")) << all[k].pointer;
    EXPECT_THAT(told, testing::AllOf(HasSubstr(all[k].key), HasSubstr(all[k].told))) << all[k].pointer;
  }
}

TEST(FitCase, WrongReadingsStandAtTheirPlaceInTheFile) {
  const auto refused = [](const char* row, json changes = json::object()) {
    json input = input_of("friction-on-the-bench");
    input["fit"]["curves"][0]["file"] = "x.csv";
    input["fit"]["curves"][0].update(changes);
    return refusal(input, {{"x.csv", std::string("force_kN,torque_Nm,s\n1,1.2,1\n") + row + "\n3,3.1,1\n"}});
  };
  for (const char* reading : {"", "nan", "inf", "word"})
    EXPECT_THAT(refused(fmt::format("2,{},1", reading).c_str()), HasSubstr("x.csv:3:3: error: torque_Nm: got"))
        << reading;
  EXPECT_THAT(refused("much,2,1"), HasSubstr("x.csv:3:1: error: force_kN"));
  EXPECT_THAT(refused("2,2.1,0", {{"deviation", {{"column", "s"}, {"unit", "N m"}}}}),
              HasSubstr("x.csv:3:7: error: s"));
  EXPECT_THAT(refused("2,0,1", {{"deviation", "1 %"}}), HasSubstr("x.csv:3:3"));
}

TEST(FitCase, UnitsAndOrdersChangeNothing) {
  json other = input_of("friction-on-the-bench");
  std::swap(other["fit"]["parameters"][0], other["fit"]["parameters"][1]);
  other["fit"]["parameters"][0]["from"] = "0 N mm";
  other["fit"]["parameters"][0]["to"] = "3000 N mm";
  other["fit"]["curves"][0]["deviation"] = "80 N mm";
  const json a = fitted_document(input_of("friction-on-the-bench")), b = fitted_document(other);
  EXPECT_NEAR(a["parameters"][0]["value"].get<double>(), b["parameters"][1]["value"].get<double>(), 1e-8);
  for (const char* key : {"value", "standard_deviation", "low", "high"})
    EXPECT_NEAR(1e3 * a["parameters"][1][key].get<double>(), b["parameters"][0][key].get<double>(), 1e-3) << key;
  EXPECT_NEAR(a["objective"].get<double>(), b["objective"].get<double>(), 1e-6);
}

TEST(FitCase, ThreadsGiveTheSameDigits) {
  const input::Source source = bench_source(input_of("friction-on-the-bench"));
  EXPECT_EQ(document(fit_case(source, {.threads = 1})), document(fit_case(source, {.threads = 3})));
}

TEST(FitCase, TheFittedFileAnswersWhatWasFitted) {
  const input::Source source = bench_source(input_of("friction-on-the-bench"));
  const FitResult r = fit_case(source, {.threads = 1});
  const std::string text = fitted_case(r);
  EXPECT_THAT(text, HasSubstr("# coulomb: fitted: standard deviation"));
  // Fitted again nothing moves.
  input::Source again = source;
  again.text = text;
  const FitResult second = fit_case(again, {.threads = 1});
  for (std::size_t j = 0; j < 2; ++j)
    EXPECT_NEAR(*second.found.unknowns[j].value, *r.found.unknowns[j].value,
                1e-3 * r.found.unknowns[j].estimate->deviation);
  // A row by the command itself.
  input::Source row = again;
  row.overrides = {"load_cases[0].axial_force=4 kN"};
  const Json slip = analysis_of(Command::slip).run(row, input::read_case_input(row, Command::slip)).document({});
  EXPECT_NEAR(*response(slip, "slip.torque_screw_Nm"), r.found.curves[0].fitted[3],
              1e-8 * std::abs(r.found.curves[0].fitted[3]));
}

/// Warming up from cold, in minutes and degF.
json warming_up() {
  json input = input_of("friction-on-the-bench");
  input["structure"] = input_of("play-on-the-bench")["structure"];
  input["heat"] = {
      {"ambient", "20 degC"},
      {"conductance",
       {{"screw_ambient", "2 W/K"}, {"nut_ambient", "4 W/K"}, {"screw_rollers", "20 W/K"}, {"rollers_nut", "30 W/K"}}},
      {"specific_heat", "460 J/(kg K)"},
      {"duty", {{{"load_case", "run"}, {"duration", "60 min"}}, {{"rest", "12 h"}}}}};
  input["fit"] = {
      {"parameters", json::array({{{"path", "heat.conductance.nut_ambient"}, {"from", "1 W/K"}, {"to", "12 W/K"}}})},
      {"curves",
       json::array({{{"name", "nut"},
                     {"file", "warm.csv"},
                     {"response", "heat_cycle.temperature_degC.nut"},
                     {"measured", {{"column", "T"}, {"unit", "degF"}}},
                     {"deviation", "0.9 degF"},
                     {"along", {{"response", "heat_cycle.time_s"}, {"column", "minutes"}, {"unit", "min"}}}}})}};
  return input;
}

TEST(FitCase, ASeriesIsTakenAtItsRowsAndTemperaturesShift) {
  json cut = warming_up();
  cut.erase("fit");
  cut["heat"]["conductance"]["nut_ambient"] = "6 W/K";
  cut["heat"]["duty"] = {{{"load_case", "run"}, {"duration", "7 min"}},
                         {{"load_case", "run"}, {"duration", "16 min"}},
                         {{"load_case", "run"}, {"duration", "37 min"}},
                         {{"rest", "12 h"}}};
  const input::Source source{.name = "cut", .text = cut.dump(), .overrides = {}};
  const Json warm = analysis_of(Command::slip).run(source, input::read_case_input(source, Command::slip)).document({});
  std::string csv = "minutes,T\n";
  for (const double minutes : {60.0, 7.0, 23.0}) {
    const Json& times = warm["heat_cycle"]["time_s"];
    for (std::size_t k = 0; k < times.size(); ++k)
      if (std::abs(times[k].get<double>() - 60.0 * minutes) < 1e-6) {
        csv += fmt::format("{},{}\n", minutes,
                           32.0 + 1.8 * warm["heat_cycle"]["temperature_degC"]["nut"][k].get<double>());
        break;
      }
  }
  const json found = fitted_document(warming_up(), {{"warm.csv", csv}});
  EXPECT_EQ(found["curves"][0]["rows"], 3);
  EXPECT_NEAR(found["parameters"][0]["value"].get<double>(), 6.0, 1e-4);
  EXPECT_NEAR(found["curves"][0]["standard_deviation"][0].get<double>(), 0.5, 1e-12);
  EXPECT_EQ(found["curves"][0]["unit"], "degC");
  EXPECT_LT(found["curves"][0]["rms"].get<double>(), 1e-6);
}

TEST(FitCase, RowsBeyondThePeriodAreRefused) {
  EXPECT_THAT(refusal(warming_up(), {{"warm.csv", "minutes,T\n1,70\n9999,80\n"}}), HasSubstr("warm.csv:3:1: error"));
}

TEST(FitCase, ConditionsMayBeWordsAndCurvesHeldBack) {
  json input = input_of("play-on-the-bench");
  input["fit"]["profile"] = json::array();
  input["fit"]["curves"][0]["offset"] = false;
  input["fit"]["curves"].push_back({{"name", "stiff"},
                                    {"file", "stiff.csv"},
                                    {"response", "axial_displacement_um"},
                                    {"use", "compare"},
                                    {"offset", true},
                                    {"measured", {{"column", "u"}, {"unit", "mm"}}},
                                    {"conditions",
                                     {{{"path", "load_cases[0].direction"}, {"column", "sense"}},
                                      {{"path", "load_cases[0].axial_force"}, {"column", "F"}, {"unit", "kN"}}}}});
  const json found = fitted_document(
      input, {{"stiff.csv", "sense;F;u\n# a comment\ntension;4;0.012\ncompression;4;0.011\ntension;8;0.02\n"}});
  const json& curve = found["curves"][1];
  EXPECT_EQ(curve["use"], "compare");
  EXPECT_EQ(curve["line"], json({3, 4, 5}));
  EXPECT_FALSE(curve.contains("redundancy"));
  EXPECT_EQ(curve["low"].size(), 3U);
  // The offset is the mean of y - f.
  double sum = 0.0;
  for (const json& r : curve["residual"]) sum += r.get<double>();
  EXPECT_NEAR(sum, 0.0, 1e-9);
  EXPECT_NEAR(curve["measured"][0].get<double>(), 12.0, 1e-9);
}

TEST(FitCase, EveryLoadOfAPreloadSeriesIsThatOfItsRow) {
  json input = input_of("play-on-the-bench");
  input.erase("fit");
  const input::Source source{
      .name = "play", .text = input.dump(), .overrides = {"preload.load={from: -3 kN, to: 5 kN, steps: 2}"}};
  const Json direct =
      analysis_of(Command::preload).run(source, input::read_case_input(source, Command::preload)).document({});
  json with_fit = input_of("play-on-the-bench");
  with_fit["fit"]["profile"] = json::array();
  with_fit["fit"]["parameters"].erase(1);
  with_fit["fit"]["parameters"][0].update({{"prior", {{"mean", "20 um"}, {"deviation", "1 nm"}}}});
  with_fit["fit"]["curves"][0].update({{"file", "two.csv"}, {"offset", false}, {"deviation", "1 mm"}});
  const json found = fitted_document(with_fit, {{"two.csv", "force_kN,travel_um\n5,20\n-3,-15\n"}});
  const Json& loads = direct["preload"]["loads"];
  EXPECT_NEAR(found["curves"][0]["fitted"][0].get<double>(), loads[1]["axial_displacement_um"].get<double>(), 1e-4);
  EXPECT_NEAR(found["curves"][0]["fitted"][1].get<double>(), loads[0]["axial_displacement_um"].get<double>(), 1e-4);
}

TEST(FitCase, OfTwoTorquesThatActAlikeOnlyASumIsTold) {
  json input = input_of("friction-on-the-bench");
  input["fit"]["curves"].erase(1);
  input["fit"]["parameters"].push_back(
      {{"path", "carrier.nut_torque"}, {"from", "0 N m"}, {"to", "1 N m"}, {"start", "0.2 N m"}});
  const FitResult r = fit_case(bench_source(input), {.threads = 1});
  const json combination = document(r)["unidentified"][0]["combination"];
  EXPECT_EQ(combination["kind"], "sum");
  EXPECT_THAT(combination["text"].get<std::string>(), testing::StartsWith("carrier.screw_torque + "));
  EXPECT_THAT(fit_analysis().table(r), HasSubstr("told: carrier.screw_torque + "));
}

TEST(FitCase, FilesHoldAllRows) {
  const FitResult r = fit_case(bench_source(input_of("friction-on-the-bench")), {.threads = 1});
  const std::vector<OutputFile> files = fit_analysis().files(r, {});
  std::vector<std::string> names;
  for (const OutputFile& f : files) names.push_back(f.name);
  EXPECT_THAT(names, testing::ElementsAre("fit_parameters.csv", "residuals.csv", "fit_bands.csv", "fitted.yaml"));
  EXPECT_EQ(std::ranges::count(files[1].content, '\n'), 1 + 16 + 24);
  EXPECT_THAT(files[1].content, HasSubstr("torque,2,load_cases[0].axial_force=1 kN,N m,1.1859,"));
  EXPECT_THAT(fit_analysis().table(r), HasSubstr("friction.coulomb"));
  EXPECT_EQ(fit_analysis().pictures(r, {}).size(), 3U);
}

}  // namespace
}  // namespace prs
