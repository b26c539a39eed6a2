#include "prs/threads/threads.h"

#include <algorithm>

#include "prs/threads/contacts.h"

namespace prs {
namespace {

[[noreturn]] void throw_design_error(const contact::DesignResult& design) {
  const auto no_contact = [&](const contact::InterfaceGeometry& geometry, Interface i) {
    const Problem failure = why_no_contact(design.mechanism, geometry, contact::HertzStatus::not_computed, i);
    throw CaseError(failure.path, fmt::format("the {} threads of a mechanism with the wanted backlash have no "
                                              "contact: {}; fix profiles, flank angles or the screw's diameter",
                                              label(i), failure.message));
  };
  switch (design.status) {
    case contact::DesignStatus::no_screw_contact:
      no_contact(design.contact.screw, Interface::screw);
      break;
    case contact::DesignStatus::no_nut_contact:
      no_contact(design.contact.nut, Interface::nut);
      break;
    case contact::DesignStatus::pitches_differ:
      throw CaseError("mechanism.pitch", "backlash has no meaning where pitches differ; leave `pitch` out of a design");
    case contact::DesignStatus::too_few_screw_starts:
      throw CaseError("mechanism.starts", "a standard screw needs more than two screw starts for each roller start");
    default:
      break;
  }
  throw CaseError("mechanism.backlash",
                  fmt::format("no mechanism with this screw has the wanted backlash ({}); fix the "
                              "backlash, profiles or the screw's diameter",
                              contact::name(design.status)));
}

bool has_heights(const contact::Thread& t) { return t.addendum && t.dedendum; }

double crest_radius(const contact::Thread& t) {
  return t.internal ? t.pitch_radius - *t.addendum : t.pitch_radius + *t.addendum;
}

double root_radius(const contact::Thread& t) {
  return t.internal ? t.pitch_radius + *t.dedendum : t.pitch_radius - *t.dedendum;
}

/// Half the groove of the material at a radius, phi in Yao 2023, (2) to (4) [m].
std::optional<double> half_groove(const contact::ThreadSurface& s, double radius) {
  if (!s.exists_at(radius)) return std::nullopt;
  const double f = s.profile(radius).height;
  return s.side > 0.0 ? f : 0.5 * s.pitch - f;
}

std::optional<double> width(const contact::ThreadSurface& s, double radius) {
  const std::optional<double> groove = half_groove(s, radius);
  return groove ? std::optional(s.pitch - 2.0 * *groove) : std::nullopt;
}

/// Distance from the edge of a crest to the flank of the other part at that part's radius [m].
std::optional<double> crest_clearance(const contact::Thread& crest, const contact::Thread& flank,
                                      double radius_on_flank) {
  const std::optional<double> thread = width(contact::ThreadSurface(crest), crest_radius(crest));
  const std::optional<double> groove = half_groove(contact::ThreadSurface(flank), radius_on_flank);
  return thread && groove ? std::optional(*groove - 0.5 * *thread) : std::nullopt;
}

double pitch_error(const PitchError& e, int k, int contacts) {
  double error = contacts > 1 ? e.linear * k / (contacts - 1) : 0.0;
  if (const auto& wave = e.periodic)
    error += wave->amplitude * std::sin(2.0 * std::numbers::pi * k / wave->period + wave->phase);
  if (!e.list.empty()) error += e.list[static_cast<std::size_t>(k)];
  return error;
}

/// Drop of the roller's pitch radius at a contact [m].
double roller_drop(const Deviations& d, int k, int contacts) {
  const double middle = 0.5 * (contacts - 1);
  double drop = contacts > 1 ? d.crowning * std::pow((k - middle) / middle, 2) : 0.0;
  if (d.end_relief) {
    const int from_end = std::min(k, contacts - 1 - k);
    drop += d.end_relief->drop * std::max(0.0, 1.0 - static_cast<double>(from_end) / d.end_relief->threads);
  }
  return drop;
}

}  // namespace

Mechanism resolved(const Mechanism& m) {
  if (m.geometry == Mechanism::Geometry::simulation) return m;
  const contact::DesignResult design =
      contact::design_by_backlash(threads_of(m), m.starts.screw, m.starts.roller, {m.backlash.screw, m.backlash.nut});
  if (!design.ok()) throw_design_error(design);
  Mechanism designed = m;
  designed.pitch_diameter.screw = 2.0 * design.mechanism.screw.pitch_radius;
  designed.pitch_diameter.roller = 2.0 * design.mechanism.roller.pitch_radius;
  designed.pitch_diameter.nut = 2.0 * design.mechanism.nut.pitch_radius;
  designed.centre_distance = design.mechanism.centre_distance;
  return designed;
}

std::optional<ThreadWidths> thread_widths(const contact::Thread& thread) {
  if (!has_heights(thread)) return std::nullopt;
  const contact::ThreadSurface surface(thread);
  return ThreadWidths{width(surface, crest_radius(thread)), width(surface, root_radius(thread))};
}

std::optional<ThreadClearance> thread_clearance(const contact::MechanismGeometry& threads, Interface interface,
                                                const contact::ContactPoint& point) {
  const contact::Thread& body = interface == Interface::screw ? threads.screw : threads.nut;
  const contact::Thread& roller = threads.roller;
  if (!point.ok() || !has_heights(body) || !has_heights(roller) || !contact::same_pitch(body, roller))
    return std::nullopt;
  // The roller is outside the screw and inside the nut.
  const double towards_body = interface == Interface::screw ? -1.0 : 1.0;
  const double c = threads.centre_distance;
  return ThreadClearance{
      .flank = 0.5 * point.backlash,
      .body_crest = crest_clearance(body, roller, towards_body * (crest_radius(body) - c)),
      .roller_crest = crest_clearance(roller, body, c + towards_body * crest_radius(roller)),
  };
}

ThreadOffsets thread_offsets(const Mechanism& m, const Deviations& d, const Materials& materials, Part part) {
  const int contacts = m.contacts_per_roller;
  const double nominal = axial_pitch(m);
  const double rise = d.temperature ? (*d.temperature)[part] - d.reference_temperature : 0.0;
  const double strain = materials[part].thermal_expansion.value_or(0.0) * rise;
  const double lag = axial_pitches(m)[part] - nominal + strain * nominal;
  const double radius = 0.5 * m.pitch_diameter[part].value();
  ThreadOffsets o;
  for (int k = 0; k < contacts; ++k) {
    o.axial.push_back(k * lag + pitch_error(d.pitch_error[part], k, contacts));
    o.radial.push_back(strain * radius);
    if (part == Part::roller) o.radial.back() += 0.5 * d.roller_diameter - roller_drop(d, k, contacts);
  }
  return o;
}

std::vector<double> gaps_between(const ThreadOffsets& body, const ThreadOffsets& roller, Interface i,
                                 double normal_angle, Direction direction) {
  // The screw pushes the roller, the roller the nut; a larger nut opens the gap.
  const double ahead = i == Interface::screw ? 1.0 : -1.0;
  std::vector<double> gaps;
  for (std::size_t k = 0; k < body.axial.size(); ++k)
    gaps.push_back(-sense(direction) * std::cos(normal_angle) * ahead * (body.axial[k] - roller.axial[k]) -
                   std::sin(normal_angle) * (roller.radial[k] + ahead * body.radial[k]));
  return gaps;
}

bool deviates(const Mechanism& m, const Deviations& d) {
  if (d.roller_diameter != 0.0 || d.crowning != 0.0 || d.end_relief || d.temperature) return true;
  for (const Part part : kParts) {
    const PitchError& e = d.pitch_error[part];
    if (m.pitch[part] || e.linear != 0.0 || e.periodic || !e.list.empty()) return true;
  }
  return false;
}

PerInterface<std::vector<double>> initial_gaps(const Mechanism& mechanism, const Deviations& deviations,
                                               const Materials& materials, const PerInterface<double>& normal_angle,
                                               Direction direction) {
  const ThreadOffsets roller = thread_offsets(mechanism, deviations, materials, Part::roller);
  PerInterface<std::vector<double>> gaps;
  for (const Interface i : kInterfaces) {
    gaps[i] = gaps_between(thread_offsets(mechanism, deviations, materials, body_of(i)), roller, i, normal_angle[i],
                           direction);
    const double closest = *std::min_element(gaps[i].begin(), gaps[i].end());
    for (double& gap : gaps[i]) gap -= closest;
  }
  return gaps;
}

}  // namespace prs
