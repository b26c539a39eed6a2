#include "prs/reference/reference.h"

#include <gmock/gmock.h>

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "prs/compare/compare_analysis.h"
#include "prs/input/reader.h"
#include "prs/reference/curve_deviations.h"
#include "prs/study/response.h"
#include "support/program.h"
#include "support/temporary_directory.h"

namespace prs {
namespace {

using testing::HasSubstr;

TEST(CurveDeviations, AreThoseOfThreeNumbers) {
  const double computed[] = {1.0, 2.0, -3.0}, reference[] = {1.0, 1.0, 1.0};
  const auto d = curve_deviations(computed, reference);
  ASSERT_TRUE(d);
  EXPECT_DOUBLE_EQ(d->mean, -1.0);
  EXPECT_DOUBLE_EQ(d->rms, std::sqrt(17.0 / 3.0));
  EXPECT_DOUBLE_EQ(d->largest, -4.0);
  EXPECT_EQ(d->largest_at, 2U);
  const double without[] = {1.0, NAN, 1.0};
  EXPECT_FALSE(curve_deviations(without, reference));
}

TEST(CurveDeviations, SlopeOfALineIsItsOwn) {
  const double x[] = {1.0, 2.0, 4.0}, y[] = {5.0, 7.0, 11.0}, same[] = {1.0, 1.0, 1.0};
  EXPECT_DOUBLE_EQ(*slope(x, y), 2.0);
  EXPECT_FALSE(slope(same, y));
}

/// Lesson 4's screw with two load cases, beside files of references.
class AgainstReferences : public testing::Test {
 protected:
  ModelComparison run(const std::string& block, std::map<std::string, std::string> files,
                      std::vector<std::string> overrides = {}) const {
    if (block != "[]") overrides.push_back("references=" + block);
    input::Source source = input::load_source(PRS_SOURCE_DIR "/configs/04_contacts_from_geometry.yaml", overrides);
    source.files = std::move(files);
    return compare_analysis().run(source, input::read_case_input(source, Command::compare));
  }
  ModelComparison run(const std::string& block, const std::string& csv, std::vector<std::string> overrides = {}) const {
    return run(block, {{"x.csv", csv}}, std::move(overrides));
  }
  Json document(const ModelComparison& c) const { return document_of(compare_analysis(), c, {}); }
  std::string refusal(const std::string& csv, const std::string& block = "[{file: x.csv}]") const {
    try {
      run(block, csv);
    } catch (const input::InputError& error) {
      return error.what();
    }
    return "accepted";
  }

