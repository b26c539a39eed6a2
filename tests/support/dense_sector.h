#pragma once

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "support/sectors.h"

namespace test {

/// Independent implementation of the sector, straight from the formulas and with full matrices, sharing no line with
/// `fe/` or the builder: displacement-based Newton on [screw u | nut u | roller u, v, theta] with supports by
/// elimination of rows and columns. Extended precision, since nothing here separates the differences of displacements
/// from their sums.
struct DenseSector {
  using Real = long double;
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

  Matrix linear;                 ///< Supports applied as unit rows.
  std::vector<Vector> approach;  ///< w = approach . q, screw contacts, then nut contacts.
  std::vector<Real> k0;
  std::vector<Real> gap;
  Vector unit_load;
  Vector push_screw, push_both;  ///< Rigid shift of the screw, and of screw and roller.
  std::vector<bool> held;

  explicit DenseSector(const SectorCase& c) {
    const auto& m = c.mechanism;
    const auto& st = c.structure;
    const int n = m.contacts_per_roller;
    const Real p = std::abs(m.lead) / m.starts.screw;
    const Real s = c.direction == prs::Direction::tension ? -1.0 : 1.0;
    const Real pi = std::acos(-1.0);

    std::vector<Real> cuts{0.0, st.nut.length};
    const Real thrust = s < 0.0 ? st.nut.thrust.tension.value() : st.nut.thrust.compression.value();
    cuts.push_back(thrust);
    for (const auto& f : st.nut.flanges) cuts.insert(cuts.end(), {f.from, f.to});
    for (int k = 0; k < n; ++k) cuts.push_back(c.position + k * p);
    std::sort(cuts.begin(), cuts.end());
    std::vector<Real> nut;
    for (const Real x : cuts)
      if (nut.empty() || x - nut.back() >= 1e-9 * st.nut.length) nut.push_back(x);
    const auto nut_index = [&](Real x) {
      int best = 0;
      for (int i = 0; i < static_cast<int>(nut.size()); ++i)
        if (std::abs(nut[static_cast<std::size_t>(i)] - x) < std::abs(nut[static_cast<std::size_t>(best)] - x))
          best = i;
      return best;
    };

    const int nuts = static_cast<int>(nut.size());
    const int rollers = n + 4;
    const auto us = [&](int k) { return k; };  // 0: loaded section, 1..n: contacts
    const auto un = [&](int i) { return n + 1 + i; };
    const auto ur = [&](int i, int dof) { return n + 1 + nuts + 3 * i + dof; };
    const int size = n + 1 + nuts + 3 * rollers;
    linear = Matrix::Zero(size, size);
    held.assign(static_cast<std::size_t>(size), false);
    const auto bar = [&](int a, int b, Real k) {
      linear(a, a) += k;
      linear(b, b) += k;
      linear(a, b) -= k;
      linear(b, a) -= k;
    };

    const Real screw_ea = c.materials.screw.youngs_modulus * pi / 4 *
                          (std::pow(*m.pitch_diameter.screw, 2) - std::pow(st.screw.bore, 2)) / m.rollers;
    for (int k = 1; k < n; ++k) bar(us(k), us(k + 1), screw_ea / p);
    int loaded = us(0);
    if (st.screw.free_length > 0.0) {
      bar(us(0), us(1), screw_ea / st.screw.free_length);
    } else {
      loaded = us(1);
      held[0] = true;
    }
    for (int i = 1; i < nuts; ++i) {
      const Real mid = 0.5 * (nut[static_cast<std::size_t>(i)] + nut[static_cast<std::size_t>(i) - 1]);
      Real outer = st.nut.outer_diameter;
      for (const auto& f : st.nut.flanges)
        if (mid > f.from && mid < f.to) outer = f.outer_diameter;
      const Real area = pi / 4 * (outer * outer - std::pow(*m.pitch_diameter.nut, 2)) / m.rollers;
      bar(un(i - 1), un(i),
          c.materials.nut.youngs_modulus * area /
              (nut[static_cast<std::size_t>(i)] - nut[static_cast<std::size_t>(i) - 1]));
    }
    held[static_cast<std::size_t>(un(nut_index(thrust)))] = true;

    const auto& steel = c.materials.roller;
    for (int i = 0; i + 1 < rollers; ++i) {
      const bool end = i == 0 || i == rollers - 2;
      const bool run_out = i == 1 || i == rollers - 3;
      const Real l = end ? st.roller.end_length : run_out ? p / 2 : p;
      const Real d = end ? st.roller.end_diameter : *m.pitch_diameter.roller;
      const Real area = pi * d * d / 4, inertia = pi * std::pow(d, 4) / 64;
      bar(ur(i, 0), ur(i + 1, 0), steel.youngs_modulus * area / l);
      const Real shear_modulus = steel.youngs_modulus / 2 / (1 + steel.poisson_ratio);
      const Real cowper = 6 * (1 + steel.poisson_ratio) / (7 + 6 * steel.poisson_ratio);
      // Flexibility of the cantilever at its end, inverted, gives the end block of the stiffness.
      Eigen::Matrix<Real, 2, 2> flexibility;
      const Real ei = steel.youngs_modulus * inertia;
      const Real shear = c.options.roller_shear ? l / (cowper * shear_modulus * area) : 0.0;
      flexibility << l * l * l / 3 / ei + shear, l * l / 2 / ei, l * l / 2 / ei, l / ei;
      const Eigen::Matrix<Real, 2, 2> end_block = flexibility.inverse();
      Eigen::Matrix<Real, 2, 4> relative;  // end motion less the start's rigid motion
      relative << -1, -l, 1, 0, 0, -1, 0, 1;
      const Eigen::Matrix<Real, 4, 4> k = relative.transpose() * end_block * relative;
      const int dof[4] = {ur(i, 1), ur(i, 2), ur(i + 1, 1), ur(i + 1, 2)};
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b) linear(dof[a], dof[b]) += k(a, b);
    }
    const int ends[4] = {0, 1, rollers - 2, rollers - 1};
    if (c.options.roller == prs::ModelOptions::Roller::rigid_bending) {
      for (int i = 0; i < rollers; ++i)
        held[static_cast<std::size_t>(ur(i, 1))] = held[static_cast<std::size_t>(ur(i, 2))] = true;
    } else {
      for (const int i : ends) {
        const bool outer = i == 0 || i == rollers - 1;
        switch (st.roller.guidance.kind) {
          case prs::Guidance::Kind::both_end_nodes:
            held[static_cast<std::size_t>(ur(i, 1))] = true;
            break;
          case prs::Guidance::Kind::outer_node:
            if (outer) held[static_cast<std::size_t>(ur(i, 1))] = true;
            break;
          case prs::Guidance::Kind::ring:
            linear(ur(i, 1), ur(i, 1)) += st.roller.guidance.ring_stiffness;
            break;
        }
      }
    }

