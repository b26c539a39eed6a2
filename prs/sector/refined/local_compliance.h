#pragma once

#include <vector>

#include "prs/model/materials.h"

namespace prs {

/// Distances at which the displacement by a line of force along the axis is zero once its smooth
/// part is taken away: normal u = 2 (1 - nu^2) q/(pi E) ln(L_n/rho), tangential (along the line)
/// u = q/(pi G) ln(L_t/rho), at the small distance rho. [m]
struct LineReach {
  double normal = 0.0;      ///< L_n
  double tangential = 0.0;  ///< L_t
};

/// Equal rows at equal distances round a cylinder of radius r, the mean round it taken away:
/// sum of (N/n) cos(n theta), n = N, 2 N, .., is -ln|2 sin(N theta/2)|, hence both lengths r/N.
LineReach rows_around(double radius, int rows);

/// Two rows opposite each other on a solid cylinder. Normal: a disc pressed along its diameter
/// (Johnson, Contact Mechanics, 1985, (5.57)), L_n = 2 r/e. Tangential: two opposed lines of shear,
/// the rotation of the sections, which a beam has, taken away: L_t = 2 r/e^2.
LineReach opposite_rows(double radius);

/// By how much a contact gives way more along its normal than under the same load spread along its
/// row, its own half-space part apart, which exact Hertz carries [m/N]. Contacts of a row stand at
/// the pitch p on a half-space:
///
///     c = sin^2(psi) 2 (1 - nu^2)/(pi E p) (ln(L_n/(2 p)) + gamma)
///         + cos^2(psi) 1/(pi G p) (ln(L_t/(2 p)) + gamma),
///
/// gamma Euler's constant; normal and tangential loads of a straight row do not see each other.
/// Negative as a rule: spread loads have a part of the half-space's deflection too. Holds for rows
/// further apart than p.
double concentration_compliance(const LineReach& reach, const Material& material, double pitch,
                                double normal_angle);

/// Radial displacement of a cylinder's surface by the normal loads of N rollers in rows of pitch p,
/// spread into the pressure q = N sin(psi)/(2 pi r p) [m/N, along the normal]. Lame's solution:
///
///     c = N sin^2(psi)/(2 pi p E) [(r^2 + b^2)/(r^2 - b^2) - nu],   b the radius of the bore.
double cylinder_compliance(double radius, double bore_radius, const Material& material, int rollers,
                           double pitch, double normal_angle);

/// Radial displacement of the inner surface of a tube from r to R, less that of its shell, whose
/// wall keeps its thickness:
///
///     c = N sin^2(psi)/(2 pi p E) [(R^2 + r^2)/(R^2 - r^2) + nu - 1/ln(R/r)].
double wall_compliance(double inner_radius, double outer_radius, const Material& material,
                       int rollers, double pitch, double normal_angle);

/// Share of the displacement under an endless band of pressure that is left at each of `contacts`
/// when the band ends half a pitch beyond the first and the last. For long waves a cylinder is a
/// beam on an elastic foundation, 1/(1 + k^4/(4 b^4)), so that an end at the distance x takes away
///
///     exp(-b x) cos(b x)/2,
///
/// b^4 = 24 (1 + nu)/r^4 for a solid cylinder (series of Lur'e's solution, Three-dimensional
/// Problems of the Theory of Elasticity, 1964, chapter 7), 3 (1 - nu^2)/(r_m h)^2 for a thin tube;
/// of both the larger b.
std::vector<double> band_shares(int contacts, double pitch, double radius, double bore_radius,
                                double poisson_ratio);

/// Displacement of the loaded section per axial force on the sector by Poisson's effect in the
/// screw, s = -1 in tension, +1 in compression [m/N]. A section that carries the axial force T
/// shrinks radially by nu r T/(E A), away from the rollers or towards them, and the radial loads
/// stretch it in turn. With radial loads tan(psi) times the axial ones, the coupling energy
/// tan(psi) nu r/(E A) int T T' dx is that of its ends only: an offset, the same for all threads,
///
///     -s nu tan(psi) r/(E A).
double poisson_offset(double sense, double radius, double bore_radius, const Material& material,
                      int rollers, double normal_angle);

}  // namespace prs
