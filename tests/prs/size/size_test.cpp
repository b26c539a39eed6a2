#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "prs/heat/thermal_network.h"
#include "prs/input/reader.h"
#include "prs/life/analyze_life.h"
#include "prs/loads/analyze.h"
#include "prs/measures/measures.h"
#include "prs/record/table_units.h"
#include "prs/size/evaluation.h"
#include "prs/size/size_analysis.h"
#include "prs/slip/slip.h"

namespace prs {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// Lift, hold and return, the example of docs/size.md.
constexpr std::string_view kMotion = R"(
motion:
  segments:
    - {name: lift, duration: 0.2 s, end_speed: 300 mm/s, force: 8 kN}
    - {duration: 1.8 s, end_speed: 300 mm/s, force: 8 kN}
    - {duration: 0.2 s, end_speed: 0 mm/s, force: 8 kN}
    - {name: hold, duration: 3 s, end_speed: 0 mm/s, force: 9 kN}
    - {duration: 0.2 s, end_speed: -300 mm/s, force: 2 kN}
    - {duration: 1.8 s, end_speed: -300 mm/s, force: 2 kN}
    - {duration: 0.2 s, end_speed: 0 mm/s, force: 2 kN}
)";
constexpr std::string_view kLoad = R"(
load: {moved_mass: 50 kg, inclination: 90 deg, guide_friction: 0.003, resistance: 20 N, drag_torque: 0.1 N m}
)";
constexpr std::string_view kRest = R"(
stroke: 650 mm
measures: {shaft: {length: 900 mm, ends: fixed_supported}}
life: {hours: 20000 h}
limits: {temperature: 80 degC}
motor: {rated_torque: 15 N m, peak_torque: 40 N m, largest_speed: 3000 rpm, inertia: 5 kg cm^2}
heat: {ambient: 25 degC, conductance: {nut_ambient: 10 W/K, screw_ambient: 3 W/K}}
model: {loads: static}
)";

std::string example() { return std::string(kMotion).append(kLoad).append(kRest); }

/// One design of 30 x 10 for a motion.
std::string of_one(const std::string& text) {
  return text +
         "\ncandidates: {designs: {screw_diameter: 30 mm, lead: 10 mm, starts: 5}}\n"
         "model: {loads: static}\n";
}

SizeInput read(const std::string& text) { return read_requirement(input::source_of_text("press.yaml", text, {})); }
SizeResult sized(const std::string& text) { return size_screws(read(text)); }

const SizedCandidate& named(const SizeResult& r, std::string_view name) {
  const auto found = std::ranges::find(r.candidates, name, &SizedCandidate::name);
  if (found == r.candidates.end()) throw std::runtime_error("no candidate");
  return *found;
}

const SizeCriterion& criterion(const SizedCandidate& c, std::string_view name) {
  const auto found = std::ranges::find(c.criteria, name, &SizeCriterion::name);
  if (found == c.criteria.end()) throw std::runtime_error("no criterion");
  return *found;
}

std::vector<double> forces(const std::string& text) {
  std::vector<double> all;
  for (const MotionSegment& s : read(text).cycle.all) all.push_back(s.force);
  return all;
}

void expect_near_relative(double value, double expected, double tolerance) {
  EXPECT_NEAR(value / expected, 1.0, tolerance) << value << " against " << expected;
}

// THK prints whole newtons, with g = 9.8.
TEST(SizeMotion, ForcesAreThoseOfPublishedAxes) {
  const auto expect = [](const std::string& text, std::vector<double> printed) {
    const std::vector<double> found = forces(text);
    for (std::size_t k = 0; k < printed.size(); ++k) EXPECT_NEAR(found[k], printed[k], 1.0) << k;
  };
  const auto axis = [](const char* time, const char* speed, const char* load) {
    return fmt::format(
        "motion: {{segments: [{{duration: {0}, end_speed: {1}}}, {{duration: 1 s, end_speed: "
        "{1}}}, "
        "{{duration: {0}, end_speed: 0 m/s}}]}}\nload: {2}\n",
        time, speed, load);
  };
  expect(axis("0.15 s", "1 m/s", "{moved_mass: 80 kg, guide_friction: 0.003, resistance: 15 N}"), {550, 17, -516});
  expect(axis("0.2 s", "0.3 m/s", "{moved_mass: 50 kg, inclination: 90 deg, resistance: 20 N}"), {585, 510, 435});
  expect(axis("0.5 s", "1.2 m/s", "{moved_mass: 30 kg, inclination: 90 deg, resistance: 10 N}"), {376, 304, 232});
}

TEST(SizeMotion, ACycleThatEndsElsewhereIsAWarning) {
  const auto warned = [](const char* last) {
    std::vector<std::string> codes;
    for (const Warning& w : read(of_one(fmt::format("motion: {{segments: [{{duration: 1 s, end_speed: 100 mm/s}}, "
                                                    "{{duration: 1 s, end_speed: 0 mm/s, force: 1 kN}}, {}]}}\n",
                                                    last)))
                                .warnings)
      codes.push_back(w.code);
    return codes;
  };
  using testing::ElementsAre, testing::IsEmpty;
  EXPECT_THAT(warned("{duration: 1 s, end_speed: -100 mm/s}, {duration: 1 s, end_speed: 0 mm/s}"), IsEmpty());
  EXPECT_THAT(warned("{duration: 1 s, end_speed: -90 mm/s}, {duration: 1 s, end_speed: 0 mm/s}"),
              ElementsAre("open_way"));
  EXPECT_THAT(warned("{duration: 1 s, end_speed: -200 mm/s}"), ElementsAre("open_cycle"));
}

TEST(SizeMotion, ABrakeWithNothingToHoldIsAWarning) {
  const auto warnings = [](const char* rest) {
    return read(of_one(
                    fmt::format("motion: {{segments: [{{duration: 1 s, end_speed: 0.1 m/s, force: 1 kN}}, {{duration: "
                                "2 s, end_speed: -0.1 m/s, force: 1 kN}}, {{duration: 1 s, end_speed: 0 m/s}}{}]}}\n"
                                "motor: {{rated_torque: 15 N m}}\nbrake: {{torque: 4 N m}}\n",
                                rest)))
        .warnings;
  };
  ASSERT_EQ(warnings("").size(), 1u);
  EXPECT_EQ(warnings("").front().code, "no_rest");
  EXPECT_THAT(warnings(", {duration: 1 s, end_speed: 0 m/s, force: 1 kN}"), testing::IsEmpty());
}

TEST(SizeMotion, APeakBetweenSamplesIsAWarning) {
  const auto warned = [](double peak) {
    input::Source source = input::source_of_text(
        "press.yaml",
        of_one("motion: {history: {file: m.csv, time: {column: t, unit: s}, speed: {column: v, unit: mm/s}, "
               "force: {column: F, unit: kN}}}\n"),
        {});
    source.files.emplace()["m.csv"] = fmt::format("t,v,F\n0,0,1\n1,50,1\n2,0,{}\n3,-50,1\n4,0,1\n", peak);
    return read_requirement(source).warnings;
  };
  ASSERT_EQ(warned(90.0).size(), 1U);
  EXPECT_EQ(warned(90.0).front().code, "peaks_between_samples");
  EXPECT_DOUBLE_EQ(*warned(90.0).front().value, 90e3);
  EXPECT_DOUBLE_EQ(*warned(90.0).front().limit, 45.5e3);
  EXPECT_THAT(warned(1.05), testing::IsEmpty());
}

TEST(SizeMotion, AnAxisAtRestIsAWarning) {
  const auto of = [](const char* speed) {
    return read(of_one(fmt::format("motion: {{segments: [{{duration: 1 s, end_speed: {0} mm/s, force: 1 kN}}, "
                                   "{{duration: 1 s, end_speed: 0 mm/s}}, {{duration: 1 s, end_speed: -{0} mm/s}}, "
                                   "{{duration: 1 s, end_speed: 0 mm/s}}]}}\n",
                                   speed)))
        .warnings;
  };
  ASSERT_EQ(of("0").size(), 1U);
  EXPECT_EQ(of("0").front().code, "at_rest");
  EXPECT_THAT(of("1"), testing::IsEmpty());
}

TEST(SizeMotion, RelubricationIsThatOfTheMakersExample) {
  const SizeResult r =
      sized(of_one("motion: {segments: [{duration: 1 s, end_speed: 1.66 in/s, force: 400 lbf}], start_speed: "
                   "1.66 in/s}\nrelubrication: {static_load_factor: 0.24, peak_force: 1700 lbf}\n"
                   "limits: {relubrication: 500 h}\n"));
  EXPECT_EQ(std::floor(*r.candidates.front().relubrication / 3600.0), 1766.0);
  EXPECT_EQ(criterion(r.candidates.front(), "relubrication").status, CriterionStatus::pass);
}

