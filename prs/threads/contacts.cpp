#include "prs/threads/contacts.h"

#include <algorithm>

#include "prs/model/groove.h"

namespace prs {
namespace {

/// Largest interference that counts as rounding of the input [m].
constexpr double kInterference = 1e-9;

/// Interference, as a share of the pitch, of nominal diameters: pitch cylinders that touch leave no room for the
/// helices. Published screws have 4 to 9.7 %.
constexpr double kTouchingInterference = 0.1;

/// Smallest relative curvature, as a share of the roller's, below which a contact counts as nearly conforming.
constexpr double kConformity = 0.01;

void add_hertz(InterfaceContact& c, const Material& body, const Material& roller, Detail detail) {
  c.contact_modulus = contact::contact_modulus(body, roller);
  c.pressure_limit = static_pressure_limit(body, roller);
  c.hertz = contact::hertz_constants(c.geometry.relative.first, c.geometry.relative.second, c.contact_modulus);
  if (!c.hertz.ok() || detail != Detail::complete) return;
  // Both bodies carry the same pressure; the larger stresses are those of the smaller nu.
  const double poisson_ratio = std::min(body.poisson_ratio, roller.poisson_ratio);
  c.shear = contact::largest_subsurface_shear(c.hertz.ellipticity, poisson_ratio);
  c.von_mises = contact::largest_subsurface_von_mises(c.hertz.ellipticity, poisson_ratio);
}

void warn_of_missing_contacts(const Contacts& c, std::vector<Warning>& warnings) {
  for (const Interface i : kInterfaces) {
    const InterfaceContact& contact = c.interfaces[i];
    const bool wants_hertz = contact.geometry.ok() && contact.contact_modulus > 0.0;
    if (!contact.geometry.ok() || (wants_hertz && !contact.hertz.ok()))
      warnings.push_back({failure(c, i).path, fmt::format("{}_without_hertz_contact", name(i)),
                          fmt::format("the {} threads give no Hertz contact ({}): ellipses and pressures are absent",
                                      label(i), failure(c, i).message)});
  }
}

void warn_of_interference(const Contacts& c, std::vector<Warning>& warnings) {
  for (const Interface i : kInterfaces) {
    const contact::ContactPoint& point = c.interfaces[i].geometry.point;
    const contact::Thread& body = i == Interface::screw ? c.threads.screw : c.threads.nut;
    if (!point.ok() || !contact::same_pitch(body, c.threads.roller) || point.backlash >= -kInterference) continue;
    const bool stated = c.mechanism.geometry == Mechanism::Geometry::design;
    const std::string_view part = name(body_of(i));
    Warning warning = Warning{fmt::format("{}.{}", stated ? "mechanism.backlash" : "mechanism.pitch_diameter", part),
                              "interference", fmt::format("the {} threads interfere: backlash {{value}}", label(i))}
                          .with(point.backlash, {}, "mm"_unit, Warning::Worse::smaller);
    const double share = -point.backlash / body.pitch;
    if (share > kTouchingInterference) {
      warning.what += fmt::format(", {:.0f} % of the pitch: pitch cylinders that touch give up to {:.0f} %",
                                  share * "%"_per_si, kTouchingInterference * "%"_per_si);
      warning.fix = stated ? "write a backlash of 0 or more, and `preload` for oversized rollers"
                           : "check pitch diameters, centre distance and thread thickness";
    }
    warnings.push_back(std::move(warning));
  }
}

void warn_of_conformity(const Contacts& c, std::vector<Warning>& warnings) {
  for (const Interface i : kInterfaces) {
    const contact::InterfaceGeometry& g = c.interfaces[i].geometry;
    if (g.ok() && g.openness() < kConformity)
      warnings.push_back(Warning{"mechanism.profile", fmt::format("{}_conformity", name(i)),
                                 fmt::format("the {} contact is closely conforming: its smallest relative "
                                             "curvature is {{value}} of the roller's, and Hertz's half-spaces "
                                             "lose their meaning",
                                             label(i))}
                             .with(g.openness(), kConformity, {}, Warning::Worse::smaller));
  }
}

void warn_of_kinematics(const Contacts& c, std::vector<Warning>& warnings) {
  const contact::KinematicConsistency k = contact::kinematic_consistency(c.threads);
  if (std::abs(k.lead_difference) > contact::kSamePitch * std::abs(c.threads.screw.lead))
    warnings.push_back(
        Warning{"mechanism.pitch", "lead_difference", "the leads of nut and screw differ by {value}"}.with(
            k.lead_difference, {}, "mm"_unit));
  if (!has_gear_ratio(c))
    warnings.push_back(Warning{"mechanism.pitch_diameter", "gear_ratio",
                               "the pitch diameters give the gear ratio {value}, the gears by their teeth n_R/n_S = "
                               "{limit}: pitch cylinders slide on each other (Sandu 2018, (2.14))"}
                           .with(k.gear_ratio, gear_ratio(c.mechanism)));
  const PerPart<double> pitch = axial_pitches(c.mechanism);
  const Part geared = carrier_part(c.mechanism.type);
  if (!contact::is_grooved(c.mechanism.type) && pitch.roller != pitch[geared])
    warnings.push_back(Warning{"mechanism.pitch", "migration",
                               fmt::format("the rollers migrate along the {}: their pitch of {{value}} is not its "
                                           "{{limit}}; `slip` has the way per turn",
                                           name(geared))}
                           .with(pitch.roller, pitch[geared], "mm"_unit));
}

void require_thickness(const Mechanism& m, Part part) {
  if (!m.thread[part] || !m.thread[part]->thickness) return;
  const double thickness = *m.thread[part]->thickness;
  const double pitch = m.pitch[part].value_or(axial_pitch(m));
  if (thickness < pitch) return;
  throw CaseError(fmt::format("mechanism.thread.{}.thickness", name(part)),
                  fmt::format("got {:.6g} mm; expected less than the axial pitch of {:.6g} mm, which thread and "
                              "groove share; change it, or leave it out for half a pitch",
                              thickness * "mm"_per_si, pitch * "mm"_per_si));
}

/// Reason why a thread is impossible, if it is.
std::optional<Problem> thread_failure(const contact::Thread& thread, Part part) {
  const contact::RadiusLimits flank = contact::flank_limits(thread);
  const std::string path =
      thread.addendum || thread.dedendum ? fmt::format("mechanism.thread.{}", name(part)) : "mechanism.flank_angle";
  const contact::ThreadStatus status = contact::check(thread);
  if (status == contact::ThreadStatus::ok || status == contact::ThreadStatus::beyond_sharp_limit) {
    if (flank.smallest < flank.largest) return std::nullopt;
    return Problem{path, fmt::format("the flanks of the {} have no height", name(part))};
  }
  return Problem{path, fmt::format("the flanks of the {} would reach from {:.4f} to {:.4f} mm radius, around a "
                                   "pitch radius of {:.4f} mm ({})",
                                   name(part), flank.smallest * "mm"_per_si, flank.largest * "mm"_per_si,
                                   thread.pitch_radius * "mm"_per_si, contact::name(status))};
}

void warn_of_heights(const contact::Thread& thread, Part part, std::vector<Warning>& warnings) {
  if (contact::check(thread) != contact::ThreadStatus::beyond_sharp_limit) return;
  const contact::RadiusLimits given = contact::flank_limits(thread);
  const contact::RadiusLimits sharp = contact::sharp_limits(thread);
  warnings.push_back({fmt::format("mechanism.thread.{}", name(part)), "beyond_sharp_thread",
                      fmt::format("the thread of the {} is given from {{{:.4f} mm}} to {{{:.4f} mm}} radius, its "
                                  "flanks meet at {{{:.4f} mm}} and {{{:.4f} mm}}",
                                  name(part), given.smallest * "mm"_per_si, given.largest * "mm"_per_si,
                                  sharp.smallest * "mm"_per_si, sharp.largest * "mm"_per_si)});
}

/// Warns of rollers that clear each other only if their crests, which are not stated, are lower than where the flanks
/// meet.
void warn_of_crowding(const Contacts& c, std::vector<Warning>& warnings) {
  const int most = contact::largest_roller_count(c.threads);
  if (c.mechanism.rollers <= most) return;
  const bool stated = c.mechanism.thread.roller.has_value();
  warnings.push_back(Warning{"mechanism.rollers", "crowded_rollers",
                             stated ? "{value} rollers touch each other at their crests: {limit} fit"
                                    : "{value} rollers touch each other at crests where the flanks meet: {limit} fit",
                             stated ? "take fewer" : "state `mechanism.thread.roller`"}
                         .with(c.mechanism.rollers, most));
}

void warn(Contacts& c) {
  for (const Part p : kParts) warn_of_heights(thread_of(c.threads, p), p, c.warnings);
  warn_of_missing_contacts(c, c.warnings);
  warn_of_crowding(c, c.warnings);
  warn_of_kinematics(c, c.warnings);
  warn_of_interference(c, c.warnings);
  warn_of_conformity(c, c.warnings);
}

/// Distance of the crest of the body's flank from the roller's crest on the line of centres [m]; < 0 if they overlap.
double distance_of_crests(const contact::ThreadPair& pair, Interface i) {
  return i == Interface::screw ? pair.centre_distance - pair.body.largest_radius - pair.roller.largest_radius
                               : pair.body.smallest_radius - pair.roller.largest_radius - pair.centre_distance;
}

std::string off_the_flanks(const contact::FlankViolations& violations, Interface i) {
  std::string text = "the contact point lies ";
  const char* separator = "";
  for (const contact::FlankViolation& v : violations) {
    text += fmt::format("{}{:.4f} mm beyond the {} of the {}", separator, v.by * "mm"_per_si, contact::name(v.end),
                        v.of_roller ? "roller" : name(i));
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

void require(const Contacts& contacts, const PerInterface<bool>& lacks, std::string_view fix) {
  std::string path, message;
  for (const Interface i : kInterfaces) {
    if (!lacks[i]) continue;
    const Problem why = failure(contacts, i);
    if (path.empty()) path = why.path;
    message += fmt::format("the {} threads give no Hertz contact: {}; ", label(i), why.message);
  }
  if (!path.empty()) throw CaseError(path, message.append(fix));
}

}  // namespace

Contacts find_contacts(const Mechanism& mechanism, const std::optional<Materials>& materials, Detail detail) {
  for (const Part p : kParts) require_thickness(mechanism, p);
  Contacts c;
  c.mechanism = resolved(mechanism);
  c.threads = threads_of(c.mechanism);
  for (const Part p : kParts) c.bad_threads[p] = thread_failure(thread_of(c.threads, p), p);
  const contact::MechanismContact geometry = contact::mechanism_contact(c.threads, contact::Configuration::i1_j2);
  const auto sound = [&](Interface i) { return !c.bad_threads.roller && !c.bad_threads[body_of(i)]; };
  if (sound(Interface::screw)) c.interfaces.screw.geometry = geometry.screw;
  if (sound(Interface::nut)) c.interfaces.nut.geometry = geometry.nut;
  for (const Interface i : kInterfaces)
    if (materials && c.interfaces[i].geometry.ok())
      add_hertz(c.interfaces[i], (*materials)[body_of(i)], materials->roller, detail);
  for (const Interface i : kInterfaces)
    c.interfaces[i].clearance = thread_clearance(c.threads, i, c.interfaces[i].geometry.point);
  if (detail == Detail::complete) warn(c);
  return c;
}

bool has_gear_ratio(const Contacts& c) {
  return std::abs(contact::kinematic_consistency(c.threads).gear_ratio / gear_ratio(c.mechanism) - 1.0) <=
         kGearRatioTolerance;
}

const contact::Thread& thread_of(const contact::MechanismGeometry& threads, Part part) {
  return part == Part::screw ? threads.screw : part == Part::roller ? threads.roller : threads.nut;
}

Problem failure(const Contacts& contacts, Interface i) {
  for (const Part p : {Part::roller, body_of(i)})
    if (contacts.bad_threads[p]) return *contacts.bad_threads[p];
  const InterfaceContact& c = contacts.interfaces[i];
  return why_no_contact(contacts.threads, c.geometry, c.hertz.status, i);
}

const char* label(Interface i) { return i == Interface::screw ? "roller-screw" : "roller-nut"; }

contact::ThreadPair pair_of(const contact::MechanismGeometry& threads, Interface i) {
  return i == Interface::screw ? contact::screw_pair(threads) : contact::nut_pair(threads);
}

Problem why_no_contact(const contact::MechanismGeometry& threads, const contact::InterfaceGeometry& geometry,
                       contact::HertzStatus hertz, Interface i) {
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
                          distance > 0.0 ? "miss each other" : "overlap", std::abs(distance) * "mm"_per_si)};
    }
    case Status::outside_flank:
      return {"mechanism.thread", off_the_flanks(point_beyond_flanks(pair_of(threads, i), geometry.point), i)};
    case Status::not_a_minimum:
      return {"mechanism.profile", "the surfaces cut each other where their slopes agree"};
    case Status::not_converged:
    case Status::not_computed:
      break;
  }
  return {"mechanism.profile",
          "the clearance of the flanks has no minimum between their ends: profiles that conform too "
          "closely, or diameters that do not fit"};
}