    const Real r = *m.pitch_diameter.roller / 2;
    const Real roller_pitch = m.pitch.roller ? Real(*m.pitch.roller) : p;
    for (int k = 0; k < n; ++k) {
      Vector w = Vector::Zero(size);
      const Real psi = c.laws.screw.normal_angle;
      w[us(k + 1)] = s * std::cos(psi);
      w[ur(k + 2, 0)] = -s * std::cos(psi);
      w[ur(k + 2, 2)] = -s * std::cos(psi) * r;
      w[ur(k + 2, 1)] = -std::sin(psi);
      approach.push_back(w);
      k0.push_back(c.laws.screw.hertz_constant);
      gap.push_back(s * std::cos(psi) * k * (roller_pitch - p));
    }
    for (int k = 0; k < n; ++k) {
      Vector w = Vector::Zero(size);
      const Real psi = c.laws.nut.normal_angle;
      w[ur(k + 2, 0)] = s * std::cos(psi);
      w[ur(k + 2, 2)] = -s * std::cos(psi) * r;
      w[un(nut_index(c.position + k * p))] = -s * std::cos(psi);
      w[ur(k + 2, 1)] = std::sin(psi);
      approach.push_back(w);
      k0.push_back(c.laws.nut.hertz_constant);
      gap.push_back(s * std::cos(psi) * k * (p - roller_pitch));
    }
    for (const auto first : {gap.begin(), gap.begin() + n}) {  // the closest thread touches
      const Real closest = *std::min_element(first, first + n);
      std::for_each(first, first + n, [&](Real& g) { g -= closest; });
    }
    unit_load = Vector::Zero(size);
    unit_load[loaded] = s;
    push_screw = push_both = Vector::Zero(size);
    for (int k = 0; k <= n; ++k) push_screw[us(k)] = push_both[us(k)] = s;
    for (int i = 0; i < rollers; ++i) push_both[ur(i, 0)] = s;
  }