  /// Shares of the screw's threads under the first load [%], by bars.
  std::vector<double> shares(double factor = 100.0) const {
    std::vector<double> all = (*plain().models[0].load_cases[0].threads).screw.load_rate;
    for (double& share : all) share *= factor;
    return all;
  }
  const ModelComparison& plain() const {
    static const ModelComparison c = run("[]", "");
    return c;
  }
  std::string name() const { return plain().models[0].load_cases[0].load_case.name; }
  std::string table(const std::vector<double>& values, const std::string& column = "screw.load_rate_percent") const {
    std::string csv = "load_case,thread," + column + "\n";
    for (std::size_t k = 0; k < values.size(); ++k) csv += fmt::format("{},{},{:.12g}\n", name(), k + 1, values[k]);
    return csv;
  }
};

TEST_F(AgainstReferences, TheCasesOwnSharesLieOnItsCurve) {
  const ModelComparison c = run("[{file: x.csv, tolerance: 0.001 %}]", table(shares()));
  ASSERT_EQ(c.references.size(), 1U);
  EXPECT_EQ(c.references[0].reference.name, "x");
  EXPECT_NEAR(c.references[0].models[0].deviations->rms, 0.0, 1e-9);
  EXPECT_NEAR(*c.references[0].sum, 100.0, 1e-6);
  EXPECT_TRUE(c.references[0].met());
  // Refined bodies share the load differently, and the case states bars.
  EXPECT_FALSE(c.references[0].models[1].met());
  EXPECT_TRUE(compare_analysis().within_tolerance(c));
}

TEST_F(AgainstReferences, AShiftOfOneThreadIsItsLargestDeviation) {
  std::vector<double> values = shares();
  values[3] -= 0.5;
  const Json r =
      document(run("[{file: x.csv, tolerance: 9 % of the mean, name: test}]", table(values)))["references"][0];
  const Json& bars = r["models"][0];
  const double n = static_cast<double>(values.size()), mean = (100.0 - 0.5) / n;
  EXPECT_EQ(r["name"], "test");
  EXPECT_EQ(r["count"], values.size());
  EXPECT_NEAR(bars["largest_deviation"]["value"], 0.5, 1e-9);
  EXPECT_EQ(bars["largest_deviation"]["at"], 4.0);
  EXPECT_NEAR(bars["mean_deviation"], 0.5 / n, 1e-9);
  EXPECT_NEAR(bars["rms_deviation"], 0.5 / std::sqrt(n), 1e-9);
  EXPECT_NEAR(bars["largest_deviation"]["percent_of_mean"], 50.0 / mean, 1e-6);
  for (const char* key : {"mean_deviation", "rms_deviation", "largest_deviation"})
    EXPECT_EQ(r[key], bars[key]);  // Stated.
  EXPECT_NEAR(r["reference_sum_percent"], 99.5, 1e-9);
  EXPECT_NEAR(r["points"][3]["computed"]["bars"].get<double>() - r["points"][3]["reference"].get<double>(), 0.5, 1e-9);
  EXPECT_EQ(bars["met"], 50.0 / mean <= 9.0);
}

TEST_F(AgainstReferences, AToleranceOfEachValueOrInUnitsIsHeld) {
  std::vector<double> values = shares();
  for (double& value : values) value *= 1.05;
  const auto met = [&](const std::string& tolerance) {
    return run(fmt::format("[{{file: x.csv, tolerance: {}}}]", tolerance), table(values)).references[0].met();
  };
  EXPECT_TRUE(met("4.8 % of each value"));  // 0.05/1.05 = 4.76 %
  EXPECT_FALSE(met("4.7 % of each value"));
  const double largest = 0.05 * std::ranges::max(shares());
  EXPECT_TRUE(met(fmt::format("{} %", largest * 1.001)));
  EXPECT_FALSE(met(fmt::format("{} %", largest * 0.999)));
}

TEST_F(AgainstReferences, AWrongNormalisationIsWarnedOf) {
  const auto codes = [&](double factor, bool all) {
    std::vector<double> values = shares(factor);
    if (!all) values.pop_back();
    const ModelComparison c = run("[{file: x.csv}]", table(values));
    EXPECT_EQ(c.references[0].sum.has_value(), all);
    return std::ranges::count(c.warnings, "reference_sum", &Warning::code);
  };
  EXPECT_EQ(codes(100.9, true), 0);
  EXPECT_EQ(codes(101.1, true), 1);
  EXPECT_EQ(codes(1.0, true), 1);
  EXPECT_EQ(codes(1.0, false), 0);
}

TEST_F(AgainstReferences, AxialLoadsSumToTheLoadOfARoller) {
  const auto& r = plain().models[0].load_cases[0];
  const ModelComparison c = run("[{file: x.csv}]", table(r.threads->screw.axial_load, "screw.axial_load_N"));
  EXPECT_NEAR(*c.references[0].expected_sum, r.load_case.axial_force / 11.0, 1e-6);
  EXPECT_NEAR(*c.references[0].sum, *c.references[0].expected_sum, 1e-3);
}

TEST_F(AgainstReferences, AGermanTableIsReadAsAnyOther) {
  std::string german = table(shares());
  std::ranges::replace(german, ',', ';');
  std::ranges::replace(german, '.', ',');
  german.replace(german.find("screw,load"), 10, "screw.load");
  EXPECT_EQ(document(run("[{file: x.csv}]", "\xEF\xBB\xBF" + german)).dump(),
            document(run("[{file: x.csv}]", table(shares()))).dump());
}

TEST_F(AgainstReferences, UnitsOfACurveOverTheForceAreConverted) {
  const std::string loads = "load_cases=[{name: pull, axial_force: 30 kN, direction: tension, position: 20 mm}]";
  const ModelComparison ten =
      run("[]", "", {"load_cases=[{name: pull, axial_force: 10 kN, direction: tension, position: 20 mm}]"});
  const ModelComparison thirty = run("[]", "", {loads});
  const double u1 = *ten.models[0].load_cases[0].axial_displacement,
               u3 = *thirty.models[0].load_cases[0].axial_displacement;
  const std::string csv = fmt::format("force_kN,axial_displacement_mm\n30,{:.12g}\n10,{:.12g}\n", u3 * 1e3, u1 * 1e3);
  const ModelComparison c = run("[{file: x.csv}]", csv, {loads});
  EXPECT_NEAR(c.references[0].models[0].deviations->largest, 0.0, 1e-6);
  EXPECT_EQ(c.references[0].reference.readings[0].along, 10.0);
  EXPECT_NEAR(document(c)["references"][0]["stiffness_N_per_um"], 20e3 / ((u3 - u1) * 1e6), 1e-3);
  EXPECT_NEAR(document(c)["references"][0]["models"][0]["stiffness_N_per_um"], 20e3 / ((u3 - u1) * 1e6), 1e-3);
}

TEST_F(AgainstReferences, HeadingsTakeAnyUnitOfTheirKind) {
  const std::string loads = "load_cases=[{name: pull, axial_force: 30 kN, direction: tension, position: 20 mm}]";
  const LoadCaseResult at_30 = run("[]", "", {loads}).models[0].load_cases[0];
  const std::string csv =
      fmt::format("force_lbf,axial_displacement_uin,axial_stiffness_kN_per_mm\n{:.15g},{:.15g},{:.15g}\n",
                  30e3 / 4.4482216152605, *at_30.axial_displacement / 25.4e-9, *at_30.axial_stiffness * 1e-6);
  const ModelComparison c = run("[{file: x.csv}]", csv, {loads});
  ASSERT_EQ(c.references.size(), 2u);
  EXPECT_NEAR(c.references[0].reference.readings[0].along, 30e3 / 4.4482216152605, 1e-9);
  for (const auto& of : c.references)
    EXPECT_NEAR(of.models[0].deviations->largest, 0.0, 1e-9 * of.reference.readings[0].value);
}

TEST_F(AgainstReferences, AnyInputMaySetTheRows) {
  const std::string block =
      "[{file: x.csv, response: axial_displacement_um, along: {column: E, input: materials.youngs_modulus, unit: "
      "GPa}}]";
  const std::string loads = "load_cases=[{name: pull, axial_force: 30 kN, direction: tension, position: 20 mm}]";
  const ModelComparison c = run(block, "E,u\n209,50\n190,50\n", {loads});
  const ModelComparison soft = run("[]", "", {loads, "materials.youngs_modulus=190 GPa"});
  EXPECT_NEAR(c.references[0].models[0].computed[0], *soft.models[0].load_cases[0].axial_displacement * 1e6, 1e-9);
}

TEST_F(AgainstReferences, NegativeForcesAreThoseOfTheOtherDirection) {
  const auto displacement = [&](const std::string& direction) {
    const std::string load =
        fmt::format("load_cases=[{{name: pull, axial_force: 30 kN, direction: {}, position: 20 mm}}]", direction);
    return *run("[]", "", {load}).models[0].load_cases[0].axial_displacement * 1e6;
  };
  const double pulled = displacement("tension"), pushed = displacement("compression");
  ASSERT_NE(pulled, pushed);
  for (const std::string direction : {"tension", "compression"}) {
    const std::string load =
        fmt::format("load_cases=[{{name: load, axial_force: 1 kN, direction: {}, position: 20 mm}}]", direction);
    for (const std::string along : {"", ", along: {column: force_kN, input: 'load_cases[0].axial_force', unit: kN}"}) {
      const ModelComparison c = run(fmt::format("[{{file: x.csv, response: axial_displacement_um{}}}]", along),
                                    "force_kN,u\n30,1\n-30,-1\n", {load});
      const auto& computed = c.references[0].models[0].computed;
      const bool is_tension = direction == "tension";
      EXPECT_NEAR(computed[0], -(is_tension ? pushed : pulled), 1e-9);
      EXPECT_NEAR(computed[1], is_tension ? pulled : pushed, 1e-9);
      EXPECT_NEAR(document(c)["references"][0]["stiffness_N_per_um"], 60e3 / 2.0, 1e-6);
      EXPECT_NEAR(document(c)["references"][0]["models"][0]["stiffness_N_per_um"], 60e3 / (pulled + pushed), 1e-6);
    }
  }
  const ModelComparison shares = run("[{file: x.csv, response: screw.load_rate_percent.max}]",
                                     "load_case,force_kN,x\n" + name() + ",-30,7\n" + name() + ",30,7\n");
  EXPECT_GT(shares.references[0].models[0].computed[0], 100.0 / 20.0);
}

/// Numbers of all commands, of the load case and of the whole case: each by the document of its command.
TEST(ReferencesOfAnyCommand, AreTheirNumbers) {
  const std::pair<const char*, std::vector<const char*>> kResponses[] = {
      {"31_running_screw",
       {"slip.efficiency", "life.system.l10_revolutions", "contact.nut.backlash_mm", "measures.geometry_factor"}},
      {"12_preload", {"preload.lost_motion_um", "axial_stiffness_N_per_um"}},
      {"34_reversal", {"response.lost_motion_um"}},
  };
  for (const auto& [lesson, paths] : kResponses) {
    const std::string file = fmt::format("{}/configs/{}.yaml", PRS_SOURCE_DIR, lesson);
    for (const std::string path : paths) {
      const std::string command = path.substr(0, path.find('.'));
      const std::string known[] = {"slip", "life", "contact", "measures", "preload", "response"};
      const bool named = std::ranges::find(known, command) != std::end(known);
      const test::Outcome own = test::run_prs(fmt::format("{} {} --json --quiet", named ? command : "solve", file));
      const auto value = response(Json::parse(own.out), path);
      ASSERT_TRUE(value) << path;
      const Json document = Json::parse(own.out);
      input::Source source = input::load_source(file, {"references=[{file: x.csv}]"});
      const bool of_load = path.starts_with("slip.") || !named;
      const std::string load = of_load ? document["load_cases"][0]["name"].get<std::string>() : "";
      source.files = {{"x.csv", fmt::format("{}{}\n{}{:.12g}\n", of_load ? "load_case," : "", path,
                                            of_load ? load + "," : "", *value)}};
      const ModelComparison c = compare_analysis().run(source, input::read_case_input(source, Command::compare));
      ASSERT_EQ(c.references.size(), 1U);
      const double computed = c.references[0].models[c.stated].computed[0];
      EXPECT_NEAR(computed, *value, 1e-9 * std::abs(*value)) << path;
      EXPECT_EQ(c.references[0].reference.load_case, load);
    }
  }
}

TEST_F(AgainstReferences, WhatTheCaseDoesNotGiveIsSaid) {
  EXPECT_THAT(
      refusal("life.system.l10_revolutions\n1e6\n"),
      HasSubstr("x.csv:1:1: error: heading: got life.system.l10_revolutions; expected the response of a command "
                "that the case is ready for; `prs life` is not: life: missing"));
  EXPECT_THAT(refusal("load_case,contact.nut.backlash_mm\n" + name() + ",0.1\n"),
              HasSubstr("x.csv:1:1: error: heading: got load_case; expected none, since contact.nut.backlash_mm is a "
                        "response of the whole case"));
  EXPECT_THAT(refusal("contact.nut.backlash_mm,axial_displacement_um\n0.1,5\n"),
              HasSubstr("got axial_displacement_um; expected a response of the whole case"));
  EXPECT_THAT(refusal("force_kN,contact.nut.backlash_mm\n10,0.1\n"),
              HasSubstr("x.csv:1:1: error: heading: got force_kN; expected an input of the whole case, since "
                        "contact.nut.backlash_mm is a response of it"));
  EXPECT_THAT(refusal("load_case,axial_displacement_um,axial_displacement_mm\n" + name() + ",5,0.005\n"),
              HasSubstr("got axial_displacement_mm; expected each response once"));
  const ModelComparison c = run("[{file: x.csv}]", "measures.weight_kg\n5\n");
  EXPECT_EQ(std::ranges::count(c.warnings, "reference_absent", &Warning::code), 1);
}

TEST_F(AgainstReferences, OneNumberOfEachLoadCaseIsAReference) {
  const auto& r = plain().models[0].load_cases[0];
  const ModelComparison c = run("[{file: x.csv}]", fmt::format("load_case,axial_stiffness_N_per_um\n{},{:.12g}\n",
                                                               name(), *r.axial_stiffness * 1e-6));
  EXPECT_NEAR(c.references[0].models[0].deviations->largest, 0.0, 1e-6);
}

TEST_F(AgainstReferences, WhatIsWrongIsNamedWhereItStands) {
  const std::string head = "load_case,thread,screw.load_rate_percent\n", first = name() + ",1,5\n";
  EXPECT_THAT(refusal("load_case,thread,screw.load_rat_percent\n" + first),
              AllOf(HasSubstr("x.csv:1:18: error: heading: got screw.load_rat_percent"),
                    HasSubstr("did you mean `screw.load_rate_percent`")));
  EXPECT_THAT(refusal(head + name() + ",21,5\n"), HasSubstr("error: thread: got 21; expected a thread from 1 to 20"));
  EXPECT_THAT(refusal(head + name() + ",1.5,5\n"), HasSubstr("error: thread: got 1.5; expected a thread from 1 to 20"));
  EXPECT_THAT(
      refusal(head + first + first),
      HasSubstr(fmt::format("x.csv:3:{}: error: thread: got thread 1 of {} a second time", name().size() + 2, name())));
  EXPECT_THAT(refusal(head + name() + ",1,\n"), HasSubstr("x.csv:2:"));
  EXPECT_THAT(refusal(head + name() + ",1,\n"),
              HasSubstr("screw.load_rate_percent: got nothing; expected a finite number"));
  EXPECT_THAT(refusal(head + name() + ",1\n"), HasSubstr("got nothing; expected a value in each column"));
  EXPECT_THAT(refusal(head + name() + ",1,nan\n"), HasSubstr("got nan; expected a finite number"));
  EXPECT_THAT(refusal("load_case,thread,screw.load_rate_kN\n" + first),
              HasSubstr("x.csv:1:18: error: heading: got screw.load_rate_kN"));
  EXPECT_THAT(refusal(head + "nowhere,1,5\n"),
              HasSubstr("x.csv:2:1: error: load_case: got nowhere; expected a load case that is solved"));
  EXPECT_THAT(refusal(""), AllOf(HasSubstr("x.csv:1:1: error: got "), HasSubstr("x.csv, which has no heading")));
  EXPECT_THAT(refusal("load_case,thread,force_kN,screw.load_rate_percent\n" + name() + ",1,2,5\n"),
              HasSubstr("x.csv:1:18: error: heading: got force_kN; expected `thread` or a force, not both"));
  EXPECT_THAT(refusal(head), HasSubstr("x.csv, which has no rows"));
  EXPECT_THAT(refusal("thread,screw.load_rate_percent\n1,5\n"), HasSubstr("which names no load case"));
  EXPECT_THAT(refusal("load_case,thread\n" + name() + ",1\n"), HasSubstr("no column with the name of a response"));
  EXPECT_THAT(refusal("load_case,force_kN,axial_displacement_um\n" + name() + ",0,5\n"),
              HasSubstr(fmt::format("x.csv:2:{}: error: force_kN: got 0 kN", name().size() + 2)));
}

TEST_F(AgainstReferences, WhatIsWrongInTheBlockIsNamedThere) {
  const std::string csv = "thread,share,s\n1,5,0.1\n2,6,0.1\n";
  const auto with = [&](const std::string& keys) {
    return refusal(csv, fmt::format("[{{file: x.csv, response: screw.load_rate_percent, {}}}]", keys));
  };
  const std::string here = fmt::format("load_case: {}", name());
  EXPECT_EQ(with(here), "accepted");
  EXPECT_EQ(with(here + ", deviation: {column: s, unit: \"%\"}, measured: {column: share, unit: \"%\"}"), "accepted");
  EXPECT_THAT(with("load_case: nowhere"), HasSubstr("references[0].load_case: got nowhere"));
  EXPECT_THAT(with(here + ", measured: {column: shar}"), HasSubstr("references[0].measured.column: got shar"));
  EXPECT_THAT(with(here + ", measured: {column: share, unit: mm}"),
              HasSubstr("references[0].measured.unit: got mm; expected a unit of the response"));
  EXPECT_THAT(with(here + ", tolerance: 5 mm"), HasSubstr("references[0].tolerance: got 5 mm"));
  EXPECT_THAT(with(here + ", tolerance: -5 % of the mean"), HasSubstr("references[0].tolerance: got -5 % of the mean"));
  EXPECT_THAT(refusal(csv, fmt::format("[{{file: x.csv, response: axial_displacement_um, {}}}]", here)),
              HasSubstr("references[0].response: got axial_displacement_um; expected an array over threads"));
  EXPECT_THAT(refusal(csv, "[{file: y.csv}]"), HasSubstr("references[0].file: got y.csv"));
}

/// The finite elements of validation/reference_fe: at 45 kN bars lie up to 9.4 % from the share of a screw thread and
/// 19.6 % from that of a nut thread, refined bodies within 14 % of the mean thread (docs/refined.md).
TEST(ReferencesOfLesson38, AreThoseOfTheFiniteElements) {
  const std::string file = PRS_SOURCE_DIR "/configs/38_reference.yaml";
  const input::Source source = input::load_source(file, {});
  const ModelComparison c = compare_analysis().run(source, input::read_case_input(source, Command::compare));
  ASSERT_EQ(c.references.size(), 13U);
  double screw = 0.0, nut = 0.0;
  for (const ReferenceComparison& r : c.references) {
    if (!r.reference.is_over_threads()) continue;
    EXPECT_NEAR(*r.sum, 100.0, 1e-3);
    double& largest = r.reference.response.starts_with("screw") ? screw : nut;
    for (std::size_t k = 0; k < r.reference.readings.size(); ++k) {
      const double value = r.reference.readings[k].value;
      largest = std::max(largest, std::abs(r.models[0].computed[k] / value - 1.0));
      EXPECT_LT(std::abs(r.models[1].computed[k] - value), 0.14 * 5.0);
    }
    EXPECT_LT(r.models[1].deviations->rms, r.models[0].deviations->rms) << r.reference.load_case;
  }
  EXPECT_NEAR(screw, 0.094, 0.0005);
  EXPECT_NEAR(nut, 0.196, 0.0005);
  EXPECT_TRUE(compare_analysis().within_tolerance(c));
}

/// The nut thread with the largest deviation, 19.6 %, over the tolerance.
TEST(ReferencesOfTheProgram, AreACriterionOfTheVerdict) {
  const auto criterion = [](const std::string& tolerance) {
    const test::Outcome checked = test::run_prs("check configs/38_reference.yaml --json " + tolerance);
    const Json document = Json::parse(checked.out);
    for (const Json& c : document["verdict"]["criteria"])
      if (c["name"] == "references") return c;
    return Json();
  };
  const Json met = criterion(""), missed = criterion("--set 'references[0].tolerance=5 % of each value'");
  EXPECT_NEAR(met["value"], 19.6 / 20.0, 0.003);
  EXPECT_EQ(met["state"], "green");
  EXPECT_NEAR(missed["value"], 19.6 / 5.0, 0.01);
  EXPECT_EQ(missed["state"], "red");
}

/// Curves over the force of a screw whose threads come from its geometry, against single runs.
TEST(ReferencesOfTheProgram, GoOverTheForceOfADesignToo) {
  const test::TemporaryDirectory folder;
  const std::string at = folder.path().string();
  ASSERT_EQ(test::run_prs("new standard " + at + "/n.yaml --screw-diameter 30mm --lead 10mm").status, 0);
  std::string csv = "load_case,force_kN,axial_displacement_um\n";
  for (const int force : {5, 10}) {
    const test::Outcome run =
        test::run_prs(fmt::format("solve {}/n.yaml --json --set 'load_cases[0].axial_force={} kN'", at, force));
    csv += fmt::format("tension,{},{}\n", force,
                       Json::parse(run.out)["load_cases"][0]["axial_displacement_um"].get<double>());
  }
  std::ofstream(at + "/r.csv") << csv;
  const test::Outcome compared = test::run_prs(fmt::format("compare {0}/n.yaml --reference {0}/r.csv --json", at));
  ASSERT_EQ(compared.status, 0) << compared.err;
  const Json reference = Json::parse(compared.out)["references"][0];
  EXPECT_EQ(reference["count"], 2);
  EXPECT_NEAR(reference["largest_deviation"]["value"], 0.0, 1e-9);
}

TEST(ReferencesOfTheProgram, StandOnThePage) {
  const test::TemporaryDirectory folder;
  const std::string page = (folder.path() / "page.html").string();
  ASSERT_EQ(test::run_prs("report configs/38_reference.yaml --static --output " + page).status, 0);
  const std::string text = test::content_of(page);
  EXPECT_THAT(text, HasSubstr("data-figure=\"reference_butterfly\""));
  EXPECT_THAT(text, HasSubstr("finite elements, config1-tension"));
}

TEST(ReferencesOfTheProgram, HaveTensionOnTheSideThatTheCaseAsksFor) {
  for (const std::string butterfly : {"mean", "load"}) {
    const input::Source source =
        input::load_source(PRS_SOURCE_DIR "/configs/38_reference.yaml", {"report.butterfly=" + butterfly});
    const input::CaseInput in = input::read_case_input(source, Command::compare);
    const ModelComparison c = compare_analysis().run(source, in);
    const Figure drawn = figure(compare_analysis().pictures(c, in.values), "reference_butterfly", {});
    const double x = drawn.panels[0].series.back().parts[0][0][0];  // Compression comes last.
    EXPECT_THAT(drawn.title, HasSubstr(butterfly == "mean" ? "tension to the right" : "tension to the left"));
    EXPECT_EQ(x < 0.0, butterfly == "mean");
  }
}

TEST(ReferencesOfTheProgram, EndWithFourBeyondATolerance) {
  const std::string lesson = "compare configs/38_reference.yaml";
  EXPECT_EQ(test::run_prs(lesson + " --quiet").status, 0);
  const test::Outcome beyond = test::run_prs(lesson + " --set 'references[0].tolerance=5 % of the mean'");
  EXPECT_EQ(beyond.status, 4);
  EXPECT_THAT(beyond.out, HasSubstr("not met"));
}

void write(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

TEST(ReferencesOfTheProgram, AreFilesOfTheCurrentFolder) {
  const test::TemporaryDirectory folder;
  write(folder.path() / "fe.csv", "load_case;thread;screw.load_rate_percent\nconfig1-tension;1;8,1\n");
  const std::string prs = fmt::format("compare {}/configs/01_config_1_to_3.yaml --json --reference ", PRS_SOURCE_DIR);
  const test::Outcome done = test::run_prs(prs + "fe.csv", folder.path());
  ASSERT_EQ(done.status, 0) << done.err;
  const Json r = Json::parse(done.out)["references"];
  ASSERT_EQ(r.size(), 1U);
  EXPECT_EQ(r[0]["points"][0]["reference"], 8.1);
  const test::Outcome missing = test::run_prs(prs + "none.csv", folder.path());
  EXPECT_EQ(missing.status, 2);
  EXPECT_EQ(missing.out, "");
  write(folder.path() / "fe.csv", "load_case,thread,screw.load_rate_percent\nconfig1-tension,21,8\n");
  const test::Outcome wrong = test::run_prs(prs + "fe.csv", folder.path());
  EXPECT_EQ(wrong.status, 2);
  EXPECT_EQ(wrong.out, "");
  EXPECT_THAT(wrong.err, HasSubstr("fe.csv:2:17: error: thread: got 21; expected a thread from 1 to 20"));
  const std::string from_root = (folder.path() / "fe.csv").string();
  EXPECT_THAT(test::run_prs(prs + from_root).err, testing::StartsWith(from_root + ":2:17: error: thread: got 21"));
}

}  // namespace
}  // namespace prs
