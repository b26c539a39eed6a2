#include "prs/configurations/screw_case.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "prs/input/reader.h"
#include "prs/loads/analyze.h"
#include "prs/threads/contacts.h"
#include "prs/threads/geometry_warnings.h"
#include "prs/threads/threads.h"
#include "tests/support/program.h"
#include "tests/support/temporary_directory.h"

namespace prs {
namespace {

using std::numbers::pi;
using testing::HasSubstr;

constexpr double mm = 1e-3;

ConfigurationQuery query(double screw_diameter, double lead) {
  ConfigurationQuery q;
  q.screw_diameter = screw_diameter * mm;
  q.lead = lead * mm;
  return q;
}

/// The one configuration of a type with these starts.
Configuration only(ConfigurationQuery q, Mechanism::Type type, int screw_starts, int roller_starts = 1) {
  q.type = type;
  q.screw_starts = screw_starts;
  q.roller_starts = roller_starts;
  const Configurations all = configurations(q);
  EXPECT_EQ(all.found.size(), 1u);
  return all.found.empty() ? Configuration{} : all.found[0];
}

constexpr auto standard = Mechanism::Type::standard;
constexpr auto inverted = Mechanism::Type::inverted;

TEST(Configurations, JungExample) {
  // Section 2.2.2.4: 50 mm, seven starts, lead 21 mm.
  const Configuration c = only(query(50, 21), standard, 7);
  EXPECT_NEAR(axial_pitch(c.mechanism), 3 * mm, 1e-15);
  EXPECT_NEAR(c.rolling_diameter.roller, 10 * mm, 1e-15);
  EXPECT_NEAR(c.rolling_diameter.nut, 70 * mm, 1e-15);
  EXPECT_NEAR(c.pitch_diameter.roller, 10 * mm, 1e-15);
  EXPECT_NEAR(c.pitch_diameter.nut, 70 * mm, 1e-15);
  EXPECT_NEAR(c.gear_ratio, 1.0 / 7, 1e-15);
}

TEST(Configurations, SanduReferenceIsTheDesignWithoutBacklash) {
  ConfigurationQuery q = query(30, 10);
  q.roller_profile_radius = 6 * mm;
  const Configuration c = only(q, standard, 5);
  // Errata 4, to the digits printed.
  EXPECT_NEAR(0.5 * c.pitch_diameter.screw, 14.9467 * mm, 6e-5 * mm);
  EXPECT_NEAR(c.centre_distance, 20.0 * mm, 6e-5 * mm);
  EXPECT_NEAR(c.pitch_diameter.roller, 10 * mm, 1e-15);
  EXPECT_NEAR(c.pitch_diameter.nut, 50 * mm, 1e-15);

  Mechanism m;
  m.type = standard;
  m.geometry = Mechanism::Geometry::design;
  m.lead = 10 * mm;
  m.starts = {5, 1};
  m.flank_angle = {pi / 4, pi / 4, pi / 4};
  m.pitch_diameter.screw = 30 * mm;
  m.profile.roller = {Profile::Shape::convex, 6 * mm};
  m.rollers = 9;
  m.contacts_per_roller = 20;
  const Mechanism designed = resolved(m);
  for (const Part p : kParts) EXPECT_NEAR(c.pitch_diameter[p], *designed.pitch_diameter[p], 1e-13) << name(p);
  EXPECT_NEAR(c.centre_distance, *designed.centre_distance, 1e-13);
}

TEST(Configurations, AbeviScrew) {
  // Tables 1 and 2: 21, 7 and 35 mm, 11 rollers.
  const Configuration c = only(query(21, 5), inverted, 3);
  EXPECT_NEAR(c.rolling_diameter.roller, 7 * mm, 1e-15);
  EXPECT_NEAR(c.rolling_diameter.nut, 35 * mm, 1e-15);
  EXPECT_NEAR(c.centre_distance, 14 * mm, 1e-9);
  EXPECT_EQ(c.most_rollers, 11);
  EXPECT_LT(c.lead.roller, 0.0);
  // Errata: INTERFACE gives -0.064 mm of backlash for a nut of 35 mm, at 45 deg about its oversize.
  EXPECT_NEAR(c.pitch_diameter.nut - 35 * mm, 0.064 * mm, 6e-4 * mm);
}

/// Warnings of `prs check` on a case.
std::vector<std::string> unusual(const std::string& text) {
  const Case c = input::read_case_text(text, "case.yaml", {}, Command::solve);
  return sentences(selected(geometry_warnings(c, find_contacts(c.mechanism, c.materials), c.load_cases), false));
}

TEST(Configurations, EachPassesCheckWithoutWarning) {
  std::size_t count = 0;
  for (const auto& [diameter, lead] :
       {std::pair{30.0, 10.0}, {21.0, 5.0}, {8.0, 1.0}, {100.0, -20.0}, {48.0, 40.0}, {300.0, 12.0}})
    for (const double flank_angle : {30.0, 45.0, 55.0}) {
      ConfigurationQuery q = query(diameter, lead);
      q.flank_angle = flank_angle * pi / 180;
      for (const Configuration& c : configurations(q).found) {
        SCOPED_TRACE(configuration_case(c));
        EXPECT_THAT(unusual(configuration_case(c)), testing::IsEmpty());
        ++count;
      }
    }
  EXPECT_GT(count, 300u);
}

TEST(Configurations, WrittenCaseIsTheListedMechanism) {
  for (const Configuration& c : configurations(query(30, 10)).found) {
    const Case read = input::read_case_text(configuration_case(c), "case.yaml", {}, Command::solve);
    const Mechanism m = resolved(read.mechanism);
    for (const Part p : kParts) EXPECT_EQ(*m.pitch_diameter[p], c.pitch_diameter[p]);
    EXPECT_EQ(*m.centre_distance, c.centre_distance);
    EXPECT_EQ(m.rollers, c.most_rollers);
  }
}

TEST(Configurations, WrittenCaseSolvesNearItsPressure) {
  for (const auto& [type, starts] : {std::pair{standard, 5}, {inverted, 4}}) {
    const Configuration c = only(query(30, 10), type, starts);
    const Case read = input::read_case_text(configuration_case(c), "case.yaml", {}, Command::solve);
    const Result result = analyze(read);
    ASSERT_EQ(result.load_cases.size(), 2u);
    ASSERT_TRUE(result.load_cases[0].converged());
    EXPECT_THAT(sentences(result.warnings), testing::IsEmpty());
    EXPECT_THAT(sentences(result.load_cases[0].warnings), testing::IsEmpty());
    // Two digits of the force, and shares that are not equal.
    double peak = 0.0;
    for (const Interface i : kInterfaces)
      for (const double p : (*result.load_cases[0].threads)[i].peak_pressure) peak = std::max(peak, p);
    EXPECT_GT(peak, 1.75e9);
    EXPECT_LT(peak, 2.5e9);
  }
}

TEST(Configurations, HelixAnglesMatchWhereRollersKeepTheirPlace) {
  for (const Configuration& c : configurations(query(40, 16)).found) {
    if (c.mechanism.starts.roller == 0) continue;
    const bool is_standard = c.mechanism.type == standard;
    const Part body = is_standard ? Part::nut : Part::screw;
    EXPECT_NEAR(c.helix_angle.roller, (is_standard ? 1 : -1) * c.helix_angle[body], 1e-12);
    EXPECT_NEAR(c.gear_ratio, c.pitch_diameter.roller / c.pitch_diameter[body], 1e-12);
    EXPECT_NEAR(c.rolling_diameter.nut, c.rolling_diameter.screw + 2 * c.rolling_diameter.roller, 1e-12);
  }
}

TEST(Configurations, MirrorAndScaleChangeNothingElse) {
  const Configurations one = configurations(query(30, 10));
  const Configurations mirrored = configurations(query(30, -10));
  const Configurations twice = configurations(query(60, 20));
  ASSERT_EQ(one.found.size(), mirrored.found.size());
  ASSERT_EQ(one.found.size(), twice.found.size());
  for (std::size_t k = 0; k < one.found.size(); ++k) {
    const Configuration& c = one.found[k];
    for (const Part p : kParts) {
      EXPECT_NEAR(c.pitch_diameter[p], mirrored.found[k].pitch_diameter[p], 1e-12);
      EXPECT_NEAR(c.pitch_diameter[p], 0.5 * twice.found[k].pitch_diameter[p], 1e-12);
      EXPECT_EQ(c.lead[p], -mirrored.found[k].lead[p]);
    }
    EXPECT_EQ(c.most_rollers, mirrored.found[k].most_rollers);
    EXPECT_EQ(c.most_rollers, twice.found[k].most_rollers);
  }
}

TEST(Configurations, StartsWithoutSenseAreLeftOutWithTheirReason) {
  ConfigurationQuery q = query(30, 10);
  q.type = standard;
  q.screw_starts = 2;
  q.roller_starts = 1;
  Configurations all = configurations(q);
  EXPECT_TRUE(all.found.empty());
  ASSERT_EQ(all.left_out.size(), 1u);
  EXPECT_THAT(all.left_out[0].reason, HasSubstr("more than two screw starts"));
  q.screw_starts = 5;
  q.rollers = 12;
  all = configurations(q);
  ASSERT_EQ(all.left_out.size(), 1u);
  EXPECT_EQ(all.left_out[0].reason, "12 rollers do not fit, at most 11");
  q.rollers = 11;
  EXPECT_EQ(configurations(q).found.size(), 1u);
}

TEST(RollerSpacing, AsManyFitAsTheCrestsLeaveRoomFor) {
  ConfigurationQuery q = query(30, 10);
  for (const double gap : {0.0, 0.2, 1.0}) {
    q.gap = gap * mm;
    for (const Configuration& c : configurations(q).found) {
      // Distance of two neighbours' axes less two crests, from their coordinates.
      const double crest = contact::flank_limits(find_contacts(c.mechanism, {}).threads.roller).largest;
      const auto free = [&](int n) {
        const double angle = 2 * pi / n;
        return std::hypot(c.centre_distance * (1 - std::cos(angle)), c.centre_distance * std::sin(angle)) - 2 * crest;
      };
      EXPECT_GE(free(c.most_rollers), q.gap - 1e-12);
      EXPECT_LT(free(c.most_rollers + 1), q.gap);
      EXPECT_NEAR(free(c.most_rollers), c.crest_gap, 1e-12);
    }
  }
}

/// Height [m], modulo the pitch, by which the crest of roller i at its place misses the groove of a
/// body there. Crests z = l theta/(2 pi), grooves half a pitch higher; the roller is turned by
/// `turn` as seen from its place and faces the screw with its inner side.
double mismatch(const Configuration& c, Part body, int i, int rollers, double turn) {
  const double place = 2 * pi * i / rollers, psi = place + turn;
  const double facing = body == Part::screw ? place + pi : place;
  const double pitch = axial_pitch(c.mechanism);
  const double crest = c.lead.roller * (facing - psi) / (2 * pi);
  const double groove = c.lead[body] * place / (2 * pi) + 0.5 * pitch;
  return crest - groove;
}

/// Whether all rollers meet the grooves of a body at the same height, each turned by `indexing` against the previous
/// one.
bool all_mesh(const Configuration& c, Part body, int rollers, double indexing) {
  const double pitch = axial_pitch(c.mechanism);
  const double first = mismatch(c, body, 0, rollers, 0.0);
  for (int i = 1; i < rollers; ++i)
    if (std::abs(std::remainder(mismatch(c, body, i, rollers, i * indexing) - first, pitch)) > 1e-9 * pitch)
      return false;
  return true;
}

TEST(RollerSpacing, EveryNumberMeshesBothThreadsWithItsIndexing) {
  for (const double lead : {10.0, -10.0})
    for (const Configuration& c : configurations(query(30, lead)).found)
      for (int n = 3; n <= c.most_rollers && c.mechanism.starts.roller > 0; ++n) {
        const Mechanism& m = c.mechanism;
        const double indexing = indexing_angle(m.type, m.starts, n);
        EXPECT_GE(indexing, 0.0);
        EXPECT_LT(indexing, 2 * pi / m.starts.roller);
        for (const Part body : {Part::screw, Part::nut}) {
          EXPECT_TRUE(all_mesh(c, body, n, indexing));
          EXPECT_EQ(all_mesh(c, body, n, 0.0), go_in_alike(m.starts, n)) << n;
          EXPECT_FALSE(all_mesh(c, body, n, indexing + 0.1));
        }
        EXPECT_EQ(std::ranges::count(c.alike, n), go_in_alike(m.starts, n) ? 1 : 0);
      }
}

/// The teeth of all pinions meet the gaps of the body's gear in the same phase.
TEST(GearPairs, MeshInTheTurnThatTheThreadsAskFor) {
  for (const Configuration& c : configurations(query(30, 10)).found)
    for (const GearPair& pair : c.gears)
      for (int n = 3; n <= c.most_rollers; ++n) {
        const Mechanism& m = c.mechanism;
        const double turn = indexing_angle(m.type, m.starts, n);
        const double sense = m.type == standard ? -1.0 : 1.0;
        for (int i = 0; i < n; ++i) {
          // Phase of a tooth of the pinion every 2 pi/z_R from its mark, in the line of centres.
          const double phase = (pair.roller_teeth * (-turn * i) + sense * pair.body_teeth * 2 * pi * i / n) / (2 * pi);
          EXPECT_NEAR(std::remainder(phase, 1.0), 0.0, 1e-9) << pair.roller_teeth << ' ' << n;
        }
      }
}

TEST(GearPairs, RunWithoutBacklashAtTheCentreDistance) {
  const double alpha = pi / 9;
  const auto involute = [](double a) { return std::tan(a) - a; };
  std::size_t count = 0;
  for (const Configuration& c : configurations(query(33, 9)).found)
    for (const GearPair& pair : c.gears) {
      const Mechanism& m = c.mechanism;
      EXPECT_EQ(pair.body_teeth * m.starts.roller, pair.roller_teeth * m.starts.screw);
      const bool internal = m.type == standard;
      // Thickness [rad of the gear's turn] at the operating circle; for a ring gear that of the gap.
      const auto thickness = [&](int teeth, double shift) {
        return (pi + 4 * shift * std::tan(alpha)) / teeth +
               2 * (involute(alpha) - involute(pair.working_pressure_angle));
      };
      const auto operating_radius = [&](int teeth) {
        return 0.5 * teeth * pair.module * std::cos(alpha) / std::cos(pair.working_pressure_angle);
      };
      const double r_roller = operating_radius(pair.roller_teeth);
      const double r_body = operating_radius(pair.body_teeth);
      EXPECT_NEAR(internal ? r_body - r_roller : r_body + r_roller, c.centre_distance, 1e-12);
      const double x_roller = 0.3;
      const double x_body = internal ? pair.profile_shift + x_roller : pair.profile_shift - x_roller;
      const double tooth = r_roller * thickness(pair.roller_teeth, x_roller);
      const double other = r_body * thickness(pair.body_teeth, x_body);
      const double pitch = 2 * pi * r_roller / pair.roller_teeth;
      EXPECT_NEAR(internal ? other : pitch - other, tooth, 1e-12);
      EXPECT_LE(std::abs(pair.profile_shift), 1.0);
      ++count;
    }
  EXPECT_GT(count, 100u);
}

TEST(GearPairs, ExactModuleNeedsNoShift) {
  // Inverted, 21 and 7 mm: 14 : 42 of module 0.5 mm have the pitch circles of the threads.
  Mechanism m;
  m.type = inverted;
  m.starts = {3, 1};
  m.lead = 5 * mm;
  const auto of = [&](int rollers) {
    m.rollers = rollers;
    return m;
  };
  const std::vector<GearPair> pairs = gear_pairs(of(9), 14 * mm, 0.0);
  ASSERT_FALSE(pairs.empty());
  EXPECT_EQ(pairs[0].roller_teeth, 14);
  EXPECT_EQ(pairs[0].body_teeth, 42);
  EXPECT_NEAR(pairs[0].module, 0.5 * mm, 1e-15);
  EXPECT_NEAR(pairs[0].profile_shift, 0.0, 1e-12);
  EXPECT_NEAR(pairs[0].working_pressure_angle, pi / 9, 1e-12);
  EXPECT_EQ(pairs[0].most_rollers, 9);
  EXPECT_NEAR(pairs[0].tooth_misfit, 5 * mm / 3 / 14, 1e-15);  // One tooth turns the roller by a 14th of its lead.
  // Tips of 8 mm in diameter: 2 * 14 sin(pi/10) = 8.65 mm, sin(pi/11) gives 7.89 mm.
  const std::vector<GearPair> crowded = gear_pairs(of(11), 14 * mm, 0.0);
  const auto same = std::ranges::find_if(
      crowded, [&](const GearPair& p) { return p.roller_teeth == 14 && p.module == pairs[0].module; });
  ASSERT_NE(same, crowded.end());
  EXPECT_EQ(same->most_rollers, 10);
}

class ConfigurationsCommand : public testing::Test {
 protected:
  test::TemporaryDirectory folder;

