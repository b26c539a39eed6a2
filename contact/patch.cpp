#include "contact/patch.h"

#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

namespace contact {
namespace {

Eigen::ArrayXd filled_up(const std::vector<double>& values) {
  const auto size = static_cast<Eigen::Index>(values.size());
  Eigen::ArrayXd array =
      Eigen::ArrayXd::Zero((size + simd::kWidest - 1) / simd::kWidest * simd::kWidest);
  array.head(size) = Eigen::Map<const Eigen::ArrayXd>(values.data(), size);
  return array;
}

}  // namespace

PatchGrid::PatchGrid(int points_along_axis) {
  assert(points_along_axis > 0);
  const double n = points_along_axis;
  std::vector<double> major, minor, dome, inverse_dome;
  for (int i = 0; i < points_along_axis; ++i)
    for (int j = 0; j < points_along_axis; ++j) {
      const double x = (2 * i + 1 - n) / n, y = (2 * j + 1 - n) / n;
      if (x * x + y * y >= 1.0) continue;
      major.push_back(x);
      minor.push_back(y);
      dome.push_back(std::sqrt(1.0 - x * x - y * y));
      inverse_dome.push_back(1.0 / dome.back());
    }
  inside_ = static_cast<Eigen::Index>(major.size());
  along_major_ = filled_up(major);
  along_minor_ = filled_up(minor);
  dome_ = filled_up(dome);
  inverse_dome_ = filled_up(inverse_dome);
  cell_load_ = 6.0 / (std::numbers::pi * n * n);
}

PatchPoints PatchGrid::points() const {
  return {along_major_.data(), along_minor_.data(), dome_.data(), inverse_dome_.data(),
          static_cast<std::size_t>(dome_.size())};
}

Patch::Patch(const PatchGrid& grid, const HertzContact& ellipse, double coefficient)
    : grid_(&grid), ellipse_(ellipse), coefficient_(coefficient) {}

Patch::Patch(const PatchGrid& grid, const HertzContact& ellipse, const Lubricant& lubricant,
             const FilmContact& film_contact)
    : grid_(&grid), ellipse_(ellipse), lubricant_(lubricant), film_contact_(film_contact) {
  const PatchPoints points = grid.points();
  viscosity_ratio_ =
      ellipse.peak_pressure *
      Eigen::Map<const Eigen::ArrayXd>(points.dome, static_cast<Eigen::Index>(points.size));
  xsimd::dispatch<simd::Architectures>(ViscosityKernel{})(
      lubricant.viscosity, viscosity_ratio_.data(), points.size, viscosity_ratio_.data());
  viscosity_ratio_.tail(viscosity_ratio_.size() - grid.inside()).setZero();  // no friction there
}

Patch::Patch(const PatchGrid& grid, const HertzContact& ellipse, const Lubricant& lubricant,
             const FilmContact& film_contact, const TouchingFlanks& touching)
    : Patch(grid, ellipse, lubricant, film_contact) {
  touching_ = touching;
}

PatchLaw Patch::law(const PatchMotion& motion) const {
  PatchLaw law;
  law.coefficient = coefficient_;
  if (!lubricant_) return law;
  const double speed = motion.rolling_speed;
  law.viscosity_ratio = viscosity_ratio_.data();
  law.scale = lubricant_->eyring_stress / ellipse_.peak_pressure;
  law.factor = sliding_factor(*lubricant_, film_contact_,
                              sandu_film(*lubricant_, film_contact_, speed), speed);
  if (!touching_) return law;
  const double film = nijenbanning_film(*lubricant_, film_contact_, speed).thickness;
  const double share = boundary_share(film / touching_->roughness, touching_->exponent);
  law.coefficient = share * touching_->friction;
  law.scale *= 1.0 - share;
  return law;
}

PatchFriction Patch::friction(const PatchMotion& motion) const {
  const double a = ellipse_.semi_major, b = ellipse_.semi_minor;
  const PatchSums sums = xsimd::dispatch<simd::Architectures>(PatchKernel{})(
      grid_->points(),
      SlidingField{motion.sliding_major, motion.sliding_minor, motion.spin * a, motion.spin * b},
      law(motion));
  const double weight = grid_->cell_load();
  return {weight * sums.traction_major,
          weight * sums.traction_minor,
          weight * (a * sums.moment_major - b * sums.moment_minor),
          weight * sums.power,
          sums.friction / static_cast<double>(grid_->inside()),
          sums.max_speed};
}

Eigen::ArrayXd Patch::sliding_major(const PatchMotion& motion) const {
  return motion.sliding_major - motion.spin * ellipse_.semi_minor * grid_->along_minor();
}

Eigen::ArrayXd Patch::sliding_minor(const PatchMotion& motion) const {
  return motion.sliding_minor + motion.spin * ellipse_.semi_major * grid_->along_major();
}

Eigen::ArrayXd Patch::sliding_speed(const PatchMotion& motion) const {
  return (sliding_major(motion).square() + sliding_minor(motion).square()).sqrt();
}

double Patch::sliding_under_pressure(const PatchMotion& motion) const {
  return grid_->cell_load() * (grid_->dome() * sliding_speed(motion)).sum();
}

Eigen::ArrayXd Patch::friction_coefficient(const PatchMotion& motion) const {
  const PatchLaw at = law(motion);
  if (!lubricant_) return Eigen::ArrayXd::Constant(grid_->inside(), at.coefficient);
  return at.coefficient +
         at.scale *
             (viscosity_ratio_.head(grid_->inside()) * (at.factor * sliding_speed(motion)))
                 .asinh() /
             grid_->dome();
}

}  // namespace contact
