#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "contact/hertz.h"
#include "contact/patch_kernel.h"

namespace contact {

/// Points at which a contact ellipse is sampled: the centres of n x n equal cells of the rectangle
/// around it, those inside the ellipse (Sandu 2018, fig. 2.7), with the Hertz dome as weight. In
/// units of the semi-axes, so that one grid serves every ellipse.
class PatchGrid {
 public:
  explicit PatchGrid(int points_along_axis);

  Eigen::Index inside() const { return inside_; }
  auto along_major() const { return along_major_.head(inside_); }  ///< t_1D/a
  auto along_minor() const { return along_minor_.head(inside_); }  ///< t_2D/b
  auto dome() const { return dome_.head(inside_); }                ///< sqrt(1 - (t_1D/a)^2 - (t_2D/b)^2), > 0
  /// Different values of `dome`, padded for batches, and the index of each point's value.
  const Eigen::ArrayXd& domes() const { return domes_; }
  std::span<const std::uint32_t> dome_of_point() const { return dome_of_point_; }
  /// Load on a cell over the normal load and the dome: p_0 4 a b/(n^2 N) = 6/(pi n^2) (3.7).
  double cell_load() const { return cell_load_; }
  /// Points including those that fill the last batch.
  PatchPoints points() const;

 private:
  Eigen::Index inside_ = 0;
  Eigen::ArrayXd along_major_, along_minor_, dome_, inverse_dome_;
  Eigen::ArrayXd domes_;
  std::vector<std::uint32_t> dome_of_point_;
  double cell_load_ = 0.0;
};

using PatchMotion = PatchMotionOf<double>;
using PatchFriction = PatchFrictionOf<double>;

/// eta_bar of a lubricant at each of the different domes of a grid, under a peak pressure [Pa]: `ratio` has space for
/// all `domes`.
void set_viscosity_ratios(const PatchGrid& grid, double viscosity, double peak_pressure, double* ratio);

/// One contact ellipse with its law of friction: the data that stay constant while the slip ratio is searched.
class Patch {
 public:
  Patch(const PatchGrid& grid, const HertzContact& ellipse, const FrictionLaw& law);

  const HertzContact& ellipse() const { return ellipse_; }

  /// Resultants of the friction (Sandu 2018, (3.8), (3.10), (3.51)). Points slower than
  /// kNoDirection are left out of tractions, moment and power, not of the mean coefficient. No
  /// allocation.
  /// `Number`: a number, or one with its slope.
  template <class Number = double>
  PatchFrictionOf<Number> friction(const PatchMotionOf<Number>& motion) const;

  // Values at every point inside:
  Eigen::ArrayXd sliding_major(const PatchMotion& motion) const;         ///< v_D . t_1 [m/s]
  Eigen::ArrayXd sliding_minor(const PatchMotion& motion) const;         ///< v_D . t_2 [m/s]
  Eigen::ArrayXd friction_coefficient(const PatchMotion& motion) const;  ///< mu_D

 private:
  const PatchGrid* grid_;
  HertzContact ellipse_;
  FrictionLaw law_;
  Eigen::ArrayXd viscosity_ratio_;  ///< eta_bar at the points; empty without film.
};

/// A body under a contact, and the motion of the contact over it in the tangent plane.
struct HeatedBody {
  double conductivity = 0.0;   ///< k [W/(m K)]
  double density = 0.0;        ///< [kg/m^3]
  double specific_heat = 0.0;  ///< [J/(kg K)]
  double speed_major = 0.0;    ///< Speed of its surface along the major axis of the ellipse [m/s].
  double speed_minor = 0.0;    ///< [m/s]
};

/// Largest rise of the surface of one body [K] that takes all of `power` [W], which flows in as the
/// pressure of Hertz is spread, q = q_0 sqrt(1 - x^2/a^2 - y^2/b^2), q_0 = 3 P/(2 pi a b):
///
///     1/theta^2 = 1/theta_s^2 + 1/theta_f^2,
///     theta_s = 3 P K/(4 pi k a)                             at rest, exact,
///     theta_f = 1.23462 q_0 sqrt(l/(k rho c V))              fast: a band of half length l,
///
/// K the complete elliptic integral for b/a, l half of the ellipse's length along the motion
/// through its centre. The limits are combined with the exponent of Greenwood (Wear 150 (1991)
/// 153), for ellipses in any direction by Muzychka and Yovanovich (ASME J. Heat Transfer 123 (2001)
/// 624). Half spaces, steady.
double surface_rise(const HertzContact& ellipse, const HeatedBody& body, double power);

/// Flash temperature [K]: rise of both surfaces, which are equally hot (Blok 1937), where they
/// share the power [W]: 1/theta = 1/theta_1 + 1/theta_2 with all of it in each. Above the bodies'
/// own temperature.
double flash_temperature(const HertzContact& ellipse, const std::array<HeatedBody, 2>& bodies, double power);

}  // namespace contact
