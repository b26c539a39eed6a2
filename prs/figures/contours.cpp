#include "prs/figures/contours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace prs {
namespace {

constexpr std::uint32_t kNoEdge = static_cast<std::uint32_t>(-1);

/// Follows one level through the cells of a grid. Every edge of the grid is crossed at most once,
/// and left into one cell only, so that each crossing has at most one successor.
class LevelTracer {
 public:
  LevelTracer(const GridData& grid, double level) : grid_(grid), level_(level) {
    const std::size_t nodes = grid.values.size();
    next_.assign(2 * nodes, kNoEdge);
    entered_.assign(2 * nodes, false);
    for (std::size_t i = 0; i + 1 < grid.x.size(); ++i)
      for (std::size_t j = 0; j + 1 < grid.y.size(); ++j) trace_cell(i, j);
  }

  /// Open lines first, then closed ones, which end where they begin.
  std::vector<Polyline> lines() {
    std::vector<Polyline> all;
    for (const bool closed : {false, true})
      for (std::uint32_t edge = 0; edge < next_.size(); ++edge)
        if (next_[edge] != kNoEdge && (closed || !entered_[edge])) all.push_back(follow(edge));
    return all;
  }

 private:
  bool is_above(double value) const { return value >= level_; }

  /// Edges from node (i, j): 0 along x, 1 along y.
  std::uint32_t edge(std::size_t i, std::size_t j, std::size_t along) const {
    return static_cast<std::uint32_t>(2 * (i * grid_.y.size() + j) + along);
  }

  /// Lines lead from where the edges of the cell, run through counter-clockwise, leave what is
  /// above the level, to where they come back to it.
  void trace_cell(std::size_t i, std::size_t j) {
    const std::array corners{grid_.at(i, j), grid_.at(i + 1, j), grid_.at(i + 1, j + 1),
                             grid_.at(i, j + 1)};
    if (std::ranges::any_of(corners, [](double v) { return std::isnan(v); })) return;
    const std::array edges{edge(i, j, 0), edge(i + 1, j, 1), edge(i, j + 1, 0), edge(i, j, 1)};
    int leaving = 0;
    std::size_t back = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const bool from = is_above(corners[k]), to = is_above(corners[(k + 1) % 4]);
      leaving += from && !to ? 1 : 0;
      if (!from && to) back = k;
    }
    const double middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
    for (std::size_t k = 0; k < 4; ++k) {
      if (!is_above(corners[k]) || is_above(corners[(k + 1) % 4])) continue;
      if (leaving == 2) back = is_above(middle) ? (k + 1) % 4 : (k + 3) % 4;  // A saddle.
      next_[edges[k]] = edges[back];
      entered_[edges[back]] = true;
    }
  }

  std::array<double, 2> crossing(std::uint32_t edge) const {
    const std::size_t node = edge / 2, i = node / grid_.y.size(), j = node % grid_.y.size();
    const bool along_x = edge % 2 == 0;
    const std::size_t i2 = i + (along_x ? 1 : 0), j2 = j + (along_x ? 0 : 1);
    const double from = grid_.at(i, j) - level_, to = grid_.at(i2, j2) - level_;
    const double share = std::isinf(from) ? 1.0 : std::isinf(to) ? 0.0 : from / (from - to);
    return {grid_.x[i] + share * (grid_.x[i2] - grid_.x[i]),
            grid_.y[j] + share * (grid_.y[j2] - grid_.y[j])};
  }

  Polyline follow(std::uint32_t edge) {
    Polyline line{crossing(edge)};
    while (next_[edge] != kNoEdge) {
      edge = std::exchange(next_[edge], kNoEdge);
      if (const auto point = crossing(edge); point != line.back()) line.push_back(point);
    }
    return line;
  }

  const GridData& grid_;
  double level_;
  std::vector<std::uint32_t> next_;
  std::vector<bool> entered_;
};

