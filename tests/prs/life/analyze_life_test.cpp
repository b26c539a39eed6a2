#include "prs/life/analyze_life.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <random>

#include "prs/input/reader.h"
#include "prs/loads/analyze.h"
#include "prs/loads/load_case_result.h"
#include "prs/losses/life_analysis.h"
#include "prs/model/problems.h"
#include "prs/record/pictures.h"
#include "prs/text.h"
#include "tests/prs/input/abevi.h"
#include "tests/support/parsed_csv.h"
#include "tests/support/sanitized.h"

namespace prs {
namespace {

constexpr double kLead = 5e-3;
constexpr int kRollers = 11, kThreads = 20;

/// The screw of Abevi 2015 in CONFIG 2 with a block `life`.
Case life_case(const std::string& life, const std::vector<std::string>& overrides = {}) {
  return input::read_case_text(input::kAbevi + "life: " + life + "\n", "test.yaml", overrides, Command::life);
}

std::string spectrum(const std::string& loads, const std::string& more = "") {
  return "{position: 29.1666667 mm, spectrum: [" + loads + "]" + more + "}";
}

const std::string kMixed = R"({force: 4 kN, direction: tension, revolutions: 5e4},
  {force: 30 kN, direction: tension, revolutions: 1e3},
  {force: 12 kN, direction: compression, revolutions: 2e4},
  {force: 18 kN, direction: tension, revolutions: 7e3})";

/// Forces of a file, each over the same travel.
LoadHistory history(std::vector<double> force) {
  LoadHistory h;
  for (std::size_t k = 0; k < force.size(); ++k) h.position.push_back(1e-3 * static_cast<double>(k));
  h.force = std::move(force);
  return h;
}

Case history_case() {
  return life_case(
      "{position: 29.1666667 mm, history: {file: f.csv, force: {column: F, unit: N}, "
      "position: {column: x, unit: m}}}");
}

TEST(AnalyzeLife, EqualSharesGiveTheCatalogueLife) {
  const LifeResult r =
      analyze_life(life_case(spectrum("{force: 12 kN, direction: tension, revolutions: 10}", ", share: equal")));
  ASSERT_TRUE(r.converged());
  EXPECT_NEAR(r.mean_load, 12e3, 1e-9);
  EXPECT_NEAR(r.system_life / rating_life(r.dynamic_capacity, 12e3), 1.0, 1e-13);
  EXPECT_NEAR(r.system_life / r.catalogue_life, 1.0, 1e-13);
  for (const Interface i : kInterfaces)
    for (const double load : r.flanks.tension->threads[i].equivalent_load)
      EXPECT_NEAR(load, 12e3 / (kRollers * kThreads), 1e-11);
  EXPECT_FALSE(r.flanks.compression);
}

TEST(AnalyzeLife, BothFlanksFailOnTheirOwn) {
  const LifeResult r =
      analyze_life(life_case(spectrum("{force: 12 kN, direction: tension, share: 0.5},"
                                      "{force: 12 kN, direction: compression, share: 0.5}",
                                      ", share: equal")));
  // Each flank lives twice as long as under the load of all revolutions: 2 * 2^(-9/10).
  EXPECT_NEAR(r.system_life / r.catalogue_life, std::pow(2.0, 0.1), 1e-13);
  EXPECT_FALSE(r.revolutions_known);
  EXPECT_EQ(r.revolutions, 1.0);
}

/// Lives from every load's separate equilibrium, by `analyze`, with the formulas of ISO/TS 16281.
struct Direct {
  double life = 0.0;
  PerInterface<std::vector<double>> equivalent;
};

Direct direct(const LifeResult& r, Case c, Direction d) {
  std::vector<double> cubes(2 * kThreads, 0.0);
  for (const LoadStep& s : r.steps) {
    const double force = d == Direction::tension ? s.axial_force : -s.axial_force;
    if (force <= 0.0) continue;
    LoadCase load;
    load.axial_force = force;
    load.direction = d;
    load.position = c.life->position;
    c.load_cases = {load};
    const Result solved = analyze(c);
    for (const Interface i : kInterfaces)
      for (std::size_t k = 0; k < kThreads; ++k)
        cubes[k + (i == Interface::nut ? kThreads : 0)] +=
            std::pow((*solved.load_cases[0].threads)[i].axial_load[k], 3) * s.revolutions;
  }
  Direct answer;
  double hazard = 0.0;
  for (const Interface i : kInterfaces)
    for (std::size_t k = 0; k < kThreads; ++k) {
      const double load = std::cbrt(cubes[k + (i == Interface::nut ? kThreads : 0)] / r.revolutions);
      answer.equivalent[i].push_back(load);
      // Capacity of a contact: C_a over the contacts, with the share of its ring.
      const double capacity =
          r.dynamic_capacity / (kRollers * kThreads) * std::pow(kThreads / r.failure_shares[i], 0.3);
      hazard += std::pow(1e6 * std::pow(capacity / load, 3), -10.0 / 9);
    }
  answer.life = std::pow(hazard, -0.9);
  return answer;
}

TEST(AnalyzeLife, TakesThreadLoadsAtEveryLoad) {
  const Case c = life_case(spectrum(kMixed));
  const LifeResult r = analyze_life(c);
  ASSERT_TRUE(r.converged());
  for (const Direction d : kDirections) {
    const Direct expected = direct(r, c, d);
    const FlankLife& flank = *r.flanks[d];
    EXPECT_NEAR(flank.life / expected.life, 1.0, 1e-7);
    for (const Interface i : kInterfaces)
      for (std::size_t k = 0; k < kThreads; ++k)
        EXPECT_NEAR(flank.threads[i].equivalent_load[k] / expected.equivalent[i][k], 1.0, 1e-8);
  }
  const double lives[] = {r.flanks.tension->life, r.flanks.compression->life};
  EXPECT_NEAR(r.system_life / combined_life(lives), 1.0, 1e-14);
  EXPECT_LT(r.system_life, r.equal_shares_life);
}

TEST(AnalyzeLife, OfARandomHistoryIsThatOfItsSamples) {
  std::mt19937 random(8);
  std::normal_distribution<double> force(2e3, 6e3);
  std::vector<double> forces(60);
  for (double& f : forces) f = force(random);
  const Case c = history_case();
  const LifeResult r = analyze_life(c, history(forces));
  for (const Direction d : kDirections) EXPECT_NEAR(r.flanks[d]->life / direct(r, c, d).life, 1.0, 1e-7);
}

TEST(AnalyzeLife, WeakestThreadHasTheShortestLife) {
  const LifeResult r = analyze_life(life_case(spectrum(kMixed)));
  ASSERT_TRUE(r.weakest);
  EXPECT_EQ(r.weakest->direction, Direction::tension);
  EXPECT_EQ(r.weakest->interface, Interface::screw);
  EXPECT_EQ(r.weakest->thread, 0u);
  for (const Direction d : kDirections)
    for (const Interface i : kInterfaces)
      for (const double life : r.flanks[d]->threads[i].life) EXPECT_GE(life, r.weakest->life);
}

TEST(AnalyzeLife, CatalogueLifeFollowsTheMeanLoad) {
  const LifeResult r = analyze_life(life_case(spectrum(kMixed)));
  const double mean = std::cbrt((5e4 * 64 + 1e3 * 27000 + 2e4 * 1728 + 7e3 * 5832) / 78e3) * 1e3;
  EXPECT_NEAR(r.mean_load, mean, 1e-9 * mean);
  EXPECT_NEAR(r.catalogue_life, 1e6 * std::pow(r.dynamic_capacity / mean, 3), 1e-3);
  EXPECT_EQ(r.revolutions, 78e3);
}

TEST(AnalyzeLife, StaticCapacityGivesTheLimitPressure) {
  const Case c = life_case(spectrum(kMixed));
  const LifeResult r = analyze_life(c);
  for (const Direction d : kDirections) {
    Case at_capacity = c;
    LoadCase load;
    load.axial_force = *r.flanks[d]->static_capacity;
    load.direction = d;
    load.position = c.life->position;
    at_capacity.load_cases = {load};
    const Result solved = analyze(at_capacity);
    double pressure = 0.0;
    for (const Interface i : kInterfaces)
      for (const double p : (*solved.load_cases[0].threads)[i].peak_pressure) pressure = std::max(pressure, p);
    EXPECT_NEAR(pressure / kStaticPressureLimit, 1.0, 1e-9);
  }
  EXPECT_NEAR(*r.static_safety(),
              std::min(*r.flanks.tension->static_capacity / 30e3, *r.flanks.compression->static_capacity / 12e3),
              1e-12);
}

TEST(AnalyzeLife, StaticCapacityOfEqualSharesScalesWithTheCubeOfPressure) {
  const LifeResult r =
      analyze_life(life_case(spectrum("{force: 10 kN, direction: tension, share: 1}", ", share: equal")));
  const FlankLife& flank = *r.flanks.tension;
  const double pressure = std::max(*flank.peak_pressure.screw, *flank.peak_pressure.nut);
  const double expected = 10e3 * std::pow(kStaticPressureLimit / pressure, 3);
  EXPECT_NEAR(*r.equal_shares_static_capacity / expected, 1.0, 1e-12);
  EXPECT_NEAR(*flank.static_capacity / expected, 1.0, 1e-9);
}

TEST(AnalyzeLife, CapacitiesOfACatalogueComeFirst) {
  const LifeResult r =
      analyze_life(life_case(spectrum("{force: 10 kN, direction: tension, share: 1}",
                                      ", share: equal, dynamic_capacity: 50 kN, static_capacity: 90 kN")));
  EXPECT_FALSE(r.lemor);
  EXPECT_NEAR(r.system_life, 125e6, 1e-5);
  EXPECT_NEAR(*r.static_safety(), 9.0, 1e-14);
}

const std::string kBearing = "bearings: {fixed: {dynamic_capacity: 50 kN, static_capacity: 90 kN, preload: 5 kN}}\n";

// Loads, shares and numbers of the definition; a stated capacity gives the screw 30 million revolutions.
TEST(BearingLife, IsThatOfTheSolvedCase) {
  const double mean = std::cbrt(0.3 * 1e12 + 0.2 * 8e12 + 0.5 * 8e9);
  const Case c = input::read_case_text(
      input::kAbevi + kBearing +
          fmt::format(
              "life: {{share: equal, dynamic_capacity: {:.12g} N, spectrum: [{{force: 10 kN, direction: tension, "
              "share: 0.3}}, {{force: 20 kN, direction: compression, share: 0.2}}, {{force: 2 kN, direction: "
              "tension, share: 0.5}}]}}\n",
              std::cbrt(30.0) * mean),
      "test.yaml", {}, Command::life);
  const LifeResult r = analyze_life(c);
  ASSERT_TRUE(r.bearing);
  EXPECT_NEAR(r.bearing->equivalent_load, 12864.4321, 5e-5);
  EXPECT_NEAR(*r.bearing->life * 1e-6, 58.7135, 5e-5);
  EXPECT_NEAR(r.screw_life() * 1e-6, 30.0, 1e-9);
  EXPECT_NEAR(*r.life_with_bearings() * 1e-6, 21.1551, 5e-5);
  EXPECT_NEAR(*r.bearing->static_safety, 4.5, 1e-12);
}

TEST(BearingLife, WaysWithoutForceTurnUnderThePreload) {
  const auto of = [](const std::string& more) {
    return analyze_life(input::read_case_text(
        input::kAbevi + kBearing + "life: {share: equal, spectrum: [{force: 10 kN, direction: tension, distance: 5 m}" +
            more + "}\n",
        "test.yaml", {}, Command::life));
  };
  const LifeResult loaded = of("]"), idle = of("], travel: 15 m");
  const double cube = std::pow(preloaded_bearing_load(10e3, 5e3), 3);
  EXPECT_NEAR(idle.bearing->revolutions, 3.0 * loaded.bearing->revolutions, 1e-9);
  EXPECT_NEAR(std::pow(idle.bearing->equivalent_load, 3) / ((cube + 2.0 * std::pow(5e3, 3)) / 3.0), 1.0, 1e-12);
  // In passes: three times the revolutions of the bearing belong to those of the screw under load.
  EXPECT_NEAR(*idle.bearing_life() * 3.0 / *idle.bearing->life, 1.0, 1e-12);
  EXPECT_NEAR(*loaded.bearing_life() / *loaded.bearing->life, 1.0, 1e-12);
}

TEST(AnalyzeLife, TravelAndPeriodHoldTheMotionUnderLoad) {
  const auto life = [](const std::string& more, const std::string& speed = "100 rpm") {
    return analyze_life(life_case(spectrum("{force: 10 kN, direction: tension, revolutions: 100}", more),
                                  {"operation.speed=" + speed}));
  };
  const auto is_short = [](const LifeResult& r) {
    return std::ranges::count(r.warnings, "short_period", &Warning::code) == 1;
  };
  EXPECT_FALSE(is_short(life(", travel: 500 mm, period: 60 s")));
  EXPECT_TRUE(is_short(life(", travel: 500 mm, period: 59 s")));
  EXPECT_FALSE(is_short(life(", travel: 500 mm, period: 59 s", "110 rpm")));
  EXPECT_THROW(life(", travel: 499 mm"), input::InputError);
}

TEST(AnalyzeLife, HoursFollowTheMissionOrTheSpeed) {
  const std::string loads =
      "{force: 10 kN, direction: tension, duration: 2 h},"
      "{force: 5 kN, direction: tension, duration: 1 h}";
  const LifeResult timed = analyze_life(life_case(spectrum(loads), {"operation={speed: 300 rpm}"}));
  EXPECT_NEAR(timed.revolutions, 54e3, 1e-8);
  EXPECT_NEAR(*timed.duration, 10800.0, 1e-9);
  EXPECT_NEAR(*timed.revolution_rate, 5.0, 1e-12);
  const LifeResult untimed = analyze_life(life_case(spectrum(kMixed)));
  EXPECT_FALSE(untimed.revolution_rate);
  EXPECT_FALSE(untimed.duration);
}

TEST(AnalyzeLife, RestUnderLoadCostsNoLife) {
  const double life = analyze_life(history_case(), history({8e3, 8e3, 8e3})).system_life;
  LoadHistory resting = history({8e3, 8e3, 8e3, 8e3, 20e3});
  resting.position = {0.0, 1e-3, 2e-3, 2e-3, 2e-3};
  const LifeResult r = analyze_life(history_case(), resting);
  EXPECT_NEAR(r.system_life / life, 1.0, 1e-7);
  EXPECT_EQ(r.largest_force, 20e3);
}

TEST(AnalyzeLife, LoadsAtRestAloneWearNothing) {
  LoadHistory h = history({0.0, 0.0, 0.0, 9e3, -9e3});
  h.position = {0.0, 1e-3, 2e-3, 2e-3, 2e-3};
  const LifeResult r = analyze_life(history_case(), h);
  EXPECT_TRUE(std::isinf(r.system_life));
  EXPECT_FALSE(r.weakest);
  EXPECT_GT(*r.static_safety(), 1.0);
  EXPECT_FALSE(document_of(life_analysis(), r, {})["life"]["system"].contains("l10_revolutions"));
  EXPECT_EQ(figures(life_analysis().pictures(r, Case{})).size(), 2u);
}

TEST(AnalyzeLife, EquivalentRangesAreThoseOfTheThreadLoads) {
  // One full swing between 5 kN of compression and 15 kN of tension: two halves.
  const LifeResult r = analyze_life(history_case(), history({-5e3, 15e3, -5e3}));
  ASSERT_TRUE(r.cycles);
  EXPECT_EQ(count(r.cycles->cycles), 1.0);
  EXPECT_NEAR(r.cycles->equivalent_range, 20e3, 1e-9);
  for (const Direction d : kDirections)
    for (const Interface i : kInterfaces)
      for (std::size_t k = 0; k < kThreads; ++k)
        // Each flank is loaded from nothing to its largest load.
        EXPECT_NEAR(r.flanks[d]->threads[i].equivalent_range[k] / r.flanks[d]->threads[i].largest_load[k], 1.0, 1e-12);
}

TEST(AnalyzeLife, ThreadLoadsSumToTheForce) {
  const LifeResult r = analyze_life(life_case(spectrum(kMixed)));
  for (const Interface i : kInterfaces) {
    const std::vector<double>& loads = r.flanks.tension->threads[i].largest_load;
    EXPECT_NEAR(std::accumulate(loads.begin(), loads.end(), 0.0), 30e3 / kRollers, 1e-6);
  }
}

/// Path and message with which a case is refused.
std::pair<std::string, std::string> refused(const Case& c, std::optional<LoadHistory> h = {}) {
  try {
    analyze_life(c, std::move(h));
  } catch (const CaseError& error) {
    return {error.path(), error.what()};
  }
  return {};
}

TEST(AnalyzeLife, RefusesLoadsWithoutLife) {
  LoadHistory still = history({1e3, 2e3});
  still.position = {0.0, 0.0};
  EXPECT_THAT(refused(history_case(), still).second, testing::HasSubstr("does not turn"));
  EXPECT_THAT(refused(history_case(), history({0.0, 0.0})).second, testing::HasSubstr("no load other than 0"));
  LoadHistory stopped = history({1e3, 2e3});
  stopped.time = {1.0, 1.0};
  EXPECT_EQ(refused(history_case(), stopped).first, "life.history.time");
  Case c = history_case();
  c.structure->nut.thrust.compression.reset();
  EXPECT_EQ(refused(c, history({1e3, -1e3})).first, "structure.nut.thrust.compression");
  EXPECT_EQ(refused(c, history({1e3, 0.0})).first, "");
}

TEST(AnalyzeLife, RefusesRatiosBeyondTheFactorUnlessTheCapacityIsGiven) {
  Case c = life_case(spectrum("{force: 10 kN, direction: tension, share: 1}", ", share: equal"));
  // Rollers three times as thick as the screw: d_r cos(alpha)/d_n = 0.303.
  c.mechanism.rollers = 2;
  c.mechanism.pitch_diameter = {21e-3, 63e-3, 147e-3};
  c.mechanism.centre_distance = 42e-3;
  c.structure->nut.outer_diameter = 170e-3;
  c.structure->nut.flanges.clear();
  EXPECT_EQ(refused(c).first, "mechanism.pitch_diameter.roller");
  c.life->dynamic_capacity = 50e3;
  EXPECT_EQ(refused(c).first, "");
}

TEST(AnalyzeLife, WarnsOfLoadsBeyondTheFormula) {
  const LifeResult r = analyze_life(life_case(spectrum("{force: 60 kN, direction: tension, share: 1}")));
  EXPECT_THAT(sentences(r.warnings), testing::Contains(testing::HasSubstr("exceeds 4 GPa")));
  EXPECT_THAT(sentences(r.warnings), testing::Contains(testing::HasSubstr("92.9 % of the dynamic capacity")));
}

/// Paths with which a case text is refused.
std::string input_error(const std::string& life, const std::vector<std::string>& set = {}) {
  try {
    life_case(life, set);
  } catch (const input::InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(LifeInput, SaysWhatIsWrongWithASpectrum) {
  using testing::HasSubstr;
  EXPECT_THAT(input_error("{position: 10 mm}"), HasSubstr("life.spectrum: missing"));
  EXPECT_THAT(input_error(spectrum("{force: 1 kN, direction: tension}")), HasSubstr("life.spectrum[0].share: missing"));
  EXPECT_THAT(input_error(spectrum("{force: 1 kN, direction: tension, share: 0.5, revolutions: 3}")),
              HasSubstr("life.spectrum[0].share"));
  EXPECT_THAT(input_error(spectrum("{force: 1 kN, direction: tension, share: 0.5},"
                                   "{force: 1 kN, direction: tension, revolutions: 3}")),
              HasSubstr("life.spectrum[1]: mixes `share`"));
  EXPECT_THAT(input_error(spectrum("{force: 1 kN, direction: tension, share: 0.5}")),
              HasSubstr("life.spectrum: got shares with the sum 0.5"));
  EXPECT_THAT(input_error(spectrum("{force: 1 kN, direction: tension, duration: 1 h}")),
              HasSubstr("life.spectrum[0].duration: got a duration without speed"));
  EXPECT_THAT(input_error(spectrum("{force: -1 kN, direction: tension, share: 1}")),
              HasSubstr("life.spectrum[0].force: got -1 kN"));
  EXPECT_THAT(input_error("{spectrum: [{force: 1 kN, direction: tension, share: 1}]}"),
              HasSubstr("life.position: missing"));
  EXPECT_THAT(input_error("{position: 80 mm, spectrum: [{force: 1 kN, direction: tension, "
                          "share: 1}]}"),
              HasSubstr("life.position: got 80 mm; expected 0 mm to 58.33333 mm"));
  EXPECT_THAT(
      input_error(spectrum("{force: 1 kN, direction: tension, share: 1}"),
                  {"structure.nut.thrust={compression: 80 mm}", "load_cases=[{axial_force: 1 kN, share: equal}]"}),
      HasSubstr("structure.nut.thrust.tension: missing"));
}

TEST(LifeInput, SaysWhatAHistoryLacks) {
  using testing::HasSubstr;
  const std::string head = "{position: 10 mm, history: {file: f.csv, force: {column: F, unit: N}";
  EXPECT_THAT(input_error(head + "}}"), HasSubstr("life.history: got neither `position` nor a clock"));
  EXPECT_THAT(input_error(head + ", interval: 1 s}}"), HasSubstr("life.history: got neither `position` nor a speed"));
  EXPECT_THAT(input_error(head + ", interval: 1 s, time: {column: t, unit: s}}}"), HasSubstr("life.history.interval"));
  EXPECT_EQ(input_error(head + ", interval: 1 s}}", {"operation={speed: 100 rpm}"}), "no error");
  EXPECT_EQ(input_error(head + ", position: {column: x, unit: mm}}}"), "no error");
}

TEST(LifeOutput, SaysTheSameInEveryForm) {
  const LifeResult r = analyze_life(history_case(), history({1e3, 15e3, -4e3, 9e3, 2e3, 12e3, -8e3, 0.0}));
  const auto json = document_of(life_analysis(), r, {})["life"];
  EXPECT_NEAR(json["system"]["l10_revolutions"].get<double>(), r.system_life, 1.0);
  EXPECT_NEAR(json["system"]["l10_travel_km"].get<double>(), r.system_life * kLead * 1e-3, 1e-6);
  EXPECT_NEAR(json["system"]["l10_passes"].get<double>(), r.system_life / 1.4, 1e-3);
  EXPECT_FALSE(json["system"].contains("l10_hours"));
  const auto range = json["system"]["l10_revolutions_range"];
  EXPECT_LT(range[0].get<double>(), r.system_life);
  EXPECT_GT(range[1].get<double>(), r.system_life);
  double counted = 0.0;
  for (const auto& row : json["cycles"]["matrix"]["count"])
    for (const auto& n : row) counted += n.get<double>();
  EXPECT_EQ(counted, json["cycles"]["count"].get<double>());
  EXPECT_EQ(json["tension"]["screw"]["equivalent_load_N"].size(), kThreads);

  const auto threads = test::parse_fields(life_threads_csv(r));
  EXPECT_EQ(threads.size(), 1u + 2 * 2 * kThreads);
  EXPECT_EQ(test::parse_fields(cycles_csv(*r.cycles)).size(), 1 + r.cycles->cycles.size());
  const std::string table = life_table(r);
  EXPECT_THAT(table, testing::HasSubstr("mechanism, real thread loads"));
  for (std::size_t begin = 0; begin < table.size();) {
    const std::size_t end = table.find('\n', begin);
    EXPECT_LE(width(table.substr(begin, end - begin)), 110u);
    begin = end + 1;
  }
  EXPECT_EQ(figures(life_analysis().pictures(r, Case{})).size(), 4u);
}

TEST(AnalyzeLife, StaticSafetyNamesItsLimit) {
  const LifeResult r = analyze_life(life_case(spectrum(kMixed)));
  const auto json = document_of(life_analysis(), r, {})["life"];
  EXPECT_EQ(json["static_safety_limit"], name(*r.static_safety_limit()));
  for (const Direction d : kDirections) {
    const FlankLife& flank = *r.flanks[d];
    EXPECT_EQ(flank.static_rating->force, *flank.static_capacity);
    EXPECT_NEAR(json[name(d)]["flank_edge_margin"].get<double>(), *flank.flank_edge_load / flank.largest_force, 1e-12);
    EXPECT_NEAR(json[name(d)]["static_safety"].get<double>(), flank.static_rating->force / flank.largest_force, 1e-12);
  }
  // A stated capacity determines both directions as it does the whole.
  const LifeResult given =
      analyze_life(life_case(spectrum("{force: 10 kN, direction: tension, share: 1}", ", static_capacity: 20 kN")));
  EXPECT_EQ(document_of(life_analysis(), given, {})["life"]["tension"]["static_safety"], 2.0);
  EXPECT_EQ(given.static_safety_limit(), StaticLimit::given);
}

TEST(AnalyzeLife, PressuresInRunningAreThoseUnderLoadsThatTurn) {
  LoadHistory h = history({8e3, 8e3, 8e3, 8e3, 40e3});
  h.position = {0.0, 1e-3, 2e-3, 2e-3, 2e-3};
  const LifeResult r = analyze_life(history_case(), h);
  const FlankLife& flank = *r.flanks.tension;
  EXPECT_LT(*flank.running_peak_pressure.screw, 0.7 * *flank.peak_pressure.screw);
  EXPECT_GT(*flank.peak_pressure.screw, kRunningPressureLimit);
  EXPECT_THAT(sentences(r.warnings), ::testing::Not(::testing::Contains(::testing::HasSubstr("run"))));
}

/// Compares each L10 of the document with the rated life beside it.
void expect_rated(const nlohmann::ordered_json& object, double factor, int& found) {
  for (const auto& [key, value] : object.items()) {
    if (value.is_object()) expect_rated(value, factor, found);
    if (!key.starts_with("l10_")) continue;
    ++found;
    const auto& rated = object.at("rated_" + key.substr(4));
    if (value.is_number()) {
      EXPECT_NEAR(rated.get<double>(), factor * value.get<double>(), 1e-12 * value.get<double>());
      continue;
    }
    ASSERT_EQ(rated.size(), value.size());
    for (std::size_t k = 0; k < value.size(); ++k)
      EXPECT_NEAR(rated[k].get<double>(), factor * value[k].get<double>(), 1e-12 * value[k].get<double>());
  }
}

TEST(LifeOutput, HasTheRatedLifeNextToEachL10) {
  const std::string more = ", reliability: 97 %, modification_factor: 3";
  const Case c = life_case(spectrum(kMixed, more), {"operation={speed: 100 rpm}"});
  const auto json = document_of(life_analysis(), analyze_life(c), {})["life"];
  EXPECT_EQ(json["reliability_factor"], 0.47);
  EXPECT_EQ(json["modification_factor"], 3.0);
  int found = 0;
  expect_rated(json, 0.47 * 3.0, found);
  EXPECT_GT(found, 25);
  const auto plain = document_of(life_analysis(), analyze_life(life_case(spectrum(kMixed))), {})["life"];
  EXPECT_EQ(plain["reliability_factor"], 1.0);
  EXPECT_EQ(plain["system"]["rated_revolutions"], plain["system"]["l10_revolutions"]);
  EXPECT_EQ(plain["system"]["l10_revolutions"], json["system"]["l10_revolutions"]);
}

std::string preload(const std::string& force) {
  return "preload={arrangement: single_nut, force: " + force +
         ", position: 29.1666667 mm, load: {from: -10 kN, to: 10 kN}}";
}

TEST(PreloadedLife, WithoutPreloadIsThatOfTheFlanksAlone) {
  const LifeResult without = analyze_life(life_case(spectrum(kMixed)));
  const LifeResult with = analyze_life(life_case(spectrum(kMixed), {preload("1 N")}));
  EXPECT_NEAR(with.system_life / without.system_life, 1.0, 1e-8);
  EXPECT_NEAR(with.equal_shares_life / without.equal_shares_life, 1.0, 1e-8);
  EXPECT_NEAR(*with.static_safety() / *without.static_safety(), 1.0, 1e-8);
  for (const Direction d : kDirections)
    for (const Interface i : kInterfaces)
      for (std::size_t k = 0; k < kThreads; ++k)
        EXPECT_NEAR(with.flanks[d]->threads[i].equivalent_load[k] / without.flanks[d]->threads[i].equivalent_load[k],
                    1.0, 1e-7);
}

TEST(PreloadedLife, ShortensWithThePreload) {
  double last = std::numeric_limits<double>::infinity();
  for (const char* force : {"1 N", "6 kN", "12 kN"}) {
    const LifeResult r =
        analyze_life(life_case(spectrum("{force: 10 kN, direction: tension, share: 1}"), {preload(force)}));
    ASSERT_TRUE(r.converged());
    EXPECT_LT(r.system_life, last);
    last = r.system_life;
  }
}

/// One thread on each flank. At rest the screw's side carries the preload P on either flank, the
/// roller floats, so that the nut's carries P tan(psi_S)/tan(psi_N); beyond the opening one flank
/// carries the force.
TEST(PreloadedLife, OfOneThreadIsThatOfFourContacts) {
  const double p = 3e3, f = 60e3;
  const LifeResult r = analyze_life(life_case(
      "{position: 29.1666667 mm, dynamic_capacity: 40 kN, spectrum: ["
      "{force: 0.001 N, direction: tension, share: 0.75},"
      "{force: 60 kN, direction: tension, share: 0.25}]}",
      {preload("3 kN"), "mechanism.contacts_per_roller=1", "contact={normal_angle: {screw: 44 deg, nut: 46 deg}}"}));
  ASSERT_TRUE(r.converged());
  const double at_nut = p * std::tan(44 * std::numbers::pi / 180) / std::tan(46 * std::numbers::pi / 180);
  const double screw_pulled = std::cbrt(0.75 * p * p * p + 0.25 * f * f * f);
  const double nut_pulled = std::cbrt(0.75 * at_nut * at_nut * at_nut + 0.25 * f * f * f);
  double hazard = 0.0;
  const auto add = [&](double load, double share) {
    hazard += share * std::pow(1e6 * std::pow(40e3 / load, 3), -10.0 / 9);
  };
  add(screw_pulled, r.failure_shares.screw);
  add(nut_pulled, r.failure_shares.nut);
  add(std::cbrt(0.75) * p, r.failure_shares.screw);
  add(std::cbrt(0.75) * at_nut, r.failure_shares.nut);
  EXPECT_NEAR(r.system_life / std::pow(hazard, -0.9), 1.0, 1e-7);
  EXPECT_NEAR(r.flanks.compression->threads.screw.equivalent_load[0] * kRollers, std::cbrt(0.75) * p, 1e-6 * p);
}

/// Cases of many forces, which are interpolated, and of few, which are solved.
TEST(PreloadedLife, OfAHistoryIsThatOfItsSamples) {
  SKIP_UNDER_SANITIZERS();
  std::mt19937 random(5);
  std::normal_distribution<double> force(1e3, 8e3);
  std::vector<double> samples(60);
  for (double& f : samples) f = force(random);
  Case c = history_case();
  c.preload = life_case(spectrum(kMixed), {preload("4 kN")}).preload;
  const LifeResult r = analyze_life(c, history(samples));
  ASSERT_TRUE(r.converged());
  EXPECT_LT(r.flanks.tension->interpolation_error, 1e-5);
  PerDirection<double> cubes;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const double turns = k == 0 || k + 1 == samples.size() ? 0.5 : 1.0;
    Case one = c;
    one.life->history.reset();
    one.life->spectrum = {
        {std::abs(samples[k]), samples[k] < 0.0 ? Direction::compression : Direction::tension, 1.0, {}, {}, {}}};
    const LifeResult alone = analyze_life(one);
    for (const Direction d : kDirections)
      cubes[d] += turns * std::pow(alone.flanks[d]->threads.screw.equivalent_load[3], 3);
  }
  for (const Direction d : kDirections)
    EXPECT_NEAR(r.flanks[d]->threads.screw.equivalent_load[3] / std::cbrt(cubes[d] / 59.0), 1.0, 1e-5);
}

/// The screw with all rollers, with the guidance of a sector.
Case full_case(const std::string& loads, const std::vector<std::string>& overrides = {}) {
  std::vector<std::string> all = {"model={mechanism: full}"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  Case c = life_case(spectrum(loads), all);
  c.load_cases.clear();
  return c;
}

TEST(FullLife, OfRollersThatAreAlikeIsThatOfTheSector) {
  const LifeResult full = analyze_life(full_case(kMixed));
  const LifeResult sector = analyze_life(life_case(spectrum(kMixed)));
  ASSERT_TRUE(full.converged());
  EXPECT_NEAR(full.system_life / sector.system_life, 1.0, 1e-8);
  for (const Direction d : kDirections) {
    EXPECT_NEAR(full.flanks[d]->life / sector.flanks[d]->life, 1.0, 1e-8);
    EXPECT_NEAR(*full.flanks[d]->static_capacity / *sector.flanks[d]->static_capacity, 1.0, 1e-8);
    EXPECT_EQ(full.flanks[d]->threads.nut.rollers->life.size(), kRollers * kThreads);
  }
}

/// Loads of unequal rollers over a turn of the carrier, solved one by one: a thread of the screw meets all of them, a
/// thread of a roller its own.
TEST(FullLife, RatesEachPartByTheLoadsThatItMeets) {
  constexpr int kFew = 4, kSteps = 2;
  const Case c = life_case(
      "{position: 29.1666667 mm, spectrum: [{force: 3 kN, direction: tension, share: 0.8},"
      "{force: 9 kN, direction: tension, share: 0.2}]}",
      {"model={mechanism: full}", "mechanism.rollers=5", "mechanism.contacts_per_roller=4",
       "deviations={roller_diameter: [4 um, 0 um, 0 um, -1 um, 0 um]}",
       "load_cases=[{name: aside, axial_force: 9 kN, direction: tension, position: "
       "29.1666667 mm, side_force: {y: 200 N, z: 0 N}, orbit: {steps: 2, exponent: 5}}]"});
  const LifeResult r = analyze_life(c);
  ASSERT_TRUE(r.converged());
  PerInterface<std::vector<double>> cubes = {std::vector<double>(5 * kFew, 0.0), std::vector<double>(5 * kFew, 0.0)};
  for (const auto& [force, share] : {std::pair{3e3, 0.8}, std::pair{9e3, 0.2}})
    for (int m = 0; m < 5 * kSteps; ++m) {
      Case at = c;
      at.load_cases[0].axial_force = force;
      at.load_cases[0].spatial.carrier_angle = 2.0 * std::numbers::pi * m / (5 * kSteps);
      at.load_cases[0].spatial.orbit.reset();
      const Result solved = analyze(at);
      for (const Interface i : kInterfaces)
        for (std::size_t k = 0; k < 5 * kFew; ++k)
          cubes[i][k] += share / (5 * kSteps) * std::pow((*solved.load_cases[0].threads)[i].axial_load[k], 3);
    }
  double hazard = 0.0;
  const auto add = [&](double load, double contacts_of_capacity, double share) {
    const double whole = load * 5 * kFew;  // The mechanism's load at equal shares.
    hazard += share / contacts_of_capacity * std::pow(1e6 * std::pow(r.dynamic_capacity / whole, 3), -10.0 / 9);
  };
  for (const Interface i : kInterfaces) {
    const ThreadLives& t = r.flanks.tension->threads[i];
    const double rollers = (*r.roller_shares)[i];
    for (std::size_t k = 0; k < kFew; ++k) {
      double all = 0.0;
      for (std::size_t j = 0; j < 5; ++j) {
        const double own = cubes[i][j * kFew + k];
        all += own / 5.0;
        EXPECT_NEAR(t.rollers->equivalent_load[j * kFew + k], std::cbrt(own), 1e-8 * t.largest_load[0]);
        add(std::cbrt(own), 5.0 * kFew, r.failure_shares[i] * rollers);
      }
      EXPECT_NEAR(t.equivalent_load[k], std::cbrt(all), 1e-8 * t.largest_load[0]);
      add(std::cbrt(all), kFew, r.failure_shares[i] * (1.0 - rollers));
    }
  }
  EXPECT_NEAR(r.system_life / std::pow(hazard, -0.9), 1.0, 1e-7);
  double shortest = std::numeric_limits<double>::infinity();
  for (const Interface i : kInterfaces) {
    const ThreadLives& t = r.flanks.tension->threads[i];
    shortest = std::min({shortest, std::ranges::min(t.life), std::ranges::min(t.rollers->life)});
  }
  ASSERT_TRUE(r.weakest);
  EXPECT_EQ(r.weakest->life, shortest);
}

/// Few loads are solved one by one, many are interpolated: damages of two halves add up.
TEST(FullLife, OfManyLoadsIsThatOfTheirHalves) {
  SKIP_UNDER_SANITIZERS();
  constexpr int kMany = 60;
  const auto life_of = [](int first, int last) {
    std::string loads;
    for (int k = first; k < last; ++k)
      loads += fmt::format("{}{{force: {} N, direction: tension, share: {}}}", loads.empty() ? "" : ", ", 200 + 150 * k,
                           1.0 / (last - first));
    return analyze_life(life_case("{position: 29.1666667 mm, spectrum: [" + loads + "]}",
                                  {"model={mechanism: full}", "mechanism.rollers=5", "mechanism.contacts_per_roller=4",
                                   "deviations={roller_diameter: [20 um, 0 um, 0 um, -1 um, 0 um]}",
                                   "load_cases=[{name: aside, axial_force: 9 kN, direction: tension, position: "
                                   "29.1666667 mm, side_force: {y: 2 N, z: 0 N}, orbit: {steps: 2}}]"}));
  };
  const LifeResult all = life_of(0, kMany), low = life_of(0, kMany / 2), high = life_of(kMany / 2, kMany);
  ASSERT_TRUE(all.converged() && low.converged() && high.converged());
  EXPECT_EQ(low.flanks.tension->interpolation_error, 0.0);
  EXPECT_GT(all.flanks.tension->interpolation_error, 0.0);
  const auto mean = [](double a, double b) { return std::cbrt(0.5 * (a * a * a + b * b * b)); };
  for (const Interface i : kInterfaces) {
    const RollerLives &a = *all.flanks.tension->threads[i].rollers, &b = *low.flanks.tension->threads[i].rollers,
                      &c = *high.flanks.tension->threads[i].rollers;
    const double largest = std::ranges::max(a.equivalent_load);
    for (std::size_t k = 0; k < a.equivalent_load.size(); ++k)
      EXPECT_NEAR(a.equivalent_load[k], mean(b.equivalent_load[k], c.equivalent_load[k]), 2e-4 * largest);
  }
}

TEST(FullLife, SaysWhichLoadIsNotHeldAndWhere) {
  const LifeResult r =
      analyze_life(life_case("{position: 29.1666667 mm, spectrum: [{force: 9 kN, direction: tension, share: 0.5}, "
                             "{force: 500 N, direction: tension, share: 0.5}]}",
                             {"model={mechanism: full}",
                              "load_cases=[{name: aside, axial_force: 9 kN, direction: "
                              "tension, position: 29.1666667 mm, side_force: {y: 400 N, z: 0 "
                              "N}}]"}));
  ASSERT_FALSE(r.converged());
  EXPECT_THAT(*r.failure, testing::HasSubstr("under 500 N in tension"));
  EXPECT_THAT(*r.failure, testing::HasSubstr("no equilibrium: flanks that only push"));
  EXPECT_THAT(*r.failure, testing::HasSubstr("(carrier at 0 deg)"));
}

TEST(FullLife, SaysWhyNothingHoldsTheLoad) {
  const LifeResult r = analyze_life(full_case(kMixed, {"mechanism.rollers=2"}));
  ASSERT_FALSE(r.converged());
  EXPECT_THAT(*r.failure, testing::HasSubstr("did not converge: mechanism: 2 motions of screw"));
}

TEST(FullLife, AsksWhichSideLoadsActWhereTheyDiffer) {
  const std::string loads =
      "load_cases=[{name: straight, axial_force: 9 kN, direction: tension, position: 29 mm},"
      "{name: aside, axial_force: 9 kN, direction: tension, position: 29 mm, "
      "side_force: {y: 200 N, z: 0 N}}]";
  const std::string block = spectrum("{force: 3 kN, direction: tension, share: 1}");
  EXPECT_THAT(input_error(block, {"model={mechanism: full}", loads}), testing::HasSubstr("life.load_case: missing"));
  EXPECT_EQ(input_error(block, {"model={mechanism: full}", loads, "life.load_case=aside"}), "no error");
  EXPECT_THAT(input_error(block, {"model={mechanism: full}", loads, "life.load_case=askew"}),
              testing::HasSubstr("got askew; expected the name of a load case that is solved: "
                                 "straight, aside"));
  EXPECT_THAT(input_error(block, {"life.load_case=aside"}), testing::HasSubstr("life.load_case"));
}

}  // namespace
}  // namespace prs
