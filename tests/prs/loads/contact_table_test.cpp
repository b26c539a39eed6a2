#include "prs/loads/load_analysis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "prs/loads/analyze.h"
#include "prs/record/table_units.h"
#include "prs/text.h"
#include "support/contact_cases.h"

namespace prs {
namespace {

using test::abevi_contacts;
using test::equal_share;

std::string table(const Case& c) { return contact_table(analyze_contacts(c)); }

/// Line that starts with the label, with single blanks; empty if there is none.
std::string row(const std::string& table, const std::string& label) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string reduced;
    for (std::string word; words >> word;) reduced += (reduced.empty() ? "" : " ") + word;
    if (reduced.starts_with(label)) return reduced;
  }
  return {};
}

TEST(ContactTable, HoldsTheMechanismAndBothContacts) {
  const std::string text = table(abevi_contacts());
  EXPECT_TRUE(text.starts_with("Inverted roller screw, right-handed, lead 5 mm, 11 rollers"));
  EXPECT_EQ(row(text, "centre distance"), "centre distance 14.0000 mm");
  EXPECT_EQ(row(text, "pitch diameter"), "pitch diameter, mm 21.0000 7.0000 35.0000");
  EXPECT_EQ(row(text, "helix angle"), "helix angle, deg 4.3341 -4.3341 2.6036");
  EXPECT_EQ(row(text, "Contacts"), "Contacts roller-screw roller-nut");
  EXPECT_EQ(row(text, "radius on the body"), "radius on the body, mm 10.5000 17.4615");
  EXPECT_EQ(row(text, "Hertz constant"), "Hertz constant, N/mm^1.5 318654.9 361610.6");
}

TEST(ContactTable, MayBeInInchesAndPounds) {
  std::string text;
  {
    const TableUnits units(UnitSystem::us);
    text = table(abevi_contacts({equal_share("equal", 45e3)}));
  }
  EXPECT_EQ(row(text, "centre distance"), "centre distance 0.551181 in");
  EXPECT_EQ(row(text, "pitch diameter"), "pitch diameter, in 0.826772 0.275591 1.377953");
  EXPECT_EQ(row(text, "helix angle"), "helix angle, deg 4.3341 -4.3341 2.6036");
  EXPECT_EQ(row(text, "backlash"), "backlash, in 0.000000 -0.002530");
  EXPECT_TRUE(row(text, "load case").starts_with("load case lbf lbf in in ksi µin"));
  EXPECT_TRUE(row(text, "equal screw").starts_with("equal screw 45.984 "));  // 204.545 N
  // The setting ends with the object.
  EXPECT_EQ(row(table(abevi_contacts()), "centre distance"), "centre distance 14.0000 mm");
}

TEST(TableUnits, EveryUnitThatIsReplacedIsOneOfDocumentsAndKeepsItsValue) {
  struct Same {
    std::string_view unit, us;
    double documents, tables;
  };
  // NIST SP 811, appendix B.8, to the digits that it prints.
  constexpr Same sames[] = {
      {"mm", "in", 25.4, 1.0},           {"µm", "µin", 0.0254, 1.0},          {"nm", "µin", 25.4, 1.0},
      {"kN", "lbf", 4.448222e-3, 1.0},   {"N", "lbf", 4.448222, 1.0},         {"MPa", "ksi", 6.894757, 1.0},
      {"GPa", "ksi", 6.894757e-3, 1.0},  {"N/µm", "lbf/µin", 175.1268, 1.0},  {"N m", "lbf in", 0.1129848, 1.0},
      {"N mm", "lbf in", 112.9848, 1.0}, {"kg", "lb", 0.4535924, 1.0},        {"cm³", "in³", 16.38706, 1.0},
      {"kg/m", "lb/in", 17.85797, 1.0},  {"kg mm²", "lb in²", 292.6397, 1.0}, {"mm/s", "in/s", 25.4, 1.0},
      {"km", "10^6 in", 25.4, 1.0},      {"W/mm²", "W/in²", 1.0, 645.16},     {"W", "W", 1.0, 1.0},
      {"rpm", "rpm", 1.0, 1.0},          {"kN/kg", "lbf/lb", 9.80665e-3, 1.0}};
  const TableUnits units(UnitSystem::us);
  for (const ShownUnit& unit : kShownUnits)
    for (const Same& same : sames)
      if (same.unit == unit.text) {
        EXPECT_EQ(table_unit(unit).text, same.us);
        EXPECT_NEAR(table_factor(unit) * same.documents / same.tables, 1.0, 5e-7) << same.unit;
      }
  EXPECT_EQ(with_table_unit("torque on the screw, N m"), "torque on the screw, lbf in");
  EXPECT_EQ(with_table_unit("kN"), "lbf");
  EXPECT_EQ(with_table_unit("column"), "column");
  EXPECT_EQ(fixed_with_unit(12e3, "kN", 3), "2697.7 lbf");
}

