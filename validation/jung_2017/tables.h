#pragma once

#include "prs/validation/validate.h"

namespace prs::jung_2017 {

/// Dimensions that vary between rows of tables 7.1 and 7.2 [m].
struct Diameters {
  double nut_outer = 0.0;  ///< D_n
  double screw = 0.0;      ///< d_s
  double roller = 0.0;     ///< d_r

  double nut_inner() const { return screw + 2.0 * roller; }  ///< d_n
};

/// The columns of tables 7.1 and 7.2. SI.
struct Measures {
  double nut_thickness = 0.0;  ///< [m]
  double volume = 0.0;         ///< [m^3]
  double stiffness = 0.0;      ///< Stiffness of one thread [N/m].
  double load_capacity = 0.0;  ///< C_a [N]
  double weight = 0.0;         ///< Weight of nut and rollers [kg].

  double force_density() const { return load_capacity / weight; }  ///< [N/kg]
};

/// Axial compliance of one thread [m/N], by its parts.
struct ThreadCompliance {
  double teeth = 0.0;         ///< Bending, shear and root of both teeth, (3.4)-(3.7), (3.13)-(3.16)
  double screw_radial = 0.0;  ///< (3.8)
  double nut_radial = 0.0;    ///< (3.17)
  double hertz = 0.0;         ///< (3.20), (3.21)

  double total() const { return teeth + screw_radial + nut_radial + hertz; }
};

// Fixed dimensions of the tables: p = 2 mm, N_s = 5, N_r = 10, L = 100 mm, alpha_0 = 45 deg, 500 contacts.
inline constexpr double kPitch = 2e-3;
inline constexpr int kRollers = 10;
inline constexpr double kLength = 0.1;

/// Parameters of the sweeps of chapters 3 to 6 besides diameters, by default as in tables 7.1 and 7.2. SI units.
struct Threads {
  double pitch = kPitch;
  double starts = 5;  ///< N_s
  double rollers = kRollers;
  double length = kLength;
  /// Axial load of a thread, which is not printed: with the teeth of the recipe table 7.1 allows 1476 to 1509 N.
  double load = 1500.0;
  std::optional<double> helix_angle = {};  ///< beta_0 if it is varied alone [rad], as in table 3.9.

