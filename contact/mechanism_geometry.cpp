#include "contact/mechanism_geometry.h"

namespace contact {

namespace {

/// d backlash/d centre distance at fixed point: only the roller's flank moves.
double backlash_rate_over_centre_distance(const ContactPoint& p) { return -2.0 * p.normal.x / std::abs(p.normal.z); }

/// d backlash/d pitch radius of the body: its flank moves outwards and, in the normal plane, its helix angle changes.
double backlash_rate_over_pitch_radius(const ThreadSurface& body, const ContactPoint& p) {
  const ProfilePoint f = body.profile(p.radius_on_body);
  double rate = -f.slope;
  if (body.plane == ProfilePlane::normal) {
    const double r = body.pitch_radius, l = body.reduced_lead;
    rate -= (f.height - body.half_groove) * l * l / (r * (r * r + l * l));
  }
  return 2.0 * body.side * rate;
}

/// Length that is varied until a pair has its backlash.
enum class Unknown { centre_distance, pitch_radius_of_body };

struct BacklashSearch {
  bool solved = false;
  ContactPoint point;
  int iterations = 0;
};

/// Varies the unknown inside `m` until the body (screw or nut) has the wanted backlash in I1J2.
BacklashSearch solve_for_backlash(MechanismGeometry& m, Thread MechanismGeometry::*body_of, Unknown what,
                                  double wanted) {
  constexpr int kMaxIterations = 30;
  constexpr double kTolerance = 1e-14;  // [m]
  constexpr double kStationary = 1e-6;  // Slope at a point off the flank that is good enough to step from [-].

  Thread& body = m.*body_of;
  double& unknown = what == Unknown::centre_distance ? m.centre_distance : body.pitch_radius;
  const RollerFace face =
      body.internal ? roller_face_at_nut(Configuration::i1_j2) : roller_face_at_screw(Configuration::i1_j2);
  BacklashSearch search;
  while (search.iterations < kMaxIterations) {
    const ThreadPair pair{ThreadSurface(body), ThreadSurface(m.roller), m.centre_distance};
    const ContactPoint point = search.point = find_contact_point(pair, face);
    ++search.iterations;
    const bool near_flank = point.status == ContactPointStatus::outside_flank && point.residual < kStationary;
    if (!point.ok() && !near_flank) return search;

    const double excess = point.backlash - wanted;
    if (std::abs(excess) <= kTolerance) {
      search.solved = point.ok();
      return search;
    }
    unknown -= excess / (what == Unknown::centre_distance ? backlash_rate_over_centre_distance(point)
                                                          : backlash_rate_over_pitch_radius(pair.body, point));
  }
  return search;
}

}  // namespace

std::optional<MechanismType> type_named(std::string_view name) {
  for (const MechanismType type : kMechanismTypes)
    if (facts_of(type).name == name) return type;
  return std::nullopt;
}

MechanismContact mechanism_contact(const MechanismGeometry& mechanism, Configuration configuration) {
  return {interface_geometry(screw_pair(mechanism), roller_face_at_screw(configuration)),
          interface_geometry(nut_pair(mechanism), roller_face_at_nut(configuration))};
}

double roller_lead(MechanismType type, double screw_lead, double roller_pitch, int roller_starts) {
  const int hand = facts_of(type).roller_hand;
  return hand == 0 ? 0.0 : std::copysign(hand * roller_pitch * roller_starts, hand * screw_lead);
}

PitchRadii matched_pitch_radii(MechanismType type, double screw_radius, int screw_starts, int roller_starts) {
  const double ratio = static_cast<double>(screw_starts) / roller_starts;
  const double roller = screw_radius / (ratio - facts_of(type).starts_over_diameters);
  return {screw_radius, roller, screw_radius + 2.0 * roller};
}

KinematicConsistency kinematic_consistency(const MechanismGeometry& m) {
  const Thread& geared = facts_of(m.type).carrier_on_nut ? m.nut : m.screw;
  return {m.nut.lead - m.screw.lead, m.roller.pitch_radius / geared.pitch_radius,
          std::abs(m.roller.lead / m.screw.lead)};
}

int largest_roller_count(const MechanismGeometry& m) {
  return largest_roller_count(flank_limits(m.roller).largest, m.centre_distance);
}

int largest_roller_count(double crest_radius, double centre_distance) {
  const double ratio = crest_radius / centre_distance;
  if (!(ratio < 1.0)) return 1;
  // Small tolerance, so that rollers that just touch count.
  return static_cast<int>(std::floor(std::numbers::pi / std::asin(ratio) * (1.0 + 1e-12)));
}

AxialPositions axial_positions(const MechanismGeometry& m, const MechanismContact& contact,
                               Configuration configuration) {
  const double sense = configuration == Configuration::i1_j2 ? 1.0 : -1.0;
  return {-0.5 * (m.roller.lead + m.roller.pitch) - sense * 0.5 * contact.screw.point.backlash,
          sense * 0.5 * contact.nut.point.backlash};
}

std::string_view name(DesignStatus status) {
  constexpr std::string_view kNames[] = {
      "ok",           "not_solved", "pitches_differ", "too_few_screw_starts", "no_screw_contact", "no_nut_contact",
      "not_converged"};
  return kNames[static_cast<std::size_t>(status)];
}

DesignResult design_by_backlash(const MechanismGeometry& draft, int screw_starts, int roller_starts,
                                const Backlash& backlash) {
  DesignResult result;
  result.mechanism = draft;
  MechanismGeometry& m = result.mechanism;
  if (!same_pitch(m.screw, m.roller) || !same_pitch(m.nut, m.roller)) {
    result.status = DesignStatus::pitches_differ;
    return result;
  }
  if (screw_starts <= facts_of(m.type).starts_over_diameters * roller_starts) {
    result.status = DesignStatus::too_few_screw_starts;
    return result;
  }
  if (!is_grooved(m.type))
    m.roller.pitch_radius = matched_pitch_radii(m.type, m.screw.pitch_radius, screw_starts, roller_starts).roller;
  m.nut.pitch_radius = m.screw.pitch_radius + 2.0 * m.roller.pitch_radius;
  m.centre_distance = m.screw.pitch_radius + m.roller.pitch_radius;

  // The matched part determines the centre distance, then the other one is rectified.
  struct Step {
    Thread MechanismGeometry::*body;
    Unknown what;
  };
  const auto screw = &MechanismGeometry::screw, nut = &MechanismGeometry::nut;
  const bool on_nut = facts_of(m.type).carrier_on_nut;
  for (const Step& step : {Step{on_nut ? nut : screw, Unknown::centre_distance},
                           Step{on_nut ? screw : nut, Unknown::pitch_radius_of_body}}) {
    const bool at_screw = step.body == screw;
    const BacklashSearch search = solve_for_backlash(m, step.body, step.what, at_screw ? backlash.screw : backlash.nut);
    result.iterations += search.iterations;
    (at_screw ? result.contact.screw : result.contact.nut).point = search.point;
    if (!search.solved) {
      result.status = search.point.ok() ? DesignStatus::not_converged
                      : at_screw        ? DesignStatus::no_screw_contact
                                        : DesignStatus::no_nut_contact;
      return result;
    }
  }
  result.contact = mechanism_contact(m, Configuration::i1_j2);
  result.status = DesignStatus::ok;
  return result;
}

}  // namespace contact
