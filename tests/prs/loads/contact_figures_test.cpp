#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "contact/mechanism_geometry.h"
#include "prs/loads/analyze.h"
#include "prs/loads/load_pictures.h"
#include "prs/svg/elements.h"
#include "support/contact_cases.h"
#include "support/count.h"
#include "support/drawn.h"
#include "support/shown.h"
#include "support/temporary_directory.h"
#include "tests/contact/mechanisms.h"

namespace prs {
namespace {

namespace fs = std::filesystem;
using test::abevi_contacts;
using test::contact_lesson;
using test::equal_share;
using test::expect_drawn;
using test::TemporaryDirectory;

constexpr double mm = 1e-3;
constexpr double kChord = 1e-4;  ///< Deviation of a polyline from a curved flank [mm].

/// Same as example 1 of Sandu 2018, table 1.6.
Case standard() { return contact_lesson("05_standard_screw.yaml"); }

Case left_handed(Case c) {
  c.mechanism.lead = -c.mechanism.lead;
  return c;
}

/// Truncated threads, concave bodies.
Case truncated() {
  Case c = standard();
  c.mechanism.profile.screw = c.mechanism.profile.nut = {Profile::Shape::concave, 40 * mm};
  for (const Part part : kParts) c.mechanism.thread[part] = {0.3 * mm, 0.4 * mm};
  return c;
}

std::vector<Case> variants() {
  return {abevi_contacts(), left_handed(abevi_contacts()), standard(), left_handed(standard()), truncated()};
}

std::optional<Figure> contact_picture(const Result& result, const char* name) {
  return test::shown(contact_pictures(result), name);
}

Figures all_figures(const Result& result) { return figures(contact_pictures(result)); }

/// Line of the panel with the legend entry `title`.
const Series& series_of(const Figure& figure, const Panel& panel, const std::string& title) {
  const auto entry =
      std::find_if(figure.legend.begin(), figure.legend.end(), [&](const LegendEntry& e) { return e.title == title; });
  EXPECT_NE(entry, figure.legend.end()) << title;
  const auto line =
      std::find_if(panel.series.begin(), panel.series.end(), [&](const Series& l) { return l.style == entry->style; });
  EXPECT_NE(line, panel.series.end()) << title;
  return *line;
}

// Parts of the section's overview: the outlines of screw, roller (at the screw, at the nut), nut.
constexpr std::size_t kOutlines = 3;

struct Outlines {
  Polyline body;
  Polyline roller;
};

Outlines outlines_at(const Figure& section, Interface i) {
  const std::vector<Series>& lines = section.panels[0].series;
  return i == Interface::screw ? Outlines{lines[kOutlines].parts[0], lines[kOutlines + 1].parts[0]}
                               : Outlines{lines[kOutlines + 2].parts[0], lines[kOutlines + 1].parts[1]};
}

/// x of an outline at z.
double at(const Polyline& outline, double z) {
  const auto above = std::find_if(outline.begin(), outline.end(), [&](const auto& point) { return point[0] >= z; });
  const auto& [z1, x1] = *above;
  const auto& [z0, x0] = *std::prev(above);
  return x0 + (x1 - x0) * (z - z0) / (z1 - z0);
}

/// Gap between the parts at z [mm]; negative if they overlap.
double gap(const Outlines& outlines, Interface i, double z) {
  const double towards_roller = i == Interface::screw ? 1.0 : -1.0;
  return towards_roller * (at(outlines.roller, z) - at(outlines.body, z));
}

TEST(ContactSection, LoadedFlanksTouchAtTheMarksAndNowhereInterpenetrate) {
  for (const Case& c : variants()) {
    const Result result = analyze_contacts(c);
    const auto figure = contact_picture(result, "contact_axial_section");
    ASSERT_TRUE(figure);
    const double pitch = result.contacts.threads.roller.pitch / mm;
    const Series& marks = series_of(*figure, figure->panels[0], "contact points I, J");
    for (const Interface i : kInterfaces) {
      const Outlines outlines = outlines_at(*figure, i);
      const Polyline& points = marks.parts[i == Interface::screw ? 0 : 1];
      ASSERT_GT(points.size(), 5);
      for (const auto& [z, x] : points) {
        EXPECT_NEAR(at(outlines.body, z), x, kChord) << figure->title;
        EXPECT_NEAR(gap(outlines, i, z), 0.0, kChord) << figure->title;
        for (double away = -0.24; away < 0.24; away += 0.01)
          EXPECT_GT(gap(outlines, i, z + away * pitch), -kChord) << figure->title << ' ' << away;
      }
    }
  }
}

TEST(ContactSection, ThreadsStandWhereTheirAxialPositionsAre) {
  // This screw's contact lies in the plane of the axes, where the middle of a groove is at the
  // height of the origin; the roller's origin is at z = 0.
  const Result result = analyze_contacts(abevi_contacts());
  const contact::MechanismGeometry& threads = result.contacts.threads;
  const auto positions = contact::axial_positions(
      threads, contact::mechanism_contact(threads, contact::Configuration::i1_j2), contact::Configuration::i1_j2);
  const Polyline screw = outlines_at(*contact_picture(result, "contact_axial_section"), Interface::screw).body;
  const auto root = std::min_element(screw.begin(), screw.end(), [](const auto& a, const auto& b) {
    return std::lround(a[1] * 1e6) < std::lround(b[1] * 1e6);
  });
  const double from_root = (*root)[0] * mm - positions.screw;
  EXPECT_NEAR(std::remainder(from_root, threads.screw.pitch), 0.0, 1e-9);
}

TEST(ContactSection, PartsOfDifferentPitchTouchAtOneThread) {
  Case c = abevi_contacts();
  c.mechanism.pitch.screw = c.mechanism.pitch.nut = 1.67 * mm;
  const auto figure = contact_picture(analyze_contacts(c), "contact_axial_section");
  ASSERT_TRUE(figure);
  for (const Interface i : kInterfaces) {
    const Series& marks = series_of(*figure, figure->panels[0], "contact points I, J");
    const Polyline& points = marks.parts[i == Interface::screw ? 0 : 1];
    ASSERT_EQ(points.size(), 1);
    EXPECT_NEAR(gap(outlines_at(*figure, i), i, points[0][0]), 0.0, kChord);
  }
  for (const Panel& panel : figure->panels)
    for (const Label& label : panel.labels) EXPECT_EQ(label.text.find("backlash"), std::string::npos);
}

TEST(ContactXy, MarksStandAtTheContactPoints) {
  for (const Case& c : variants()) {
    const Result result = analyze_contacts(c);
    const auto figure = contact_picture(result, "contact_xy");
    ASSERT_TRUE(figure);
    const Series& marks = series_of(*figure, figure->panels[0], "contact points I, J");
    for (const Interface i : kInterfaces) {
      const auto& point = result.contacts.interfaces[i].geometry.point;
      const auto& [x, y] = marks.parts[i == Interface::screw ? 0 : 1].at(0);
      EXPECT_DOUBLE_EQ(std::hypot(x, y) * mm, point.radius_on_body);
      EXPECT_DOUBLE_EQ(std::atan2(y, x), point.angle_on_body);
    }
  }
}

TEST(ContactXy, AllRollersAreDrawn) {
  const Result result = analyze_contacts(abevi_contacts());
  const auto figure = contact_picture(result, "contact_xy");
  ASSERT_TRUE(figure);
  EXPECT_EQ(series_of(*figure, figure->panels[0], "pitch circle, roller").parts.size(), 11);
}

TEST(ContactEllipses, AreThoseOfTheLargestLoad) {
  const Result result = analyze_contacts(
      abevi_contacts({equal_share("small", 5e3), equal_share("large", -45e3), equal_share("some", 20e3)}));
  const auto figure = contact_picture(result, "contact_ellipses");
  ASSERT_TRUE(figure);
  EXPECT_EQ(figure->title, "Contact ellipses, load case large");
  for (const Interface i : kInterfaces) {
    const std::size_t index = i == Interface::screw ? 0 : 1;
    const Polyline& ellipse = series_of(*figure, figure->panels[index], "contact ellipse").parts.at(0);
    const InterfaceLoads& loads = (*result.load_cases[1].threads)[i];
    const double angle = result.contacts.interfaces[i].geometry.relative.angle;
    EXPECT_NEAR(std::hypot(ellipse[0][0], ellipse[0][1]) * mm, loads.semi_major[0], 1e-12);
    EXPECT_NEAR(std::remainder(std::atan2(ellipse[0][1], ellipse[0][0]) - angle, M_PI), 0, 1e-12);
  }
}

TEST(ContactEllipses, HaveUnitMajorAxesWithoutMaterials) {
  Case c = abevi_contacts({equal_share("equal", 45e3)});
  const contact::HertzConstants hertz = analyze_contacts(c).contacts.interfaces.nut.hertz;
  c.materials.reset();
  const auto figure = contact_picture(analyze_contacts(c), "contact_ellipses");
  ASSERT_TRUE(figure);
  EXPECT_EQ(figure->title, "Contact ellipses, shape without load");
  double least = 1.0;
  const Series& ellipse = series_of(*figure, figure->panels[1], "contact ellipse");
  for (const auto& [x, y] : ellipse.parts[0]) least = std::min(least, std::hypot(x, y));
  EXPECT_NEAR(least, hertz.ellipticity, 1e-12);
}

/// Contacts of threads that no case describes.
Result contacts_of(const contact::MechanismGeometry& threads) {
  Result result;
  result.contacts.threads = threads;
  result.contacts.mechanism.rollers = 3;
  const auto contact = contact::mechanism_contact(threads, contact::Configuration::i1_j2);
  result.contacts.interfaces.screw.geometry = contact.screw;
  result.contacts.interfaces.nut.geometry = contact.nut;
  return result;
}

void expect_finite(const Figure& figure) {
  for (const Panel& panel : figure.panels)
    for (const Series& line : panel.series)
      for (const Polyline& part : line.parts)
        for (const auto& [x, y] : part) ASSERT_TRUE(std::isfinite(x) && std::isfinite(y)) << figure.name;
}

TEST(ContactFigures, AllCoordinatesAreFinite) {
  for (const Case& c : variants())
    for (const Figure& figure : all_figures(analyze_contacts(c))) expect_finite(figure);
  contact::test::RandomMechanisms random(7);
  int drawn = 0;
  const int mechanisms = test::samples(200, 200);
  for (int k = 0; k < mechanisms; ++k)
    for (const Figure& figure : all_figures(contacts_of(random.next()))) {
      expect_finite(figure);
      ++drawn;
    }
  EXPECT_GT(drawn, mechanisms);
}

TEST(ContactFigures, NeedBothContactPoints) {
  Result result = analyze_contacts(abevi_contacts());
  result.contacts.interfaces.nut.geometry.point.status = contact::ContactPointStatus::outside_flank;
  EXPECT_TRUE(all_figures(result).empty());
}

TEST(ContactFigures, DrawingsAreToScale) {
  // Panels of one width and height: twice the range of x means twice the range of y.
  Figure figure;
  figure.to_scale = true;
  figure.columns = 2;
  figure.panels = {{.title = "wide", .x = Axis{"x", "", 0.0, 10.0}, .y = Axis{"y", "", 0.0, 1.0}},
                   {.title = "high", .x = Axis{"x", "", 0.0, 1.0}, .y = Axis{"y", "", 0.0, 10.0}}};
  const auto [wide_x, wide_y] = drawn_axes(figure, Layout(figure), 0);
  const auto [high_x, high_y] = drawn_axes(figure, Layout(figure), 1);
  const auto length = [](const Axis& axis) { return axis.to - axis.from; };
  EXPECT_DOUBLE_EQ(length(wide_x), 10.0);
  EXPECT_DOUBLE_EQ(length(high_y), 10.0);
  EXPECT_NEAR(length(wide_x) / length(wide_y), length(high_x) / length(high_y), 1e-5);
}

TEST(ContactPlots, EveryFigureIsDrawn) { expect_drawn(all_figures(analyze_contacts(truncated()))); }

}  // namespace
}  // namespace prs