  double lead() const { return starts * pitch; }
  double contacts() const { return rollers * length / pitch; }  ///< N_c
  /// beta_0 of a thread of that diameter.
  double helix_angle_at(double diameter) const {
    return helix_angle.value_or(std::atan(lead() / (std::numbers::pi * diameter)));
  }
};

/// Rows of both tables: D_n = 54, 57 .. 81 mm, d_s = D_n/2; in case 1, table 7.1, d_r = 9, 10 ..
/// 18 mm; in case 2, table 7.2, d_r = d_s/3.
std::array<Diameters, 10> case_1();
std::array<Diameters, 10> case_2();

/// The columns of tables 7.1 and 7.2 as printed, slips included; but table 7.2 divides C_a of table 7.1 by its own W:
///
///     T   = D_n - d_n                                                              (7.1)
///     V   = pi (D_n^2 + d_s^2 - d_n^2 + N_r d_r^2) L                               for (7.2)
///     C_a = (7.5) with beta_0 the same for every screw
///     W   = 0.006165 d_r^2 N_r L + 0.02466 (D_n - T) T L   [mm, L in m]            (7.7)
///     k   = 1/`compliance_as_printed`
///
/// Valid in `geometry_factor`'s range of d_r cos(alpha_0)/d_n and for d_n < D_n.
Measures as_printed(const Diameters& d, const Threads& t = {});

/// Yamamoto's corrected terms, on 1 mm of thread, with the lead N_s p in place of the pitch (root shear and radial
/// terms) and the crest's width p/8 in place of the tooth's height; root width 7p/8, p/2 at the pitch line. Hertz's
/// term for 1500 N with Y* = 4.333e-12 1/Pa used as if in mm^2/N, delta* = 0.98: 1e4 times too small, visible only in
/// the last digits.
ThreadCompliance compliance_as_printed(const Diameters& d, const Threads& t = {});

/// The columns by the right formulas: the nut's wall T = (D_n - d_n)/2; volume of nut and rollers pi/4 (D_n^2 - d_n^2 +
/// N_r d_r^2) L; C_a with tan(beta_0) = N_s p/(pi d_s); 7850 kg/m^3 times the volume; 1/`right_compliance`.
Measures corrected(const Diameters& d, const Threads& t = {});

/// (3.45) with Yamamoto's terms on a roller's share of the thread's circumference, pi d/N_r, the smallest deflection
/// that they can give, height 3p/16 from the pitch line to the root, and exact Hertz for 1500 N of axial load on the
/// curvatures (3.27)-(3.38). As in (3.45) the roller's teeth are left out.
ThreadCompliance right_compliance(const Diameters& d, const Threads& t = {});

/// Dimensionless contact parameters of Hertz and Harris, table A1.
struct ContactParameters {
  double semi_major = 1.0;  ///< a* = (2 k^2 E/pi)^(1/3), k = a/b
  double semi_minor = 1.0;  ///< b* = a*/k
  double approach = 1.0;    ///< delta* = 2 K/(pi a*)
};

/// The parameters for F(rho) = (kappa_2 - kappa_1)/(kappa_1 + kappa_2), 0 <= F < 1, of the relative principal
/// curvatures, (3.39) and (3.40), by exact elliptic integrals. Computed from (1 - F)/(1 + F), which loses no digits
/// near F = 1.
ContactParameters contact_parameters(double curvature_difference);

/// A line of table A1 except the first and the last, which are limits.
struct PrintedParameters {
  PrintedNumber curvature_difference, semi_major, semi_minor, approach;
};
std::vector<PrintedParameters> table_a1(const Reference& thesis);

/// Deviation of a printed number that the rounding of F(rho) and its own do not explain, relative to it; 0 for a number
/// that may be right.
double unexplained(const PrintedNumber& printed, const PrintedNumber& curvature_difference,
                   double ContactParameters::*parameter);

/// A line of table 8.1: the four parameters at one place on the y-axis of the envelopes.
struct ScaleLine {
  double scale = 0.0;  ///< D_n over the root mean square of its ten values.
  int rollers = 0;
  double roller = 0.0;     ///< d_r [m]
  double screw = 0.0;      ///< d_s [m]
  double nut_outer = 0.0;  ///< D_n [m]
};

/// Table 8.1: N_r = 6 .. 15, d_r from 7.8 mm by 1.3 mm, d_s from 18 mm by 3 mm, D_n from 40 mm by
/// 6.67 mm. The printed scale is that of D_n, whose step is rounded; the other three have 0.55118
/// to 1.37795 in place of 0.55105 to 1.37804.
std::array<ScaleLine, 10> scale_chart();

/// A measure as a polynomial of the volume x, in the 1e-3 m^3 that the tables call m^3.
struct VolumeFit {
  std::string equation;
  std::string measure;  ///< Name with its unit.
  bool of_case_2 = false;
  double (*value)(const Measures&) = nullptr;  ///< Value of the measure, in that unit.
  std::array<double, 6> coefficients{};        ///< Factors of x^5, x^4 .. 1, as printed.

  double at(double x) const;
};

/// (7.8) to (7.13). The text below (7.11) to (7.13) calls y the load capacity; figures 7.4 to 7.6 and the numbers have
/// stiffness, load capacity and weight.
std::vector<VolumeFit> volume_fits(const Reference& thesis);

/// Least-squares polynomial through the ten rows of its case by the recipe `as_printed`, case 1 with unrounded values.
/// Case 2 uses volumes, capacities and weights with three decimals as the table prints them, since only these give the
/// printed coefficients.
std::array<double, 6> refitted(const VolumeFit& fit);

/// The printed polynomials at the volumes of their rows, unrounded and with three decimals, minus the recipe's values;
/// and the printed coefficients next to `refitted`.
std::vector<ValidationTable> fit_tables(const Reference& thesis);

}  // namespace prs::jung_2017
