#pragma once

#include <array>

#include "fe/model.h"
#include "fe/sparse_symmetric.h"

namespace fe {

/// Displacements as an unevaluated sum head + tail. Stiff elements multiply differences of nearly
/// equal displacements by large numbers; the tail keeps the digits that the head alone would lose,
/// so that equilibrium holds to rounding of the forces and not of the displacements.
struct State {
  Eigen::VectorXd head;
  Eigen::VectorXd tail;

  State() = default;
  State(Eigen::VectorXd q)  // NOLINT: a plain vector is a state without tail
      : head(std::move(q)), tail(Eigen::VectorXd::Zero(head.size())) {}

  /// Displacement i; -1 is a freedom that does not move.
  double operator[](int i) const { return i < 0 ? 0.0 : head[i]; }

  /// Compensation of displacement i: the part that the head lost by rounding.
  double compensation(int i) const { return i < 0 ? 0.0 : tail[i]; }

  /// Displacement j minus displacement i.
  double difference(int i, int j) const {
    if (i < 0 || j < 0) return (*this)[j] - (*this)[i];
    return (head[j] - head[i]) + (tail[j] - tail[i]);
  }

  /// Sets this to from - length * step; the tail keeps the rounding error of the head.
  void set_to_step(const State& from, double length, const Eigen::VectorXd& step) {
    for (Eigen::Index i = 0; i < step.size(); ++i) {
      const double change = from.tail[i] - length * step[i];
      const double sum = from.head[i] + change;
      const double rounded = sum - from.head[i];
      tail[i] = (from.head[i] - (sum - rounded)) + (change - rounded);
      head[i] = sum;
    }
  }
};

/// The model as equations: numbered free freedoms, the sparse pattern, the linear part of the stiffness, and for each
/// spring its approach as a linear form of the unknowns with the slots of its tangent in the matrix. Built once, read
/// by every solve.
class Equations {
 public:
  explicit Equations(const Model& model);

  /// Takes the numbers of another model. Numbering and pattern stay, and objects built on them remain valid. Returns
  /// false, without a change, if the model has other nodes, elements or forms.
  bool take(const Model& model);

  int size() const { return static_cast<int>(kind_.size()); }
  /// Number of the equation of a freedom, or -1 if it is fixed or has no stiffness. From `size()` on: freedoms that
  /// follow others.
  int number(int node, Dof dof) const {
    return number_[static_cast<std::size_t>(kDofsPerNode * node + static_cast<int>(dof))];
  }
  Dof kind(int equation) const { return kind_[static_cast<std::size_t>(equation)]; }

  /// Displacement of a freedom [m or rad]; 0 where fixed.
  double displacement(const State& q, int node, Dof dof) const {
    return Displacements<State>{*this, q, 1.0}[number(node, dof)];
  }

  /// Load vector over the free freedoms; loads on fixed ones go into the support.
  Eigen::VectorXd load_vector(const std::vector<NodalLoad>& loads) const;
  /// Calls visit(equation, force) for the terms of the loads.
  template <class Visit>
  void for_each_load(const std::vector<NodalLoad>& loads, Visit visit) const {
    for (const NodalLoad& load : loads)
      for_each_term(number(load.node, load.dof), [&](int equation, double c) { visit(equation, c * load.value); });
  }

  /// A spring by its approach w = sum_i coefficient[i] q[equation[i]] over at most kMost freedoms;
  /// `slot` leads to the values of the tangent for each pair i <= j.
  struct Spring {
    static constexpr int kMost = 24;
    PowerLawSpring law;
    std::size_t count = 0;
    std::array<int, kMost> equation{};
    std::array<double, kMost> coefficient{};
    std::vector<int> slot;

    double approach(const State& q) const;
    /// Approach less gap, to its own rounding: it may be far smaller than the displacements.
    double net_approach(const State& q) const;

    /// Calls add(slot, value) for the tangent stiffness k times the outer product of the coefficients.
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
  /// Approach of spring k less its gap, without cancellation [m].
  double net_approach(const State& q, int k) const;
  /// Force, tangent and energy of spring k.
  SpringResponse response(const State& q, int k) const;
  /// Deflection of spring k's power law alone [m].
  double law_approach(const State& q, int k) const;