TEST(TableUnits, QuantitiesOfTextsHaveThemTooWithAsManyDigits) {
  EXPECT_EQ(in_table_unit("12.34 kN"), "12.34 kN");
  const Warning warning = Warning{"a", "code", "got {value}, against {0.5 mm} at {limit}, `{b: 5 mm}`", "write 1"}.with(
      12.5e3, 4.0e3, "kN"_unit);
  EXPECT_EQ(sentence(warning), "a: got 12.5 kN, against 0.5 mm at 4 kN, `{b: 5 mm}`; write 1");
  const TableUnits units(UnitSystem::us);
  // 1 lbf = 4.448222 N, 1 ksi = 6.894757 MPa (NIST SP 811, appendix B.8).
  EXPECT_EQ(in_table_unit("12.34 kN"), "2774 lbf");
  EXPECT_EQ(in_table_unit("4.0 GPa"), "580 ksi");
  EXPECT_EQ(in_table_unit("−2.54 mm"), "−0.1 in");
  EXPECT_EQ(in_table_unit("-1e-3 N/µm"), "-5.71e-06 lbf/µin");
  EXPECT_EQ(in_table_unit("9 m/s"), "9 m/s");
  EXPECT_EQ(in_table_unit("254 mm/min"), "10 in/min");
  EXPECT_EQ(table_sentence(warning), "a: got 2810 lbf, against 0.0197 in at 899 lbf, `{b: 5 mm}`; write 1");
}

TEST(ContactTable, RoundingErrorsHaveNoSign) {
  EXPECT_EQ(row(table(abevi_contacts()), "backlash"), "backlash, mm 0.0000 -0.0643");
}

TEST(ContactTable, WithoutMaterialsThereIsNoHertzContact) {
  Case c = abevi_contacts({equal_share("equal", 45e3)});
  c.materials.reset();
  const std::string text = table(c);
  for (const char* label : {"ellipticity", "Hertz constant"}) EXPECT_EQ(row(text, label), "");
  EXPECT_EQ(row(text, "thread"), "thread normal");
  EXPECT_EQ(row(text, "equal screw"), "equal screw 204.55 290.10");
}

TEST(ContactTable, DifferentPitchesHaveNoBacklash) {
  Case c = abevi_contacts();
  c.mechanism.pitch.screw = c.mechanism.pitch.nut = 1.67e-3;
  EXPECT_EQ(row(table(c), "backlash"), "");
  c.mechanism.pitch.nut.reset();
  EXPECT_TRUE(row(table(c), "backlash, mm –").starts_with("backlash, mm – -0.06"));
}

TEST(ContactTable, PitchesThatRoundingTellsApartHaveABacklash) {
  Case c = abevi_contacts();
  c.mechanism.pitch = {1.67e-3, 1.67e-3, 1.67e-3};
  const std::string same = row(table(c), "backlash");
  EXPECT_NE(same, "");
  c.mechanism.pitch = {1.67e-3, std::nextafter(1.67e-3, 1.0), std::nextafter(1.67e-3, 0.0)};
  EXPECT_EQ(row(table(c), "backlash"), same);
}

TEST(ContactTable, LoadCasesShowWhatOneThreadBears) {
  const std::string text = table(abevi_contacts({equal_share("equal", -45e3)}));
  EXPECT_EQ(row(text, "thread"), "thread normal a b peak approach shear depth");
  EXPECT_TRUE(row(text, "equal screw").starts_with("equal screw 204.55 290.10 0.2271 0.1778 3430.0"));
}

TEST(ContactTable, WarningsOfMechanismAndCasesStandBelow) {
  const std::string text = table(abevi_contacts({equal_share("heavy", 150e3)}));
  const auto heading = text.find("\nWarnings\n");
  ASSERT_NE(heading, std::string::npos);
  EXPECT_NE(text.find("the roller-nut threads interfere", heading), std::string::npos);
  EXPECT_NE(text.find("exceeds 4 GPa", heading), std::string::npos);
}

TEST(ContactTable, FitsInto100ColumnsWhateverTheNames) {
  std::vector<LoadCase> cases;
  for (int k = 0; k < 40; ++k) cases.push_back(equal_share("range[" + std::to_string(k) + ']', 1e6 * (k + 1)));
  cases.push_back(equal_share(std::string(300, 'x'), 1.0));
  cases.push_back(equal_share("\x1b[2J\n\xff", 1.0));
  const std::string text = table(abevi_contacts(cases));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(width(line), 100) << line;
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_NE(text.find("5 of 42 cases"), std::string::npos);
}

}  // namespace
}  // namespace prs
