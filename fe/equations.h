#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "fe/model.h"
#include "fe/sparse_symmetric.h"
#include "fe/state.h"

namespace fe {

/// The model as equations: numbered free freedoms, the sparse pattern, the linear part of the
/// stiffness, and for each spring its approach as a linear form of the unknowns with the places
/// where its tangent goes. Built once, read by every solve.
class Equations {
 public:
  explicit Equations(const Model& model);

  int size() const { return static_cast<int>(kind_.size()); }
  /// Number of the equation of a freedom, or -1 where it is fixed or not stiffened by anything.
  int number(int node, Dof dof) const {
    return number_[static_cast<std::size_t>(kDofsPerNode * node + static_cast<int>(dof))];
  }
  Dof kind(int equation) const { return kind_[static_cast<std::size_t>(equation)]; }

  /// Displacement of a freedom [m or rad]; 0 where fixed.
  double displacement(const State& q, int node, Dof dof) const { return q[number(node, dof)]; }

  /// Load vector over the free freedoms; loads on fixed ones go into the support.
  Eigen::VectorXd load_vector(const std::vector<NodalLoad>& loads) const;

  /// A spring by its approach w = sum_i coefficient[i] q[equation[i]] over at most six freedoms;
  /// `slot` leads to the values of the tangent for each pair i <= j.
  struct Spring {
    static constexpr int kMost = 2 * kDofsPerNode;
    PowerLawSpring law;
    std::size_t count = 0;
    std::array<int, kMost> equation{};
    std::array<double, kMost> coefficient{};
    std::array<int, kMost*(kMost + 1) / 2> slot{};

    double approach(const State& q) const;
    /// Approach less gap, to its own rounding: it may be far smaller than the displacements.
    double net_approach(const State& q) const;

    /// Calls add(slot, value) for the tangent stiffness k times the coefficients' outer product.
    template <class Real, class Add>
    void for_each_tangent(const Real& k, Add add) const {
      std::size_t next = 0;
      for (std::size_t i = 0; i < count; ++i) {
        const Real row = k * coefficient[i];
        for (std::size_t j = i; j < count; ++j) add(slot[next++], Real(row * coefficient[j]));
      }
    }
  };

  const std::vector<Spring>& springs() const { return springs_; }
  /// Approach w of spring k, without its gap [m].
  double approach(const State& q, int k) const;
  /// Approach of spring k less its gap, to its own rounding [m].
  double net_approach(const State& q, int k) const;
  /// Force, tangent and energy of spring k.
  SpringResponse response(const State& q, int k) const;
  /// Deflection of the power law alone of spring k [m].
  double law_approach(const State& q, int k) const;

  /// A matrix with the fixed pattern, holding the linear part (bars, beams, shells, elastic
  /// supports) [N/m].
  const SparseSymmetric& linear_stiffness() const { return linear_; }
  /// Its values in numbers of another kind.
  template <class Real>
  std::vector<Real> linear_values() const;
  /// Forces K q of the linear part, element by element from what deforms them. `Displacements`
  /// reads as State does.
  template <class Displacements, class Vector>
  void linear_forces(const Displacements& q, Vector& forces) const;

  /// Potential energy 1/2 q'Kq + sum of the springs' - f'q [J], and its gradient, the residual
  /// [N, N m]. Allocates nothing.
  double energy_and_residual(const State& q, const Eigen::VectorXd& f,
                             Eigen::VectorXd& residual) const;

  /// Largest residual of each equation that rounding of the state alone can cause: eps times the
  /// sum of |K_ij q_j| over the elements [N, N m].
  Eigen::VectorXd rounding_residual(const State& q) const;

  /// Refills `tangent`, the Hessian of the energy, in place. Allocates nothing.
  void tangent_stiffness(const State& q, SparseSymmetric& tangent) const;

  /// f - K x with the tangent K at the state q, from what x deforms: exact to rounding of the
  /// forces however large the rigid motion in x is. Allocates nothing.
  void tangent_residual(const State& q, const State& x, const Eigen::VectorXd& f,
                        Eigen::VectorXd& residual) const;

