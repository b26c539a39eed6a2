#pragma once

#include <vector>

#include "fe/equations.h"

namespace test {

/// Writes the Hessian of the energy at a state into a matrix of the pattern of `linear_stiffness`.
inline void set_tangent(const fe::Equations& equations, const fe::State& q, fe::SparseSymmetric& tangent) {
  std::vector<double> springs;
  for (int k = 0; k < static_cast<int>(equations.springs().size()); ++k)
    springs.push_back(equations.response(q, k).tangent);
  equations.secant_stiffness(springs, tangent);
}

}  // namespace test
