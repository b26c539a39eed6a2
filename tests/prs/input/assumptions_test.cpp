#include "prs/input/echo.h"

#include <gmock/gmock.h>

#include "prs/configurations/screw_case.h"
#include "prs/input/reader.h"

namespace prs::input {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Key;
using testing::Not;
using testing::Pair;

using Reasons = std::map<std::string, std::string>;

Reasons assumed_in(const std::string& text, std::vector<std::string> overrides = {}) {
  const Source source = source_of_text("case.yaml", text, std::move(overrides));
  return assumptions(read_case_input(source, Command::check).fields, source);
}

/// A case for which only screw diameter and lead are given.
std::string new_case() {
  return screw_case(complete_screw({.screw_diameter = 25e-3, .lead = 5e-3}), {}, "Given: two.");
}

std::string with(std::string text, const std::string& old, const std::string& now) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, text.npos) << old;
  return at == text.npos ? text : text.replace(at, old.size(), now);
}

/// Paths in `a` that `b` lacks.
std::vector<std::string> only_in(const Reasons& a, const Reasons& b) {
  std::vector<std::string> paths;
  for (const auto& [path, reason] : a)
    if (!b.contains(path)) paths.push_back(path);
  return paths;
}

TEST(Assumptions, OfANewCaseAreAllButWhatIsGiven) {
  const std::string text = new_case();
  const Reasons assumed = assumed_in(text);
  const Source source = source_of_text("case.yaml", text, {});
  std::vector<std::string> given;
  for (const EchoEntry& entry : read_case_input(source, Command::check).fields)
    if (!entry.is_default && !assumed.contains(entry.path)) given.push_back(entry.path);
  EXPECT_THAT(given, ElementsAre("mechanism.type", "mechanism.lead", "mechanism.pitch_diameter.screw"));
  EXPECT_THAT(assumed, Contains(Pair("mechanism.flank_angle", testing::StartsWith("as on nearly"))));
  for (const auto& [path, reason] : assumed) EXPECT_FALSE(reason.empty()) << path;
}

TEST(Assumptions, EndWhereTheValueWasChanged) {
  const std::string text = new_case();
  const Reasons before = assumed_in(text);
  const auto changed = [&](const std::string& old, const std::string& now) {
    return only_in(before, assumed_in(with(text, old, now)));
  };
  EXPECT_THAT(changed("\n  flank_angle: 45 deg", "\n  flank_angle: 40 deg"), ElementsAre("mechanism.flank_angle"));
  EXPECT_THAT(changed("\n  backlash: {screw: 0 mm,", "\n  backlash: {screw: 0.02 mm,"),
              ElementsAre("mechanism.backlash.screw"));
  EXPECT_THAT(changed("\n  rollers: 11", "\n  rollers: 9"), ElementsAre("mechanism.rollers"));
  EXPECT_THAT(changed("    nut: {addendum: 0.15 mm", "    nut: {addendum: 0.2 mm"),
              ElementsAre("mechanism.thread.nut.addendum"));
  EXPECT_THAT(changed("  - {name: tension, axial_force: ", "  - {name: tension, axial_force: 1"),
              ElementsAre("load_cases[0].axial_force"));
}

TEST(Assumptions, StayWithTheirValuesWhereOthersAreEdited) {
  const std::string text = new_case();
  const Reasons before = assumed_in(text);
  EXPECT_EQ(assumed_in(with(text, "\nmechanism:", "\n\n# of mine\nmechanism:  # mine")), before);
  // The reasons, one per line.
  EXPECT_EQ(
      assumed_in(with(text, "\n  starts: {screw: 5, roller: 1}", "\n  starts:\n    roller: 1  # one\n    screw: 5")),
      before);
  EXPECT_EQ(assumed_in(with(text, "\n  starts: {", "\n\n  # mine\n  starts: {")), before);
}

TEST(Assumptions, AreNotWhatAnOverrideGives) {
  const std::string text = new_case();
  EXPECT_THAT(only_in(assumed_in(text), assumed_in(text, {"mechanism.flank_angle=45 deg", "mechanism.starts.screw=5"})),
              ElementsAre("mechanism.flank_angle", "mechanism.starts.screw"));
}

TEST(Assumptions, AreWhatACommentSaysAndNoOtherText) {
  const std::string text = new_case();
  const auto lead = [&](const std::string& behind) {
    const std::size_t at = text.find("  lead: 5 mm");
    std::string changed = text;
    changed.replace(at, text.find('\n', at) - at, "  lead: 5 mm" + behind);
    const Reasons all = assumed_in(changed);
    const auto found = all.find("mechanism.lead");
    return found == all.end() ? std::string() : found->second;
  };
  EXPECT_EQ(lead("  # assumed: a guess"), "a guess");
  EXPECT_EQ(lead("  # assumed 5 mm: a guess: mine"), "a guess: mine");
  EXPECT_EQ(lead("  # assumed 4 mm: a guess"), "");
  EXPECT_EQ(lead("  # assumed {screw: 5 mm: broken"), "");
  EXPECT_EQ(lead("  # assumed [5 mm]: a list"), "");
  EXPECT_EQ(lead("  # presumed: a guess"), "");
  EXPECT_EQ(lead("\n  # assumed: of another key"), "");
  const std::string name = "\"x # assumed: no comment\"";
  EXPECT_THAT(assumed_in(with(text, "  - {name: tension", "  - {name: " + name)),
              Not(Contains(Key("load_cases[0].name"))));
}

}  // namespace
}  // namespace prs::input
