#include "prs/configurations/configurations.h"

#include <algorithm>

#include "prs/configurations/complete_screw.h"
#include "prs/model/check_case.h"
#include "prs/threads/geometry_warnings.h"
#include "prs/threads/threads.h"

namespace prs {
namespace {

constexpr int kFewestStarts = 3, kMostStarts = 10;
constexpr int kMostRollerStarts = 3;

/// Rolling diameters by the starts; without sense where `too_few_starts`.
PerPart<double> rolling_diameters(const Mechanism& m, double screw_diameter) {
  const contact::PitchRadii radii = contact::matched_pitch_radii(
      threads_of(m).type, 0.5 * screw_diameter, m.starts.screw, m.starts.roller);
  return {screw_diameter, 2.0 * radii.roller, 2.0 * radii.nut};
}

bool too_few_starts(Mechanism::Type type, Mechanism::Starts starts) {
  return type == Mechanism::Type::standard && starts.screw <= 2 * starts.roller;
}

/// Threads along one and a half screw diameters, as a first proposal.
int proposed_contacts(double screw_diameter, double pitch) {
  return static_cast<int>(std::clamp(std::round(1.5 * screw_diameter / pitch), 5.0, 100.0));
}

Mechanism draft(const ConfigurationQuery& query, Mechanism::Type type, Mechanism::Starts starts) {
  Mechanism m;
  m.type = type;
  m.geometry = Mechanism::Geometry::design;
  m.lead = query.lead;
  m.starts = starts;
  m.flank_angle = {query.flank_angle, query.flank_angle, query.flank_angle};
  m.pitch_diameter.screw = query.screw_diameter;
  m.rollers = query.rollers.value_or(kFewestRollers);
  m.contacts_per_roller = proposed_contacts(query.screw_diameter, axial_pitch(m));
  return m;
}

void describe(Configuration& c, const Contacts& contacts, double gap) {
  const contact::MechanismGeometry& threads = contacts.threads;
  const PerPart<const contact::Thread*> thread{&threads.screw, &threads.roller, &threads.nut};
  for (const Part p : kParts) {
    c.pitch_diameter[p] = 2.0 * thread[p]->pitch_radius;
    c.lead[p] = thread[p]->lead;
    c.helix_angle[p] = contact::ThreadSurface(*thread[p]).helix_angle();
  }
  c.centre_distance = threads.centre_distance;
  c.gear_ratio = static_cast<double>(c.mechanism.starts.roller) / c.mechanism.starts.screw;
  const double crest = contact::flank_limits(threads.roller).largest;
  c.most_rollers = most_rollers(c.centre_distance, crest, gap);
}

void count_rollers(Configuration& c, const ConfigurationQuery& query, double crest) {
  c.mechanism.rollers = query.rollers.value_or(c.most_rollers);
  c.crest_gap = neighbour_gap(c.centre_distance, crest, c.mechanism.rollers);
  for (int n = kFewestRollers; n <= c.most_rollers; ++n)
    if (go_in_alike(c.mechanism.starts, n)) c.alike.push_back(n);
  c.gears = gear_pairs(c.mechanism.type, c.mechanism.starts, c.centre_distance, c.mechanism.rollers,
                       query.gap);
}

/// What `prs check` would say of the mechanism, the first of it; empty where nothing.
std::string first_warning(const Mechanism& mechanism, const Contacts& contacts) {
  Case c;
  c.mechanism = mechanism;
  for (const Problem& problem : check_case(c)) return problem.text();
  for (const Warning& warning : geometry_warnings(c, contacts, {})) return sentence(warning);
  return {};
}

/// Why starts are left out; no reason where they are not.
struct Verdict {
  std::string reason = {}, detail = {};
};

/// The mechanism with these starts, in `c`.
Verdict try_starts(const ConfigurationQuery& query, Mechanism::Type type, Mechanism::Starts starts,
                   Configuration& c) {
  if (too_few_starts(type, starts))
    return {
        "roller and nut can only have the same helix angle with more than two screw starts for "
        "each roller start"};
  c.mechanism = draft(query, type, starts);
  c.rolling_diameter = rolling_diameters(c.mechanism, query.screw_diameter);
  if (c.rolling_diameter.roller > query.screw_diameter * (1.0 + 1e-9))
    return {"the rollers would be thicker than the screw"};
  const double arc = query.roller_profile_radius.value_or(0.5 * c.rolling_diameter.roller /
                                                          std::sin(query.flank_angle));
  c.mechanism.profile.roller = {Profile::Shape::convex, arc};

  Contacts contacts;
  const std::string no_contact = "the threads have no sound contact without backlash";
  try {
    contacts = find_contacts(c.mechanism, Materials{kSteel, kSteel, kSteel});
  } catch (const CaseError& error) {
    return {no_contact, error.what()};
  }
  for (const Interface i : kInterfaces)
    if (!contacts.interfaces[i].has_hertz()) return {no_contact, failure(contacts, i).message};
  describe(c, contacts, query.gap);
  if (c.most_rollers < kFewestRollers) return {"fewer than three rollers fit"};
  if (query.rollers && *query.rollers > c.most_rollers)
    return {fmt::format("{} rollers do not fit, at most {}", *query.rollers, c.most_rollers)};
  count_rollers(c, query, contact::flank_limits(contacts.threads.roller).largest);
  c.moderate_force = moderate_force(c.mechanism, contacts);
  const std::string warning = first_warning(c.mechanism, contacts);
  return warning.empty() ? Verdict{} : Verdict{"the geometry is unusual", warning};
}

struct Span {
  int first, last;
};

Span span(const std::optional<int>& given, int first, int last) {
  return given ? Span{*given, *given} : Span{first, last};
}

}  // namespace

Configurations configurations(const ConfigurationQuery& query) {
  Configurations all;
  const Span screw = span(query.screw_starts, kFewestStarts, kMostStarts);
  const Span roller = span(query.roller_starts, 1, kMostRollerStarts);
  for (const Mechanism::Type type : {Mechanism::Type::standard, Mechanism::Type::inverted}) {
    if (query.type && *query.type != type) continue;
    for (int n_r = roller.first; n_r <= roller.last; ++n_r)
      for (int n_s = screw.first; n_s <= screw.last; ++n_s) {
        Configuration c;
        const Verdict verdict = try_starts(query, type, {n_s, n_r}, c);
        if (verdict.reason.empty())
          all.found.push_back(std::move(c));
        else
          all.left_out.push_back({type, {n_s, n_r}, verdict.reason, verdict.detail});
      }
  }
  return all;
}

}  // namespace prs