// Numbers of the published definition, to its digits.
TEST(Size, ExampleHasItsPublishedNumbers) {
  const SizeResult r = sized(example());
  const std::vector<double> axial{8585.3325, 8510.3325, 8435.3325, 9490.3325, 2395.3325, 2470.3325, 2545.3325};
  for (std::size_t k = 0; k < axial.size(); ++k) EXPECT_NEAR(r.input.cycle.shown[k].force, axial[k], 1e-9);
  EXPECT_NEAR(*r.input.cycle.mean_load, 6809.348202, 5e-7);
  EXPECT_NEAR(1e3 * r.input.cycle.rms_speed, 216.857158, 5e-7);
  ASSERT_EQ(r.candidates.size(), 24);
  EXPECT_EQ(r.passing(), 5);
  std::vector<std::string> names;
  for (std::size_t k = 0; k < 5; ++k) {
    names.push_back(r.candidates[k].name);
    EXPECT_EQ(r.candidates[k].limited_by, "motor_torque");
  }
  EXPECT_THAT(names, ElementsAre("21x10", "24x10", "30x10", "36x9", "36x10"));
  EXPECT_EQ(r.candidates[5].name, "24x12");
  EXPECT_EQ(r.candidates[5].missed().size(), 1);

  const SizedCandidate& c = named(r, "30x10");
  EXPECT_NEAR(*c.life.hours, 165399.94, 5e-3);
  expect_near_relative(*c.by_threads.life.hours, 98085.15, 1e-7);
  expect_near_relative(*c.static_safety, 29.60908, 1e-6);
  expect_near_relative(*c.buckling_safety, 19.07977, 1e-6);
  expect_near_relative(*c.stiffness * 1e-6, 137.9923, 1e-6);
  expect_near_relative(*c.inertia * 1e6, 593.7406, 1e-6);
  expect_near_relative(*c.efficiency, 0.8122502, 1e-6);
  expect_near_relative(*c.segments[0].torque, 16.82271, 1e-6);
  expect_near_relative(*c.segments[0].motor_torque, 17.95354, 1e-6);
  expect_near_relative(*c.segments[3].motor_torque, 15.10433, 1e-6);
  expect_near_relative(*c.segments[4].torque, -3.098476, 1e-6);
  expect_near_relative(*c.segments[4].motor_torque, -1.967650, 1e-6);
  expect_near_relative(*c.motor_rms_torque, 13.384525, 1e-7);
  expect_near_relative(*c.regenerated_mean, 157.6882, 1e-6);
  expect_near_relative(*c.regenerated_peak, 795.998, 1e-6);
  EXPECT_NEAR(c.temperature->screw - 273.15, 59.168, 1e-3);
  EXPECT_NEAR(c.temperature->roller - 273.15, 61.474, 1e-3);
  EXPECT_NEAR(c.temperature->nut - 273.15, 34.451, 1e-3);
  expect_near_relative(*c.power_lost, 197.0128, 1e-6);
  expect_near_relative(*c.relubrication / 3600.0, 155.2418, 1e-6);
  expect_near_relative(*criterion(c, "life").margin, 8.26999, 1e-5);
  expect_near_relative(*criterion(c, "motor_torque").margin, 1.120697, 1e-6);
  expect_near_relative(*criterion(c, "temperature").margin, 1.507925, 1e-5);
}

void expect_numbers_of_the_list(const std::string& text) {
  const SizeResult r = sized(text);
  const SizedCandidate& c = named(r, "30x10");
  const Case written = input::read_case_text(written_candidate(r.input, c), "screw.yaml", {}, Command::slip);
  const Result slip = analyze_slip(written, kManyDesigns);
  ASSERT_EQ(slip.load_cases.size(), 7);  // Six that move, and the back-driven one.
  constexpr double kSame = 1e-9;
  std::size_t place = 0;
  for (const SizedSegment& s : c.segments)
    if (s.power_loss) expect_near_relative(slip.load_cases[place++].slip->power.total(), *s.power_loss, kSame);
  EXPECT_EQ(place, 6);
  expect_near_relative(*slip.load_cases.back().slip->efficiency, *c.back_driving_efficiency, kSame);
  const double under_load = r.input.cycle.travel / r.input.cycle.loaded_travel;
  const LifeResult by_maker = analyze_life(written);
  expect_near_relative(by_maker.catalogue_life * under_load, *c.life.revolutions, kSame);
  Case by_threads = written;
  by_threads.life->dynamic_capacity.reset();
  by_threads.life->static_capacity.reset();
  const LifeResult life = analyze_life(by_threads);
  expect_near_relative(life.system_life * under_load, *c.by_threads.life.revolutions, kSame);
  expect_near_relative(*life.static_safety(), *c.by_threads.static_safety, kSame);
  const MeasuresResult measures = analyze_measures(written);
  expect_near_relative(*measures.measures.buckling_load, *c.buckling_load, kSame);
  expect_near_relative(*measures.measures.equivalent_inertia, *c.inertia, kSame);
  expect_near_relative(*measures.measures.critical_speed, *c.critical_speed, kSame);
}

TEST(Size, WrittenCaseGivesTheNumbersOfTheList) { expect_numbers_of_the_list(example()); }

TEST(Size, WrittenCaseOfARunningScrewDoesToo) {
  std::string text = example();
  expect_numbers_of_the_list(text.replace(text.find("static"), 6, "running"));
}

/// Friction as a word, as blocks of a law, and heads that need no film.
TEST(Size, WrittenCaseHasTheFrictionOfItsRequirement) {
  for (const auto& [text, law] : {std::pair{"friction: {model: jacod}\n", contact::kind_of<contact::Jacod>},
                                  std::pair{"friction: {coulomb: 0.05}\n", contact::kind_of<contact::Coulomb>},
                                  std::pair{"friction: {mixed: {boundary: 0.1}}\n", contact::kind_of<contact::Mixed>},
                                  std::pair{"friction: {coulomb: 0.05}\n"
                                            "carrier: {bearing: {diameter: 7 mm, friction: {coulomb: 0.1}}}\n",
                                            contact::kind_of<contact::Coulomb>}}) {
    const SizeResult r = sized(of_one(std::string(kMotion).append("stroke: 650 mm\n").append(text)));
    const std::string written = written_candidate(r.input, r.candidates.front());
    const Case c = input::read_case_text(written, "screw.yaml", {}, Command::slip);
    EXPECT_EQ(c.friction->kind, law) << written;
    EXPECT_EQ(c.carrier.bearing.has_value(), std::string_view(text).find("bearing") != std::string_view::npos);
  }
}

TEST(Size, CandidatesWithoutTheObjectiveComeLast) {
  input::Source source = input::source_of_text("press.yaml",
                                               "motion: {segments: [{duration: 1 s, end_speed: 200 mm/s, force: -2 kN},"
                                               " {duration: 0.2 s, end_speed: 200 mm/s, force: 6.7 kN},"
                                               " {duration: 0.7 s, end_speed: 0 mm/s, force: 0.7 kN}]}\n"
                                               "losses: catalogue\nobjective: motor_torque\nmodel: {loads: static}\n"
                                               "candidates: {catalogue: {file: own.csv}}\n",
                                               {});
  source.files.emplace()["own.csv"] =
      "screw_diameter_mm,lead_mm,starts,nut_diameter_mm,nut_length_mm,dynamic_capacity_kN,efficiency,back_driving_"
      "efficiency\n"
      "30,10,5,62,85,145,0.87,0.80\n"
      "24,6,4,55,70,90,0.85,\n"
      "39,10,5,75,100,,,\n";
  const SizeResult r = size_screws(read_requirement(source));
  ASSERT_EQ(r.passing(), 3);
  EXPECT_TRUE(r.candidates[0].motor_rms_torque);
  EXPECT_EQ(r.candidates[0].name, "30x10");
  EXPECT_FALSE(r.candidates[1].motor_rms_torque);
  EXPECT_EQ(r.candidates[1].name, "24x6");  // Chosen by the nut's diameter.
  EXPECT_EQ(r.candidates[2].name, "39x10");
}

/// The source is called as the requirement names its file, wherever the requirement stands.
TEST(SizeCatalogue, HasItsNameWithoutTheFolderOfTheRequirement) {
  SizeInput in = read(
      "motion: {segments: [{duration: 1 s, end_speed: 9 mm/s, force: 1 kN}]}\n"
      "candidates: {catalogue: [{file: lists/own.csv}, {file: lists/own.csv, source: maker A}]}\n");
  in.source.files.emplace()["lists/own.csv"] = "screw_diameter_mm,lead_mm,starts\n48,10,5\n";
  for (const char* name : {"press.yaml", "axes/press.yaml"}) {
    in.source.name = name;
    std::vector<Warning> warnings;
    const std::vector<CandidateData> all = candidates_of(in, warnings);
    EXPECT_EQ(all.at(0).list, "lists/own.csv");
    EXPECT_EQ(all.at(1).list, "maker A");
  }
}

