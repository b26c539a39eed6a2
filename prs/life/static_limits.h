#pragma once

#include "prs/threads/contacts.h"

namespace prs {

// Static limits of a mechanism.
//
// Static safety is the static rating F_0 over the force F: the static capacity of a catalogue if the case states it,
// else the force at which the first thread reaches the pressure of 4.0 GPa. This is `static_safety` of `prs life`,
// which solves the thread loads at F_0. `prs measures` has two estimates: `static_safety` with equal thread loads, the
// same as life's with `share: equal`, and `thread_static_safety` with the shares solved under F: usually above life's,
// by 7 % on lesson 18, since shares become less even with the load; below it if initial gaps close. An ellipse that
// reaches the end of its flank is not a failure but an edge stress: that force over F is the margin of the flank's
// edge, a separate quantity.

/// Total permanent deformation of rolling element and raceway, over the diameter of the element, that a bearing may
/// have at its most loaded contact without impairing its running (ISO 76).
inline constexpr double kPermanentDeformation = 1e-4;

/// Normal load N [N] under which the total permanent deformation of both bodies in the middle of a
/// point contact, after Palmgren, is `share` of the rolling element's diameter D [m]:
///
///     delta_p = 1.3e-7 N^2/D kappa_1 kappa_2, N = D sqrt(share/(1.3e-7 kappa_1 kappa_2))  [mm, N]
///
/// kappa_1, kappa_2 are relative principal curvatures [1/m], their product being that of the sums
/// of both bodies' curvatures in the two principal planes. A fit to tests with balls and raceways
/// of bearing steel of 63.5 to 65.5 HRC, for small deformations; softer flanks deform more.
/// Palmgren, Grundlagen der Waelzlagertechnik; Harris, Rolling Bearing Analysis, chapter on
/// permanent deformation, where D kappa_1 kappa_2 is worked out for ball bearings to 5.25e-7
/// N^2/D^3 (1 +- gamma/(1 -+ gamma)) (1 - 1/(2 f)).
double load_at_permanent_deformation(double element_diameter, double kappa_1, double kappa_2,
                                     double share = kPermanentDeformation);

/// Diameter of the rolling element equivalent to a roller's flank [m]: twice the radius of its convex profile. Absent
/// if the flank is straight or concave.
std::optional<double> flank_element_diameter(const contact::Thread& roller);

/// Kind of static limit.
enum class StaticLimit {
  pressure,  ///< Peak pressure of `kStaticPressureLimit`.
  given,     ///< Static capacity stated in the case.
};

const char* name(StaticLimit limit);      ///< Name in documents: `given`.
std::string describe(StaticLimit limit);  ///< Text for messages.

/// Loads at which the limits are reached: normal loads of one contact, or forces on the mechanism [N]. Absent if the
/// geometry gives no Hertz contact, or no rolling element.
struct StaticLimits {
  std::optional<double> pressure;
  std::optional<double> deformation;
  std::optional<double> flank_edge;
};

/// Normal loads of one contact of an interface [N]. At the flank's edge N = scale^3 for semi-axes under 1 N, see
/// `contact::nearest_flank_edge`. Without materials those of steel are used.
StaticLimits static_limits(const std::optional<Materials>& materials, const Contacts& contacts, Interface i);

/// The end of a flank that the ellipse of an interface reaches first; its Hertz contact must exist.
contact::FlankEdge nearest_flank_edge(const Contacts& contacts, Interface i);

/// Static rating: the allowed load and the limit that determines it.
struct StaticRating {
  double force = 0.0;  ///< [N]
  StaticLimit limit = StaticLimit::pressure;
};

/// The `given` static capacity [N], else the force at which a thread reaches the limit of pressure [N].
std::optional<StaticRating> static_rating(std::optional<double> pressure, std::optional<double> given);

std::optional<StaticRating> smaller(const std::optional<StaticRating>& a, const std::optional<StaticRating>& b);

/// Static safety above which no limit needs a note: makers ask for 1 to 3 under smooth loads.
inline constexpr double kUsualStaticSafety = 1.5;

/// A warning if an ellipse reaches the end of a flank at a force [N] on the mechanism that is below its static capacity
/// [N] and less than `kUsualStaticSafety` times the load [N]. `ellipse`: its name.
std::optional<Warning> flank_edge_near(std::string_view ellipse, double edge_load, double static_capacity, double load);

/// A warning if the dynamic capacity [N] exceeds the static one [N], which is not so for any maker. `is_stated`:
/// whether the file states the static one; else it is that of equal thread loads.
std::optional<Warning> dynamic_above_static(double dynamic_capacity, double static_capacity, bool is_stated);

/// A warning if a force [N] exceeds its static rating.
std::optional<Warning> beyond_static_rating(double load, const StaticRating& rating, std::string_view shares = {});

}  // namespace prs
