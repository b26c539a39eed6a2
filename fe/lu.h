#pragma once

#include <Eigen/LU>

/// Compiled once, in lu.cpp, for all who factorize dense matrices.
extern template void Eigen::PartialPivLU<Eigen::MatrixXd>::compute();
