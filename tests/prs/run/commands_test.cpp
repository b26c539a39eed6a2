#include "prs/run/analyses.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "prs/run/response_lists.h"

namespace prs {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

input::Source lesson(const std::string& name, std::vector<std::string> overrides = {}) {
  return input::load_source(PRS_SOURCE_DIR "/configs/" + name, std::move(overrides));
}

input::CaseInput read(const input::Source& source) { return input::read_case_input(source, Command::check); }

bool accepts(const input::Source& source, Command command) {
  try {
    input::read_case_input(source, command);
    return true;
  } catch (const input::InputError&) {
    return false;
  }
}

TEST(Commands, EachStandsOnceInTheTable) {
  std::set<std::string_view> names;
  for (const AnyAnalysis& row : analyses()) {
    names.insert(name(row.command));
    EXPECT_EQ(&analysis_of(row.command), &row);
  }
  EXPECT_EQ(names.size(), analyses().size());
}

TEST(Commands, LackNothingWhereTheyReadTheCase) {
  for (const auto& file : std::filesystem::directory_iterator(PRS_SOURCE_DIR "/configs")) {
    if (file.path().extension() != ".yaml") continue;
    const input::Source source = lesson(file.path().filename());
    if (other_file(source)) continue;
    const input::CaseInput in = read(source);
    for (const AnyAnalysis& row : analyses()) {
      if (!row.run) continue;
      EXPECT_EQ(input::missing(in, row.command).empty(), accepts(source, row.command))
          << file.path() << ' ' << name(row.command);
    }
  }
}

TEST(Commands, NameTheBlocksThatTheyLack) {
  const input::CaseInput in = read(lesson("01_config_1_to_3.yaml"));
  EXPECT_THAT(input::missing(in, Command::solve), IsEmpty());
  EXPECT_THAT(input::missing(in, Command::slip), ElementsAre("friction", "operation"));
  EXPECT_THAT(input::missing(in, Command::preload), ElementsAre("preload"));
  EXPECT_THAT(input::missing(in, Command::study), ElementsAre("study"));
  EXPECT_THAT(input::missing(in, Command::optimize), ElementsAre("optimize"));
}

/// The suggestion contains the file's own design, so that no best design is worse.
TEST(Commands, SuggestDesignsAroundThatOfTheFile) {
  const input::CaseInput in = read(lesson("01_config_1_to_3.yaml"));
  ASSERT_EQ(in.values.mechanism.rollers, 11);
  EXPECT_THAT(input::unmet(in, Command::optimize).at(0).message,
              HasSubstr("{path: mechanism.rollers, from: 10, to: 11}"));
  EXPECT_THAT(input::unmet(in, Command::study).at(0).message, HasSubstr("{path: mechanism.rollers, values: [10, 11]}"));
}

/// A study needs the inputs of the command of its designs.
TEST(Commands, AStudyLacksWhatItsDesignsLack) {
  const std::string study = "study={command: slip, factors: [{path: mechanism.rollers, values: [8, 9]}]}";
  EXPECT_THAT(input::missing(read(lesson("01_config_1_to_3.yaml", {study})), Command::study),
              ElementsAre("friction", "operation"));
  EXPECT_THAT(input::missing(read(lesson("09_slip_and_dissipation.yaml", {study})), Command::study), IsEmpty());
}

/// The names in the table of quantities equal those in results.
TEST(Responses, OfACaseAreThoseOfTheTable) {
  const std::vector<std::string> known = known_responses();
  const std::set<std::string> table(known.begin(), known.end());
  EXPECT_EQ(table.size(), known.size());
  for (const char* path : {"slip.efficiency", "screw.peak_pressure_MPa.max", "contact.nut.backlash_mm",
                           "measures.weight_kg", "life.system.l10_revolutions", "axial_stiffness_N_per_um"})
    EXPECT_EQ(table.count(path), 1U) << path;
  const std::vector<std::string> of_case = responses_of(lesson("09_slip_and_dissipation.yaml"));
  EXPECT_GT(of_case.size(), 50U);
  for (const std::string& path : of_case) EXPECT_EQ(table.count(path), 1U) << path;
}

TEST(Responses, OfAStudyAreThoseOfItsCommand) {
  const std::vector<std::string> paths = responses_of(
      lesson("09_slip_and_dissipation.yaml", {"study={command: contact, factors: [{path: mechanism.rollers, values: "
                                              "[8, 9]}]}"}));
  EXPECT_THAT(paths, testing::Contains("contact.screw.normal_angle_deg"));
  EXPECT_THAT(paths, testing::Not(testing::Contains("slip.efficiency")));
}

/// A delivery needs neither the case nor the result to stay alive.
TEST(Delivery, OutlivesWhatItWasMadeOf) {
  Delivery delivery;
  DocumentInfo info;
  {
    const input::Source source = lesson("05_standard_screw.yaml");
    delivery = run(analysis_of(Command::contact), source);
    info = document_info(source, Command::contact);
  }
  EXPECT_EQ(delivery.file, "contact.json");
  EXPECT_TRUE(delivery.document(info).contains("contact"));
  EXPECT_NE(delivery.table(), "");
  EXPECT_FALSE(figures(delivery.pictures()).empty());
}

}  // namespace
}  // namespace prs
