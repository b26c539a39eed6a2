#pragma once

#include <optional>

#include "prs/contacts.h"

namespace prs {

/// Total permanent deformation of rolling element and raceway over the diameter of the element that
/// a bearing may have at its most loaded contact without harm to its running (ISO 76).
inline constexpr double kPermanentDeformation = 1e-4;

/// Total permanent deformation [m] of both bodies in the middle of a point contact, after Palmgren:
///
///     delta_p = 1.3e-7 N^2/D kappa_1 kappa_2     [mm, N]
///
/// `normal_load` N [N]; `element_diameter` D of the rolling element [m]; kappa_1, kappa_2 relative
/// principal curvatures [1/m], their product being that of the sums of both bodies' curvatures in
/// the two principal planes. A fit to tests with balls and raceways of bearing steel of 63.5 to
/// 65.5 HRC, for small deformations; softer flanks deform more. Palmgren, Grundlagen der
/// Waelzlagertechnik; Harris, Rolling Bearing Analysis, chapter on permanent deformation, where
/// D kappa_1 kappa_2 is worked out for ball bearings to 5.25e-7 N^2/D^3 (1 +- gamma/(1 -+ gamma))
/// (1 - 1/(2 f)).
double permanent_deformation(double normal_load, double element_diameter, double kappa_1,
                             double kappa_2);

/// Normal load [N] under which that deformation is `share` of the element's diameter:
///
///     N = D sqrt(share/(1.3e-7 kappa_1 kappa_2))     [mm, N]
double load_at_permanent_deformation(double element_diameter, double kappa_1, double kappa_2,
                                     double share = kPermanentDeformation);

/// Diameter of the rolling element that a roller's flank stands for [m]: twice the radius of its
/// convex profile. Absent where the flank is straight or concave.
std::optional<double> flank_element_diameter(const contact::Thread& roller);

}  // namespace prs