void require_contacts(const Conditions& c, const Contacts& contacts) {
  PerInterface<bool> lacks;
  for (const Interface i : kInterfaces) {
    const InterfaceContact& contact = contacts.interfaces[i];
    lacks[i] = !contact.geometry.ok() || (c.materials && !contact.hertz.ok());
  }
  require(contacts, lacks, "fix profiles, flank angles or diameters");
}

ContactLaw contact_law(const ContactOverrides& overrides, const InterfaceContact& contact, Interface i) {
  return {overrides.hertz_constant[i].value_or(contact.hertz.hertz_constant),
          overrides.normal_angle[i] ? *overrides.normal_angle[i] : contact.normal_angle()};
}

PerInterface<ContactLaw> contact_laws(const Conditions& c, const Contacts& contacts) {
  PerInterface<bool> lacks;
  for (const Interface i : kInterfaces)
    lacks[i] = !contacts.interfaces[i].has_hertz() && !(c.contact.hertz_constant[i] && c.contact.normal_angle[i]);
  require(contacts, lacks,
          "fix profiles, flank angles or diameters, or give both "
          "contact.hertz_constant and contact.normal_angle of the interface");
  PerInterface<ContactLaw> laws;
  for (const Interface i : kInterfaces) laws[i] = contact_law(c.contact, contacts.interfaces[i], i);
  if (c.structure && c.model.tooth_compliance.kind == ModelOptions::ToothCompliance::Kind::yamamoto) {
    const PerInterface<double> teeth =
        yamamoto_compliance(contacts.mechanism, *c.structure, *c.materials,
                            {laws.screw.normal_angle, laws.nut.normal_angle}, c.model.tooth_compliance.width);
    for (const Interface i : kInterfaces) laws[i].compliance = teeth[i];
  }
  return laws;
}

