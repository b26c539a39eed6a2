#include "validation/sandu_2018/profile_curvatures.h"

#include "prs/input/reader.h"
#include "prs/loads/analyze.h"

namespace prs::sandu_2018 {
namespace {

/// A column of table 1.8: signed curvatures of screw and nut, +-1/r_B [1/mm]; for a nut those of its air.
struct ProfileCurvatures {
  double screw = 0.0, nut = 0.0;
};
constexpr ProfileCurvatures kLeft{-0.007, 0.03}, kCentre{0.0, 0.0}, kRight{0.6, -0.01};

Profile profile_of(double convexity) {
  if (convexity == 0.0) return {Profile::Shape::straight};
  return {convexity > 0.0 ? Profile::Shape::convex : Profile::Shape::concave, 1.0 / std::abs(convexity) / "mm"_per_si};
}

PerInterface<InterfaceContact> contacts_of(const Case& example, const ProfileCurvatures& curvatures) {
  Case c = example;
  c.mechanism.profile.screw = profile_of(curvatures.screw);
  c.mechanism.profile.nut = profile_of(-curvatures.nut);
  return analyze_contacts(c).contacts.interfaces;
}

/// k = a/b of the thesis.
double ellipticity(const InterfaceContact& contact) { return 1.0 / contact.hertz.ellipticity; }

/// Acute angle between the major axis and the helix of the roller [deg].
double from_helix(const InterfaceContact& contact) {
  return std::abs(std::remainder(contact.geometry.relative.angle, std::numbers::pi)) * "deg"_per_si;
}

bool has_contacts(const Case& example, const ProfileCurvatures& curvatures) {
  try {
    contacts_of(example, curvatures);
    return true;
  } catch (const CaseError&) {
    return false;
  }
}

Finding ellipses_are_wide(const Case& example) {
  const auto c = contacts_of(example, kCentre);
  return {std::max(ellipticity(c.screw), ellipticity(c.nut)) < 2.0,
          fmt::format("k {:.2f} at I, {:.2f} at J", ellipticity(c.screw), ellipticity(c.nut))};
}

constexpr double kClose = 30.0;  // [deg]

Finding ellipses_lie_across_and_along(const Case& example) {
  const auto c = contacts_of(example, kCentre);
  return {from_helix(c.screw) > 90.0 - kClose && from_helix(c.nut) < kClose,
          fmt::format("major axis {:.0f} deg from the helix at I, {:.0f} deg at J (compared with {:.0f})",
                      from_helix(c.screw), from_helix(c.nut), kClose)};
}

Finding convex_screws_turn_the_ellipse(const Case& example) {
  std::string evidence;
  double last_angle = 0.0, last_k = 0.0, first_k = 0.0;
  for (const double curvature : {0.0, 0.05, 0.1, 0.2, 0.4, 0.6}) {
    const InterfaceContact i = contacts_of(example, {curvature, 0.0}).screw;
    last_angle = from_helix(i), last_k = ellipticity(i);
    if (evidence.empty()) first_k = last_k;
    evidence +=
        fmt::format("{}{:g}/mm k {:.2f} at {:.0f} deg", evidence.empty() ? "" : ", ", curvature, last_k, last_angle);
  }
  return {last_k > first_k && last_angle < kClose, evidence + " from the helix"};
}

Finding ellipse_turns_by_a_right_angle(const Case& example) {
  const double left = from_helix(contacts_of(example, kLeft).screw),
               right = from_helix(contacts_of(example, kRight).screw);
  return {std::abs(left - right) > 90.0 - kClose,
          fmt::format("{:.0f} deg on the left, {:.0f} deg on the right", left, right)};
}

/// Whether none of the four limits of table 1.8 can be exceeded by half.
Finding limits_are_those_of_contact(const Case& example) {
  bool none = true;
  std::string evidence = "contacts within the flanks at";
  for (const ProfileCurvatures& beyond : {ProfileCurvatures{2.0 * kLeft.screw, 0.0},
                                          {2.0 * kRight.screw, 0.0},
                                          {0.0, 1.5 * kLeft.nut},
                                          {0.0, 2.0 * kRight.nut}}) {
    if (!has_contacts(example, beyond)) continue;
    none = false;
    evidence += fmt::format(" {:g}/mm ({}),", beyond.screw + beyond.nut, beyond.nut == 0.0 ? "screw" : "nut");
  }
  evidence.pop_back();
  return {none, evidence};
}

const Checks<Case> kProfileChecks{
    {"ellipses_are_wide", ellipses_are_wide},
    {"ellipses_lie_across_and_along", ellipses_lie_across_and_along},
    {"convex_screws_turn_the_ellipse", convex_screws_turn_the_ellipse},
    {"ellipse_turns_by_a_right_angle", ellipse_turns_by_a_right_angle},
    {"limits_are_those_of_contact", limits_are_those_of_contact},
};

ValidationTable ellipses(const Case& example) {
  ValidationTable table{
      "Table 1.8, fig. 1.16: ellipses for profile curvatures of screw and nut, angles from the roller's helix",
      {"column", "k at I", "angle, deg", "r_IS, mm", "k at J", "angle, deg", "r_JN, mm"},
      {},
      3};
  const auto add = [&](const char* label, const ProfileCurvatures& curvatures) {
    std::vector<double> values;
    const PerInterface<InterfaceContact> contacts = contacts_of(example, curvatures);
    for (const Interface i : kInterfaces) {
      const InterfaceContact& contact = contacts[i];
      values.push_back(ellipticity(contact));
      values.push_back(from_helix(contact));
      values.push_back(contact.geometry.point.radius_on_body * "mm"_per_si);
    }
    table.rows.push_back({label, values});
  };
  add("left: -0.007, +0.03", kLeft);
  add("centre: 0, 0", kCentre);
  add("right: +0.6, -0.01", kRight);
  return table;
}

}  // namespace

Supplement profile_curvatures(const Reference& thesis) {
  const Case example = input::read_case((thesis.folder / "example_4.yaml").string(), {}, Command::contact);
  return {.statements = compare(thesis.statements, kProfileChecks, std::vector<Variant<Case>>{{"example 4", example}}),
          .tables = {ellipses(example)}};
}

}  // namespace prs::sandu_2018
