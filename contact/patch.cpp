#include "contact/patch.h"

#include <algorithm>
#include <cassert>

#include "contact/hertz_formulas.h"
#include "simd/dispatch.h"

namespace contact {
namespace {

Eigen::ArrayXd filled_up(const std::vector<double>& values, double with) {
  const auto size = static_cast<Eigen::Index>(values.size());
  Eigen::ArrayXd array = Eigen::ArrayXd::Constant((size + simd::kWidest - 1) / simd::kWidest * simd::kWidest, with);
  array.head(size) = Eigen::Map<const Eigen::ArrayXd>(values.data(), size);
  return array;
}

/// max over x of the integral of sqrt(1 - s^2)/sqrt(x - s) from -1 to x, at x = 0.652, over
/// sqrt(pi).
constexpr double kBand = 1.234619830961;

}  // namespace

PatchGrid::PatchGrid(int points_along_axis) {
  assert(points_along_axis > 0);
  const double n = points_along_axis;
  std::vector<double> major, minor, dome, inverse_dome;
  std::vector<int> squares;  // (n r)^2 of the points, whole numbers.
  for (int i = 0; i < points_along_axis; ++i)
    for (int j = 0; j < points_along_axis; ++j) {
      const int x = 2 * i + 1 - points_along_axis, y = 2 * j + 1 - points_along_axis;
      if (x * x + y * y >= points_along_axis * points_along_axis) continue;
      major.push_back(x / n);
      minor.push_back(y / n);
      squares.push_back(x * x + y * y);
    }
  std::vector<int> different = squares;
  std::ranges::sort(different);
  different.erase(std::unique(different.begin(), different.end()), different.end());
  std::vector<double> domes;
  for (const int square : different) domes.push_back(std::sqrt(n * n - square) / n);
  for (const int square : squares) {
    const auto k = std::lower_bound(different.begin(), different.end(), square) - different.begin();
    dome_of_point_.push_back(static_cast<std::uint32_t>(k));
    dome.push_back(domes[static_cast<std::size_t>(k)]);
    inverse_dome.push_back(1.0 / dome.back());
  }
  inside_ = static_cast<Eigen::Index>(major.size());
  along_major_ = filled_up(major, major.front());
  along_minor_ = filled_up(minor, minor.front());
  dome_ = filled_up(dome, 0.0);
  inverse_dome_ = filled_up(inverse_dome, 0.0);
  domes_ = filled_up(domes, 0.0);
  cell_load_ = 6.0 / (std::numbers::pi * n * n);
}

PatchPoints PatchGrid::points() const {
  return {along_major_.data(), along_minor_.data(), dome_.data(), inverse_dome_.data(),
          static_cast<std::size_t>(dome_.size())};
}

void set_viscosity_ratios(const PatchGrid& grid, double viscosity, double peak_pressure, double* ratio) {
  const auto size = static_cast<std::size_t>(grid.domes().size());
  Eigen::Map<Eigen::ArrayXd>(ratio, grid.domes().size()) = peak_pressure * grid.domes();
  simd::run_kernel(simd::InstructionSet::best, ViscosityKernel{}, viscosity, ratio, size, ratio);
}

Patch::Patch(const PatchGrid& grid, const HertzContact& ellipse, const FrictionLaw& law)
    : grid_(&grid), ellipse_(ellipse), law_(law) {
  if (!law.has_film()) return;
  Eigen::ArrayXd ratio(grid.domes().size());
  set_viscosity_ratios(grid, law.oil.viscosity, ellipse.peak_pressure, ratio.data());
  viscosity_ratio_ = Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(grid.points().size));
  Eigen::Index point = 0;  // No friction beyond those inside.
  for (const std::uint32_t dome : grid.dome_of_point()) viscosity_ratio_[point++] = ratio[dome];
}

template <class Number>
PatchFrictionOf<Number> Patch::friction(const PatchMotionOf<Number>& motion) const {
  const double a = ellipse_.semi_major, b = ellipse_.semi_minor;
  const auto sums =
      simd::run_kernel(simd::InstructionSet::best, PatchKernel{}, grid_->points(), sliding_field(motion, a, b), law_,
                       rolling_contact(law_, ellipse_.peak_pressure, motion), viscosity_ratio_.data());
  return patch_friction(sums, grid_->cell_load(), static_cast<double>(grid_->inside()), a, b);
}
template PatchFriction Patch::friction(const PatchMotion&) const;
template PatchFrictionOf<simd::Dual<double>> Patch::friction(const PatchMotionOf<simd::Dual<double>>&) const;

Eigen::ArrayXd Patch::sliding_major(const PatchMotion& motion) const {
  return motion.sliding_major - motion.spin * ellipse_.semi_minor * grid_->along_minor();
}

Eigen::ArrayXd Patch::sliding_minor(const PatchMotion& motion) const {
  return motion.sliding_minor + motion.spin * ellipse_.semi_major * grid_->along_major();
}

Eigen::ArrayXd Patch::friction_coefficient(const PatchMotion& motion) const {
  const Eigen::ArrayXd speed = (sliding_major(motion).square() + sliding_minor(motion).square()).sqrt();
  Eigen::ArrayXd coefficient(grid_->inside());
  law_.visit([&](const auto& law, bool) {
    const auto friction = law.in(rolling_contact(law_, ellipse_.peak_pressure, motion));
    for (Eigen::Index k = 0; k < coefficient.size(); ++k) {
      const double dome = grid_->dome()[k];
      coefficient[k] = friction({speed[k], dome, law.facts.has_film() ? viscosity_ratio_[k] : 0.0}) / dome;
    }
  });
  return coefficient;
}

double surface_rise(const HertzContact& ellipse, const HeatedBody& body, double power) {
  constexpr double kPi = std::numbers::pi;
  const double a = ellipse.semi_major, b = ellipse.semi_minor;
  const double at_rest = 3.0 * power * complete_elliptic_integrals(b / a).first / (4.0 * kPi * body.conductivity * a);
  const double speed = std::hypot(body.speed_major, body.speed_minor);
  if (!(speed > 0.0)) return at_rest;
  // l/V, the time in which the surface passes half of the band.
  const double time = 1.0 / std::hypot(body.speed_major / a, body.speed_minor / b);
  const double flux = 3.0 * power / (2.0 * kPi * a * b);
  const double fast = kBand * flux * std::sqrt(time / (body.conductivity * body.density * body.specific_heat));
  return at_rest / std::hypot(1.0, at_rest / fast);
}

double flash_temperature(const HertzContact& ellipse, const std::array<HeatedBody, 2>& bodies, double power) {
  if (!(power > 0.0)) return 0.0;
  return 1.0 / (1.0 / surface_rise(ellipse, bodies[0], power) + 1.0 / surface_rise(ellipse, bodies[1], power));
}

}  // namespace contact
