#include "prs/configurations/configurations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <regex>

#include "prs/model/check_case.h"
#include "prs/model/problems.h"
#include "validation/standard_screws/comparison.h"

namespace prs {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<standard_screws::CatalogueScrew> printed_screws() {
  return standard_screws::read_catalogue(PRS_SOURCE_DIR "/validation/standard_screws/screws.csv");
}

ScrewData screw_of_30() {
  return {.screw_diameter = 30e-3, .lead = 10e-3, .starts = 5, .nut_diameter = 64e-3, .nut_length = 85e-3};
}

TEST(CompleteScrew, EveryScrewOfTheCatalogueIsSound) {
  ASSERT_THAT(printed_screws(), SizeIs(24));
  for (const standard_screws::CatalogueScrew& s : printed_screws()) {
    const Case c = complete_screw(s.screw).c;
    EXPECT_THAT(check_case(c), IsEmpty()) << s.name;
    const Contacts contacts = find_contacts(c.mechanism, c.materials);
    for (const Interface i : kInterfaces) EXPECT_TRUE(contacts.interfaces[i].has_hertz()) << s.name;
    EXPECT_GE(c.mechanism.rollers, 3) << s.name;
  }
}

TEST(CompleteScrew, DimensionsFollowTheRules) {
  const CompleteScrew s = complete_screw(screw_of_30());
  EXPECT_NEAR(s.centre_distance, 20e-3, 1e-8);
  EXPECT_NEAR(s.pitch_diameter.roller, 10e-3, 1e-15);
  EXPECT_NEAR(s.pitch_diameter.nut, 50e-3, 1e-15);
  EXPECT_EQ(s.c.mechanism.contacts_per_roller, 29);  // 0.68 x 85 mm over 2 mm
  EXPECT_EQ(s.c.mechanism.rollers, 10);
  EXPECT_EQ(s.most_rollers, 11);
  EXPECT_NEAR(s.c.mechanism.profile.roller.radius, 10e-3, 1e-15);
  EXPECT_NEAR(s.position, 0.5 * (85e-3 - 28 * 2e-3), 1e-12);
  ASSERT_FALSE(s.gears.empty());
  EXPECT_EQ(s.gears.front().roller_teeth, 20);  // docs/configurations.md, Jung's example
  EXPECT_EQ(s.gears.front().body_teeth, 100);
}

/// Outer diameters of the catalogue (screws.csv), if printed: to the last digit up to 36 mm; crests of larger screws
/// are up to 0.05 p higher.
TEST(CompleteScrew, TheOuterDiameterIsThatOfTheCatalogue) {
  struct Printed {
    double diameter, lead;
    int starts;
    double outer;
  };
  for (const auto& [d, lead, starts, outer] :
       {Printed{12, 5, 5, 12.3}, Printed{18, 5, 5, 18.3}, Printed{21, 10, 5, 21.6}, Printed{24, 12, 6, 24.6},
        Printed{30, 10, 5, 30.6}, Printed{36, 9, 6, 36.5}}) {
    const CompleteScrew s = complete_screw({.screw_diameter = 1e-3 * d, .lead = 1e-3 * lead, .starts = starts});
    const double computed = 1e3 * (s.pitch_diameter.screw + 2.0 * s.c.mechanism.thread.screw->addendum);
    EXPECT_NEAR(computed, outer, 0.05 + 1e-9) << d << 'x' << lead;
  }
}

TEST(CompleteScrew, TheRulesGiveTheStartsAndNutsOfTheCatalogue) {
  for (const standard_screws::CatalogueScrew& s : printed_screws()) {
    const CompleteScrew by_rule = complete_screw({.screw_diameter = s.screw.screw_diameter, .lead = s.screw.lead});
    if (s.screw.starts != 6) {
      EXPECT_EQ(by_rule.c.mechanism.starts.screw, s.screw.starts) << s.name;
    }
    const Structure::Nut nut =
        complete_screw({.screw_diameter = s.screw.screw_diameter, .lead = s.screw.lead, .starts = s.screw.starts})
            .c.structure->nut;
    EXPECT_NEAR(nut.outer_diameter / *s.screw.nut_diameter, 1.0, 0.06) << s.name;
    EXPECT_NEAR(nut.length / *s.screw.nut_length, 1.0, 0.17) << s.name;
  }
}

TEST(CompleteScrew, TheLoadGivesAModeratePressureWithEqualShares) {
  const CompleteScrew s = complete_screw(screw_of_30());
  const Mechanism& m = s.c.mechanism;
  const Contacts contacts = find_contacts(m, s.c.materials);
  double highest = 0.0;
  for (const Interface i : kInterfaces) {
    const InterfaceContact& contact = contacts.interfaces[i];
    const double normal_load = s.load / (m.rollers * m.contacts_per_roller) / std::cos(contact.normal_angle());
    highest = std::max(highest, contact::at_load(contact.hertz, normal_load).peak_pressure);
  }
  EXPECT_NEAR(highest / 1.8e9, 1.0, 0.02);  // The load has two digits.
}

TEST(CompleteScrew, AnInvertedScrewLooksLikeThePublishedOne) {
  // Abevi 2015: 20 threads, nut of 35 mm in pitch diameter; lesson 1 takes 46 mm outside.
  const CompleteScrew s =
      complete_screw({.type = Mechanism::Type::inverted, .screw_diameter = 21e-3, .lead = 5e-3, .starts = 3});
  EXPECT_EQ(s.c.mechanism.contacts_per_roller, 20);
  EXPECT_NEAR(s.pitch_diameter.roller, 7e-3, 1e-15);
  EXPECT_NEAR(s.pitch_diameter.nut, 35e-3, 0.1e-3);
  EXPECT_NEAR(s.c.structure->nut.outer_diameter, 46e-3, 1e-12);
  EXPECT_GT(s.c.structure->nut.length, 2.0 * 20 * 5e-3 / 3);  // Space to travel.
}

TEST(CompleteScrew, ALeftHandedScrewHasTheSameNumbers) {
  ScrewData left = screw_of_30();
  left.lead = -left.lead;
  const CompleteScrew a = complete_screw(screw_of_30()), b = complete_screw(left);
  EXPECT_EQ(a.load, b.load);
  EXPECT_EQ(a.c.mechanism.rollers, b.c.mechanism.rollers);
  EXPECT_NEAR(a.pitch_diameter.screw, b.pitch_diameter.screw, 1e-12);
}

struct Impossible {
  const char* member;
  ScrewData data;
};

std::vector<Impossible> impossible_screws() {
  std::vector<Impossible> all;
  const auto add = [&](const char* member, auto change) {
    ScrewData d = screw_of_30();
    change(d);
    all.push_back({member, d});
  };
  add("lead", [](ScrewData& d) { d.lead = 0.0; });
  add("lead", [](ScrewData& d) { d.lead = 1e-6; });
  add("lead", [](ScrewData& d) { d.lead = 0.5; });
  add("lead", [](ScrewData& d) { d.lead = -10.0; });
  add("starts", [](ScrewData& d) { d.starts = 1; });
  add("starts", [](ScrewData& d) { d.starts = 0; });
  add("starts", [](ScrewData& d) {
    d.type = Mechanism::Type::inverted;
    d.starts = 0;
  });
  add("rollers", [](ScrewData& d) { d.rollers = 2; });
  add("rollers", [](ScrewData& d) { d.rollers = 20; });
  add("nut_diameter", [](ScrewData& d) { d.nut_diameter = 45e-3; });
  add("nut_diameter", [](ScrewData& d) { d.nut_diameter = 20.0; });
  add("nut_length", [](ScrewData& d) { d.nut_length = 5e-3; });
  add("nut_length", [](ScrewData& d) { d.nut_length = 1e3; });
  add("roller_profile_radius", [](ScrewData& d) { d.roller_profile_radius = 1e3; });
  add("roller_profile_radius", [](ScrewData& d) { d.roller_profile_radius = 0.5e-3; });
  add("roller_profile_radius", [](ScrewData& d) { d.roller_profile_radius = 0.05e-3; });
  add("load", [](ScrewData& d) { d.load = 1e12; });
  add("load", [](ScrewData& d) { d.load = 2.5 * 281e3; });  // C_0 of 30 x 10 by its maker.
  return all;
}

/// Lengths in mm, forces in kN, other numbers unchanged.
void set(ScrewData& d, const std::string& member, double value) {
  if (member == "lead") d.lead = 1e-3 * value;
  if (member == "starts") d.starts = static_cast<int>(value);
  if (member == "rollers") d.rollers = static_cast<int>(value);
  if (member == "nut_diameter") d.nut_diameter = 1e-3 * value;
  if (member == "nut_length") d.nut_length = 1e-3 * value;
  if (member == "roller_profile_radius") d.roller_profile_radius = 1e-3 * value;
  if (member == "load") d.load = 1e3 * value;
}

TEST(CompleteScrew, WhatCannotBeIsRefusedWithTheNearestThatCan) {
  for (const Impossible& wrong : impossible_screws()) try {
      complete_screw(wrong.data);
      ADD_FAILURE() << wrong.member;
    } catch (const CaseError& error) {
      EXPECT_EQ(error.path(), wrong.member) << error.what();
      const std::string text = error.what();
      std::smatch limits;
      ASSERT_TRUE(std::regex_search(
          text, limits, std::regex("expected (?:at (?:least|most) )?([0-9.e+]+)(?: mm| kN)?(?: to ([0-9.e+]+))?")))
          << text;
      for (std::size_t k = 1; k < limits.size() && limits[k].matched; ++k) {
        ScrewData possible = wrong.data;
        set(possible, wrong.member, std::stod(limits[k]));
        const std::string member = wrong.member;  // Threads of other sizes need other nuts.
        if (member == "lead") possible.nut_length = std::nullopt;
        if (member == "starts") possible.nut_diameter = std::nullopt;
        EXPECT_NO_THROW(complete_screw(possible)) << text << " " << limits[k];
      }
    }
}

}  // namespace
}  // namespace prs
