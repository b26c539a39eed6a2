#include "prs/input/echo.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "prs/input/document.h"
#include "prs/input/reader.h"

namespace prs::input {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::vector<std::string> warnings_of(const std::string& file, std::vector<std::string> overrides) {
  return sentences(
      read_case_input(load_source(PRS_SOURCE_DIR "/" + file, std::move(overrides)), Command::check).warnings);
}

/// The only warning under one override: the key, the value as written, the unit that fits.
struct OddValue {
  std::string path, written, fitting;
};

TEST(UsualValues, ANutThatHangsOnNothingIsNamed) {
  for (const char* way : {"axial", "lateral"}) {
    const std::string path = std::string("structure.nut.housing.") + way;
    EXPECT_THAT(warnings_of("configs/24_misalignment.yaml", {path + "=1e-3 N/mm"}),
                ElementsAre(AllOf(StartsWith(path + ": got 1e-3 N/mm; usual is "), HasSubstr("check"))));
    EXPECT_THAT(warnings_of("configs/24_misalignment.yaml", {path + "=200 kN/mm"}), IsEmpty());
  }
}

TEST(UsualValues, MassesAndLoadsOfLostMotionHaveThem) {
  for (const auto& [file, path, written] : {std::tuple("12_preload", "preload.lost_motion_load", "1e9 N"),
                                            std::tuple("36_servo_axis", "response.load.mass", "1e9 kg")})
    EXPECT_THAT(warnings_of(std::string("configs/") + file + ".yaml", {std::string(path) + "=" + written}),
                testing::Contains(StartsWith(std::string(path) + ": got " + written + "; usual is up to ")));
}

TEST(UsualValues, OddOnesAreNamedAsWrittenWithTheUnitThatFits) {
  const OddValue odd[] = {
      {"materials.youngs_modulus", "210 MPa", "`210 GPa`?"},
      {"materials.density", "7850 g/cm^3", "`7850 kg/m^3`?"},
      {"materials.density", "7.85 kg/m^3", "`7.85 g/cm^3`?"},
      {"materials.poisson_ratio", "0.03", "check value and unit"},
      {"load_cases[0].axial_force", "1e9 kN", "check value and unit"},
      {"load_cases[0].axial_force", "20 kN", ""},
      {"load_cases[0].axial_force", "19 MN", "`19 kN`?"},
      {"structure.nut.outer_diameter", "54 in", "`54 mm`?"},
      {"load_cases[1].speed", "-1e6 rpm", "check value and unit"},
      {"operation.speed", "1e6 rpm", "check value and unit"},
      {"lubricant.viscosity_at[0].kinematic_viscosity", "185 m^2/s", "`185 mm^2/s`?"},
      {"lubricant.pressure_viscosity", "20 1/MPa", "`20 1/GPa`?"},
      {"lubricant.eyring_stress", "12 Pa", "`12 MPa`?"},
      {"roughness", "100 um", "`100 nm`?"},
      // Nuts of bronze and of polyether ether ketone.
      {"materials.youngs_modulus", "105 GPa", ""},
      {"materials.youngs_modulus", "3.7 GPa", ""},
      {"materials.poisson_ratio", "0.4", ""},
      {"materials.density", "1.3 g/cm^3", ""},
      {"roughness", "0.4 um", ""},
  };
  for (const auto& [path, written, fitting] : odd) {
    const std::vector<std::string> warnings =
        warnings_of("configs/09_slip_and_dissipation.yaml", {path + "=" + written});
    if (fitting.empty())
      EXPECT_THAT(warnings, IsEmpty()) << path;
    else
      EXPECT_THAT(warnings,
                  ElementsAre(AllOf(StartsWith(path + ": got " + written + "; usual is "), HasSubstr(fitting))))
          << path;
  }
}

TEST(UsualValues, EachPartAndEachEndOfARangeCounts) {
  EXPECT_THAT(warnings_of("configs/15_sensitivity.yaml", {"materials.nut.youngs_modulus=210 MPa"}),
              ElementsAre(StartsWith("materials.nut.youngs_modulus: got 210 MPa")));
  EXPECT_THAT(
      warnings_of("configs/03_load_sweep.yaml", {"load_cases[0].axial_force={from: 1 kN, to: 1e6 kN, steps: 3}"}),
      ElementsAre(StartsWith("load_cases[0].axial_force: got {from: 1 kN, to: 1e6 kN, steps: 3};")));
}

TEST(UsualValues, ATemperatureInKelvinIsTakenForOneInCelsius) {
  EXPECT_THAT(warnings_of("configs/11_real_parts.yaml", {"deviations.temperature.screw=40 K"}),
              ElementsAre(AllOf(StartsWith("deviations.temperature.screw: got 40 K"), HasSubstr("`40 degC`?"))));
}

TEST(UsualValues, LessonsAndPublishedScrewsHaveThem) {
  for (const char* folder : {"/configs", "/validation"})
    for (const auto& file : std::filesystem::recursive_directory_iterator(std::string(PRS_SOURCE_DIR) + folder)) {
      if (file.path().extension() != ".yaml" || file.path().filename() == "reference.yaml") continue;
      const Source source = load_source(file.path().string(), {});
      ErrorList errors(source);
      if (!find(read_document(source, errors), "mechanism")) continue;  // Requirements are skipped.
      const CaseInput in = read_case_input(source, Command::check);
      EXPECT_THAT(sentences(in.warnings), IsEmpty()) << file.path();
    }
}

}  // namespace
}  // namespace prs::input