  test::Outcome prs(const std::string& arguments) const { return test::run_prs(arguments, folder.path()); }
};

TEST_F(ConfigurationsCommand, DocumentFilesAndTableAgree) {
  const std::string asked = "configurations --screw-diameter '30 mm' --lead '10 mm' ";
  const test::Outcome json = prs(asked + "--json --output out");
  ASSERT_EQ(json.status, 0) << json.err;
  EXPECT_EQ(json.err, "");
  const auto document = nlohmann::json::parse(json.out);
  const Configurations all = configurations(query(30, 10));
  ASSERT_EQ(document["configurations"].size(), all.found.size());
  EXPECT_EQ(document["left_out"].size(), all.left_out.size());
  for (std::size_t k = 0; k < all.found.size(); ++k) {
    const auto& one = document["configurations"][k];
    EXPECT_EQ(one["number"], k + 1);
    EXPECT_NEAR(one["pitch_diameter_mm"]["nut"].get<double>(), all.found[k].pitch_diameter.nut * 1e3, 1e-9);
    EXPECT_EQ(one["rollers"]["most"], all.found[k].most_rollers);
  }
  const auto lines = [](const std::string& text) { return std::ranges::count(text, '\n'); };
  EXPECT_EQ(lines(test::content_of(folder.path() / "out/configurations.csv")), static_cast<long>(all.found.size() + 1));
  EXPECT_EQ(nlohmann::json::parse(test::content_of(folder.path() / "out/configurations.json")), document);
  EXPECT_THAT(prs(asked).out, HasSubstr("20:100, 0.5"));
  EXPECT_EQ(prs(asked + "--quiet").out, "");
}

/// Every start of an inverted screw is listed by default, and what is listed can be written.
TEST_F(ConfigurationsCommand, WritesInvertedScrewsOfOneAndTwoStarts) {
  for (const int starts : {1, 2}) {
    const test::Outcome run = prs(fmt::format(
        "configurations --screw-diameter '20 mm' --lead '2 mm' --type inverted --starts {0} --write 1 {0}.yaml",
        starts));
    ASSERT_EQ(run.status, 0) << run.err;
    const auto checked = nlohmann::json::parse(prs(fmt::format("check {}.yaml --json", starts)).out);
    EXPECT_NEAR(checked["contact"]["pitch_diameter_mm"]["roller"].get<double>(), 20.0 / starts, 1e-9);
  }
  const auto all = nlohmann::json::parse(
      prs("configurations --screw-diameter '20 mm' --lead '2 mm' --type inverted --json").out)["configurations"];
  EXPECT_EQ(all[0]["starts"]["screw"], 1);
  EXPECT_EQ(prs("new inverted one.yaml --screw-diameter 20mm --lead 2mm --starts 1").status, 0);
}

/// Screws of all starts in one nut: d_N = (D - 5.8 mm)/1.155 = d_S + 2 d_R by the rule of `prs new`.
TEST_F(ConfigurationsCommand, ComparesStartsInOneNut) {
  const test::Outcome json = prs("configurations --nut-diameter '50 mm' --lead '5 mm' --json");
  ASSERT_EQ(json.status, 0) << json.err;
  const auto document = nlohmann::json::parse(json.out);
  ASSERT_GT(document["configurations"].size(), 8u);
  for (const auto& one : document["configurations"]) {
    EXPECT_NEAR(one["rolling_diameter_mm"]["nut"].get<double>(), (50.0 - 5.8) / 1.155, 1e-9);
    EXPECT_EQ(one["nut_outer_diameter_mm"], 50.0);
    EXPECT_GT(one["dynamic_capacity_kN"].get<double>(), 0.0);
    const double rpm = one["greatest_speed_rpm"].get<double>();
    EXPECT_NEAR(rpm * one["rolling_diameter_mm"]["screw"].get<double>(), 150e3, 1e-6);
    EXPECT_NEAR(one["greatest_travel_mm_per_s"].get<double>(), rpm * 5.0 / 60.0, 1e-9);
    if (one["type"] == "recirculating") {
      EXPECT_EQ(one["gears"].size(), 0u);
      EXPECT_EQ(one["rollers"]["unloaded"], 1);
      EXPECT_FALSE(one["rollers"].contains("indexing_angle_deg"));
      continue;
    }
    const auto& rollers = one["rollers"];
    const double turn = 360.0 / one["starts"]["roller"].get<double>();
    for (std::size_t k = 0; k < rollers["indexing_angles_deg"].size(); ++k)
      EXPECT_NEAR(std::remainder(rollers["indexing_angles_deg"][k].get<double>() -
                                     static_cast<double>(k) * rollers["indexing_angle_deg"].get<double>(),
                                 turn),
                  0.0, 1e-9);
    for (const auto& pair : one["gears"])
      EXPECT_NEAR(pair["tooth_misfit_mm"].get<double>() * pair["roller_teeth"].get<double>(),
                  std::abs(one["lead_mm"]["roller"].get<double>()), 1e-12);
  }
  EXPECT_THAT(prs("configurations --nut-diameter '50 mm' --lead '5 mm'").out, HasSubstr("misfit"));
  EXPECT_EQ(
      prs("configurations --nut-diameter '50 mm' --lead '5 mm' --type standard --starts 5 --write 1 in.yaml").status,
      0);
  EXPECT_THAT(test::content_of(folder.path() / "in.yaml"), HasSubstr("outer_diameter: 50 mm"));
}

TEST_F(ConfigurationsCommand, WritesARecirculatingScrew) {
  const test::Outcome run =
      prs("configurations --screw-diameter '20 mm' --lead '2 mm' --type recirculating --write 1 case.yaml");
  ASSERT_EQ(run.status, 0) << run.err;
  for (const char* command : {"check", "contact", "solve", "slip", "measures", "life"})
    EXPECT_EQ(prs(fmt::format("{} case.yaml --quiet", command)).status, 0) << command;
}

TEST_F(ConfigurationsCommand, WritesACaseThatChecks) {
  const std::string asked = "configurations --screw-diameter '21 mm' --lead '5 mm' --starts 3 ";
  const test::Outcome run = prs(asked + "--type inverted --rollers 9 --write 1 case.yaml");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_THAT(run.err, HasSubstr("case.yaml: line 1 is written"));
  const test::Outcome check = prs("check case.yaml");
  EXPECT_EQ(check.status, 0) << check.err;
  const auto document = nlohmann::json::parse(prs("check case.yaml --json").out);
  EXPECT_EQ(document["contact"]["max_rollers"], 11);
  EXPECT_EQ(document["warnings"].dump(), "[]");
  const test::Outcome printed = prs(asked + "--type inverted --rollers 9 --write 1 -");
  EXPECT_EQ(printed.out, test::content_of(folder.path() / "case.yaml"));
  EXPECT_EQ(printed.err, "");
  const test::Outcome again = prs(asked + "--write 1 case.yaml");
  EXPECT_EQ(again.status, 2);
  EXPECT_THAT(again.err, HasSubstr("exists already"));
}

TEST_F(ConfigurationsCommand, RefusesWhatIsWrong) {
  const std::string sound = "--screw-diameter '21 mm' --lead '5 mm' ";
  for (const auto& [arguments, message] : std::initializer_list<std::pair<std::string, const char*>>{
           {"--screw-diameter 21 --lead '5 mm'", "--screw-diameter: got 21; expected a length"},
           {"--screw-diameter '21 mm' --lead '5 N'", "`N` is the unit of a force"},
           {"--screw-diameter '21 mm' --lead '0 mm'", "--lead: got 0 mm"},
           {"--screw-diameter '21 m' --lead '5 mm'", "check the unit"},
           {"--screw-diameter '21 mm'", "--lead is missing"},
           {"--lead '5 mm'", "--screw-diameter: missing; expected this or `--nut-diameter`"},
           {sound + "--nut-diameter '50 mm'", "--screw-diameter: got it and the nut's"},
           {"--nut-diameter '4 mm' --lead '1 mm'", "the nut is thinner than its wall"},
           {sound + "--type recirculating --roller-starts 1", "its rollers have grooves, no starts"},
           {sound + "--flank-angle '80 deg'", "20 deg to 70 deg"},
           {sound + "--gap '-1 mm'", "--gap: got -1 mm"},
           {sound + "--starts 0", "--starts"},
           {sound + "--starts 3 --rollers 40", "40 rollers do not fit, at most 11"},
           {sound + "--starts 2 --type standard", "more than two screw"},
           {sound + "--write 400 x.yaml", "expected the number of a line, 1 to"}}) {
    const test::Outcome run = prs("configurations --json " + arguments);
    EXPECT_EQ(run.status, 2) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_THAT(run.err, HasSubstr(message)) << arguments;
  }
}

}  // namespace
}  // namespace prs