  struct Solution {
    bool converged = false;
    std::vector<Real> normal_load;
    Real displacement = 0.0;
    Real tangent_stiffness = 0.0;  ///< Stiffness of one sector.
  };

  Solution solve(Real sector_force) const {
    const auto size = static_cast<int>(unit_load.size());
    const auto contacts = approach.size();
    Solution result;
    // Every contact closed by its share of the load: the tangent is regular.
    Vector q = Vector::Zero(size);
    for (const bool at_screw : {true, false}) {
      const Vector& push = at_screw ? push_screw : push_both;
      Real shift = 0;
      for (std::size_t i = at_screw ? 0 : contacts / 2; i < (at_screw ? contacts / 2 : contacts); ++i) {
        const Real share = sector_force / static_cast<Real>(contacts / 2);
        const Real approached = gap[i] + std::pow(share / k0[i], Real(2) / 3);
        shift = std::max(shift, approached / approach[i].dot(push));
      }
      q += shift * push;
    }
    const auto residual = [&](const Vector& x) {
      Vector r = linear * x - sector_force * unit_load;
      for (std::size_t i = 0; i < contacts; ++i) {
        const Real w = std::max(Real(0), approach[i].dot(x) - gap[i]);
        r += k0[i] * std::pow(w, 1.5) * approach[i];
      }
      return r;
    };
    const auto energy = [&](const Vector& x) {
      Real e = 0.5 * x.dot(linear * x) - sector_force * unit_load.dot(x);
      for (std::size_t i = 0; i < contacts; ++i)
        e += 0.4 * k0[i] * std::pow(std::max(Real(0), approach[i].dot(x) - gap[i]), 2.5);
      return e;
    };
    Eigen::MatrixXd tangent;
    const auto factorize = [&](const Vector& x) {
      tangent = linear.cast<double>();
      for (std::size_t i = 0; i < contacts; ++i) {
        const Real w = std::max(Real(0), approach[i].dot(x) - gap[i]);
        const Eigen::VectorXd row = (std::sqrt(1.5 * k0[i] * std::sqrt(w)) * approach[i]).cast<double>();
        tangent.selfadjointView<Eigen::Lower>().rankUpdate(row);
      }
      for (int i = 0; i < size; ++i)
        if (held[static_cast<std::size_t>(i)]) {
          tangent.row(i).setZero();
          tangent.col(i).setZero();
          tangent(i, i) = 1.0;
        }
    };
    Real previous = 1e300;
    for (int iteration = 0; iteration < 200; ++iteration) {
      Vector r = residual(q);
      for (int i = 0; i < size; ++i)
        if (held[static_cast<std::size_t>(i)]) r[i] = 0.0;
      const Real norm = r.cwiseAbs().maxCoeff() / sector_force;
      if (norm < 1e-15 || (norm < 1e-11 && norm >= previous)) {
        result.converged = true;
        break;
      }
      previous = norm;
      factorize(q);
      const Vector d = tangent.ldlt().solve(r.cast<double>()).cast<Real>();
      Real t = 1.0;
      const Real e = energy(q);
      while (t > 1e-8 && norm > 1e-8 && energy(q - t * d) > e) t *= 0.5;
      q -= t * d;
    }
    for (std::size_t i = 0; i < contacts; ++i)
      result.normal_load.push_back(k0[i] * std::pow(std::max(Real(0), approach[i].dot(q) - gap[i]), 1.5));
    result.displacement = unit_load.dot(q);
    factorize(q);
    const Eigen::VectorXd load = unit_load.cast<double>();
    result.tangent_stiffness = 1.0 / load.dot(tangent.ldlt().solve(load));
    return result;
  }
};

}  // namespace test