/// A catalogue as German makers print and spreadsheets write it.
TEST(Size, ReadsAMakersCatalogueWithDecimalCommas) {
  const auto first = [](const char* csv, std::vector<Warning>& warnings) {
    SizeInput in = read(
        "motion: {segments: [{duration: 1 s, end_speed: 9 mm/s, force: 1 kN}]}\n"
        "candidates: {catalogue: {file: own.csv}}\n");
    in.source.files.emplace()["own.csv"] = csv;
    return candidates_of(in, warnings).front();
  };
  std::vector<Warning> warnings, of_columns, of_capacities;
  const CandidateData plain =
      first("screw_diameter_mm,lead_mm,starts,dynamic_capacity_kN,static_capacity_kN\n48,10,5,188.5,376\n", warnings);
  const CandidateData german = first("d0;Ph;Gangzahl;C;C0\n48;10;5;188,5;376\n", of_columns);
  EXPECT_EQ(german.dynamic_capacity, plain.dynamic_capacity);
  EXPECT_EQ(german.static_capacity, plain.static_capacity);
  EXPECT_EQ(german.screw.screw_diameter, plain.screw.screw_diameter);
  EXPECT_TRUE(warnings.empty());
  ASSERT_EQ(of_columns.size(), 1);
  EXPECT_THAT(of_columns[0].what, HasSubstr("Gangzahl as starts"));
  first("d0;Ph;Gangzahl;C;C0\n48;10;5;376;188,5\n", of_capacities);
  EXPECT_EQ(of_capacities.back().code, "static_below_dynamic_capacity");
}

/// A speed that is rounding of zero makes no separate segment.
TEST(Size, RoundingInAHistoryIsNoMotion) {
  const auto segments = [](const char* middle) {
    input::Source source = input::source_of_text(
        "press.yaml",
        "motion: {history: {file: m.csv, time: {column: t, unit: s}, speed: {column: v, unit: mm/s}, "
        "force: {column: F, unit: N}}}\n",
        {});
    source.files.emplace()["m.csv"] =
        fmt::format("t,v,F\n0,0,3000\n1,100,3000\n2,{},3000\n3,-100,3000\n4,0,3000\n", middle);
    return read_requirement(source).cycle.all.size();
  };
  EXPECT_EQ(segments("1e-14"), segments("0"));
}

TEST(Size, EveryRowPassesWhenAskedForByItsOwnRating) {
  const SizeResult all = sized(example());
  for (const SizedCandidate& row : all.candidates) {
    // A million revolutions at C_a in 100 h.
    const double speed = std::abs(row.screw.lead) * 1e6 / (100.0 * 3600.0);
    const SizeResult r =
        sized(fmt::format("motion: {{segments: [{{duration: 1 s, end_speed: {0} mm/s, force: {1} N}}], start_speed: "
                          "{0} mm/s}}\nstroke: 100 mm\nmeasures: {{shaft: {{length: 1 mm}}}}\nlife: {{hours: 100 "
                          "h}}\n"
                          "limits: {{static_safety: 0.1, buckling_safety: 0.1}}\nmodel: {{loads: static}}\n",
                          1e3 * speed, *row.dynamic_capacity));
    const auto found = std::ranges::find(r.candidates, row.name, &SizedCandidate::name);
    if (found == r.candidates.end()) {
      EXPECT_TRUE(std::ranges::any_of(r.invalid, [&](auto& i) { return i.name == row.name; }));
      continue;
    }
    EXPECT_NEAR(*criterion(*found, "life").margin, 1.0, 1e-9) << row.name;
    EXPECT_EQ(criterion(*found, "life").status, CriterionStatus::pass) << row.name;
    EXPECT_TRUE(found->passes) << row.name << ": " << found->limited_by;
  }
}

TEST(Size, MakersLifeFallsWithTheCubeOfTheForce) {
  const auto hours = [](double factor) {
    return *named(sized(fmt::format("motion: {{segments: [{{duration: 1 s, end_speed: 100 mm/s, "
                                    "force: {} kN}}], start_speed: 100 mm/s}}\n"
                                    "model: {{loads: static}}\n",
                                    factor)),
                  "30x10")
                .life.hours;
  };
  EXPECT_NEAR(hours(2.0) / hours(5.0), std::pow(2.5, 3), 1e-9);
}

TEST(Size, MirroredMotionHasTheSameValues) {
  const auto one = [](double sign, const char* positive) {
    return sized(
        of_one(fmt::format("motion: {{segments: [{{duration: 0.2 s, end_speed: {0} mm/s, force: {1} kN}}, {{duration: "
                           "1 s, end_speed: {0} mm/s, force: {1} kN}}, {{duration: 0.4 s, end_speed: {2} mm/s}}, "
                           "{{duration: 0.2 s, end_speed: 0 mm/s, force: {2} N}}]}}\nload: {{moved_mass: 40 kg, "
                           "inclination: {3} "
                           "deg, resistance: 20 N, positive_force: {4}}}\nheat: {{}}\n",
                           200 * sign, 5 * sign, -150 * sign, 30 * sign, positive)));
  };
  const SizedCandidate a = one(1.0, "tension").candidates.front(), b = one(-1.0, "compression").candidates.front();
  for (const auto member :
       {&SizedCandidate::efficiency, &SizedCandidate::motor_rms_torque, &SizedCandidate::motor_peak_torque,
        &SizedCandidate::regenerated_mean, &SizedCandidate::power_lost, &SizedCandidate::buckling_safety,
        &SizedCandidate::stiffness}) {
    ASSERT_EQ((a.*member).has_value(), (b.*member).has_value());
    if (a.*member) expect_near_relative(*(a.*member), *(b.*member), 1e-9);
  }
  expect_near_relative(*a.life.hours, *b.life.hours, 1e-9);
  expect_near_relative(*a.by_threads.static_safety, *b.by_threads.static_safety, 1e-9);
}

TEST(Size, CuttingASegmentOfConstantSpeedChangesNothing) {
  const auto one = [](const char* constant) {
    return sized(of_one(fmt::format("motion: {{start_speed: 100 mm/s, segments: [{}, {{duration: 1 "
                                    "s, end_speed: 100 mm/s, force: -2 kN}}]}}\n",
                                    constant)))
        .candidates.front();
  };
  const SizedCandidate a = one("{duration: 2 s, end_speed: 100 mm/s, force: 5 kN}"),
                       b =
                           one("{duration: 0.5 s, end_speed: 100 mm/s, force: 5 kN}, {duration: "
                               "1.5 s, end_speed: 100 mm/s, force: 5 kN}");
  expect_near_relative(*a.life.hours, *b.life.hours, 1e-9);
  expect_near_relative(*a.efficiency, *b.efficiency, 1e-12);
  expect_near_relative(*a.motor_rms_torque, *b.motor_rms_torque, 1e-12);
  expect_near_relative(*a.power_lost, *b.power_lost, 1e-12);
}

TEST(Size, LaxerLimitLosesNoCandidate) {
  const auto passing = [](const char* torque) {
    std::string text = example();
    text.replace(text.find("15 N m"), 6, torque);
    std::vector<std::string> names;
    for (const SizedCandidate& c : sized(text).candidates)
      if (c.passes) names.push_back(c.name);
    return names;
  };
  const std::vector<std::string> strict = passing("13 N m"), lax = passing("16 N m");
  EXPECT_FALSE(strict.empty());
  EXPECT_LT(strict.size(), lax.size());
  for (const std::string& name : strict) EXPECT_THAT(lax, testing::Contains(name));
}

TEST(Size, EnergyOfAClosedCycleIsBalanced) {
  std::string text = of_one(std::string(kMotion).append(kLoad));
  const SizeResult r = sized(text);
  const SizedCandidate& c = r.candidates.front();
  double motor = 0.0, work = 0.0, lost = 0.0, drag = 0.0;
  for (std::size_t k = 0; k < c.segments.size(); ++k) {
    const MotionSegment& s = r.input.cycle.all[k];
    const double angle = 2.0 * std::numbers::pi * std::abs(s.travel()) / c.screw.lead;
    motor += *c.segments[k].motor_torque * angle;
    work += s.force * s.travel();
    lost += c.segments[k].power_loss.value_or(0.0) * s.duration;
    drag += 0.1 * angle;
  }
  EXPECT_NEAR(motor / (work + lost + drag), 1.0, 1e-9);
}

TEST(Size, InvertedNutHoldsTheStroke) {
  const SizeResult r = sized(
      "motion: {segments: [{duration: 1 s, end_speed: 100 mm/s, force: 2 kN}], start_speed: 100 "
      "mm/s}\nstroke: 200 mm\nmodel: {loads: static}\n"
      "candidates: {designs: {type: inverted, screw_diameter: 21 mm, lead: 5 mm, starts: 3}}\n");
  const SizedCandidate& c = r.candidates.front();
  EXPECT_GT(c.nut_length, 0.2);
  EXPECT_NEAR(1e3 * c.nut_length, std::round(1e3 * c.nut_length), 1e-9);
  EXPECT_EQ(criterion(c, "critical_speed").status, CriterionStatus::not_applicable);
}

