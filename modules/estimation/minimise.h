#pragma once

#include <functional>
#include <vector>

namespace modules::fit {

/// Residuals at z and, where `derivatives` is not null, their derivatives, one row per residual. False: none at this z.
using Residuals = std::function<bool(const double* z, double* residuals, double* derivatives)>;

/// Moves z to where half the sum of squares is least, within 0 <= z <= 1 where `bounded`; returns the
/// iterations. With `roughly` it may end early: what follows does the rest.
std::size_t minimise(const Residuals& residuals, std::size_t count, const std::vector<bool>& bounded, bool roughly,
                     std::vector<double>& z);

}  // namespace modules::fit
