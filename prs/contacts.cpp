#include "prs/contacts.h"

#include <fmt/format.h>

#include <cmath>

#include "prs/threads.h"

namespace prs {
namespace {

constexpr double kMillimetre = 1e-3;

/// Interference below this is the rounding of the input [m].
constexpr double kInterference = 1e-9;

/// Gear ratios that differ by less are those of a sound mechanism with rounded diameters.
constexpr double kGearRatioTolerance = 1e-6;

/// A smallest relative curvature below this share of the roller's is a nearly conforming contact.
constexpr double kConformity = 0.01;

contact::Elasticity elasticity(const Material& m) { return {m.youngs_modulus, m.poisson_ratio}; }

void add_hertz(InterfaceContact& c, const Material& body, const Material& roller) {
  c.contact_modulus = contact::contact_modulus(elasticity(body), elasticity(roller));
  c.hertz = contact::hertz_constants(c.geometry.relative.first, c.geometry.relative.second,
                                     c.contact_modulus);
  // Both bodies carry the same pressure; the larger shear stress is that of the smaller nu.
  if (c.hertz.ok())
    c.shear = contact::largest_subsurface_shear(c.hertz.ellipticity,
                                                std::min(body.poisson_ratio, roller.poisson_ratio));
}

bool same_pitch(const contact::Thread& a, const contact::Thread& b) { return a.pitch == b.pitch; }

/// From the crest of the body's flank to the roller's crest on the line of centres [m]; < 0 where
/// they overlap.
double radial_distance_between_flanks(const contact::ThreadPair& pair, Interface i) {
  return i == Interface::screw
             ? pair.centre_distance - pair.body.largest_radius - pair.roller.largest_radius
             : pair.body.smallest_radius - pair.roller.largest_radius - pair.centre_distance;
}

void warn_of_missing_contacts(const Contacts& c, std::vector<std::string>& warnings) {
  for (const Interface i : kInterfaces) {
    const InterfaceContact& contact = c.interfaces[i];
    const bool wants_hertz = contact.geometry.ok() && contact.contact_modulus > 0.0;
    if (!contact.geometry.ok() || (wants_hertz && !contact.hertz.ok()))
      warnings.push_back(fmt::format(
          "the {} threads give no Hertz contact ({}): ellipses and pressures are absent", label(i),
          failure(c, i)));
  }
}

void warn_of_interference(const Contacts& c, std::vector<std::string>& warnings) {
  for (const Interface i : kInterfaces) {
    const contact::ContactPoint& point = c.interfaces[i].geometry.point;
    const contact::Thread& body = i == Interface::screw ? c.threads.screw : c.threads.nut;
    if (point.ok() && same_pitch(body, c.threads.roller) && point.backlash < -kInterference)
      warnings.push_back(fmt::format("the {} threads interfere: backlash {:.4f} mm", label(i),
                                     point.backlash / kMillimetre));
  }
}

void warn_of_conformity(const Contacts& c, std::vector<std::string>& warnings) {
  for (const Interface i : kInterfaces) {
    const contact::InterfaceGeometry& g = c.interfaces[i].geometry;
    if (g.ok() && g.openness() < kConformity)
      warnings.push_back(fmt::format(
          "the {} contact is closely conforming: its smallest relative curvature is {:.2g} of the "
          "roller's, and Hertz's half-spaces lose their meaning",
          label(i), g.openness()));
  }
}

void warn_of_kinematics(const Contacts& c, std::vector<std::string>& warnings) {
  const contact::KinematicConsistency k = contact::kinematic_consistency(c.threads);
  if (k.lead_difference != 0.0)
    warnings.push_back(fmt::format("the leads of nut and screw differ by {:.6f} mm",
                                   k.lead_difference / kMillimetre));
  if (std::abs(k.gear_ratio / k.gear_ratio_by_leads - 1.0) > kGearRatioTolerance)
    warnings.push_back(fmt::format(
        "the rollers migrate: the pitch diameters give the gear ratio {:.6f}, the leads ask for "
        "{:.6f} (Sandu 2018, (2.14))",
        k.gear_ratio, k.gear_ratio_by_leads));
}

void warn_of_threads(const Contacts& c, std::vector<std::string>& warnings) {
  const auto warn = [&](const contact::Thread& thread, const char* part) {
    const contact::ThreadStatus status = contact::check(thread);
    if (status != contact::ThreadStatus::ok)
      warnings.push_back(fmt::format("thread of the {}: {}", part, contact::name(status)));
  };
  warn(c.threads.screw, "screw");
  warn(c.threads.roller, "roller");
  warn(c.threads.nut, "nut");
}

void warn_of_crowding(const Contacts& c, std::vector<std::string>& warnings) {
  const int most = contact::largest_roller_count(c.threads);
  if (c.mechanism.rollers > most)
    warnings.push_back(fmt::format("{} rollers touch each other at their crests: {} fit",
                                   c.mechanism.rollers, most));
}

}  // namespace

const char* label(Interface i) { return i == Interface::screw ? "roller-screw" : "roller-nut"; }

contact::ThreadPair pair_of(const contact::MechanismGeometry& threads, Interface i) {
  return i == Interface::screw ? contact::screw_pair(threads) : contact::nut_pair(threads);
}

Contacts find_contacts(const Mechanism& mechanism, const std::optional<Materials>& materials) {
  Contacts c;
  c.mechanism = resolved(mechanism);
  c.threads = threads_of(c.mechanism);
  const contact::MechanismContact geometry =
      contact::mechanism_contact(c.threads, contact::Configuration::i1_j2);
  c.interfaces.screw.geometry = geometry.screw;
  c.interfaces.nut.geometry = geometry.nut;
  for (const Interface i : kInterfaces)
    if (materials && c.interfaces[i].geometry.ok())
      add_hertz(c.interfaces[i], (*materials)[body_of(i)], materials->roller);
  warn_of_missing_contacts(c, c.warnings);
  warn_of_threads(c, c.warnings);
  warn_of_crowding(c, c.warnings);
  warn_of_kinematics(c, c.warnings);
  warn_of_interference(c, c.warnings);
  warn_of_conformity(c, c.warnings);
  return c;
}

std::string failure(const Contacts& contacts, Interface i) {
  const InterfaceContact& c = contacts.interfaces[i];
  const contact::ContactPoint& point = c.geometry.point;
  if (point.ok()) return std::string(contact::name(c.hertz.status));
  const std::string_view body = name(i);
  std::string text(contact::name(point.status));
  const char* separator = ": ";
  for (const contact::FlankViolation& v : point.violations) {
    text += fmt::format("{}{:.4f} mm beyond the {} of the {}", separator, v.by / kMillimetre,
                        contact::name(v.end), v.of_roller ? "roller" : body);
    separator = ", ";
  }
  if (point.status == contact::ContactPointStatus::out_of_reach) {
    const contact::ThreadPair pair = pair_of(contacts.threads, i);
    const double between = radial_distance_between_flanks(pair, i);
    text += fmt::format(": the flanks of {} and roller {} by {:.4f} mm", body,
                        between > 0.0 ? "miss each other" : "pass each other",
                        std::abs(between) / kMillimetre);
  }
  return text;
}

}  // namespace prs
