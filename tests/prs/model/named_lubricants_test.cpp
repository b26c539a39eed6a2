#include "prs/model/operation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace prs {
namespace {

LubricantName name_of(std::string_view name) {
  const auto rows = named_lubricants();
  const auto row = std::ranges::find(rows, name, &NamedLubricant::name);
  return LubricantName{static_cast<std::size_t>(row - rows.begin())};
}

Lubricant named(std::string_view name, double temperature) {
  Lubricant l;
  l.name = name_of(name);
  l.temperature = temperature;
  return l;
}

/// Viscosity index by ASTM D2270 from both viscosities [mm^2/s], up to 100: (L - U)/(L - H) with
/// the quadratics of its appendix, from the viscosity at 100 degC on that each row names.
double viscosity_index(double at_40, double at_100) {
  constexpr double rows[][7] = {{5.0, 0.101, 16.635, -45.469, 0.04985, 9.1613, -18.557},
                                {6.4, 3.35714, -23.5643, 78.466, 0.22619, 7.7369, -16.656},
                                {7.0, 0.01191, 21.475, -72.870, 0.79762, -0.7321, 14.610},
                                {7.7, 0.41858, 16.1558, -56.040, 0.05794, 10.5156, -28.240},
                                {9.0, 0.88779, 7.5527, -16.600, 0.26665, 6.7015, -10.810},
                                {12.0, 0.76720, 10.7972, -38.180, 0.20073, 8.4658, -22.490},
                                {15.0, 0.97305, 5.3135, -2.200, 0.28889, 5.9741, -4.930},
                                {18.0, 0.97256, 5.2500, -0.980, 0.24504, 7.4160, -16.730},
                                {22.0, 0.91413, 7.4759, -21.820, 0.20323, 9.1267, -34.230},
                                {28.0, 0.87031, 9.7157, -50.770, 0.18411, 10.1015, -46.750}};
  const double* row = rows[0];
  for (const auto& r : rows)
    if (r[0] <= at_100) row = r;
  const double l = (row[1] * at_100 + row[2]) * at_100 + row[3];
  const double h = (row[4] * at_100 + row[5]) * at_100 + row[6];
  return 100.0 * (l - at_40) / (l - h);
}

TEST(NamedLubricants, ViscosityGradesHaveTheViscosityIndexOfTheirStandard) {
  int grades = 0;
  for (const NamedLubricant& l : named_lubricants()) {
    if (!l.name.starts_with("iso-vg-")) continue;
    ++grades;
    EXPECT_NEAR(l.viscosity_40 * 1e6, std::stod(std::string(l.name.substr(7))), 1e-9);
    EXPECT_NEAR(viscosity_index(1e6 * l.viscosity_40, 1e6 * l.viscosity_100), 95.0, 0.2) << l.name;
  }
  EXPECT_EQ(grades, 8);
}

/// Values of the chart at 40 degC; the index that the table assumes for 100 degC.
TEST(NamedLubricants, BearingGreasesHaveTheBaseOilOfTheirMakersChart) {
  for (const auto& [name, at_40] :
       {std::pair{"skf-lgmt-2", 110.0}, {"skf-lgep-2", 200.0}, {"skf-lgwa-2", 185.0}, {"skf-lghb-2", 400.0}}) {
    const auto rows = named_lubricants();
    const auto grease = std::ranges::find(rows, name, &NamedLubricant::name);
    ASSERT_NE(grease, rows.end()) << name;
    EXPECT_NEAR(1e6 * grease->viscosity_40, at_40, 1e-9) << name;
    EXPECT_NEAR(viscosity_index(at_40, 1e6 * grease->viscosity_100), 95.0, 0.2) << name;
  }
}

TEST(NamedLubricants, HaveTheirViscositiesWhereTheyWereMeasured) {
  for (const NamedLubricant& l : named_lubricants()) {
    const Lubricant oil = named(l.name, 313.15);
    EXPECT_NEAR(in_operation(oil).viscosity / (l.density * l.viscosity_40), 1.0, 1e-12) << l.name;
    EXPECT_NEAR(at_temperature(oil, 373.15).viscosity / (l.density * l.viscosity_100), 1.0, 1e-12);
    EXPECT_NE(l.source, "");
  }
}

TEST(NamedLubricants, TheEstimateOfPressureViscosityFollowsTheTemperature) {
  const Lubricant oil = named("iso-vg-100", 333.15);
  for (const double temperature : {293.15, 333.15, 393.15}) {
    const contact::Lubricant at = at_temperature(oil, temperature);
    EXPECT_EQ(at.pressure_viscosity, contact::gold_pressure_viscosity(contact::BaseOil::mineral, at.viscosity / 891.0));
  }
  // alpha = s nu^t: over a range of temperatures it falls with the power t of the viscosity.
  const contact::Lubricant cold = at_temperature(oil, 313.15), hot = at_temperature(oil, 373.15);
  EXPECT_NEAR(cold.pressure_viscosity / hot.pressure_viscosity, std::pow(100.0 / 11.07, 0.139), 1e-12);
}

TEST(NamedLubricants, StatedValuesComeFirst) {
  Lubricant oil = named("iso-vg-100", 333.15);
  oil.pressure_viscosity = 21e-9;
  EXPECT_EQ(in_operation(oil).pressure_viscosity, 21e-9);
  EXPECT_EQ(in_operation(oil).eyring_stress, kTypicalEyringStress);
  oil.eyring_stress = 8e6;
  EXPECT_EQ(in_operation(oil).eyring_stress, 8e6);
  EXPECT_FALSE(estimated_lubricant(oil));
  oil.density = 2.0 * 891.0;
  EXPECT_NEAR(in_operation(oil).viscosity / in_operation(named("iso-vg-100", 333.15)).viscosity, 2.0, 1e-12);
  oil.viscosity_at = {{313.15, {}, 68e-6}, {373.15, {}, 8.53e-6}};
  oil.density = 887.0;
  EXPECT_EQ(in_operation(oil).viscosity, in_operation(named("iso-vg-68", 333.15)).viscosity);
  oil.temperature.reset();
  oil.viscosity_at.clear();
  oil.viscosity = 0.05;
  oil.pressure_viscosity.reset();
  EXPECT_EQ(in_operation(oil).viscosity, 0.05);
  EXPECT_EQ(in_operation(oil).pressure_viscosity,
            contact::gold_pressure_viscosity(contact::BaseOil::mineral, 0.05 / 887.0));
}

}  // namespace
}  // namespace prs