  /// Largest change of a spring's force by a step x to the state q, relative to the largest force.
  double force_change(const State& q, const Eigen::VectorXd& x) const;
  /// What rounding of `Spring::approach` at the state q can change in a force, likewise.
  double force_rounding(const State& q) const;

 private:
  struct NumberedBar {
    std::array<int, 2> equation;
    double stiffness;
  };
  struct NumberedBeam {
    std::array<int, 6> equation;
    Beam beam;
  };
  struct NumberedShell {
    std::array<int, 6> equation;
    ShellMatrix stiffness;
  };
  struct NumberedSupport {
    int equation;
    double stiffness;
  };

  void number_freedoms(const Model& model);
  void add_linear_elements(const Model& model);
  void add_springs(const Model& model);
  int slot(int i, int j) const;

  std::vector<int> number_;
  std::vector<Dof> kind_;
  std::vector<NumberedBar> bars_;
  std::vector<NumberedBeam> beams_;
  std::vector<NumberedShell> shells_;
  std::vector<NumberedSupport> supports_;
  std::vector<Spring> springs_;
  SparseSymmetric linear_;
};

template <class Real>
std::vector<Real> Equations::linear_values() const {
  std::vector<Real> value(linear_.row.size(), Real(0.0));
  const auto add = [&](int i, int j, const Real& k) {
    if (i >= 0 && j >= 0) value[static_cast<std::size_t>(slot(i, j))] += k;
  };
  const auto add_all = [&](const std::array<int, 6>& equation, const auto& k) {
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = i; j < 6; ++j)
        add(equation[i], equation[j],
            k(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
  };
  for (const NumberedBar& b : bars_) {
    const auto [i, j] = b.equation;
    const Real k = b.stiffness;
    add(i, i, k);
    add(j, j, k);
    add(i, j, -k);
  }
  for (const NumberedBeam& b : beams_) add_all(b.equation, stiffness_matrix<Real>(b.beam));
  for (const NumberedShell& s : shells_) add_all(s.equation, nodal_stiffness<Real>(s.stiffness));
  for (const NumberedSupport& s : supports_) add(s.equation, s.equation, Real(s.stiffness));
  return value;
}

template <class Displacements, class Vector>
void Equations::linear_forces(const Displacements& q, Vector& forces) const {
  using Real = typename Vector::Scalar;
  forces.setZero();
  const auto add = [&](int equation, const Real& force) {
    if (equation >= 0) forces[equation] += force;
  };
  const auto add_all = [&](const std::array<int, 6>& equation, const BeamVector<Real>& f) {
    for (std::size_t i = 0; i < 6; ++i) add(equation[i], f[static_cast<Eigen::Index>(i)]);
  };
  for (const NumberedBar& b : bars_) {
    const auto [i, j] = b.equation;
    const Real tension = b.stiffness * q.difference(i, j);
    add(i, -tension);
    add(j, tension);
  }
  for (const NumberedBeam& b : beams_) {
    const auto& [u1, v1, t1, u2, v2, t2] = b.equation;
    add_all(b.equation, end_forces<Real>(b.beam, {q.difference(u1, u2), q.difference(v1, v2), q[t1],
                                                  q[t2], q.compensation(t1), q.compensation(t2)}));
  }
  for (const NumberedShell& s : shells_) {
    const auto& [u1, v1, t1, u2, v2, t2] = s.equation;
    const auto mean = [&](int i, int j) -> Real {
      return 0.5 * (q[i] + q[j]) + 0.5 * (q.compensation(i) + q.compensation(j));
    };
    add_all(s.equation,
            end_forces<Real>(s.stiffness, {q.difference(u1, u2), q.difference(v1, v2),
                                           q.difference(t1, t2), mean(v1, v2), mean(t1, t2)}));
  }
  for (const NumberedSupport& s : supports_) add(s.equation, s.stiffness * q[s.equation]);
}

}  // namespace fe