/// A rim of -inf around the grid and in place of what it lacks closes all lines.
GridData rimmed(const GridData& grid) {
  GridData all;
  const auto widened = [](std::vector<double> axis) {
    axis.insert(axis.begin(), axis.front());
    axis.push_back(axis.back());
    return axis;
  };
  all.x = widened(grid.x);
  all.y = widened(grid.y);
  all.values.assign(all.x.size() * all.y.size(), -HUGE_VAL);
  for (std::size_t i = 0; i < grid.x.size(); ++i)
    for (std::size_t j = 0; j < grid.y.size(); ++j)
      if (const double value = grid.at(i, j); !std::isnan(value))
        all.values[(i + 1) * all.y.size() + j + 1] = value;
  return all;
}

/// Twice the area that a closed line encloses, > 0 counter-clockwise.
double signed_area(const Polyline& line) {
  double area = 0.0;
  for (std::size_t k = 1; k < line.size(); ++k)
    area += (line[k - 1][0] - line[0][0]) * (line[k][1] - line[0][1]) -
            (line[k][0] - line[0][0]) * (line[k - 1][1] - line[0][1]);
  return area;
}

std::vector<std::size_t> spread(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen(std::min(count, most));
  for (std::size_t k = 0; k < chosen.size(); ++k)
    chosen[k] = chosen.size() == 1 ? 0 : k * (count - 1) / (chosen.size() - 1);
  return chosen;
}

}  // namespace

GridData thinned(const GridData& grid, std::size_t most) {
  const std::vector<std::size_t> is = spread(grid.x.size(), most), js = spread(grid.y.size(), most);
  GridData some;
  for (const std::size_t i : is) some.x.push_back(grid.x[i]);
  for (const std::size_t j : js) some.y.push_back(grid.y[j]);
  for (const std::size_t i : is)
    for (const std::size_t j : js) some.values.push_back(grid.at(i, j));
  return some;
}

std::vector<double> round_levels(const GridData& grid, std::size_t most_steps) {
  double least = HUGE_VAL, largest = -HUGE_VAL;
  for (const double value : grid.values)
    if (std::isfinite(value)) least = std::min(least, value), largest = std::max(largest, value);
  if (least > largest) return {};
  const double magnitude = std::max(std::abs(least), std::abs(largest));
  if (largest - least <= 1e-9 * magnitude || largest == least) {
    const double margin = magnitude > 0.0 ? 0.05 * magnitude : 1.0;
    return {least - margin, largest + margin};
  }
  const double most = static_cast<double>(most_steps);
  for (double power = std::pow(10.0, std::floor(std::log10((largest - least) / most)));;
       power *= 10.0)
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double step = digit * power;
      const double first = std::floor(least / step), last = std::ceil(largest / step);
      if (last - first > most) continue;
      std::vector<double> levels;
      for (double k = first; k <= last; k += 1.0) levels.push_back(k * step);
      return levels;
    }
}

std::vector<Polyline> contour_lines(const GridData& grid, double level) {
  return LevelTracer(grid, level).lines();
}

std::vector<ContourBand> contour_bands(const GridData& grid, const std::vector<double>& levels) {
  struct Loop {
    std::size_t level = 0;
    double area = 0.0;
    Polyline line;
  };
  const GridData all = rimmed(grid);
  std::vector<Loop> loops;
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const double level = k == 0 ? -std::numeric_limits<double>::max() : levels[k];
    for (Polyline& line : LevelTracer(all, level).lines()) {
      const double area = signed_area(line);
      if (area != 0.0) loops.push_back({k, area, std::move(line)});
    }
  }
  // Lines of different levels do not cross: what lies inside of another encloses less. Of equal
  // ones, hills come level by level upwards and hollows downwards.
  std::ranges::stable_sort(loops, [](const Loop& a, const Loop& b) {
    if (std::abs(a.area) != std::abs(b.area)) return std::abs(a.area) > std::abs(b.area);
    return a.area > 0.0 ? a.level < b.level : a.level > b.level;
  });
  std::vector<ContourBand> bands;
  for (Loop& loop : loops) {
    const bool hill = loop.area > 0.0;
    const std::size_t band = hill ? loop.level : loop.level > 0 ? loop.level - 1 : levels.size();
    bands.push_back({band, std::move(loop.line)});
  }
  return bands;
}

}  // namespace prs
