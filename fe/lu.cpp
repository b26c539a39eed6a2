#include "fe/lu.h"

template void Eigen::PartialPivLU<Eigen::MatrixXd>::compute();
