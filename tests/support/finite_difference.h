#pragma once

#include <cmath>
#include <functional>

namespace test {

/// Central difference of f at x with Richardson's extrapolation, error O(h^4).
inline double derivative(const std::function<double(double)>& f, double x, double h) {
  const double coarse = (f(x + h) - f(x - h)) / (2.0 * h);
  const double fine = (f(x + 0.5 * h) - f(x - 0.5 * h)) / h;
  return (4.0 * fine - coarse) / 3.0;
}

}  // namespace test