ToothDeflection yamamoto_deflection(const ToothSection& t, const Material& m, double diameter,
                                    double nut_outer_diameter) {
  using std::numbers::pi;
  const double a = t.root_width, b = t.pitch_width, c = t.height, p = t.pitch;
  const double tangent = std::tan(t.flank_angle);
  const double e = m.youngs_modulus, nu = m.poisson_ratio;
  const double plane = (1.0 - nu * nu) / e;
  const double slope = 1.0 - std::pow(2.0 - b / a, 2) + 2.0 * std::log(a / b);
  const double outer = nut_outer_diameter * nut_outer_diameter, inner = diameter * diameter;
  ToothDeflection d;
  d.bending = 0.75 * plane * (slope / std::pow(tangent, 3) - 4.0 * c * c / (a * a) * tangent);
  d.shear = 1.2 * (1.0 + nu) / e / tangent * std::log(a / b);
  d.root_inclination = 12.0 * plane * c / (pi * a * a) * (c - 0.5 * b * tangent);
  d.root_shear = 2.0 * plane / pi *
                 (p / a * std::log((p + 0.5 * a) / (p - 0.5 * a)) + 0.5 * std::log(4.0 * p * p / (a * a) - 1.0));
  const double ring = nut_outer_diameter > 0.0 ? (outer + inner) / (outer - inner) + nu : 1.0 - nu;
  d.radial = 0.5 / e * diameter / p * tangent * tangent * ring;
  return d;
}

ToothSection tooth_section(const Mechanism& m, Part part) {
  const double flank = m.flank_angle[part], pitch = axial_pitch(m);
  // The flank's normal leaves the axis by the flank angle.
  const double height =
      m.thread[part] ? m.thread[part]->dedendum : default_groove(part == Part::nut, pitch, 0.0, flank, flank).dedendum;
  const double width = m.thread[part] ? m.thread[part]->thickness.value_or(0.5 * pitch) : 0.5 * pitch;
  return {width + 2.0 * height * std::tan(flank), width, height, flank, pitch};
}

PerInterface<double> yamamoto_compliance(const Mechanism& m, const Structure& structure, const Materials& materials,
                                         const PerInterface<double>& normal_angle, double width) {
  const auto of = [&](Part part) {
    return yamamoto_deflection(tooth_section(m, part), materials[part], *m.pitch_diameter[part],
                               part == Part::nut ? structure.nut.outer_diameter : 0.0)
               .total() /
           width;
  };
  PerInterface<double> compliance;
  for (const Interface i : kInterfaces)
    compliance[i] = (of(body_of(i)) + of(Part::roller)) * std::pow(std::cos(normal_angle[i]), 2);
  return compliance;
}

}  // namespace prs
