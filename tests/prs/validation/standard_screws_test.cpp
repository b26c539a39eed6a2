#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "prs/configurations/standard_screw.h"
#include "prs/model/check_case.h"
#include "prs/threads/contacts.h"
#include "validation/standard_screws/comparison.h"
#include "validation/standard_screws/extension.h"

namespace prs {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::string kFolder = PRS_SOURCE_DIR "/validation/standard_screws";

std::vector<standard_screws::CatalogueScrew> catalogue() {
  return standard_screws::read_catalogue(kFolder + "/screws.csv");
}

TEST(StandardScrew, EveryScrewOfTheCatalogueMakesASoundMechanism) {
  ASSERT_THAT(catalogue(), SizeIs(24));
  for (const standard_screws::CatalogueScrew& s : catalogue()) {
    const Case c = standard_screw_case(s.screw);
    EXPECT_THAT(check_case(c), IsEmpty()) << s.name;
    const Contacts contacts = find_contacts(c.mechanism, c.materials);
    for (const Interface i : kInterfaces) EXPECT_TRUE(contacts.interfaces[i].has_hertz()) << s.name;
    EXPECT_GE(c.mechanism.rollers, 3) << s.name;
  }
}

TEST(StandardScrew, DimensionsFollowTheRules) {
  const Case c = standard_screw_case({.screw_diameter = 30e-3,
                                      .lead = 10e-3,
                                      .starts = 5,
                                      .nut_diameter = 64e-3,
                                      .nut_length = 85e-3});
  const Contacts contacts = find_contacts(c.mechanism, c.materials);
  EXPECT_NEAR(*contacts.mechanism.centre_distance, 20e-3, 1e-8);
  EXPECT_NEAR(*contacts.mechanism.pitch_diameter.roller, 10e-3, 1e-15);
  EXPECT_NEAR(*contacts.mechanism.pitch_diameter.nut, 50e-3, 1e-15);
  EXPECT_EQ(c.mechanism.contacts_per_roller, 29);  // 0.68 x 85 mm over 2 mm
  EXPECT_EQ(c.mechanism.rollers, 10);
  EXPECT_NEAR(contacts.threads.roller.profile_curvature, std::sqrt(0.5) / 5e-3, 1e-9);
}

std::vector<std::string> only_with(const std::vector<ComparedStatement>& statements,
                                   Verdict::Kind kind) {
  std::vector<std::string> texts;
  for (const ComparedStatement& s : statements)
    if (s.verdict.kind == kind) texts.push_back(s.section);
  return texts;
}

TEST(StandardScrews, TheRangeOfTheCapacityIsThatOfTheCatalogue) {
  const auto rows = standard_screws::compare(catalogue(), 0.0);
  const Interval i = standard_screws::range(
      rows, &standard_screws::Ratios::dynamic_capacity,
      [](const standard_screws::Ratios& r) { return r.printed.screw.screw_diameter > 7e-3; });
  EXPECT_NEAR(i.least, kCapacityOverMakers.least, 0.006);
  EXPECT_NEAR(i.greatest, kCapacityOverMakers.greatest, 0.006);
}

TEST(StandardScrews, SayWhatReproducesAndWhatDoesNot) {
  const SourceReport report = validate(kFolder, {standard_screws::extension()}).front();
  EXPECT_THAT(only_with(report.statements, Verdict::Kind::holds), ElementsAre("weight", "inertia"));
  EXPECT_THAT(only_with(report.statements, Verdict::Kind::holds_only_with),
              ElementsAre("dynamic capacity", "static capacity", "static capacity"));
  for (const ComparedStatement& s : report.statements)
    EXPECT_EQ(s.verdict.why.empty(), s.verdict.kind == Verdict::Kind::holds) << s.text;
  EXPECT_THAT(report.tables, SizeIs(3));
  EXPECT_THAT(report.tables[0].rows, SizeIs(24));
}

}  // namespace
}  // namespace prs