TEST(Size, NothingPassesIsSaidWithWhatToRelax) {
  std::string text = example();
  text.replace(text.find("15 N m"), 6, "1 N m");
  const SizeResult r = sized(text);
  EXPECT_EQ(r.passing(), 0);
  ASSERT_TRUE(r.relax);
  EXPECT_EQ(r.relax->criterion, "motor_torque");
  EXPECT_EQ(r.relax->rank, 1);
  EXPECT_GT(r.relax->needed, r.relax->limit);
  EXPECT_THAT(size_table(r, 10), testing::StartsWith("NOTHING PASSES"));
  text.replace(text.find("80 degC"), 7, "26 degC");
  const SizeResult both = sized(text);
  EXPECT_FALSE(both.relax);
  EXPECT_THAT(size_table(both, 10), HasSubstr("no limit alone suffices"));
}

/// Limits that `To relax` prints pass when they are written into the file; criteria without a value are not missed.
TEST(Size, WhatIsPrintedToRelaxPasses) {
  const auto of_limit = [](const std::string& limit) {
    return of_one(std::string(kMotion) + "load: {inclination: 90 deg}\nbrake: {torque: 30 N m}\n" + limit + "\n");
  };
  const auto relaxed = [](const std::string& table, std::string_view after) {
    const std::size_t from = table.find(after) + after.size();
    return table.substr(from, table.find(" instead", from) - from);
  };
  for (const auto& [before, value, after] :
       {std::tuple("life: {hours: ", "9e6 h", "}"), std::tuple("limits: {weight: ", "1 kg", "}"),
        std::tuple("limits: {efficiency: ", "99 %", "}"),
        std::tuple("limits: {critical_speed_share: ", "0.1 %", "}")}) {
    const std::string table = size_table(sized(of_limit(std::string(before) + value + after)), 10);
    ASSERT_THAT(table, HasSubstr("To relax: with ")) << before;
    const std::string of = relaxed(table.substr(table.find("To relax: with ")), " of ");
    EXPECT_EQ(sized(of_limit(std::string(before) + of + after)).passing(), 1) << of;
  }
  const SizeResult weak =
      sized(of_one(std::string(kMotion) + "load: {inclination: 90 deg}\nbrake: {torque: 0.1 N m}\n"));
  ASSERT_TRUE(weak.relax);
  EXPECT_EQ(weak.relax->limit, 0.1);
  EXPECT_THAT(size_table(weak, 10), HasSubstr(" N m instead of 0.1 N m"));
  const std::string unknown = size_table(sized(of_limit("limits: {temperature: 80 degC}")), 10);
  EXPECT_THAT(unknown, HasSubstr("Not known of 30x10: temperature: state `heat`"));
  EXPECT_THAT(unknown, Not(HasSubstr("misses")));
  EXPECT_THAT(size_table(sized(of_limit("limits: {back_driving: forbidden}")), 10),
              HasSubstr("with `back_driving: allowed`, 30x10 passes"));
}

TEST(Size, WarningsHaveTheirNumbers) {
  const SizeResult r = sized(
      "stroke: 12 mm\n"
      "motion: {segments: [{duration: 1 s, end_speed: 10 mm/s, force: 200 kN}], start_speed: 10 mm/s}\n"
      "model: {loads: static}\n");
  const SizedCandidate& c = named(r, "30x10");
  const auto warning = [&](std::string_view code) {
    const auto found = std::ranges::find(c.warnings, code, &Warning::code);
    return found == c.warnings.end() ? Warning{} : *found;
  };
  EXPECT_NEAR(warning("largest_force").limit.value() / warning("mean_load").limit.value(), 0.9 / 0.5, 1e-12);
  EXPECT_NEAR(warning("mean_load").value.value() / 200e3, 1.0, 1e-12);
  const Warning stroke = warning("short_stroke");
  EXPECT_DOUBLE_EQ(stroke.value.value(), 10e-3);
  EXPECT_DOUBLE_EQ(stroke.limit.value(), 1.5 * c.nut_length);
  EXPECT_THAT(sentence(stroke), testing::StartsWith("stroke: the stroke under load, 10 mm, is below"));
  EXPECT_THAT(sentence(stroke), testing::HasSubstr("mm, 1.5 times the nut's length: life needs"));
  const TableUnits us(UnitSystem::us);
  EXPECT_THAT(table_sentence(stroke), testing::StartsWith("stroke: the stroke under load, 0.394 in, is below"));
  EXPECT_THAT(table_sentence(warning("largest_force")), testing::HasSubstr("force, 45000 lbf, is beyond"));
}

TEST(Size, TheLargestSpeedIsInTheUnitOfTables) {
  const SizeResult r = sized(example());  // 300 mm/s
  EXPECT_THAT(size_table(r, 1), HasSubstr("largest speed 300 mm/s"));
  const TableUnits us(UnitSystem::us);
  EXPECT_THAT(size_table(r, 1), HasSubstr("largest speed 11.81 in/s"));
  EXPECT_THAT(size_table(r, 1), HasSubstr("speed times diameter, in/min "));
}

TEST(Size, ManySamplesAreClasses) {
  std::string csv = "time,speed,force\n";
  for (int k = 0; k <= 200; ++k)
    csv += fmt::format("{},{},{}\n", 0.01 * k, 100.0 * std::sin(std::numbers::pi * k / 100.0),
                       3.0 + std::cos(std::numbers::pi * k / 50.0));
  input::Source source =
      input::source_of_text("press.yaml",
                            of_one("motion: {history: {file: cycle.csv, time: {unit: s}, speed: {unit: mm/s}, force: "
                                   "{unit: kN}}}\n"),
                            {});
  source.files.emplace()["cycle.csv"] = csv;
  const SizeResult r = size_screws(read_requirement(source));
  EXPECT_TRUE(r.input.cycle.in_classes);
  EXPECT_LT(r.input.cycle.shown.size(), 61);
  double travel = 0.0, time = 0.0;
  for (const MotionSegment& s : r.input.cycle.shown) travel += std::abs(s.travel()), time += s.duration;
  EXPECT_NEAR(travel / r.input.cycle.travel, 1.0, 1e-12);
  EXPECT_NEAR(time / r.input.cycle.duration, 1.0, 1e-12);
  EXPECT_TRUE(r.candidates.front().motor_rms_torque);
  EXPECT_FALSE(r.candidates.front().segments.front().motor_torque);
}

TEST(Size, DesignsAreSeriesOfIso3) {
  DesignValues r20{.list = {}, .span = DesignValues::Span{20e-3, 63e-3, {}, DesignValues::Series::R20}};
  std::vector<double> millimetres;
  for (const double value : r20.values()) millimetres.push_back(1e3 * value);
  EXPECT_THAT(millimetres, ElementsAre(20, 22.4, 25, 28, 31.5, 35.5, 40, 45, 50, 56, 63));
}

TEST(Size, DesignsAreAllCombinationsOfTheirLists) {
  const SizeInput in = read(
      "motion: {segments: [{duration: 1 s, end_speed: 9 mm/s, force: 1 kN}]}\n"
      "candidates: {designs: {type: [standard, inverted], screw_diameter: [21 mm, 30 mm], lead: 5 "
      "mm, starts: [4, 5, 6]}}\n");
  std::vector<Warning> warnings;
  const std::vector<CandidateData> all = candidates_of(in, warnings);
  ASSERT_EQ(all.size(), 12);
  EXPECT_EQ(all[1].screw.starts, 5);
  EXPECT_EQ(all[3].screw.screw_diameter, 30e-3);
  EXPECT_EQ(all[6].screw.type, Mechanism::Type::inverted);
  EXPECT_EQ(std::ranges::count(in.fields, "candidates.designs.starts[2]", &input::EchoEntry::path), 1);
}

constexpr std::string_view kPressing =
    "motion: {segments: [{duration: 0.5 s, end_speed: 20 mm/s, force: 40 kN}, {duration: 5 s, end_speed: 20 mm/s, "
    "force: "
    "40 kN}, {duration: 1 s, end_speed: 0 mm/s, force: 40 kN}, {duration: 1 s, end_speed: -40 mm/s}, {duration: 2.25 "
    "s, "
    "end_speed: -40 mm/s}, {duration: 1 s, end_speed: 0 mm/s}]}\nload: {moved_mass: 50 kg}\nlife: {hours: 100 h}\n";

SizeResult sized_with(std::string_view text, const char* csv) {
  input::Source source = input::source_of_text("press.yaml", std::string(text), {});
  source.files.emplace()["own.csv"] = csv;
  return size_screws(read_requirement(source));
}

// Same screw as a row and as a design.
TEST(SizeBasis, OneScrewHasOneSetOfNumbers) {
  const std::string both = std::string(kPressing) +
                           "candidates: {catalogue: {file: own.csv}, designs: {screw_diameter: 30 mm, lead: 10 mm, "
                           "starts: 5}}\n";
  const SizeResult r =
      sized_with(both, "screw_diameter_mm,lead_mm,starts,dynamic_capacity_kN,static_capacity_kN\n30,10,5,145,281\n");
  ASSERT_EQ(r.candidates.size(), 2);
  const SizedCandidate &a = r.candidates[0], &b = r.candidates[1];
  EXPECT_NE(a.name, b.name);
  EXPECT_NE(a.list, b.list);
  for (const SizedCandidate* c : {&a, &b}) EXPECT_EQ(c->basis(), "threads");
  EXPECT_EQ(a.passes, b.passes);
  for (const auto member : {&SizedCandidate::static_safety, &SizedCandidate::efficiency, &SizedCandidate::stiffness,
                            &SizedCandidate::buckling_safety, &SizedCandidate::weight})
    EXPECT_EQ((a.*member).value(), (b.*member).value());
  EXPECT_EQ(a.life.hours.value(), b.life.hours.value());
}

