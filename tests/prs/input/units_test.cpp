#include "prs/input/units.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <numbers>
#include <random>

namespace prs::input {
namespace {

using std::numbers::pi;

double si(std::string_view text, const Dimension& dimension) {
  return parse_quantity(text, dimension).value.value_or(std::nan(""));
}

TEST(Units, KnowsItsUnits) {
  for (const char* unit : {"mm", "kN", "deg", "GPa", "mPa s", "N/mm^1.5", "rpm", "1/GPa", "in", "lbf", "lbf in", "psi",
                           "ksi", "lb/in^3", "lb", "degF", "lbf/in"})
    EXPECT_TRUE(is_unit(unit)) << unit;
  for (const char* unit : {"", " ", "lbs", "inches", "5", "Mm"}) EXPECT_FALSE(is_unit(unit)) << unit;
}

TEST(Units, EveryDimensionConvertsToSi) {
  EXPECT_EQ(si("5 mm", unit::length), 0.005);
  EXPECT_EQ(si("0.3 um", unit::length), 3e-7);
  EXPECT_EQ(si("0.3 µm", unit::length), 3e-7);
  EXPECT_EQ(si("45 kN", unit::force), 45e3);
  EXPECT_EQ(si("45 deg", unit::angle), pi / 4);
  EXPECT_EQ(si("90 deg", unit::angle), pi / 2);
  EXPECT_EQ(si("209 GPa", unit::pressure), 209e9);
  EXPECT_EQ(si("209000 N/mm^2", unit::pressure), 209e9);
  EXPECT_EQ(si("7.81 g/cm^3", unit::density), 7810.0);
  EXPECT_EQ(si("166.5 mPa s", unit::viscosity), 0.1665);
  EXPECT_EQ(si("166.5 cP", unit::viscosity), 0.1665);
  EXPECT_EQ(si("30 1/GPa", unit::pressure_viscosity), 30e-9);
  EXPECT_DOUBLE_EQ(si("30 rpm", unit::rotational_speed), pi);
  EXPECT_EQ(si("3 rad/s", unit::rotational_speed), 3.0);
  EXPECT_EQ(si("200 mm/s", unit::travel_speed), 0.2);
  EXPECT_DOUBLE_EQ(si("2 in/s", unit::travel_speed), 2 * 0.0254);
  EXPECT_DOUBLE_EQ(si("3 in/min", unit::travel_speed), 3 * 0.0254 / 60);
  EXPECT_DOUBLE_EQ(si("1.2 m/min", unit::travel_speed), 0.02);
  EXPECT_EQ(si("2e4 N/mm", unit::stiffness), 2e7);
  EXPECT_EQ(si("500 N/um", unit::stiffness), 5e8);
  EXPECT_EQ(si("12 N mm", unit::torque), 0.012);
  EXPECT_EQ(si("12 mN m", unit::torque), 0.012);
  EXPECT_EQ(si("12 Nm", unit::torque), 12.0);
  EXPECT_EQ(si("46 mm^2/s", unit::kinematic_viscosity), 46e-6);
  EXPECT_EQ(si("46 cSt", unit::kinematic_viscosity), 46e-6);
  EXPECT_EQ(si("46e-6 m^2/s", unit::kinematic_viscosity), 46e-6);
  EXPECT_EQ(si("313.15 K", unit::temperature), 313.15);
}

TEST(Units, TemperaturesAreAbsoluteInside) {
  for (const char* text : {"40 degC", "40degC", "40 °C", "40 C", "+4e1 degC", "313.15 K"})
    EXPECT_EQ(si(text, unit::temperature), 313.15) << text;
  EXPECT_EQ(si("0 degC", unit::temperature), 273.15);
  EXPECT_EQ(si("-273.15 degC", unit::temperature), 0.0);
  EXPECT_EQ(si("0 K", unit::temperature), 0.0);
  EXPECT_LT(si("-273.16 degC", unit::temperature), 0.0);
  for (const char* text : {"40", "40 F", "40 deg", "1e31 degC", "1e-31 K"})
    EXPECT_FALSE(parse_quantity(text, unit::temperature).value) << text;
}

TEST(Units, CustomaryUnitsAreThoseOfTheirDefinition) {
  // NIST SP 811, appendix B.8, to the digits that it prints.
  EXPECT_EQ(si("1 in", unit::length), 0.0254);
  EXPECT_EQ(si("0.75 in", unit::length), 0.01905);
  EXPECT_EQ(si("1 ft", unit::length), 0.3048);
  EXPECT_EQ(si("16 uin", unit::length), 0.4064e-6);
  EXPECT_NEAR(si("1 lbf", unit::force), 4.448222, 5e-7);
  EXPECT_NEAR(si("1 psi", unit::pressure), 6894.757, 5e-4);
  EXPECT_NEAR(si("1 ksi", unit::pressure), 6894757, 0.5);
  EXPECT_NEAR(si("1 lb/in^3", unit::density), 27679.90, 5e-3);
  EXPECT_NEAR(si("1 lbf/in", unit::stiffness), 175.1268, 5e-5);
  EXPECT_NEAR(si("1 lbf/uin", unit::stiffness), 175.1268e6, 50);
  EXPECT_NEAR(si("1 lbf in", unit::torque), 0.1129848, 5e-8);
  EXPECT_EQ(si("1 in lbf", unit::torque), si("1 lbf in", unit::torque));
  EXPECT_NEAR(si("1 lbf ft", unit::torque), 1.355818, 5e-7);
  EXPECT_NEAR(si("6.4 uin/in/degF", unit::thermal_expansion), 11.52e-6, 1e-18);
  EXPECT_NEAR(si("140 degF", unit::temperature), 333.15, 1e-12);
  EXPECT_NEAR(si("-40 degF", unit::temperature), si("-40 degC", unit::temperature), 1e-12);
}

TEST(Units, HertzConstantScalesWithLengthToTheThreeHalves) {
  EXPECT_DOUBLE_EQ(si("1 N/mm^1.5", unit::hertz_constant), std::pow(1e3, 1.5));
  EXPECT_DOUBLE_EQ(si("1 N/um^1.5", unit::hertz_constant), std::pow(1e6, 1.5));
  EXPECT_DOUBLE_EQ(si("1 kN/mm^1.5", unit::hertz_constant), 1e3 * std::pow(1e3, 1.5));
}

TEST(Units, DecimalLengthsAreTheNearestDoubles) {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> thousandths(1, 999'999);
  for (int i = 0; i < 1000; ++i) {
    const int n = thousandths(random);
    EXPECT_EQ(si(std::to_string(n) + " um", unit::length), n / 1e6);
    EXPECT_EQ(si(std::to_string(n) + " mm", unit::length), n / 1e3);
  }
}

TEST(Units, FormattedValuesReadBackExactly) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> exponent(-4.0, 4.0);
  for (const Dimension* d :
       {&unit::length, &unit::force, &unit::angle, &unit::pressure, &unit::viscosity, &unit::rotational_speed,
        &unit::hertz_constant, &unit::kinematic_viscosity, &unit::temperature})
    for (int i = 0; i < 200; ++i) {
      const double value = si(std::to_string(std::pow(10.0, exponent(random))) + " " + std::string(d->canonical), *d);
      EXPECT_EQ(si(format_quantity(value, *d), *d), value) << format_quantity(value, *d);
    }
}

TEST(Units, FormattedValuesAreShort) {
  EXPECT_EQ(format_quantity(0.021, unit::length), "21 mm");
  EXPECT_EQ(format_quantity(si("54.3333333 mm", unit::length), unit::length), "54.3333333 mm");
  EXPECT_EQ(format_quantity(pi / 4, unit::angle), "45 deg");
  EXPECT_EQ(format_quantity(si("400 rpm", unit::rotational_speed), unit::rotational_speed), "400 rpm");
  for (const char* text :
       {"0.1 degC", "40 degC", "-20 degC", "0 degC", "26.85 degC", "36.6 degC", "-273.15 degC", "123.456789 degC"})
    EXPECT_EQ(format_quantity(si(text, unit::temperature), unit::temperature), text);
}

TEST(Units, NumbersMayBeWrittenAsEngineersDo) {
  for (const char* text :
       {"5 mm", "5mm", "+5 mm", "5.0 mm", "5. mm", "0.5e1 mm", "50E-1  mm", "5\u00A0mm", "5\u202Fmm"})
    EXPECT_EQ(si(text, unit::length), 0.005) << text;
  EXPECT_EQ(si("-.5 mm", unit::length), -0.0005);
}

TEST(Units, InchesMayHaveAFraction) {
  EXPECT_EQ(si("1 1/4 in", unit::length), 0.03175);
  EXPECT_EQ(si("-1-1/4in", unit::length), -0.03175);
  EXPECT_EQ(si("5/8 in", unit::length), 0.015875);
  EXPECT_EQ(si("+2 1/2 ft", unit::length), 0.762);
  EXPECT_EQ(number_in("1 1/4 in", "mm"), 31.75);
  for (const char* text : {"1 5/4 in", "1.5 1/4 in", "1/0 in", "1 1/4 mm", "1 1/4", "1/4/2 in", "1e1/4 in", "1  1/4 in",
                           "/4 in", "1 -1/4 in", "1000000000/8 in"})
    EXPECT_FALSE(parse_quantity(text, unit::length).value) << text;
  EXPECT_NEAR(si("400 1/min", unit::rotational_speed), 400 * pi / 30, 1e-12);
  EXPECT_FALSE(parse_quantity("1/4 in/s", unit::rotational_speed).value);
}

TEST(Units, WhatMeansAnotherSpellingIsToldIt) {
  for (const auto& [text, dimension, hint] : {std::tuple{"400 RPM", &unit::rotational_speed, "write `rpm`"},
                                              {"400 U/min", &unit::rotational_speed, "write `rpm`"},
                                              {"5 MM", &unit::length, "write `mm`"},
                                              {"1 inch", &unit::length, "write `in`"},
                                              {"1\"", &unit::length, "write `in`"},
                                              {"100 kgf", &unit::force, "write `N`; 1 kgf is 9.80665 N"},
                                              {"10 KN", &unit::force, "write `kN`"},
                                              {"100 lb", &unit::force, "write `lbf`"},
                                              {"210 mPa", &unit::pressure, "did you mean `MPa`?"},
                                              {"46 mm2/s", &unit::kinematic_viscosity, "write `mm^2/s`"},
                                              {"7810 kg/m³", &unit::density, "write `kg/m^3`"},
                                              {"3e5 N/mm^1,5", &unit::hertz_constant, "use one of the units "}}) {
    const ParsedQuantity parsed = parse_quantity(text, *dimension);
    EXPECT_FALSE(parsed.value) << text;
    EXPECT_NE(parsed.hint.find(hint), std::string::npos) << parsed.hint;
  }
  EXPECT_EQ(si("700 N/mm2", unit::pressure), si("700 MPa", unit::pressure));
}

TEST(Units, WhatIsNoQuantityIsRefused) {
  for (const char* text :
       {"",         "mm",      "5",      "5 kN",    "5 MM",   "5 mm mm", "5 mm ",       " 5 mm",    "5,0 mm",
        "1_000 mm", "0x5 mm",  "nan mm", ".nan mm", "inf mm", "-inf mm", "infinity mm", "1e999 mm", "1e-999 mm",
        "1e31 m",   "1e-31 m", "+-5 mm", "--5 mm",  "5 e mm", "5e mm",   "5\tmm",       "five mm"})
    EXPECT_FALSE(parse_quantity(text, unit::length).value) << text;
}

/// Twenty or twenty thousand; lengths with three decimals are unambiguous.
TEST(Units, APointThatMayStandBetweenThousandsIsRefused) {
  for (const char* text : {"20.000 N", "+1.000 kN", "-999.000 N"}) {
    const ParsedQuantity parsed = parse_quantity(text, unit::force);
    EXPECT_FALSE(parsed.value) << text;
    EXPECT_NE(parsed.hint.find("write one of the two"), std::string::npos) << parsed.hint;
  }
  EXPECT_EQ(parse_quantity("20.000 N", unit::force).hint, "some read 20 N, others 20000 N; write one of the two");
  EXPECT_FALSE(parse_quantity("20.000 N/um", unit::stiffness).value);
  EXPECT_EQ(si("0.000 N", unit::force), 0.0);
  EXPECT_EQ(si("2000.000 N", unit::force), 2000.0);
  EXPECT_EQ(si("20.00 N", unit::force), 20.0);
  EXPECT_EQ(si("20.500 N", unit::force), 20.5);
  EXPECT_EQ(si("21.000 mm", unit::length), 0.021);
}

TEST(Units, HintsTellUnitAndDimension) {
  EXPECT_NE(parse_quantity("5", unit::length).hint.find("write the unit, for example `5 mm`"), std::string::npos);
  EXPECT_NE(parse_quantity("5 kN", unit::length).hint.find("`kN` is the unit of a force"), std::string::npos);
  EXPECT_NE(parse_quantity("5 furlong", unit::length).hint.find("not a known unit"), std::string::npos);
}

TEST(Units, TheLocaleDoesNotMatter) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) GTEST_SKIP() << "no German locale here";
  EXPECT_EQ(si("4.5 mm", unit::length), 0.0045);
  EXPECT_EQ(format_quantity(0.0045, unit::length), "4.5 mm");
  std::setlocale(LC_ALL, before.c_str());
}

}  // namespace
}  // namespace prs::input
