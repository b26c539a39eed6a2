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

  int springs() const { return static_cast<int>(springs_.size()); }
  /// Approach w of spring k, without its gap [m].
  double approach(const State& q, int k) const;

  /// A matrix with the fixed pattern, holding the linear part (bars, beams, shells, elastic
  /// supports) [N/m].
  const SparseSymmetric& linear_stiffness() const { return linear_; }

  /// Potential energy 1/2 q'Kq + sum of the springs' - f'q [J], and its gradient, the residual
  /// [N, N m]. Allocates nothing.
  double energy_and_residual(const State& q, const Eigen::VectorXd& f,
                             Eigen::VectorXd& residual) const;

  /// Largest residual of each equation that rounding of the state alone can cause: eps times the
  /// sum of |K_ij q_j| over the elements [N, N m].
  Eigen::VectorXd rounding_residual(const State& q) const;

  /// Refills `tangent`, the Hessian of the energy, in place. Allocates nothing.
  void tangent_stiffness(const State& q, SparseSymmetric& tangent) const;

 private:
  /// Approach w = sum_i coefficient[i] q[equation[i]] over at most six freedoms; `slot` leads to
  /// the values of the tangent for each pair i <= j.
  struct Spring {
    static constexpr int kMost = 2 * kDofsPerNode;
    PowerLawSpring law;
    std::size_t count = 0;
    std::array<int, kMost> equation{};
    std::array<double, kMost> coefficient{};
    std::array<int, kMost*(kMost + 1) / 2> slot{};

    double approach(const State& q) const;
  };

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

}  // namespace fe