// L = 10^6 (C_a/F_m)^3 and C_0/F_max for all, with the capacities of each.
TEST(SizeBasis, CatalogueFormulasHoldForScrewsWithoutPrintedCapacities) {
  const SizeResult r =
      sized_with(std::string(kPressing) + "candidates: {catalogue: {file: own.csv}}\n",
                 "name,screw_diameter_mm,lead_mm,starts,dynamic_capacity_kN,static_capacity_kN,maker\na,30,10,5,145,"
                 "281,M\nb,30,10,5,-"
                 ",-,-\n");
  const SizedCandidate &a = named(r, "a"), &b = named(r, "b");
  EXPECT_EQ(a.basis(), "maker");
  EXPECT_EQ(b.basis(), "computed");
  EXPECT_EQ(a.list, "M, own.csv");
  EXPECT_EQ(b.list, "own.csv");
  const double mean = *r.input.cycle.mean_load, most = r.input.cycle.largest_force;
  expect_near_relative(*a.life.revolutions, 1e6 * std::pow(145e3 / mean, 3), 1e-12);
  expect_near_relative(*a.static_safety, 281e3 / most, 1e-12);
  expect_near_relative(*b.life.revolutions, 1e6 * std::pow(*b.by_threads.capacity / mean, 3), 1e-12);
  expect_near_relative(*b.static_safety, *b.rated_static_capacity / most, 1e-12);
  EXPECT_THAT(b.assumed(), ElementsAre("rollers", "nut_diameter", "nut_length", "profile"));
}

TEST(Size, NoTwoCandidatesHaveOneName) {
  const SizeResult r = sized_with(std::string(kPressing) +
                                      "candidates: {catalogue: {file: own.csv}, designs: {type: [standard, inverted], "
                                      "screw_diameter: 30 mm, lead: [5 "
                                      "mm, 5 mm], starts: [3, 4]}}\n",
                                  "screw_diameter_mm,lead_mm,starts\n30,5,3\n30,5,4\n");
  std::set<std::string> names;
  for (const SizedCandidate& c : r.candidates) names.insert(c.name);
  for (const InvalidCandidate& c : r.invalid) names.insert(c.name);
  EXPECT_EQ(names.size(), r.candidates.size() + r.invalid.size());
  EXPECT_TRUE(names.contains("30x5"));
  EXPECT_TRUE(names.contains("30x5 (row 2)"));
  EXPECT_TRUE(names.contains("30x5 inverted 3-start"));
}

// Coulomb's friction with equal loads at all temperatures: the mission is that of the linear network with the losses of
// the segments, whatever the steady state would be.
TEST(Size, AMissionFromColdIsHeldAgainstItsPeak) {
  const auto mission = [](const char* more) {
    return sized(of_one(
        std::string(kMotion) + "limits: {temperature: 80 degC}\n" + "bearings: {fixed: {dynamic_capacity: 40 kN}}\n" +
        "heat: {ambient: 25 degC, conductance: {nut_ambient: 1 W/K, screw_ambient: 0.5 W/K}" + more + "}\n"));
  };
  const SizeResult mean = mission(""), cold = mission(", cycles: 5, start: 10 degC");
  const SizedCandidate &at_mean = mean.candidates.front(), &c = cold.candidates.front();
  EXPECT_EQ(criterion(at_mean, "temperature").status, CriterionStatus::fail);
  EXPECT_EQ(criterion(c, "temperature").status, CriterionStatus::pass);
  ASSERT_TRUE(c.mission && c.mission->converged());
  EXPECT_NEAR(*c.hottest_part(), std::max({c.mission->peak.screw, c.mission->peak.roller, c.mission->peak.nut}), 0.0);
  EXPECT_NEAR(c.mission->duration(), 5.0 * cold.input.cycle.duration, 1e-9);
  EXPECT_NEAR(c.mission->start->screw, 283.15, 1e-9);
  EXPECT_EQ(cold.candidates.size(), 1);
  EXPECT_FALSE(c.mission->time.empty());
  EXPECT_GT(*c.bearing_life.hours, 0.0);
}

// Coulomb's friction: each segment has the heat of its own force and speed, within 0.8 % for thermal expansion, and the
// parts are a linear network, here integrated with small steps. Classes keep the order of their segments: one hard
// stroke in eight, which one after the other would heat the screw twice as much.
TEST(Size, AMissionOfManySegmentsKeepsTheirOrder) {
  std::vector<std::array<double, 2>> segments;  // Force [N], speed [m/s].
  std::string text = "motion:\n  period: 2000 s\n  loads:\n";
  for (int k = 0; k < 200; ++k) {
    segments.push_back(k % 8 == 0   ? std::array{15e3, 0.12}
                       : k % 8 == 4 ? std::array{6e3, 0.11}
                                    : std::array{3e3, 0.10});
    text += fmt::format("    - {{force: {} N, speed: {} m/s, share: 0.5 %}}\n", segments.back()[0], segments.back()[1]);
  }
  const SizeResult r = sized(of_one(text + "heat: {ambient: 25 degC, cycles: 1, conductance: {screw_ambient: 2 W/K, "
                                           "nut_ambient: 4 W/K, screw_rollers: 10 W/K, rollers_nut: 8 W/K}}\n"));
  const SizedCandidate& c = r.candidates.front();
  ASSERT_TRUE(r.input.cycle.in_classes);
  ASSERT_TRUE(c.mission && c.mission->converged());

  Case of_each = sized_case(r.input, c).c;
  const Measures m = analyze_measures(of_each).measures;
  const std::array capacity{460.0 * *m.screw_weight_per_length * c.nut_length, 460.0 * *m.roller_weight,
                            460.0 * *m.nut_weight};
  const LoadCase load = of_each.load_cases.front();
  of_each.load_cases.clear();
  for (const auto& [force, speed] : segments) {
    of_each.load_cases.push_back(load);
    of_each.load_cases.back().name = fmt::format("{}", of_each.load_cases.size());
    of_each.load_cases.back().axial_force = force;
    of_each.load_cases.back().speed = std::copysign(2.0 * std::numbers::pi * speed / 0.01, *load.speed);
  }
  std::array rise{0.0, 0.0, 0.0}, peak = rise;
  double lost = 0.0;
  for (const LoadCaseResult& each : analyze_slip(of_each).load_cases) {
    const OfParts heat = heat_of(each.slip->power);
    lost += 10.0 * heat.sum();
    constexpr int kSteps = 2000;
    for (int step = 0; step < kSteps; ++step) {
      const double to_rollers = 10.0 * (rise[0] - rise[1]), to_nut = 8.0 * (rise[1] - rise[2]), dt = 10.0 / kSteps;
      rise[0] += dt * (heat[0] - to_rollers - 2.0 * rise[0]) / capacity[0];
      rise[1] += dt * (heat[1] + to_rollers - to_nut) / capacity[1];
      rise[2] += dt * (heat[2] + to_nut - 4.0 * rise[2]) / capacity[2];
      for (std::size_t part = 0; part < 3; ++part) peak[part] = std::max(peak[part], rise[part]);
    }
  }
  constexpr double kExpansion = 8e-3;
  expect_near_relative(c.mission->energy_lost, lost, kExpansion);
  const PerPart<double>& found = c.mission->peak;
  EXPECT_NEAR(found.screw - 298.15, peak[0], kExpansion * peak[0]);
  EXPECT_NEAR(found.roller - 298.15, peak[1], kExpansion * peak[1]);
  EXPECT_NEAR(found.nut - 298.15, peak[2], kExpansion * peak[2]);
}

TEST(Size, TemperaturesAreNotKnownWithoutHeat) {
  const SizeResult r = sized(std::string(kPressing) + "limits: {temperature: 80 degC}\n");
  for (const SizedCandidate& c : r.candidates) {
    EXPECT_FALSE(c.temperature);
    EXPECT_EQ(criterion(c, "temperature").status, CriterionStatus::not_computed);
    EXPECT_THAT(criterion(c, "temperature").reason, HasSubstr("`heat`"));
  }
}

// For basis `threads` the parts are at the printed temperatures, which their losses there maintain.
TEST(Size, LifeByThreadsIsThatOfPartsAtTheirTemperatures) {
  std::string text = example();
  text.replace(text.find("life: {hours: 20000 h}"), 22, "life: {hours: 20000 h, basis: threads}");
  const SizeResult r = sized(text);
  const SizedCandidate& c = named(r, "30x10");
  ASSERT_TRUE(c.parts_at);
  EXPECT_NEAR(c.parts_at->screw, c.temperature->screw, 0.01);
  EXPECT_NEAR(c.parts_at->nut, c.temperature->nut, 0.01);
  Case warm = sized_case(r.input, c).c;
  const double cold = analyze_life(warm).system_life;
  warm.deviations.temperature = c.parts_at;
  const double travel = r.input.cycle.travel / r.input.cycle.loaded_travel;
  expect_near_relative(*c.life.revolutions, analyze_life(warm).system_life * travel, 1e-12);
  EXPECT_GT(std::abs(*c.life.revolutions / (cold * travel) - 1.0), 1e-3);
}

