#include "validation/extensions.h"

#include <gtest/gtest.h>

#include "prs/input/reader.h"
#include "validation/abevi_2015/statements.h"

namespace prs {
namespace {

/// Verdicts of a second, independent computation of the paper.
TEST(Abevi2015, StatementsThatHoldWithThePapersOwnGuidance) {
  const std::string folder = PRS_SOURCE_DIR "/validation/abevi_2015/";
  const Case screw = input::read_case(folder + "screw.yaml", {}, Command::solve);
  const std::vector<ComparedStatement> compared =
      abevi_2015::compare_statements(screw, read_reference(folder + "reference.yaml"));
  const auto kind = [&](const std::string& words) {
    for (const ComparedStatement& s : compared)
      if (s.text.find(words) != std::string::npos) return s.verdict.kind;
    ADD_FAILURE() << "no statement says: " << words;
    return Verdict::Kind::does_not_hold;
  };
  using enum Verdict::Kind;
  EXPECT_EQ(kind("increases under tensile loading"), holds);
  EXPECT_EQ(kind("decreases under compressive loading"), holds);
  EXPECT_EQ(kind("most critical situation"), holds);
  EXPECT_EQ(kind("load decreases from the first thread"), holds);
  EXPECT_EQ(kind("first active thread of the screw shaft is the most loaded"), holds);
  EXPECT_EQ(kind("first active thread remains the most loaded"), holds);
  EXPECT_EQ(kind("reduced by about 40 %"), does_not_hold);
  EXPECT_EQ(kind("almost 1.5 times higher"), holds_only_with);
  EXPECT_EQ(kind("quite uniform"), holds_only_with);
}

TEST(Statements, AreComparedWithThePlainModelFirst) {
  const Checks<int> even{{"even", [](int n) { return Finding{n % 2 == 0, std::to_string(n)}; }}};
  const auto compared = [&](int plain, int a, int b) {
    return compare({{"1", "is even", "even"}, {"1", "is another's", "other"}}, even,
                   {{"plain", plain}, {"a", a}, {"b", b}})
        .at(0)
        .verdict;
  };
  EXPECT_EQ(compared(2, 1, 1).kind, Verdict::Kind::holds);
  EXPECT_EQ(compared(1, 1, 1).kind, Verdict::Kind::does_not_hold);
  EXPECT_EQ(compared(1, 1, 4).kind, Verdict::Kind::holds_only_with);
  EXPECT_EQ(compared(1, 1, 4).only_with, std::vector<std::string>{"b"});
}

}  // namespace
}  // namespace prs
