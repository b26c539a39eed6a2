#include "prs/study/derivatives.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "prs/input/reader.h"
#include "prs/loads/analyze.h"
#include "prs/loads/full_result.h"
#include "prs/model/problems.h"
#include "tests/prs/input/abevi.h"
#include "tests/support/sanitized.h"

namespace prs {
namespace {

using ::testing::HasSubstr;

const std::string kOverrides =
    "contact: {hertz_constant: {screw: 3.6062e5 N/mm^1.5, nut: 4.2140e5 N/mm^1.5}, normal_angle: "
    "{screw: 45.0288 deg, nut: 45.0803 deg}}\n";

CaseDerivatives derivatives_of(const std::string& factors, const std::string& text,
                               const std::string& responses =
                                   "axial_displacement_um, "
                                   "tangent_stiffness_N_per_um, "
                                   "screw.load_rate_percent.max, "
                                   "'nut.axial_load_N[7]', "
                                   "screw.peak_pressure_MPa.max",
                               const std::string& command = "solve") {
  return case_derivatives(
      input::read_study_input({"case.yaml",
                               text + "study: {command: " + command + ", plan: derivatives, factors: [" + factors +
                                   "], responses: [" + responses + "]}\n",
                               {}}));
}

/// Elasticity of a response; the derivative must exist.
double elasticity(const CaseDerivatives& d, std::size_t factor, std::size_t response) {
  return d.factors.at(factor).responses.at(response).value().elasticity.value();
}

// Loads, moduli and Hertz constants scaled together leave every displacement unchanged; all lengths scaled, with k_0 as
// the square root of a length and loads as its square, scale the displacement.
TEST(Derivatives, ObeyEuler) {
  for (const char* bodies : {"bars", "refined"}) {
    const CaseDerivatives d = derivatives_of(
        "{path: 'load_cases[0].axial_force'}, {path: materials.youngs_modulus}, {path: "
        "contact.hertz_constant.screw}, {path: contact.hertz_constant.nut}",
        input::kAbevi + kOverrides + "model: {bodies: " + bodies + "}\n");
    const double expected[] = {0.0, 1.0, 0.0, 1.0};
    for (std::size_t r = 0; r < 4; ++r) {
      double sum = 0.0;
      for (std::size_t f = 0; f < 4; ++f) sum += elasticity(d, f, r);
      EXPECT_NEAR(sum, expected[r], 1e-9) << bodies << " " << r;
    }
  }
}

TEST(Derivatives, OfTheLoadIsTheTangentStiffness) {
  const CaseDerivatives d = derivatives_of("{path: 'load_cases[0].axial_force'}", input::kAbevi);
  const Derivative& u = *d.factors[0].responses[0];  // um/kN
  EXPECT_NEAR(u.value * *d.values[1] / 1e3, 1.0, 1e-9);
  EXPECT_LT(u.error, 1e-8 * u.value);
}

/// Derivatives by a moment follow from the stiffness of the screw's end, also if the file has the moment as 0.
TEST(Derivatives, OfAllRollersAreTheComplianceOfTheScrewsEnd) {
  SKIP_UNDER_SANITIZERS();
  const std::string text = input::abevi_with("{name: pull,", "{name: pull, moment: {y: 0 N m, z: 0 N m},") +
                           "model: {mechanism: full}\n"
                           "deviations: {roller_diameter: [0 um, 4 um, 0 um, 0 um, 1 um, 0 um, 0 um, 0 um, 0 um, 0 um, "
                           "0 um]}\n";
  const CaseDerivatives d = derivatives_of("{path: 'load_cases[0].axial_force'}, {path: 'load_cases[0].moment.z'}",
                                           text, "axial_displacement_um, tangent_stiffness_N_per_um");
  const Case c = input::read_case_text(text, "case.yaml", {}, Command::solve);
  const Result solved = analyze(c);
  const Eigen::MatrixXd& compliance = solved.load_cases[0].full->screw_end.compliance;
  EXPECT_NEAR(d.factors[0].responses[0].value().value * *d.values[1] / 1e3, 1.0, 1e-6);
  // Tension moves the end against x.
  EXPECT_NEAR(d.factors[1].responses[0].value().value * 1e-6 / -compliance(0, 4), 1.0, 1e-6);
  EXPECT_FALSE(d.factors[1].responses[0]->elasticity);
}

TEST(Derivatives, FrequenciesFallWithTheRootOfTheDensity) {
  SKIP_UNDER_SANITIZERS();
  const std::string text =
      input::abevi_with("{name: pull,", "{name: pull, modes: {count: 2},") + "model: {mechanism: full}\n";
  const CaseDerivatives d = derivatives_of(
      "{path: materials.density}", std::string(text).insert(text.find("load_cases:"), "  density: 7850 kg/m^3\n"),
      "'modes.mode[0].frequency_Hz', axial_stiffness_N_per_um");
  EXPECT_NEAR(elasticity(d, 0, 0), -0.5, 1e-8);
  EXPECT_NEAR(elasticity(d, 0, 1), 0.0, 1e-12);
}

std::string exact(double x) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.17g", x);
  return text.data();
}

/// Central difference of whole solves, extrapolated to a step of 0.
double by_solves(const std::string& path, double at, const std::string& unit, const std::string& text, auto response) {
  const auto value = [&](double x) {
    const std::string override = path + "=" + exact(x) + " " + unit;
    return response(analyze(input::read_case_text(text, "case.yaml", {override}, Command::solve)));
  };
  const auto slope = [&](double h) { return (value(at + h) - value(at - h)) / (2.0 * h); };
  const double h = 2e-3 * at;
  return (4.0 * slope(0.5 * h) - slope(h)) / 3.0;
}

TEST(Derivatives, AgreeWithDifferencesOfWholeSolves) {
  struct Input {
    const char* path;
    double at;
    const char* unit;
  };
  const Input inputs[] = {{"mechanism.flank_angle", 45.0, "deg"},
                          {"mechanism.pitch_diameter.roller", 7.0, "mm"},
                          {"mechanism.profile.roller.convex", 4.949747468, "mm"},
                          {"structure.nut.outer_diameter", 46.0, "mm"},
                          {"structure.screw.bore", 6.0, "mm"},
                          {"materials.poisson_ratio", 0.3, ""}};
  std::string factors;
  for (const Input& i : inputs) factors += std::string(factors.empty() ? "" : ", ") + "{path: " + i.path + "}";
  const CaseDerivatives d = derivatives_of(factors, input::kAbevi);
  for (std::size_t f = 0; f < std::size(inputs); ++f) {
    const auto& [path, at, unit] = inputs[f];
    const double displacement = by_solves(path, at, unit, input::kAbevi,
                                          [](const Result& r) { return *r.load_cases[0].axial_displacement * 1e6; });
    const double pressure = by_solves(path, at, unit, input::kAbevi, [](const Result& r) {
      return r.load_cases[0].threads->screw.peak_pressure[0] * 1e-6;
    });
    ASSERT_TRUE(d.factors[f].responses[0]) << path << ": " << d.factors[f].reason;
    const double scale = *d.values[0] / at;
    EXPECT_NEAR(d.factors[f].responses[0]->value, displacement, 1e-7 * scale) << path;
    EXPECT_NEAR(d.factors[f].responses[4]->value, pressure, 1e-7 * *d.values[4] / at) << path;
  }
}

TEST(Derivatives, OfAContactNeedNoEquilibrium) {
  const CaseDerivatives d =
      derivatives_of("{path: materials.youngs_modulus}", input::kAbevi,
                     "contact.nut.hertz_constant_N_per_mm1_5, contact.nut.ellipticity", "contact");
  EXPECT_NEAR(elasticity(d, 0, 0), 1.0, 1e-10);
  EXPECT_NEAR(d.factors[0].responses[1]->value, 0.0, 1e-12);
}

TEST(Derivatives, OfContactsAreOfTheLoadCaseThatContactAnswers) {
  const std::string text = input::kAbevi + "  - {axial_force: 22 kN, share: equal}\n";
  const CaseDerivatives d =
      derivatives_of("{path: 'load_cases[2].axial_force'}", text, "'screw.axial_load_N[0]'", "contact");
  ASSERT_TRUE(d.values.at(0));
  EXPECT_NEAR(elasticity(d, 0, 0), 1.0, 1e-10);
}

TEST(Derivatives, SayWhereThereIsNone) {
  const CaseDerivatives d = derivatives_of("{path: structure.nut.thrust.tension}", input::kAbevi);
  // The thrust section lies on the face of a flange.
  EXPECT_THAT(d.factors[0].reason, HasSubstr("meet here"));
  EXPECT_FALSE(d.factors[0].responses[0]);
}

TEST(Derivatives, NeedAModelThatHasThem) {
  EXPECT_THROW(derivatives_of("{path: mechanism.lead}", input::kAbevi + "model: {bodies: influence}\n"), CaseError);
}

}  // namespace
}  // namespace prs