// The curve of the cycle passes the mean load at its speed exactly where the criteria of the mean do.
TEST(SizeCurve, TheCurveOfTheCycleLiesAboveTheMeanLoadOfAScrewThatPasses) {
  for (const char* torque : {"15 N m", "12 N m"}) {
    std::string text = example();
    text.replace(text.find("15 N m"), 6, torque);
    const SizeInput in = read(text);
    const SizeResult r = size_screws(in);
    const SizedCandidate& c = named(r, "30x10");
    const SizeCurve curve = force_over_speed(in, c).value();
    const auto series = [&](std::string_view name) -> const std::vector<double>& {
      return std::ranges::find(curve.force, name, [](const auto& s) { return s.first; })->second;
    };
    const std::vector<double>& all = series("envelope_in_cycle");
    const double v = *in.cycle.mean_speed;
    std::size_t k = 0;
    while (curve.speed[k + 1] < v) ++k;
    const double share = (v - curve.speed[k]) / (curve.speed[k + 1] - curve.speed[k]);
    const double allowed = all[k] + share * (all[k + 1] - all[k]);
    EXPECT_EQ(allowed >= *in.cycle.mean_load, c.passes) << torque;
    expect_near_relative(allowed / *in.cycle.mean_load, *criterion(c, "motor_torque").margin, 1e-3);
    ASSERT_EQ(curve.required.size(), in.cycle.shown.size());
    for (const SizeCurve::Required& point : curve.required) EXPECT_LT(point.force, series("static").front());
  }
}

constexpr const char* kScrews =
    "screw_diameter_mm,lead_mm,starts,dynamic_capacity_kN,drag_torque_Nm,axial_play_mm,grease_volume_cm3\n"
    "30,10,5,145,0.3,0.02,12\n";

/// One catalogue or several, each row with its source and what its maker prints.
TEST(SizeCatalogue, RowsHaveTheirSourcesAndPrintedValues) {
  input::Source source = input::source_of_text(
      "press.yaml",
      std::string(kPressing) + "candidates: {catalogue: [{file: a.csv, source: maker A}, {file: b.csv}]}\n", {});
  source.files.emplace()["a.csv"] = kScrews;
  (*source.files)["b.csv"] = "name,screw_diameter_mm,lead_mm,starts\nb,36,10,5\n";
  const SizeResult r = size_screws(read_requirement(source));
  ASSERT_EQ(r.candidates.size(), 2);
  const SizedCandidate &a = named(r, "30x10"), &b = named(r, "b");
  EXPECT_EQ(a.list, "maker A");
  EXPECT_EQ(b.list, "b.csv");
  EXPECT_EQ(b.number, 1U);
  EXPECT_EQ(a.row_drag_torque, 0.3);
  EXPECT_EQ(a.axial_play, 2e-5);
  EXPECT_EQ(a.grease_volume, 12e-6);
  // The printed torque is one against the motion, as `load.drag_torque`.
  source =
      input::source_of_text("press.yaml", std::string(kPressing) + "candidates: {catalogue: {file: own.csv}}\n", {});
  const SizeResult stated =
      sized_with(std::string(kPressing).insert(kPressing.find("moved_mass"), "drag_torque: 0.3 N m, ") +
                     "candidates: {catalogue: {file: own.csv}}\n",
                 "screw_diameter_mm,lead_mm,starts,dynamic_capacity_kN\n30,10,5,145\n");
  EXPECT_EQ(a.motor_rms_torque.value(), stated.candidates.front().motor_rms_torque.value());
  EXPECT_THAT(
      [] {
        sized_with(std::string(kPressing) + "candidates: {catalogue: [{file: own.csv}, {file: none.csv}]}\n", kScrews);
      },
      testing::ThrowsMessage<input::InputError>(
          AllOf(HasSubstr("candidates.catalogue[1].file"), HasSubstr("got none.csv"))));
}

/// Numbers of the published definition: a = 0.5 m, b = 0.3 m, J = 2 kg m^2, at constant speeds.
TEST(SizeLever, HasTheNumbersOfItsDefinition) {
  const auto at = [](const char* angle, const char* speed, const char* torque) {
    const SizeInput in =
        read(fmt::format("linkage: {{base: 500 mm, arm: 300 mm}}\nload: {{inertia: 2 kg m^2}}\n"
                         "motion: {{start_angle: {0}, start_speed: {1}, segments: [{{duration: 1e-9 ms, end_speed: "
                         "{1}, torque: {2}}}]}}\n",
                         angle, speed, torque));
    const PrsLever lever = prs_lever(&*in.values.linkage, in.cycle.angles->front());
    const MotionSegment& s = in.cycle.all.front();
    return std::array{lever.length, lever.ratio, s.force, s.start_speed, in.cycle.moved_mass};
  };
  const std::array a = at("60 deg", "2 rad/s", "300 N m"), b = at("110 deg", "-1.5 rad/s", "-120 N m");
  const std::array a_defined{0.435889894, 0.298019780, 1006.644591, 0.596039561, 22.518519};
  const std::array b_defined{0.665286437, 0.211869483, -566.386431, -0.317804224, 44.554665};
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_NEAR(a[k], a_defined[k], 5.1e-7 * (k < 2 || k == 3 ? 1e-3 : 1.0)) << k;
    EXPECT_NEAR(b[k], b_defined[k], 5.1e-7 * (k < 2 || k == 3 ? 1e-3 : 1.0)) << k;
  }
}

/// The work of the screw is that of the torque and the kinetic energy of the lever.
TEST(SizeLever, WorkIsThatOfTorqueAndInertia) {
  const SizeInput in = read(
      "linkage: {base: 500 mm, arm: 300 mm}\nload: {inertia: 20 kg m^2}\n"
      "motion: {start_angle: 40 deg, segments: [{duration: 0.5 s, end_speed: 30 deg/s, torque: 600 N m}, "
      "{duration: 2 s, end_speed: 30 deg/s, torque: 600 N m}]}\n");
  double work = 0.0;
  for (const MotionSegment& s : in.cycle.all) work += s.force * s.travel();
  const double turned = 67.5 * std::numbers::pi / 180.0, speed = std::numbers::pi / 6.0;
  expect_near_relative(work, 600.0 * turned + 0.5 * 20.0 * speed * speed, 2e-6);
  const auto length = [](double degrees) {
    return std::sqrt(0.34 - 0.3 * std::cos(degrees * std::numbers::pi / 180.0));
  };
  expect_near_relative(in.cycle.way, length(107.5) - length(40.0), 1e-12);
}

/// A lever that swings as a sine: theta = 80 deg + 30 deg sin(w t), with its torque and its inertia.
TEST(SizeLever, HistoryHasForcesOfTorqueAndInertia) {
  std::string csv = "t,angle,torque\n";
  constexpr int kSamples = 720;
  const double w = 2.0 * std::numbers::pi;  // 1 Hz
  const auto angle = [&](double t) { return (80.0 + 30.0 * std::sin(w * t)) * std::numbers::pi / 180.0; };
  for (int k = 0; k <= kSamples; ++k) {
    const double t = static_cast<double>(k) / kSamples;
    csv += fmt::format("{:.12f},{:.12f},{:.9f}\n", t, angle(t) * 180.0 / std::numbers::pi, 100.0 * std::cos(w * t));
  }
  input::Source source = input::source_of_text(
      "lever.yaml",
      "linkage: {base: 500 mm, arm: 300 mm}\nload: {inertia: 5 kg m^2}\n"
      "motion: {history: {file: swing.csv, time: {column: t, unit: s}, angle: {unit: deg}, torque: {unit: N m}}}\n",
      {});
  source.files.emplace()["swing.csv"] = csv;
  const SizeInput in = read_requirement(source);
  EXPECT_NEAR(in.cycle.angles->front() * 180.0 / std::numbers::pi, 50.0, 1e-9);
  EXPECT_NEAR(in.cycle.angles->back() * 180.0 / std::numbers::pi, 110.0, 1e-9);
  double largest = 0.0, time = 0.0;
  constexpr double kStep = 1.0 / kSamples;
  for (const MotionSegment& s : in.cycle.all) {
    const double t = time + 0.5 * s.duration, theta = angle(t);
    time += s.duration;
    if (s.duration < 1e-3 * kStep) continue;  // Cut off by rounding where the lever turns back.
    const double length = std::sqrt(0.34 - 0.3 * std::cos(theta)), ratio = 0.15 * std::sin(theta) / length;
    // At both ends the acceleration is that of the parabola through three samples, so of the second one.
    const double turning = -30.0 * std::numbers::pi / 180.0 * w * w * std::sin(w * std::clamp(t, kStep, 1.0 - kStep));
    const double force = (100.0 * std::cos(w * t) + 5.0 * turning) / ratio;
    largest = std::max(largest, std::abs(force));
    EXPECT_NEAR(s.force, force, 2e-4 * 600.0) << t;
  }
  expect_near_relative(in.cycle.largest_force, largest, 2e-4);
}

