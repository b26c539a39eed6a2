#include "prs/configurations/configurations.h"

#include <algorithm>
#include <tuple>

#include "prs/model/check_case.h"
#include "prs/model/groove.h"
#include "prs/model/quantity_text.h"
#include "prs/threads/geometry_warnings.h"

namespace prs {
namespace {

constexpr double kPressureAngle = std::numbers::pi / 9;
constexpr int kFewestTeeth = 12, kMostTeeth = 40;
constexpr double kMostShift = 1.0;
constexpr int kFewestContacts = 3;

/// ISO 54, and DIN 780-1 below 1 mm, from 0.2 to 10 mm [m].
constexpr double kSeries1[] = {0.2e-3,  0.25e-3, 0.3e-3, 0.4e-3, 0.5e-3, 0.6e-3, 0.7e-3, 0.8e-3, 0.9e-3, 1e-3,
                               1.25e-3, 1.5e-3,  2e-3,   2.5e-3, 3e-3,   4e-3,   5e-3,   6e-3,   8e-3,   10e-3};
constexpr double kSeries2[] = {0.22e-3, 0.28e-3, 0.35e-3,  0.45e-3,  0.55e-3, 0.65e-3, 0.75e-3,
                               0.85e-3, 0.95e-3, 1.125e-3, 1.375e-3, 1.75e-3, 2.25e-3, 2.75e-3,
                               3.5e-3,  4.5e-3,  5.5e-3,   7e-3,     9e-3};

double involute(double angle) { return std::tan(angle) - angle; }

/// z_body -+ z_roller, for an internal or an external pair.
int teeth_between(Mechanism::Type type, const GearPair& pair) {
  return pair.body_teeth + (carrier_part(type) == Part::nut ? -pair.roller_teeth : pair.roller_teeth);
}

/// Sets working pressure angle and profile shift; false if base circles do not let the gears mesh or the shift is too
/// large.
bool fit(Mechanism::Type type, double centre_distance, GearPair& pair) {
  const int teeth = teeth_between(type, pair);
  const double cosine = 0.5 * pair.module * teeth / centre_distance * std::cos(kPressureAngle);
  if (!(cosine < 1.0)) return false;
  pair.working_pressure_angle = std::acos(cosine);
  pair.profile_shift =
      teeth * (involute(pair.working_pressure_angle) - involute(kPressureAngle)) / (2.0 * std::tan(kPressureAngle));
  return std::abs(pair.profile_shift) <= kMostShift;
}

constexpr int kMostRollerStarts = 3;

/// Rolling diameter of the rollers by the starts, (1.52), (1.53); meaningless if `too_few_starts`. Rollers with grooves
/// are as thick as those of a standard screw of three starts.
double rolling_diameter(Mechanism::Type type, double screw_diameter, Mechanism::Starts starts) {
  const bool grooved = contact::is_grooved(type);
  if (grooved) starts = {3, 1};
  return 2.0 * contact::matched_pitch_radii(grooved ? Mechanism::Type::standard : type, 0.5 * screw_diameter,
                                            starts.screw, starts.roller)
                   .roller;
}

bool too_few_starts(Mechanism::Type type, Mechanism::Starts starts) {
  return starts.screw <= contact::facts_of(type).starts_over_diameters * starts.roller;
}

/// Least number of rollers that centre the screw and carry it.
int fewest_rollers(Mechanism::Type type) { return kFewestRollers + contact::facts_of(type).unloaded_rollers; }

/// Threads along one and a half screw diameters, as a first proposal.
int proposed_contacts(double screw_diameter, double pitch) {
  return static_cast<int>(std::clamp(std::round(1.5 * screw_diameter / pitch), 5.0, 100.0));
}

/// Diameter of the screw [m]: that whose nut has the outer diameter by rule, if it is given.
double screw_diameter_of(const ConfigurationQuery& query, Mechanism::Type type, Mechanism::Starts starts) {
  if (!query.nut_diameter) return query.screw_diameter;
  const double nut = (*query.nut_diameter - kNutDiameterOffset) / kNutDiameterSlope;
  return nut / (1.0 + 2.0 * rolling_diameter(type, 1.0, starts));
}

/// A mechanism with its fewest rollers and contacts and one flank angle; the rollers' diameter counts if they have
/// grooves.
Mechanism draft(Mechanism::Type type, double lead, Mechanism::Starts starts, double flank_angle, double screw_diameter,
                double roller_diameter) {
  Mechanism m;
  m.type = type;
  m.geometry = Mechanism::Geometry::design;
  m.lead = lead;
  m.starts = starts;
  m.flank_angle = {flank_angle, flank_angle, flank_angle};
  m.pitch_diameter.screw = screw_diameter;
  if (contact::is_grooved(type)) m.pitch_diameter.roller = roller_diameter;
  m.rollers = fewest_rollers(type);
  m.contacts_per_roller = kFewestContacts;
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
  c.gear_ratio = gear_ratio(contacts.mechanism);
  const double crest = contact::flank_limits(threads.roller).largest;
  c.most_rollers = most_rollers(c.centre_distance, crest, gap);
}

/// Free space between the outermost radii of neighbouring rollers, overlap < 0 [m]:
/// 2 c sin(pi/N) - 2 r (Sandu 2018, (1.45)).
double neighbour_gap(double centre_distance, double outer_radius, int rollers) {
  return 2.0 * (centre_distance * std::sin(std::numbers::pi / rollers) - outer_radius);
}

void count_rollers(Configuration& c, const ConfigurationQuery& query, double crest) {
  c.mechanism.rollers = query.rollers.value_or(c.most_rollers);
  c.crest_gap = neighbour_gap(c.centre_distance, crest, c.mechanism.rollers);
  for (int n = kFewestRollers; n <= c.most_rollers; ++n)
    if (go_in_alike(c.mechanism.starts, n)) c.alike.push_back(n);
  c.gears = gear_pairs(c.mechanism, c.centre_distance, query.gap);
}

/// First warning of `prs check` about the mechanism; empty if there is none.
std::string first_warning(const Mechanism& mechanism, const Contacts& contacts) {
  Case c;
  c.mechanism = mechanism;
  for (const Problem& problem : check_case(c)) return problem.text();
  for (const Warning& warning : geometry_warnings(c, contacts, {})) return sentence(warning);
  return {};
}

/// Reason why starts are left out; no reason if they are kept.
struct Verdict {
  std::string reason = {}, detail = {};
};

/// Tries the mechanism with these starts, and stores it in `c`.
Verdict try_starts(const ConfigurationQuery& query, Mechanism::Type type, Mechanism::Starts starts, Configuration& c) {
  if (contact::is_grooved(type) != (starts.roller == 0)) return {"its rollers have grooves, no starts"};
  if (too_few_starts(type, starts))
    return {
        "roller and nut can only have the same helix angle with more than two screw starts for "
        "each roller start"};
  const double screw = screw_diameter_of(query, type, starts), roller = rolling_diameter(type, screw, starts);
  c.mechanism = draft(type, query.lead, starts, query.flank_angle, screw, roller);
  c.mechanism.rollers = query.rollers.value_or(c.mechanism.rollers);
  c.mechanism.contacts_per_roller = proposed_contacts(screw, axial_pitch(c.mechanism));
  if (!(screw > 0.0)) return {"the nut is thinner than its wall"};
  c.rolling_diameter = {screw, roller, screw + 2.0 * roller};
  if (roller > screw * (1.0 + 1e-9)) return {"the rollers would be thicker than the screw"};
  const double arc = query.roller_profile_radius.value_or(0.5 * roller / std::sin(query.flank_angle));
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
  if (c.most_rollers < fewest_rollers(type)) return {fmt::format("fewer than {} rollers fit", fewest_rollers(type))};
  if (query.rollers && *query.rollers > c.most_rollers)
    return {fmt::format("{} rollers do not fit, at most {}", *query.rollers, c.most_rollers)};
  count_rollers(c, query, contact::flank_limits(contacts.threads.roller).largest);
  c.moderate_force = moderate_force(c.mechanism, contacts);
  c.greatest_speed = kGreatestSpeedTimesDiameter / screw;
  const std::string warning = first_warning(c.mechanism, contacts);
  if (!warning.empty()) return {"the geometry is unusual", warning};
  c.nut_diameter = query.nut_diameter;
  try {
    const CompleteScrew written = complete_screw(data_of(c));
    c.dynamic_capacity = required_capacity(written);
    c.outer_diameter = written.c.structure->nut.outer_diameter;
  } catch (const CaseError& error) {
    return {"no case can be written of it", fmt::format("{}: {}", error.path(), error.what())};
  }
  return {};
}

struct Span {
  int first, last;
};

Span span(const std::optional<int>& given, int first, int last) {
  return given ? Span{*given, *given} : Span{first, last};
}

}  // namespace

int most_rollers(double centre_distance, double outer_radius, double gap) {
  constexpr double kMost = 1000.0;
  const double ratio = (outer_radius + 0.5 * gap) / centre_distance;
  if (!(ratio < 1.0)) return 1;
  // Small tolerance, so that rollers that just fit count.
  return static_cast<int>(std::min(kMost, std::floor(std::numbers::pi / std::asin(ratio) * (1.0 + 1e-12))));
}

double indexing_angle(Mechanism::Type type, Mechanism::Starts starts, int rollers) {
  const int forward = starts.screw % rollers;
  const int steps = carrier_part(type) == Part::screw ? forward : (rollers - forward) % rollers;
  return 2.0 * std::numbers::pi / starts.roller * steps / rollers;
}

bool go_in_alike(Mechanism::Starts starts, int rollers) { return starts.screw % rollers == 0; }

std::vector<GearPair> gear_pairs(const Mechanism& m, double centre_distance, double gap) {
  std::vector<GearPair> pairs;
  const Mechanism::Starts starts = m.starts;
  if (starts.roller == 0) return pairs;
  const int first = (kFewestTeeth + starts.roller - 1) / starts.roller;
  for (int k = first; k * starts.roller <= kMostTeeth; ++k) {
    GearPair pair;
    pair.roller_teeth = k * starts.roller;
    pair.body_teeth = k * starts.screw;
    pair.tooth_misfit = axial_pitch(m) / k;
    const int teeth = teeth_between(m.type, pair);
    if (teeth <= 0) continue;
    const double pitch_radius = centre_distance * pair.roller_teeth / teeth;
    const auto try_series = [&](const auto& modules, int series) {
      for (const double module : modules) {
        pair.module = module;
        pair.series = series;
        if (!fit(m.type, centre_distance, pair)) continue;
        pair.most_rollers = std::min(m.rollers, most_rollers(centre_distance, pitch_radius + module, gap));
        pairs.push_back(pair);
      }
    };
    try_series(kSeries1, 1);
    try_series(kSeries2, 2);
  }
  std::ranges::stable_sort(pairs, {}, [](const GearPair& p) {
    return std::tuple(-p.most_rollers, p.series, std::round(10.0 * std::abs(p.profile_shift)), p.roller_teeth);
  });
  return pairs;
}

Configurations configurations(const ConfigurationQuery& query) {
  Configurations all;
  for (const Mechanism::Type type : contact::kMechanismTypes) {
    if (query.type ? *query.type != type : query.roller_starts && contact::is_grooved(type)) continue;
    const contact::TypeFacts& facts = contact::facts_of(type);
    const Span screw = span(query.screw_starts, facts.fewest_starts, facts.most_starts);
    const Span roller =
        contact::is_grooved(type) ? span(query.roller_starts, 0, 0) : span(query.roller_starts, 1, kMostRollerStarts);
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

namespace {

constexpr int kMostContacts = 10'000;
constexpr int kStartsLimit = 100, kMostUsualStarts = 10;
constexpr double kFinestPitch = 0.002, kUsualPitch = 0.1, kCoarsestPitch = 1.0;  // over d_R
constexpr double kThickestNut = 100.0;                                           // over d_N

/// Whether the rollers keep their place on the nut, or run along it: then it is as long as its threads need.
bool on_nut(const ScrewData& d) { return carrier_part(d.type) == Part::nut; }

double roller_diameter(const ScrewData& d, int starts) {
  return d.roller_diameter.value_or(rolling_diameter(d.type, d.screw_diameter, {starts, d.roller_starts}));
}

/// Whole number of threads along a length.
int contacts_over(double length, double pitch) { return static_cast<int>(std::lround(std::min(length / pitch, 1e9))); }

/// Threads of screw, rollers and nut, without their number of contacts.
struct Threads {
  Mechanism mechanism;
  std::optional<Contacts> contacts;  ///< Absent if nothing rolls.
  int most_rollers = 0;
  std::string reason = {};  ///< Reason why nothing rolls.
};

/// Reason why contacts cannot roll without play; empty if they can.
std::string obstacle(const Mechanism& m, std::optional<Contacts>& contacts) {
  try {
    contacts = find_contacts(m, Materials{kSteel, kSteel, kSteel}, Detail::numbers);
  } catch (const CaseError& error) {
    return error.what();
  }
  for (const Interface i : kInterfaces)
    if (!contacts->interfaces[i].has_hertz()) return failure(*contacts, i).message;
  return {};
}

/// Height as makers cut threads, but no more than 95 % of that of sharp ones. Crests are counted from the nominal
/// radius, as outer diameters of a catalogue are: without play the pitch line of one part lies up to 0.04 p below it.
ThreadHeight thread_height(const contact::Thread& thread, double nominal_radius, double pitch) {
  const contact::RadiusLimits limits = contact::flank_limits(thread);
  double crest = limits.largest - thread.pitch_radius, root = thread.pitch_radius - limits.smallest;
  if (thread.internal) std::swap(crest, root);
  const double below = (nominal_radius - thread.pitch_radius) * (thread.internal ? -1.0 : 1.0);
  // Bodies with teeth have straight flanks, which meet before those of an arc at its root.
  root = std::min(root, sharp_height(pitch, thread.flank_angle));
  return {std::min(kCrestHeight * pitch + below, 0.95 * crest), std::min(kMeshedRootDepth * pitch, 0.95 * root)};
}

Threads threads_for(const ScrewData& d, int starts) {
  const double roller = roller_diameter(d, starts);
  Threads t{draft(d.type, d.lead, {starts, contact::is_grooved(d.type) ? 0 : d.roller_starts}, d.flank_angle,
                  d.screw_diameter, roller),
            {}};
  const double pitch = axial_pitch(t.mechanism);
  t.mechanism.profile.roller = {Profile::Shape::convex, d.roller_profile_radius.value_or(kProfileRadius * pitch)};
  if (!(pitch >= kFinestPitch * roller * (1.0 - 1e-9) && pitch <= kCoarsestPitch * roller)) {
    t.reason = fmt::format("the pitch is {} on rollers of {}", mm(pitch), mm(roller));
    return t;
  }
  t.reason = obstacle(t.mechanism, t.contacts);
  if (t.reason.empty()) {
    const std::optional<Contacts> sharp = t.contacts;
    const PerPart<double> nominal = nominal_radii(d, roller);
    for (const Part p : kParts) t.mechanism.thread[p] = thread_height(thread_of(sharp->threads, p), nominal[p], pitch);
    if (!obstacle(t.mechanism, t.contacts).empty()) {  // Contacts are beyond a maker's crest.
      t.mechanism.thread = {};
      t.contacts = sharp;
    }
  }
  Case c;
  c.mechanism = t.mechanism;
  if (t.reason.empty())
    for (const Problem& problem : check_case(c)) t.reason = problem.message;
  if (t.reason.empty()) {
    const contact::MechanismGeometry& threads = t.contacts->threads;
    const double crest = contact::flank_limits(threads.roller).largest;
    t.most_rollers = most_rollers(threads.centre_distance, crest, 0.0);
    t.mechanism.rollers = std::max(std::min(fewest_rollers(d.type), t.most_rollers),
                                   most_rollers(threads.centre_distance, crest, 0.5 * pitch));
    if (t.most_rollers < fewest_rollers(d.type))
      t.reason = fmt::format("fewer than {} rollers fit", fewest_rollers(d.type));
  }
  if (!t.reason.empty()) t.contacts.reset();
  return t;
}

bool rolls(const ScrewData& d, int starts) { return threads_for(d, starts).contacts.has_value(); }

/// Nearest working value to `wrong`, between it and `right`, which works.
template <class Works>
double nearest(double wrong, double right, Works works) {
  for (int k = 0; k < 40; ++k) {
    const double middle = 0.5 * (wrong + right);
    (works(middle) ? right : wrong) = middle;
  }
  return right;
}

/// Value rounded to three digits, downwards or upwards.
double rounded(double value, double (*rounding)(double)) {
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  return rounding(value / digit) * digit;
}
double down(double value) {
  return rounded(value * (1.0 + 1e-12), [](double x) { return std::floor(x); });
}
double up(double value) {
  return rounded(value * (1.0 - 1e-12), [](double x) { return std::ceil(x); });
}

/// Value rounded to two significant digits.
double proposed(double value) {
  const double digit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::round(value / digit) * digit;
}

/// Length rounded to whole millimetres.
double whole(double length) { return 1e-3 * std::round(1e3 * length); }

int usual_starts(const ScrewData& d) {
  if (contact::is_grooved(d.type)) return 1;
  for (const int n : {5, 4, 3})
    if (roller_diameter(d, n) >= kThinnestRoller * (1.0 - 1e-9) && rolls(d, n)) return n;
  for (int n = 3; n <= kMostUsualStarts; ++n)
    if (rolls(d, n)) return n;
  return 5;
}

[[noreturn]] void refuse_lead(const ScrewData& d, int starts, const std::string& reason) {
  const auto at_pitch = [&](double share) { return share * roller_diameter(d, starts) * starts; };
  const auto works = [&](double lead) {
    ScrewData other = d;
    other.lead = lead;
    return rolls(other, starts);
  };
  const double usual = at_pitch(kUsualPitch), coarsest = at_pitch(kCoarsestPitch);
  if (!works(usual))
    throw CaseError("lead", fmt::format("got {}; nothing rolls with {} starts: {}", mm(d.lead), starts, reason));
  const double greatest = works(coarsest) ? coarsest : nearest(coarsest, usual, works);
  throw CaseError("lead", fmt::format("got {}; expected {} to {} with {} starts on {}, < 0 where "
                                      "left-handed",
                                      mm(d.lead), mm(up(at_pitch(kFinestPitch))), mm(down(greatest)), starts,
                                      mm(d.screw_diameter)));
}

void check_starts(const ScrewData& d) {
  const int less = contact::facts_of(d.type).starts_over_diameters;
  const int fewest = std::max(less * d.roller_starts + 1, d.roller_starts);
  if (d.starts && (*d.starts < fewest || *d.starts > kStartsLimit))
    throw CaseError("starts", fmt::format("got {}; expected {} to {}{}", *d.starts, fewest, kStartsLimit,
                                          contact::is_grooved(d.type) ? ""
                                          : less > 0 ? ": the rollers' diameter is that of the screw over starts - 2"
                                                     : ": the rollers' diameter is that of the screw over starts"));
}

/// Rollers of a screw without helix may have any diameter with which they roll.
void check_roller_diameter(const ScrewData& d, int starts) {
  if (!d.roller_diameter) return;
  if (!contact::is_grooved(d.type))
    throw CaseError(
        "roller_diameter",
        fmt::format("got {}; expected none: those of this type follow from the starts, {}", mm(*d.roller_diameter),
                    mm(rolling_diameter(d.type, d.screw_diameter, {starts, d.roller_starts}))));
  ScrewData by_rule = d;
  by_rule.roller_diameter.reset();
  if (rolls(by_rule, starts) && !rolls(d, starts))
    throw CaseError("roller_diameter",
                    fmt::format("got {}; nothing rolls with it: {}; take one nearer to {}", mm(*d.roller_diameter),
                                threads_for(d, starts).reason, mm(roller_diameter(by_rule, starts))));
}

/// Checks that an arc, which becomes parallel to the axis r (1 - sin(flank angle)) above the pitch line, is high
/// enough.
void check_profile_radius(const ScrewData& d, int starts) {
  if (!d.roller_profile_radius) return;
  const double pitch = std::abs(d.lead) / starts;
  const double least = kLeastThreadHeight * kCrestHeight * pitch / (1.0 - std::sin(d.flank_angle));
  if (*d.roller_profile_radius < least)
    throw CaseError("roller_profile_radius",
                    fmt::format("got {}; expected at least {}, usually 5 pitches, {}: arcs of less end below "
                                "half of a thread's usual height",
                                mm(*d.roller_profile_radius), mm(up(least)), mm(kProfileRadius * pitch)));
}

Threads sound_threads(const ScrewData& d) {
  check_starts(d);
  const int starts = d.starts.value_or(usual_starts(d));
  check_profile_radius(d, starts);
  check_roller_diameter(d, starts);
  Threads t = threads_for(d, starts);
  if (t.contacts) return t;
  ScrewData by_rule = d;
  by_rule.roller_profile_radius = std::nullopt;
  if (!d.roller_profile_radius || !rolls(by_rule, starts)) refuse_lead(d, starts, t.reason);
  const double wrong = *d.roller_profile_radius, right = kProfileRadius * axial_pitch(t.mechanism);
  const double limit = nearest(wrong, right, [&](double radius) {
    by_rule.roller_profile_radius = radius;
    return rolls(by_rule, starts);
  });
  throw CaseError("roller_profile_radius", fmt::format("got {}; expected at {} {}, usually 5 pitches, {}", mm(wrong),
                                                       wrong < right ? "least" : "most",
                                                       mm(wrong < right ? up(limit) : down(limit)), mm(right)));
}

void set_rollers(const ScrewData& d, Threads& t) {
  if (!d.rollers) return;
  if (*d.rollers < fewest_rollers(d.type) || *d.rollers > t.most_rollers)
    throw CaseError("rollers", fmt::format("got {}; expected {} to {}: fewer cannot centre the screw, more "
                                           "overlap",
                                           *d.rollers, fewest_rollers(d.type), t.most_rollers));
  t.mechanism.rollers = *d.rollers;
}

double nut_length(const ScrewData& d, double pitch, double roller_diameter, double nut_diameter) {
  const double least = kFewestContacts * pitch / kThreadedShare,
               most = on_nut(d) ? kMostContacts * pitch / kThreadedShare : kThickestNut * nut_diameter;
  if (!d.nut_length) {
    const double rule = on_nut(d) ? std::min(kNutLengthSlope * nut_diameter + kNutLengthOffset,
                                             kSlendernessOfRollers * roller_diameter / kThreadedShare)
                                  : kInvertedNut * kInvertedThreads * d.screw_diameter;
    return std::max(whole(rule), up(least));
  }
  if (*d.nut_length < least || *d.nut_length > most)
    throw CaseError("nut_length", fmt::format("got {}; expected {} to {}, room for threads of {}", mm(*d.nut_length),
                                              mm(up(least)), mm(down(most)), mm(pitch)));
  return *d.nut_length;
}

double root_depth(const Mechanism& m) {
  return m.thread.nut ? m.thread.nut->dedendum : default_root_depth(axial_pitch(m), m.flank_angle.nut);
}

double nut_outer_diameter(const ScrewData& d, const Mechanism& m, double pitch_diameter) {
  const double threads = pitch_diameter + 2.0 * (root_depth(m) + kLeastWall * axial_pitch(m));
  const double least = std::max(threads, 1.001 * pitch_diameter);
  if (!d.nut_diameter) return std::max(whole(kNutDiameterSlope * pitch_diameter + kNutDiameterOffset), up(least));
  if (*d.nut_diameter < least || *d.nut_diameter > kThickestNut * pitch_diameter)
    throw CaseError("nut_diameter", fmt::format("got {}; expected {} to {}: the nut's threads have a pitch "
                                                "diameter of {}",
                                                mm(*d.nut_diameter), mm(up(least)),
                                                mm(down(kThickestNut * pitch_diameter)), mm(pitch_diameter)));
  return *d.nut_diameter;
}

/// Axial force at which, with equal shares, an ellipse reaches the end of a flank [N].
double edge_force(const Mechanism& m, const Contacts& contacts) {
  double force = std::numeric_limits<double>::infinity();
  for (const Interface i : kInterfaces) {
    const InterfaceContact& c = contacts.interfaces[i];
    const contact::FlankEdge edge = contact::nearest_flank_edge(
        pair_of(contacts.threads, i), c.geometry, c.hertz.semi_major_per_cbrt_load, c.hertz.semi_minor_per_cbrt_load);
    force = std::min(force,
                     std::pow(edge.scale, 3) * std::cos(c.normal_angle()) * m.contacts_per_roller * loaded_rollers(m));
  }
  return force;
}

double load_of(const ScrewData& d, const Mechanism& m, const Contacts& contacts) {
  const double moderate = moderate_force(m, contacts);
  if (!d.load)
    return proposed(std::min({moderate, kModerateStress * 0.25 * std::numbers::pi * d.screw_diameter * d.screw_diameter,
                              kModerateEdgeShare * edge_force(m, contacts)}));
  const double most = moderate * std::pow(kGreatestPressure / kModeratePressure, 3);
  if (*d.load > most)
    throw CaseError("load", fmt::format("got {:.6g} kN; expected at most {:.6g} kN, with which "
                                        "equal thread loads give {:g} GPa: twice the static capacity",
                                        1e-3 * *d.load, 1e-3 * down(most), 1e-9 * kGreatestPressure));
  return *d.load;
}

Structure structure_of(const ScrewData& d, const Mechanism& m, double nut_diameter, double length) {
  const double roller = roller_diameter(d, m.starts.screw);
  const double threaded = m.contacts_per_roller * axial_pitch(m);
  Structure s;
  s.roller.end_length = on_nut(d) ? 0.5 * kRollerEndsShare * (length - threaded) : 0.7 * roller;
  s.roller.end_diameter = kRollerEndDiameter * roller;
  s.nut.length = length;
  s.nut.outer_diameter = nut_outer_diameter(d, m, nut_diameter);
  s.nut.thrust = {0.0, length};
  return s;
}

constexpr double kPi = std::numbers::pi;

double of_nut(const Structure::Nut& nut, double bore) { return nut_in_still_air(nut.outer_diameter, bore, nut.length); }

double of_shaft(double diameter, double length) {
  const double perimeter = kPi * diameter, area = 0.25 * kPi * diameter * diameter;
  const double rate = std::sqrt(kStillAir * perimeter / (kSteelConductivity * area));
  return kSteelConductivity * area * rate * std::tanh(rate * length);
}

}  // namespace

PerPart<double> nominal_radii(const ScrewData& d, double roller_diameter) {
  return {0.5 * d.screw_diameter, 0.5 * roller_diameter, 0.5 * d.screw_diameter + roller_diameter};
}

double moderate_force(const Mechanism& m, const Contacts& contacts) {
  double force = std::numeric_limits<double>::infinity();
  for (const Interface i : kInterfaces) {
    const InterfaceContact& contact = contacts.interfaces[i];
    const double pressure_of_1_newton = contact::at_load(contact.hertz, 1.0).peak_pressure;
    const double normal_load = std::pow(kModeratePressure / pressure_of_1_newton, 3);
    force = std::min(force, normal_load * std::cos(contact.normal_angle()) * m.contacts_per_roller * loaded_rollers(m));
  }
  return force;
}

CompleteScrew complete_screw(const ScrewData& d) {
  Threads threads = sound_threads(d);
  set_rollers(d, threads);
  Mechanism& m = threads.mechanism;
  const Contacts& contacts = *threads.contacts;
  const double pitch = axial_pitch(m);

  CompleteScrew screw;
  screw.data = d;
  for (const Part p : kParts) screw.pitch_diameter[p] = *contacts.mechanism.pitch_diameter[p];
  screw.centre_distance = contacts.threads.centre_distance;
  screw.most_rollers = threads.most_rollers;
  const double length = nut_length(d, pitch, screw.pitch_diameter.roller, screw.pitch_diameter.nut);
  m.contacts_per_roller = contacts_over(kThreadedShare * length, pitch);
  if (!on_nut(d))
    m.contacts_per_roller = std::min(m.contacts_per_roller, contacts_over(kInvertedThreads * d.screw_diameter, pitch));
  screw.position = 0.5 * (length - (m.contacts_per_roller - 1) * pitch);
  screw.gears = gear_pairs(m, screw.centre_distance, 0.5 * pitch);
  screw.load = load_of(d, m, contacts);
  constexpr double one_rpm = std::numbers::pi / 30.0;
  screw.speed =
      d.speed.value_or(one_rpm * proposed(kSpeedShare * kGreatestSpeedTimesDiameter / d.screw_diameter / one_rpm));
  screw.c.structure = structure_of(d, m, screw.pitch_diameter.nut, length);
  screw.c.structure->screw.free_length = on_nut(d) ? screw.position : screw.c.structure->roller.end_length;
  screw.c.materials = Materials{kSteel, kSteel, kSteel};
  screw.c.mechanism = m;
  return screw;
}

Heat::Conductance estimated_conductance(const CompleteScrew& s, double shaft_length) {
  const Contacts contacts = find_contacts(s.c.mechanism, s.c.materials);
  const Mechanism& m = contacts.mechanism;
  const double count = static_cast<double>(loaded_rollers(m)) * m.contacts_per_roller;
  const auto spots = [&](Interface i) {
    const InterfaceContact& contact = contacts.interfaces[i];
    const contact::HertzContact e = contact::at_load(contact.hertz, s.load / count / std::cos(contact.normal_angle()));
    return count * 2.0 * kSteelConductivity * std::sqrt(e.semi_major * e.semi_minor);
  };
  const Structure::Nut& nut = s.c.structure->nut;
  const double beyond = std::max(0.5 * (shaft_length - nut.length), 0.0);
  return {.screw_ambient = 2.0 * of_shaft(s.data.screw_diameter, beyond),
          .nut_ambient = of_nut(nut, s.pitch_diameter.nut),
          .screw_rollers = spots(Interface::screw),
          .rollers_nut = spots(Interface::nut)};
}

}  // namespace prs
