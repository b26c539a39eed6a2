#include "prs/threads/contact_failure.h"

#include "prs/model/units.h"

namespace prs {
namespace {

/// From the crest of the body's flank to the roller's crest on the line of centres [m]; < 0 where
/// they overlap.
double distance_of_crests(const contact::ThreadPair& pair, Interface i) {
  return i == Interface::screw
             ? pair.centre_distance - pair.body.largest_radius - pair.roller.largest_radius
             : pair.body.smallest_radius - pair.roller.largest_radius - pair.centre_distance;
}

std::string off_the_flanks(const contact::FlankViolations& violations, Interface i) {
  std::string text = "the contact point lies ";
  const char* separator = "";
  for (const contact::FlankViolation& v : violations) {
    text += fmt::format("{}{:.4f} mm beyond the {} of the {}", separator, v.by * per_si::millimetre,
                        contact::name(v.end), v.of_roller ? "roller" : name(i));
    separator = ", ";
  }
  return text;
}

std::string without_hertz(contact::HertzStatus status) {
  switch (status) {
    case contact::HertzStatus::no_point_contact:
      return "the smaller relative curvature is zero, which gives a line contact";
    case contact::HertzStatus::conforming_surface:
      return "the smaller relative curvature is negative: the surfaces overlap next to the point";
    default:
      return fmt::format("the contact cannot be computed ({})", contact::name(status));
  }
}

}  // namespace

const char* label(Interface i) { return i == Interface::screw ? "roller-screw" : "roller-nut"; }

contact::ThreadPair pair_of(const contact::MechanismGeometry& threads, Interface i) {
  return i == Interface::screw ? contact::screw_pair(threads) : contact::nut_pair(threads);
}

Problem why_no_contact(const contact::MechanismGeometry& threads,
                       const contact::InterfaceGeometry& geometry, contact::HertzStatus hertz,
                       Interface i) {
  using Status = contact::ContactPointStatus;
  switch (geometry.point.status) {
    case Status::ok:
      return {"mechanism.profile", without_hertz(hertz)};
    case Status::straight_on_straight:
      return {"mechanism.profile", "both profiles are straight, which gives no point contact"};
    case Status::out_of_reach: {
      const double distance = distance_of_crests(pair_of(threads, i), i);
      return {"mechanism.centre_distance",
              fmt::format("the flanks of roller and {} {} by {:.4f} mm", name(i),
                          distance > 0.0 ? "miss each other" : "overlap",
                          std::abs(distance) * per_si::millimetre)};
    }
    case Status::outside_flank:
      return {"mechanism.thread",
              off_the_flanks(point_beyond_flanks(pair_of(threads, i), geometry.point), i)};
    case Status::not_a_minimum:
      return {"mechanism.profile", "the surfaces cut each other where their slopes agree"};
    case Status::not_converged:
    case Status::not_computed:
      break;
  }
  return {
      "mechanism.profile",
      "the clearance of the flanks has no minimum between their ends: profiles that conform too "
      "closely, or diameters that do not fit"};
}

}  // namespace prs