TEST(SizeLever, DeadCentresAreNamedByTheirRow) {
  input::Source source = input::source_of_text(
      "lever.yaml",
      "linkage: {base: 500 mm, arm: 300 mm}\n"
      "motion: {history: {file: swing.csv, time: {column: t, unit: s}, angle: {unit: deg}, torque: {unit: N m}}}\n",
      {});
  source.files.emplace()["swing.csv"] = "t,angle,torque\n0,170,5\n1,178,5\n2,179.2,5\n";
  EXPECT_THAT([&] { read_requirement(source); },
              testing::ThrowsMessage<input::InputError>(
                  AllOf(HasSubstr("lever.yaml:2:"), HasSubstr("got 179.2 deg in row 3 of swing.csv, a dead centre"))));
  EXPECT_THAT(
      [] {
        read(
            "linkage: {base: 500 mm, arm: 300 mm}\nmotion: {start_angle: 20 deg, segments: [{name: fold, duration: 1 "
            "s, "
            "end_speed: -50 deg/s, torque: 9 N m}]}\n");
      },
      testing::ThrowsMessage<input::InputError>(AllOf(HasSubstr("deg in fold, a dead centre"), HasSubstr("1 to 179"))));
}

/// Steps of one second at 50 rad/s of the motor and 10 N m: numbers of the published definition, then braking, and a
/// power that passes zero in a straight line.
TEST(SizeMotor, CurrentVoltageAndEnergyAreThoseOfTheDirectCurrentMotor) {
  DriveMotor motor;
  motor.torque_constant = 0.5;
  motor.resistance = 0.8;
  motor.supply.voltage = 48.0;
  constexpr double kLead = 2.0 * std::numbers::pi;  // A speed of the axis is then that of the motor.
  const auto demand = [&](double from, double to, double torque) {
    const DrivenStep step{{.load_case = {}, .duration = 1.0, .start_speed = from, .end_speed = to}, torque};
    return *motor_demand(std::span(&step, 1), motor, kLead, 0.0, 0.0, true).electric;
  };
  const ElectricDemand drives = demand(50.0, 50.0, 10.0);
  EXPECT_NEAR(drives.peak_current, 20.0, 1e-12);
  EXPECT_NEAR(drives.rms_current, 20.0, 1e-12);
  EXPECT_NEAR(*drives.peak_voltage, 41.0, 1e-12);
  EXPECT_NEAR(*drives.energy, 820.0, 1e-10);
  EXPECT_NEAR(*drives.copper_loss, 320.0, 1e-10);
  EXPECT_EQ(*drives.regenerated, 0.0);
  EXPECT_NEAR(*drives.voltage_speed, 64.0, 1e-12);  // 0.5 N m/A times it leaves 16 V of 48 V for 20 A.
  const ElectricDemand brakes = demand(50.0, 50.0, -10.0);
  EXPECT_NEAR(*brakes.peak_voltage, 9.0, 1e-12);
  EXPECT_NEAR(*brakes.energy, -180.0, 1e-10);
  EXPECT_NEAR(*brakes.regenerated, 180.0, 1e-10);
  const ElectricDemand stops = demand(64.0, 0.0, -10.0);  // Power from -320 W to 320 W.
  EXPECT_NEAR(*stops.energy, 0.0, 1e-10);
  EXPECT_NEAR(*stops.regenerated, 80.0, 1e-10);
  motor.resistance.reset();
  EXPECT_FALSE(demand(50.0, 50.0, 10.0).peak_voltage);
}

constexpr std::string_view kElectric =
    "motor: {torque_constant: 0.5 N m/A, resistance: 0.8 Ohm, supply: {voltage: 48 V, current: 40 A}, "
    "continuous_current: 15 A}\nbrake: {torque: 40 N m}\n";

TEST(SizeMotor, CriteriaAndCurveHaveVoltageAndCurrent) {
  const SizeResult r =
      sized(std::string(kMotion).append(kLoad).append(kElectric) + "stroke: 650 mm\nmodel: {loads: static}\n");
  const SizedCandidate& c = named(r, "30x10");
  const ElectricDemand& e = c.electric.value();
  EXPECT_NEAR(e.rms_current, *c.motor_rms_torque / 0.5, 1e-12);
  EXPECT_EQ(criterion(c, "motor_voltage").value, e.peak_voltage);
  EXPECT_EQ(criterion(c, "motor_voltage").limit, 48.0);
  EXPECT_EQ(criterion(c, "motor_voltage").unit, "V");
  EXPECT_EQ(criterion(c, "motor_current").value, e.peak_current);
  EXPECT_EQ(criterion(c, "motor_rms_current").value, e.rms_current);
  EXPECT_EQ(criterion(c, "motor_rms_current").unit, "A");
  // 1800 rpm and some 35 A need 0.5 N m/A 188 rad/s + 28 V.
  EXPECT_EQ(criterion(c, "motor_voltage").status, CriterionStatus::fail);
  EXPECT_NEAR(*criterion(c, "brake").value, 40.0 / (1.5 * *c.holding_torque), 1e-12);
  EXPECT_EQ(criterion(c, "brake").limit, 1.0);
  expect_near_relative(*c.reflected_mass, *c.inertia * std::pow(2.0 * std::numbers::pi / 0.01, 2), 1e-12);
  expect_near_relative(*c.back_driving_force, 0.1 * 2.0 * std::numbers::pi / 0.01 / *c.back_driving_efficiency, 1e-12);
  // The curve ends at the speed at which the voltage drives no torque.
  const SizeCurve curve = force_over_speed(r.input, c).value();
  expect_near_relative(curve.speed.back(), 48.0 / 0.5 / (2.0 * std::numbers::pi) * 0.01, 1e-12);
  const auto voltage = std::ranges::find(curve.force, "motor_voltage", [](const auto& s) { return s.first; });
  ASSERT_NE(voltage, curve.force.end());
  EXPECT_EQ(voltage->second.back(), 0.0);
  const double torque = 0.5 * (48.0 - 24.0) / 0.8;  // At half of that speed.
  expect_near_relative(voltage->second[19], (torque - 0.1) * 2.0 * std::numbers::pi / 0.01 * curve.efficiency[19],
                       1e-12);
}

/// The loads of both flanks give drag, life and stiffness, also for the written case.
TEST(SizePreload, IsThatOfAPreloadedNut) {
  const std::string text = of_one(std::string(kMotion).append(kLoad)) + "stroke: 650 mm\nlife: {hours: 100 h}\n";
  const SizeResult loose = sized(text), tight = sized(text + "preload: {share: 5 %}\n");
  const SizedCandidate &a = loose.candidates.front(), &b = tight.candidates.front();
  EXPECT_FALSE(a.no_load_torque);
  expect_near_relative(*b.preload_force, 0.05 * *b.by_threads.capacity, 1e-11);
  EXPECT_GT(*b.no_load_torque, 0.0);
  EXPECT_LT(*b.life.hours, *a.life.hours);
  EXPECT_GT(*b.stiffness, *a.stiffness);
  EXPECT_LT(*b.efficiency, *a.efficiency);
  const input::Source source = input::source_of_text("written.yaml", written_candidate(tight.input, b), {});
  const Case written = input::read_case_input(source, Command::life).values;
  expect_near_relative(*b.life.revolutions,
                       analyze_life(written).system_life * tight.input.cycle.travel / tight.input.cycle.loaded_travel,
                       1e-9);
  const Result slip = analyze_slip(written);
  expect_near_relative(*b.segments.front().efficiency, *slip.load_cases.front().slip->efficiency, 1e-9);
}

// The solved lever: 298.019780 mm/rad and 22.518519 kg at 60 deg.
TEST(SizePictures, ALeverIsDrawnOverItsAngle) {
  const SizeResult r = sized(
      of_one("linkage: {base: 500 mm, arm: 300 mm}\nload: {inertia: 2 kg m^2}\n"
             "motion: {start_angle: 60 deg, segments: [{duration: 1 s, end_speed: 20 deg/s, torque: 300 N m}]}\n"));
  const Pictures all = size_pictures(r);
  const Figures figures = std::ranges::find(all, "size_lever", &Picture::name)->make({});
  const auto first = [&](std::size_t panel) { return figures.at(0).panels.at(panel).series.at(0).parts.at(0).at(0); };
  EXPECT_NEAR(first(0)[0], 60.0, 1e-9);
  EXPECT_NEAR(first(0)[1], 298.019780, 1e-6);
  EXPECT_NEAR(first(1)[1], 22.518519, 1e-6);
}

