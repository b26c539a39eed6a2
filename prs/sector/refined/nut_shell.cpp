#include "prs/sector/refined/nut_shell.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "prs/model/case_error.h"

namespace prs {
namespace {

using std::numbers::pi;

/// Radii of the nut between two nodes [m].
struct Wall {
  double root = 0.0;
  double pitch = 0.0;
  double outer = 0.0;
};

fe::ShellRigidity wall_rigidity(const Wall& radii, double reference, const Material& material,
                                int rollers, const RefinedEffects& effects) {
  const double modulus = material.youngs_modulus;
  const double shear_modulus = modulus / (2.0 * (1.0 + material.poisson_ratio));
  const double poisson = effects.poisson && effects.hoop ? material.poisson_ratio : 0.0;
  const auto tube = [&](double inner, double r0) {
    return fe::tube_rigidity(inner, radii.outer, r0, modulus, poisson, shear_modulus);
  };
  fe::ShellRigidity wall = tube(radii.root, reference);
  if (!effects.flange) {
    wall = tube(radii.root, reference + wall.eccentric / wall.axial);
    wall.eccentric = 0.0;
  }
  wall.hoop = tube(radii.pitch, reference).hoop;
  wall.radially_rigid = !effects.hoop;
  return fe::scaled(wall, 1.0 / rollers);
}

/// Shells of all segments; equal ones are worked out once.
std::vector<fe::ShellMatrix> segments(const NutLine& line, const NutBore& bore, double reference,
                                      const Material& material, int rollers,
                                      const RefinedEffects& effects) {
  std::vector<fe::ShellMatrix> shells;
  for (std::size_t i = 0; i < line.outer_radius.size(); ++i) {
    const auto same = [&](std::size_t k) {
      return line.outer_radius[k] == line.outer_radius[i] && bore.root[k] == bore.root[i] &&
             std::abs(line.length(k) - line.length(i)) <= 1e-12 * line.length(i);
    };
    std::size_t k = 0;
    while (k < i && !same(k)) ++k;
    const Wall wall{bore.root[i], bore.pitch, line.outer_radius[i]};
    shells.push_back(
        k < i ? shells[k]
              : fe::stiffness_matrix(wall_rigidity(wall, reference, material, rollers, effects),
                                     line.length(i)));
  }
  return shells;
}

/// Rotation of the thrust section, u held there, by given loads and by a unit moment on it.
struct Tilt {
  double by_loads = 0.0;
  double by_moment = 0.0;  ///< [rad/(N m)]
};

/// Eliminates node by node from both ends to the thrust section.
Tilt thrust_tilt(const NutLine& line, const std::vector<fe::ShellMatrix>& shells,
                 const std::vector<Eigen::Vector3d>& loads, bool radially_rigid) {
  struct Front {
    Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
    Eigen::Vector3d load = Eigen::Vector3d::Zero();
  };
  const auto solvable = [&](Eigen::Matrix3d k) {
    if (radially_rigid) {
      k.row(1).setZero();
      k.col(1).setZero();
      k(1, 1) = 1.0;
    }
    return k;
  };
  const auto at = [&](int node) { return loads[static_cast<std::size_t>(node)]; };
  const int last = static_cast<int>(loads.size()) - 1;
  const auto sweep = [&](int from, int step) {
    Front front;
    for (int node = from; node != line.thrust; node += step) {
      const auto shell = static_cast<std::size_t>(std::min(node, node + step));
      const Eigen::Matrix<double, 6, 6> k = fe::nodal_stiffness(shells[shell]);
      const int here = step > 0 ? 0 : 3, there = 3 - here;
      Eigen::Matrix<double, 3, 4> right;
      right << k.block<3, 3>(here, there), front.load + at(node);
      if (radially_rigid) right.row(1).setZero();
      const Eigen::Matrix<double, 3, 4> solved =
          solvable(front.stiffness + k.block<3, 3>(here, here)).llt().solve(right);
      const Eigen::Matrix3d coupling = k.block<3, 3>(there, here);
      front.stiffness = k.block<3, 3>(there, there) - coupling * solved.leftCols<3>();
      front.load = -coupling * solved.col(3);
    }
    return front;
  };
  const Front before = sweep(0, 1), behind = sweep(last, -1);
  const Eigen::Matrix3d k = solvable(before.stiffness + behind.stiffness);
  Eigen::Matrix2d right;
  right.col(0) = (before.load + behind.load + at(line.thrust)).tail<2>();
  right.col(1) << 0.0, 1.0;
  if (radially_rigid) right.row(0).setZero();
  const Eigen::Matrix2d solved = k.bottomRightCorner<2, 2>().llt().solve(right);
  return {solved(1, 0), solved(1, 1)};
}

/// Radius at which the housing pushes, between the edges of the ring: the further out it does, the
/// more the face tilts, and the further in is the centre of pressure.
double thrust_radius(const ThrustRing& ring, const Tilt& tilt, const NutLoad& load,
                     double axial_force, const Material& material, int rollers) {
  const double plane_modulus =
      material.youngs_modulus / (1.0 - material.poisson_ratio * material.poisson_ratio);
  const auto centre = [&](double radius) {
    const double theta =
        load.sense * tilt.by_loads + tilt.by_moment * axial_force * (radius - ring.inner_radius);
    return ring.inner_radius + centre_of_pressure(rollers * axial_force / (2.0 * pi * radius),
                                                  theta, ring.outer_radius - ring.inner_radius,
                                                  plane_modulus);
  };
  double low = ring.inner_radius, high = ring.outer_radius;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (centre(middle) > middle ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

std::optional<ThrustRing> thrust_ring(const NutLine& line, const Structure::Nut& nut,
                                      const NutBore& bore) {
  const auto thrust = static_cast<std::size_t>(line.thrust);
  const bool at_first = thrust == 0, at_last = thrust == line.outer_radius.size();
  const double before = at_first ? bore.root.front() : line.outer_radius[thrust - 1];
  const double behind = at_last ? bore.root.back() : line.outer_radius[thrust];
  if (before == behind) return {};
  ThrustRing ring{std::min(before, behind), std::max(before, behind)};
  if (nut.shoulder) {
    ring.inner_radius = std::max(ring.inner_radius, 0.5 * nut.shoulder->inner_diameter);
    ring.outer_radius = std::min(ring.outer_radius, 0.5 * nut.shoulder->outer_diameter);
    if (ring.inner_radius >= ring.outer_radius)
      throw CaseError(
          "structure.nut.shoulder",
          fmt::format("misses the face of the nut at the thrust section {:g} mm, which "
                      "reaches from a diameter of {:g} mm to {:g} mm; expected one that "
                      "touches it; fix the diameters",
                      1e3 * line.sections[thrust], 2e3 * std::min(before, behind),
                      2e3 * std::max(before, behind)));
  }
  return ring;
}

double centre_of_pressure(double force, double tilt, double width, double plane_modulus) {
  const double lean = pi * plane_modulus * std::abs(tilt) * width / force;  // 4 where b = w
  const double from_edge = lean > 4.0 ? width / lean : width * (0.5 - lean / 16.0);
  return tilt > 0.0 ? from_edge : width - from_edge;
}

NutShell nut_shell(const NutLine& line, const std::optional<ThrustRing>& ring, const NutBore& bore,
                   const NutLoad& load, const Material& material, int rollers,
                   const RefinedEffects& effects) {
  const std::size_t before = static_cast<std::size_t>(std::max(line.thrust, 1)) - 1;
  const double middle = 0.5 * (bore.root[before] + line.outer_radius[before]);
  const double reference = ring ? ring->inner_radius : middle;
  NutShell nut{segments(line, bore, reference, material, rollers, effects),
               effects.flange ? bore.pitch - reference : 0.0, effects.flange && !ring,
               !effects.hoop};
  if (!ring || !effects.flange) return nut;

  const double axial = std::cos(load.normal_angle), radial = std::sin(load.normal_angle);
  std::vector<Eigen::Vector3d> loads(line.sections.size(), Eigen::Vector3d::Zero());
  for (const int node : line.contacts)
    loads[static_cast<std::size_t>(node)] +=
        Eigen::Vector3d(load.sense * axial, radial, -load.sense * axial * nut.contact_arm);
  const double axial_force = axial * static_cast<double>(line.contacts.size());
  const double radius = thrust_radius(*ring, thrust_tilt(line, nut.segments, loads, !effects.hoop),
                                      load, axial_force, material, rollers);
  for (fe::ShellMatrix& shell : nut.segments) shell = fe::about(shell, radius - reference);
  nut.contact_arm = bore.pitch - radius;
  return nut;
}

}  // namespace prs
