#pragma once

#include <Eigen/Core>
#include <optional>

#include "contact/film.h"
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
  auto dome() const { return dome_.head(inside_); }  ///< sqrt(1 - (t_1D/a)^2 - (t_2D/b)^2), > 0
  /// Load on a cell over the normal load and the dome: p_0 4 a b/(n^2 N) = 6/(pi n^2) (3.7).
  double cell_load() const { return cell_load_; }
  /// With the points that fill up the last batch.
  PatchPoints points() const;

 private:
  Eigen::Index inside_ = 0;
  Eigen::ArrayXd along_major_, along_minor_, dome_, inverse_dome_;
  double cell_load_ = 0.0;
};

/// How one body slides on the other in the tangent plane of a contact (Sandu 2018, (2.22)).
struct PatchMotion {
  double sliding_major = 0.0;  ///< v_M . t_1 at the centre [m/s]
  double sliding_minor = 0.0;  ///< v_M . t_2 [m/s]
  double spin = 0.0;           ///< Relative angular velocity about the normal t_1 x t_2 [rad/s]
  double rolling_speed = 0.0;  ///< |u_M|, sum of the surface velocities in the tangent plane [m/s]
};

/// Friction on a patch over its normal load N (equations of Sandu 2018). The friction acts on the
/// body that the other slides over, along the sliding velocity.
struct PatchFriction {
  double traction_major = 0.0;     ///< T . t_1/N [-] (3.6)
  double traction_minor = 0.0;     ///< T . t_2/N [-]
  double spin_arm = 0.0;           ///< C/N, moment about the centre along t_1 x t_2 [m] (3.10)
  double power_per_load = 0.0;     ///< Lost power over N [m/s] (3.51)
  double mean_friction = 0.0;      ///< mu_a over the points inside (2.40)
  double max_sliding_speed = 0.0;  ///< Over the points [m/s]
};

/// Flanks that touch through a thin film.
struct TouchingFlanks {
  double friction = 0.0;   ///< Coefficient without film.
  double exponent = 2.0;   ///< Of `boundary_share`.
  double roughness = 0.0;  ///< Composite Rq [m], > 0
};

/// One contact ellipse with its law of friction: what is constant while the slip ratio is sought.
class Patch {
 public:
  /// Coulomb friction.
  Patch(const PatchGrid& grid, const HertzContact& ellipse, double coefficient);
  /// Jacod's law, point by point: Eyring fluid, Roelands viscosity at the Hertz pressure of the
  /// *static* load in `ellipse`, Sandu's film of the whole contact.
  Patch(const PatchGrid& grid, const HertzContact& ellipse, const Lubricant& lubricant,
        const FilmContact& film_contact);
  /// Mixed friction (Olver and Spikes 1998): mu_D = (1 - s) mu_film + s mu_touching at each point,
  /// mu_film Jacod's, s the `boundary_share` of the whole contact by Nijenbanning's central film.
  /// Jacod's for thick films, Coulomb's without film or entrainment.
  Patch(const PatchGrid& grid, const HertzContact& ellipse, const Lubricant& lubricant,
        const FilmContact& film_contact, const TouchingFlanks& touching);

  const HertzContact& ellipse() const { return ellipse_; }

  /// Resultants of the friction (Sandu 2018, (3.8), (3.10), (3.51)). Points slower than
  /// kNoDirection are left out of tractions, moment and power, not of the mean coefficient. No
  /// allocation.
  PatchFriction friction(const PatchMotion& motion) const;
  /// Integral of pressure times sliding speed over the normal load [m/s], for wear.
  double sliding_under_pressure(const PatchMotion& motion) const;

  // At every point inside:
  Eigen::ArrayXd sliding_major(const PatchMotion& motion) const;         ///< v_D . t_1 [m/s]
  Eigen::ArrayXd sliding_minor(const PatchMotion& motion) const;         ///< v_D . t_2 [m/s]
  Eigen::ArrayXd friction_coefficient(const PatchMotion& motion) const;  ///< mu_D

 private:
  PatchLaw law(const PatchMotion& motion) const;
  Eigen::ArrayXd sliding_speed(const PatchMotion& motion) const;

  const PatchGrid* grid_;
  HertzContact ellipse_;
  double coefficient_ = 0.0;
  std::optional<Lubricant> lubricant_;
  FilmContact film_contact_;
  std::optional<TouchingFlanks> touching_;
  Eigen::ArrayXd viscosity_ratio_;  ///< eta_bar at the points; empty with Coulomb.
};

}  // namespace contact
