#include "prs/optimize/optimize_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace prs {
namespace {

std::string changed(const std::string& text, const std::vector<std::string>& overrides) {
  const std::string whole = case_with({"case.yaml", text, {}}, overrides, "remark");
  EXPECT_EQ(whole.substr(0, 9), "# remark\n");
  return whole.substr(9);
}

TEST(CaseWith, PutsValuesInPlaceAndKeepsComments) {
  EXPECT_EQ(changed("a: 1 mm  # one\nb: {c: 2, d: [3, 4 mm]}\n# end\n", {"a=12 mm", "b.d[1]=5 mm"}),
            "a: 12 mm  # one\nb: {c: 2, d: [3, 5 mm]}\n# end\n");
}

TEST(CaseWith, LaterOverridesWin) {
  const input::Source source{"case.yaml", "a: 1\nb: 2\n", {"a=3", "b=4"}};
  EXPECT_EQ(case_with(source, {"a=5"}, "r"), "# r\na: 5\nb: 4\n");
}

TEST(CaseWith, AddsWhatTheFileLacks) {
  EXPECT_EQ(changed("a: 1\nb:\n  c: 2  # two\n", {"b.d=3", "e.f.g=4 mm"}),
            "a: 1\nb:\n  d: 3\n  c: 2  # two\ne: {f: {g: 4 mm}}\n");
  EXPECT_EQ(changed("b: {c: 2}", {"b.d.e=3", "f=1"}), "b: {d: {e: 3}, c: 2}\nf: 1\n");
  // Two values in a missing block: comments stay.
  EXPECT_EQ(changed("a: 1  # one\n", {"b.c=2", "b.d=3"}), "a: 1  # one\nb: {d: 3, c: 2}\n");
}

TEST(CaseWith, WritesAnewWhatHasNoPlaceOfItsOwn) {
  // The alias then means another value than its anchor.
  EXPECT_EQ(changed("a: &x 1 mm\nb:\n  c: *x\n  d: [{e: 2}, {e: 3}]\n", {"a=5 mm"}),
            "a: 5 mm\nb:\n  c: 1 mm\n  d:\n    - {e: 2}\n    - {e: 3}\n");
}

}  // namespace
}  // namespace prs