  /// A matrix with the fixed pattern, holding the linear part (bars, beams, shells, elastic
  /// supports) [N/m].
  const SparseSymmetric& linear_stiffness() const { return linear_; }
  /// The values of that matrix in another number type.
  template <class Real>
  std::vector<Real> linear_values() const;
  /// Forces of the linear part at the state q, element by element from the deformations: K q if supports displace
  /// nothing. Returns 2 E - q'forces, with the stored energy E. `StateOf` has the functions of State.
  template <class StateOf, class Vector>
  auto linear_forces(const StateOf& q, Vector& forces) const {
    return forces_of(Displacements<StateOf>{*this, q, 1.0}, forces);
  }

  /// Potential energy 1/2 q'Kq + sum of the springs' - f'q [J], and its gradient, the residual
  /// [N, N m]. Allocates nothing.
  double energy_and_residual(const State& q, const Eigen::VectorXd& f, Eigen::VectorXd& residual) const;

  /// Largest residual of each equation that rounding of the state alone can cause: eps times the
  /// sum of |K_ij q_j| over the elements [N, N m].
  Eigen::VectorXd rounding_residual(const State& q) const;

  /// Fills `matrix`, of the pattern of `linear_stiffness`, for linear springs of these stiffnesses in place of the
  /// contacts [N/m]; with the contacts' tangents it is the Hessian of the energy.
  void secant_stiffness(const std::vector<double>& stiffness, SparseSymmetric& matrix) const;
  /// f less the forces of such springs and of the linear part without displaced supports.
  void secant_residual(const std::vector<double>& stiffness, const Eigen::VectorXd& f, Eigen::VectorXd& residual) const;
  /// f - K x with such springs, without their gaps.
  void secant_residual(const std::vector<double>& stiffness, const State& x, const Eigen::VectorXd& f,
                       Eigen::VectorXd& residual) const;

  /// Largest approach of a spring, of either sign [m].
  double largest_approach(const State& q) const;

  /// f - K x with the tangent K at the state q, from the deformations in x: exact to rounding of the forces however
  /// large the rigid motion in x is. Allocates nothing.
  void tangent_residual(const State& q, const State& x, const Eigen::VectorXd& f, Eigen::VectorXd& residual) const;

  /// Largest change of a spring's force by a step x to the state q, relative to the largest force.
  double force_change(const State& q, const Eigen::VectorXd& x) const;
  /// Largest change of a spring's force by rounding of `Spring::approach` at the state q, relative to the largest
  /// force.
  double force_rounding(const State& q) const;

  /// Force of an elastic link of the model [N or N m].
  double link_force(const State& q, int k) const {
    const NumberedLink& link = links_[static_cast<std::size_t>(k)];
    return link.stiffness * Displacements<State>{*this, q, 1.0}.stretch(link);
  }
  /// Forces that hold each freedom against the elements other than links, followers included, in
  /// the order of `number` [N, N m].
  std::vector<double> nodal_forces(const State& q) const;

 private:
  /// A freedom that follows others, as a form of equations.
  struct Follower {
    std::vector<std::pair<int, double>> terms;
    double offset = 0.0;
  };
  struct NumberedLink {
    std::vector<std::pair<int, double>> terms;
    double rest;
    double stiffness;
  };

  /// Displacements of all freedoms, including followers. Offsets and compensations count `affine` times: 1 for a state,
  /// 0 for a rate.
  template <class StateOf>
  struct Displacements {
    const Equations& equations;
    const StateOf& q;
    double affine;

    using Real = std::decay_t<decltype(std::declval<StateOf>().compensation(0))>;
    struct Sum {
      Real head, tail;
    };
    Sum sum(const std::vector<std::pair<int, double>>& terms, double offset) const {
      Sum s{Real(affine * offset), Real(0.0)};
      for (const auto& [i, c] : terms) {
        const Real product = c * q[i];
        if constexpr (std::is_same_v<Real, double>) s.tail += std::fma(c, q[i], -product) + c * q.compensation(i);
        const Real next = s.head + product, rounded = next - s.head;
        s.tail += (s.head - (next - rounded)) + (product - rounded);
        s.head = next;
      }
      return s;
    }
    Sum at(int i) const {
      if (i < equations.size()) return {q[i], q.compensation(i)};
      const Follower& f = equations.followers_[static_cast<std::size_t>(i - equations.size())];
      return sum(f.terms, f.offset);
    }
    Real operator[](int i) const { return i < equations.size() ? q[i] : at(i).head; }
    Real compensation(int i) const { return i < equations.size() ? q.compensation(i) : at(i).tail; }
    Real difference(int i, int j) const {
      if (std::max(i, j) < equations.size()) return q.difference(i, j);
      const Sum a = at(i), b = at(j);
      return (b.head - a.head) + (b.tail - a.tail);
    }
    Real stretch(const NumberedLink& link) const {
      const Sum s = sum(link.terms, -link.rest);
      return s.head + s.tail;
    }
  };

