#include "prs/input/echo.h"

#include <gmock/gmock.h>

#include "prs/input/reader.h"
#include "tests/support/program.h"

namespace prs::input {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

Source lesson_with(const std::string& name, std::vector<std::string> overrides) {
  return load_source(PRS_SOURCE_DIR "/configs/" + name, std::move(overrides));
}

TEST(WrittenCase, IsTheCaseOfItsOverrides) {
  const Source source = lesson_with(
      "24_misalignment.yaml", {"mechanism.rollers=9", "structure.nut.length=95 mm", "load_cases[0].axial_force=20 kN",
                               "load_cases[0].misalignment.nut_tilt.z=0.05 deg", "load_cases[1].side_force={y: 100 N}",
                               "deviations.crowning=2 um", "mechanism.profile.roller={convex: 5 mm}"});
  const auto text = written_case(source);
  ASSERT_TRUE(text);
  EXPECT_EQ(resolved_input(source_of_text(source.name, *text, {}, source.folder)), resolved_input(source));
  EXPECT_THAT(*text, StartsWith(source.text.substr(0, source.text.find('\n'))));
}

TEST(WrittenCase, LeavesTheRestAsItStands) {
  const Source source = source_of_text("case.yaml", "# mine\na: {b: 1 mm}  # why\nc:\n  - d: \"x\"\n    e: 2\n",
                                       {"a.b=2 mm", "c[0].d='y'", "c[0].f=3", "g.h=4"});
  EXPECT_EQ(written_case(source), "# mine\ng: {h: 4}\na: {b: 2 mm}  # why\nc:\n  - f: 3\n    d: 'y'\n    e: 2\n");
}

TEST(WrittenCase, GivesUpWhereOtherValuesWouldFollow) {
  EXPECT_EQ(written_case(source_of_text("case.yaml", "a: &x 1\nb: *x\n", {"b=2"})), std::nullopt);
}

TEST(WrittenCase, GivesUpWhereAValueDoesNotStandBetweenBraces) {
  for (const char* next : {"c=3", "a.b=2"})
    EXPECT_EQ(written_case(source_of_text("case.yaml", "a: {b: 1}\nc: 2\n", {"a.b=x] y", next})), std::nullopt);
}

TEST(WrittenCase, WithoutOverridesIsTheFile) {
  const Source source = lesson_with("01_config_1_to_3.yaml", {});
  EXPECT_EQ(written_case(source), source.text);
}

TEST(ResolvedInput, LacksLengthsWithoutADefaultAndCanBeReadAgain) {
  const Source source =
      lesson_with("31_running_screw.yaml", {"carrier.bearing={diameter: 5 mm, friction: {coulomb: 0.1}}"});
  const auto once = resolved_input(source);
  EXPECT_FALSE(once.at("carrier").at("bearing").contains("length"));
  EXPECT_FALSE(once.at("carrier").at("bearing").contains("radial_clearance"));
  const Source again = source_of_text("case.yaml", once.dump(), {}, source.folder);
  EXPECT_NO_THROW(read_case_input(again, Command::check));
  EXPECT_EQ(resolved_input(again), once);
}

}  // namespace
}  // namespace prs::input