TEST(SizePictures, ALeverThatOnlyHoldsHasNone) {
  const SizeResult r = sized(
      of_one("linkage: {base: 500 mm, arm: 300 mm}\n"
             "motion: {start_angle: 60 deg, segments: [{duration: 1 s, end_speed: 0 deg/s, torque: 300 N m}]}\n"));
  const Pictures all = size_pictures(r);
  EXPECT_TRUE(std::ranges::find(all, "size_lever", &Picture::name)->make({}).empty());
}

struct Wrong {
  const char* text;
  const char* place;
  const char* message;
};

class WrongRequirement : public testing::TestWithParam<Wrong> {};

TEST_P(WrongRequirement, IsRefusedWhereItStands) {
  try {
    sized(GetParam().text);
    FAIL() << "was taken";
  } catch (const input::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(fmt::format("press.yaml:{}: error: ", GetParam().place)));
    EXPECT_THAT(error.what(), HasSubstr(GetParam().message));
  }
}

#define MOTION "motion: {segments: [{duration: 1 s, end_speed: 9 mm/s, force: 1 kN}]}\n"
INSTANTIATE_TEST_SUITE_P(
    Size, WrongRequirement,
    testing::Values(
        Wrong{"load: {moved_mass: 50 kg}\n", "1:1", "motion: missing"},
        Wrong{"motion: {segments: [{duration: 1 s, end_speed: 9 mm/s}], loads: [{speed: 9 mm/s, "
              "share: 100 %}]}\n",
              "1:65", "stands next to `segments`"},
        Wrong{"motion: {segments: [{duration: 1, end_speed: 9 mm/s}]}\n", "1:32", "with its unit"},
        Wrong{"motion: {segments: [{duration: 0 s, end_speed: 9 mm/s}]}\n", "1:32", "> 0"},
        Wrong{"motion: {loads: [{speed: 9 mm/s, share: 30 %}]}\n", "1:17", "the sum 30 %"},
        Wrong{MOTION "load: {moved_mas: 5 kg}\n", "2:8", "did you mean `moved_mass`?"},
        Wrong{MOTION "load: {inclination: 91 deg}\n", "2:21", "<= 90 deg"},
        Wrong{MOTION "life: {hours: 9 h, distance: 9 km}\n", "2:30", "stands next to `hours`"},
        Wrong{MOTION "life: {reliability: 99.9 %}\n", "2:21", "<= 99 %"},
        Wrong{MOTION "objective: price\n", "2:12", "weight | nut_diameter | life"},
        Wrong{MOTION "candidates: {designs: {screw_diameter: {from: 9 mm, to: 20 mm, series: R3}, "
                     "lead: 5 mm}}\n",
              "2:72", "R5 | R10 | R20 | R40"},
        Wrong{MOTION "stroke: 1 mm\n", "2:9", "4.5 mm"},
        Wrong{MOTION "motor: {rated_torque: 3 N m, peak_torque: 2 N m}\n", "2:43", "at least `rated_torque`"},
        Wrong{MOTION "motor: {supply: {voltage: 48 V}}\n", "2:9",
              "only with `torque_constant`; write `torque_constant: 0.5 N m/A`, or delete it"},
        Wrong{MOTION "motor: {torque_constant: 0.5 N m/A, supply: {voltage: 48 V}}\n", "2:1",
              "motor.resistance: missing"},
        Wrong{MOTION "motor: {torque_constant: 0.5 N m}\n", "2:26", "mN m/A"},
        Wrong{MOTION "brake: {torque: 4 N m, safety: 0.9}\n", "2:32", ">= 1"},
        Wrong{MOTION "heat: {conductance: {screw_ambient: 0 W/K, nut_ambient: 0 W/K}}\n", "2:21",
              "got no conductance to the surroundings"},
        Wrong{MOTION "heat: {cycles: 2, start: 800 degC}\n", "2:26",
              "expected less than 726.85 degC, where bearing steel"},
        Wrong{MOTION "heat: {start: 20 degC}\n", "2:8", "it stands with `cycles`; write `cycles: 3`, or delete it"},
        Wrong{MOTION "bearings: {}\n", "2:1", "`fixed: {dynamic_capacity: 50 kN}`"},
        Wrong{MOTION "bearings: {fixed: {static_capacity: 9 kN, exponent: 3}}\n", "2:43",
              "only with `dynamic_capacity`; write `dynamic_capacity: 50 kN`"},
        Wrong{MOTION "preload: {share: 60 %}\n", "2:18", "<= 50 %"},
        Wrong{MOTION "preload: {share: 5 %, force: 2 kN}\n", "2:10", "exactly one of force, share"},
        Wrong{MOTION "linkage: {base: 500 mm, arm: 300 mm}\n", "1:48", "a rotational speed"},
        Wrong{"motion: {start_angle: 9 deg, segments: [{duration: 1 s, end_speed: 9 mm/s}]}\n", "1:10",
              "only with `segments` and `linkage`"},
        Wrong{"linkage: {base: 500 mm, arm: 300 mm}\nmotion: {segments: [{duration: 1 s, end_speed: 9 deg/s, torque: "
              "9 N m}]}\n",
              "2:1", "motion.start_angle: missing"},
        Wrong{MOTION "limits: {temperature: 20 degC}\n", "2:23", "heat.ambient: 25 degC"},
        Wrong{MOTION "relubrication: {peak_force: 1 kN}\n", "2:1", "relubrication.static_load_factor: missing"},
        Wrong{"motion: {segments: [{name: a, duration: 1 s, end_speed: 9 mm/s, force: 1 kN}, {name: "
              "a, duration: 1 s, end_speed: 0 mm/s}]}\n",
              "1:20", "two segments called a"},
        Wrong{"motion: {segments: [{name: back-driving, duration: 1 s, end_speed: 9 mm/s, force: 1 "
              "kN}]}\n",
              "1:20", "rename it"},
        Wrong{"motion: {segments: [{duration: 1 s, end_speed: 9 mm/s}]}\n", "1:20", "no force"},
        Wrong{MOTION "candidates: {catalogue: {file: none.csv}}\n", "2:32", "does not exist"},
        Wrong{MOTION "candidates: {designs: {screw_diameter: {from: 9 mm, to: 90 mm, steps: 400}, "
                     "lead: {from: 5 mm, to: 9 mm, steps: 400}}}\n",
              "2:13", "at most 100000"},
        Wrong{MOTION "heat: {cycles: 0}\n", "2:16", "got 0"},
        Wrong{"motion: {segments: [{duration: 1 s, end_speed: 9 mm/s, force: 1 kN}, {duration: 1 s, end_speed: 0 "
              "mm/s}]}\n"
              "heat: {cycles: 60000}\n",
              "2:16", "got 60000 cycles; expected at most 50000 of this cycle"},
        Wrong{MOTION "heat: {start: 20 degC}\n", "2:8", "it stands with `cycles`"},
        Wrong{MOTION "heat: {cycles: 2, start: 90 degC}\nlimits: {temperature: 80 degC}\n", "2:26",
              "less than 80 degC, `limits.temperature`"},
        Wrong{MOTION "heat: {cycles: 2}\nlosses: catalogue\n", "2:16", "together with `losses: catalogue`"},
        Wrong{MOTION
              "heat: {cycles: 2}\nlubricant: {viscosity: 0.1 Pa s, pressure_viscosity: 20 1/GPa, eyring_stress: 5 "
              "MPa}\n",
              "3:24", "follows the temperature"},
        Wrong{MOTION "bearings: {fixed: {dynamic_capacity: 5 kN, preload: 9 kN}}\n", "2:53",
              "less than `dynamic_capacity`"},
        Wrong{"mechanism: {type: standard}\n" MOTION, "1:1", "got a case"}));
#undef MOTION

TEST(SizeCatalogue, IsRefusedWhereItIsWrong) {
  const auto message = [](const char* csv) -> std::string {
    input::Source source =
        input::source_of_text("press.yaml",
                              "motion: {segments: [{duration: 1 s, end_speed: 9 mm/s, force: 1 kN}]}\n"
                              "candidates: {catalogue: {file: own.csv}}\n",
                              {});
    source.files.emplace()["own.csv"] = csv;
    try {
      size_screws(read_requirement(source));
    } catch (const input::InputError& error) {
      return error.what();
    }
    return "taken";
  };
  EXPECT_THAT(message("screw_diameter_mm,lead_mm,starts\n"), HasSubstr("has no rows"));
  EXPECT_THAT(message("screw_diameter_mm,lead_mm\n30,10\n"), HasSubstr("lacks the column starts"));
  EXPECT_THAT(message("screw_diameter_mm,lead_mm,starts\n30,ten,5\n"),
              HasSubstr("own.csv:2:4: error: lead_mm: got ten; expected a number other than 0"));
  EXPECT_EQ(message("screw_diameter_mm;lead_mm;starts;colour\n30;10;5;blue\n"), "taken");
  EXPECT_THAT(message("screw_diameter_mm,lead_mm,starts,dynamic_capacity_kN\n48,10,5,188500\n"),
              AllOf(HasSubstr("own.csv:2:9: error: dynamic_capacity_kN: got 188500"), HasSubstr("in place of N")));
}

}  // namespace
}  // namespace prs