  /// Calls visit(equation, coefficient) for the terms of a freedom.
  template <class Visit>
  void for_each_term(int equation, Visit visit) const {
    if (equation < 0) return;
    if (equation < size()) return visit(equation, 1.0);
    for (const auto& [i, c] : followers_[static_cast<std::size_t>(equation - size())].terms) visit(i, c);
  }
  template <class Number>
  std::vector<double> nodal_forces_by(const State& q) const;
  template <class Read, class Vector>
  typename Vector::Scalar forces_of(const Read& q, Vector& forces) const;
  /// Calls add(equation, force on it) and link(link, its force) for every element.
  template <class Read, class Add, class Link>
  void for_each_force(const Read& q, Add add, Link link) const;
  std::vector<std::pair<int, double>> terms_of(const LinearForm& form, double& offset) const;

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
  void add_followers(const Model& model);
  void add_linear_elements(const Model& model);
  void add_springs(const Model& model);
  int slot(int i, int j) const;

  std::vector<int> shape_;  ///< Freedoms joined by each part of the model.
  std::vector<int> number_;
  std::vector<Dof> kind_;
  std::vector<NumberedBar> bars_;
  std::vector<NumberedBeam> beams_;
  std::vector<NumberedShell> shells_;
  std::vector<NumberedSupport> supports_;
  std::vector<NumberedLink> links_;
  std::vector<Follower> followers_;
  std::vector<Spring> springs_;
  SparseSymmetric linear_;
};

template <class Real>
std::vector<Real> Equations::linear_values() const {
  std::vector<Real> value(linear_.row.size(), Real(0.0));
  const auto add = [&](int i, int j, const Real& k) {
    for_each_term(i, [&](int a, double c) {
      for_each_term(j, [&](int b, double d) {
        if (i == j && a > b) return;
        const double twice = i != j && a == b ? 2.0 : 1.0;
        value[static_cast<std::size_t>(slot(a, b))] += twice * c * d * k;
      });
    });
  };
  const auto add_all = [&](const std::array<int, 6>& equation, const auto& k) {
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = i; j < 6; ++j)
        add(equation[i], equation[j], k(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
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
  for (const NumberedLink& link : links_)
    for (std::size_t a = 0; a < link.terms.size(); ++a)
      for (std::size_t b = a; b < link.terms.size(); ++b)
        value[static_cast<std::size_t>(slot(link.terms[a].first, link.terms[b].first))] +=
            Real(link.stiffness) * link.terms[a].second * link.terms[b].second;
  return value;
}

template <class Read, class Add, class Link>
void Equations::for_each_force(const Read& q, Add add, Link link) const {
  using Real = typename Read::Real;
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
    add_all(b.equation, end_forces<Real>(b.beam, {q.difference(u1, u2), q.difference(v1, v2), q[t1], q[t2],
                                                  q.compensation(t1), q.compensation(t2)}));
  }
  for (const NumberedShell& s : shells_) {
    const auto& [u1, v1, t1, u2, v2, t2] = s.equation;
    const auto mean = [&](int i, int j) -> Real {
      return 0.5 * (q[i] + q[j]) + 0.5 * (q.compensation(i) + q.compensation(j));
    };
    add_all(s.equation, end_forces<Real>(s.stiffness, {q.difference(u1, u2), q.difference(v1, v2), q.difference(t1, t2),
                                                       mean(v1, v2), mean(t1, t2)}));
  }
  for (const NumberedSupport& s : supports_) add(s.equation, Real(s.stiffness * q[s.equation]));
  for (const NumberedLink& l : links_) link(l, Real(l.stiffness * q.stretch(l)));
}

template <class Read, class Vector>
typename Vector::Scalar Equations::forces_of(const Read& q, Vector& forces) const {
  using Real = typename Vector::Scalar;
  forces.setZero();
  Real work(0.0);
  for_each_force(
      q,
      [&](int equation, const Real& force) {
        if (equation < 0) return;
        if (equation < size()) {
          forces[equation] += force;
          return;
        }
        const Follower& f = followers_[static_cast<std::size_t>(equation - size())];
        for (const auto& [i, c] : f.terms) forces[i] += c * force;
        work += q.affine * f.offset * force;
      },
      [&](const NumberedLink& link, const Real& force) {
        for (const auto& [i, c] : link.terms) forces[i] += c * force;
        work -= q.affine * link.rest * force;
      });
  return work;
}

}  // namespace fe
