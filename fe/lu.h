#pragma once

#include <Eigen/LU>

/// Instantiated once, in lu.cpp, for all sources that factorize dense matrices.
extern template void Eigen::PartialPivLU<Eigen::MatrixXd>::compute();
