#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "validation/extensions.h"
#include "validation/standard_screws/comparison.h"

namespace prs {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::string kFolder = PRS_SOURCE_DIR "/validation/standard_screws";

std::vector<standard_screws::CatalogueScrew> catalogue() {
  return standard_screws::read_catalogue(kFolder + "/screws.csv");
}

std::vector<std::string> only_with(const std::vector<ComparedStatement>& statements, Verdict::Kind kind) {
  std::vector<std::string> texts;
  for (const ComparedStatement& s : statements)
    if (s.verdict.kind == kind) texts.push_back(s.section);
  return texts;
}

TEST(StandardScrews, TheRangeOfTheCapacityIsThatOfTheCatalogue) {
  const auto rows = standard_screws::compare(catalogue(), standard_screws::Flanks::by_rule);
  const Interval i =
      standard_screws::range(rows, &standard_screws::Ratios::dynamic_capacity,
                             [](const standard_screws::Ratios& r) { return r.printed.screw.screw_diameter > 7e-3; });
  EXPECT_NEAR(i.least, kCapacityOverMakers.least, 0.006);
  EXPECT_NEAR(i.greatest, kCapacityOverMakers.greatest, 0.006);
}

TEST(StandardScrews, SayWhatReproducesAndWhatDoesNot) {
  const SourceReport report = validate(kFolder, {standard_screws::extension()}).front();
  EXPECT_THAT(only_with(report.statements, Verdict::Kind::holds),
              ElementsAre("static capacity", "weight", "inertia", "inertia"));
  EXPECT_THAT(only_with(report.statements, Verdict::Kind::holds_only_with),
              ElementsAre("dynamic capacity", "static capacity"));
  for (const ComparedStatement& s : report.statements)
    EXPECT_EQ(s.verdict.why.empty(), s.verdict.kind == Verdict::Kind::holds) << s.text;
  EXPECT_THAT(report.tables, SizeIs(3));
  EXPECT_THAT(report.tables[0].rows, SizeIs(24));
}

}  // namespace
}  // namespace prs
