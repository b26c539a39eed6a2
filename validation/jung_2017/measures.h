#pragma once

#include <array>

namespace prs::jung_2017 {

/// What a row of tables 7.1 and 7.2 chooses [m].
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

// What the tables hold fixed: p = 2 mm, N_s = 5, N_r = 10, L = 100 mm, alpha_0 = 45 deg, 500
// contacts.
inline constexpr double kPitch = 2e-3;
inline constexpr int kStarts = 5;
inline constexpr int kRollers = 10;
inline constexpr double kLength = 0.1;
inline constexpr int kContacts = 500;

/// Rows of both tables: D_n = 54, 57 .. 81 mm, d_s = D_n/2; in case 1, table 7.1, d_r = 9, 10 ..
/// 18 mm; in case 2, table 7.2, d_r = d_s/3.
std::array<Diameters, 10> case_1();
std::array<Diameters, 10> case_2();

/// The columns of table 7.1 as they were printed, slips included:
///
///     T   = D_n - d_n                                                              (7.1)
///     V   = pi (D_n^2 + d_s^2 - d_n^2 + N_r d_r^2) L                               for (7.2)
///     C_a = (7.5) with beta_0 the same for every screw
///     W   = 0.006165 d_r^2 N_r L + 0.02466 (D_n - T) T L   [mm, L in m]            (7.7)
///     k   = 1/`compliance_as_printed`
///
/// For `geometry_factor`'s range of d_r cos(alpha_0)/d_n and d_n < D_n.
Measures as_printed(const Diameters& d);

/// Yamamoto's terms in their right form, on 1 mm of thread, with the lead N_s p where the pitch
/// belongs (root shear and radial terms) and the crest's width p/8 where the tooth's height
/// belongs; root width 7p/8, p/2 at the pitch line. Hertz's term for 1500 N with Y* = 4.333e-12
/// 1/Pa used as if in mm^2/N, delta* = 0.98: 1e4 times too small, as is seen only in the last
/// digits.
ThreadCompliance compliance_as_printed(const Diameters& d);

/// The same columns by the right formulas: the nut's wall T = (D_n - d_n)/2; volume of nut and
/// rollers pi/4 (D_n^2 - d_n^2 + N_r d_r^2) L; C_a with tan(beta_0) = N_s p/(pi d_s); 7850 kg/m^3
/// times the volume; 1/`right_compliance`.
Measures corrected(const Diameters& d);

/// (3.45) with Yamamoto's terms on the share of a roller in the thread's circumference,
/// pi d/N_r, the least deflection that they can give, height 3p/16 from the pitch line to the root,
/// and exact Hertz for 1500 N of axial load on the curvatures (3.27)-(3.38). As in (3.45) the
/// roller's teeth are left out.
ThreadCompliance right_compliance(const Diameters& d);

}  // namespace prs::jung_2017
