#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace prs {

/// How the measures of a design over two factors are made one, and the designs that are read back
/// from it (Jung 2017, chapters 7 and 8). m_i is a measure, n_i what it is normalised by, w_i its
/// weight:
///
///     product   E = prod (m_i / n_i)^w_i
///     sum       E = sum w_i m_i / n_i
///
/// Jung's weighted product w_1 m_1 w_2 m_2 .. only rescales E; weights are exponents here. What is
/// to be small has a negative weight.
struct Envelope {
  enum class Combine { product, sum };

  /// n_i: of all values of the measure in the grid,
  enum class Normalise {
    rms,   ///< their root mean square, sqrt(mean m^2) (Jung 2017, section 7.2),
    max,   ///< the largest magnitude,
    none,  ///< none: 1, in the unit of the measure.
  };

  struct Measure {
    std::string response;  ///< Path, see `response`.
    double weight = 1.0;
  };

  /// What a response shall be, in the unit of its path.
  struct Target {
    std::string response;
    double value = 0.0;
  };

  /// A design in the grid: given by its two factors, found by targets, or else the best.
  struct Point {
    std::string name;
    std::optional<std::array<double, 2>> at;  ///< In the units of the factors.
    /// One: the best of the places where a line of the grid meets it. Two: where both are met.
    std::vector<Target> reach;
  };

  Combine combine = Combine::product;
  Normalise normalise = Normalise::rms;
  std::vector<Measure> measures;
  std::vector<Point> points;
};

}  // namespace prs
