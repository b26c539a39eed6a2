#include "prs/svg/contours.h"

#include <array>
#include <cmath>
#include <unordered_map>

namespace prs {
namespace {

using Point = std::array<double, 2>;

/// A corner of a cell, by the places of its node.
struct Node {
  std::size_t i, j;
};

/// Around a cell, against the clock from its lower left.
std::array<Node, 4> corners(std::size_t i, std::size_t j) {
  return {{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
}

Point crossing(const GridData& grid, Node a, Node b, double level) {
  const double from = grid.at(a.i, a.j), to = grid.at(b.i, b.j),
               share = (level - from) / (to - from);
  return {std::lerp(grid.x[a.i], grid.x[b.i], share), std::lerp(grid.y[a.j], grid.y[b.j], share)};
}

/// The lines' points, one on an edge of the grid, and their neighbours along the lines.
class Links {
 public:
  explicit Links(const GridData& grid, double level) : grid_(grid), level_(level) {}

  /// Of the edges between nodes a and b, and c and d.
  void join(Node a, Node b, Node c, Node d) {
    const std::size_t first = edge(a, b), second = edge(c, d);
    add(first, second, crossing(grid_, a, b, level_));
    add(second, first, crossing(grid_, c, d, level_));
  }

  std::vector<Polyline> lines() {
    std::vector<Polyline> all;
    for (const bool open : {true, false})
      for (const std::size_t start : order_)
        if (const Link& link = links_.at(start); !link.done && (link.count == 1) == open)
          all.push_back(walk(start));
    return all;
  }

 private:
  struct Link {
    Point at;
    std::array<std::size_t, 2> neighbours{};
    int count = 0;
    bool done = false;
  };

  std::size_t edge(Node a, Node b) const {
    const Node least = a.i + a.j < b.i + b.j ? a : b;
    return 2 * (least.i * grid_.y.size() + least.j) + (a.i == b.i ? 1 : 0);
  }

  void add(std::size_t at, std::size_t neighbour, Point point) {
    const auto [found, is_new] = links_.try_emplace(at, Link{point});
    if (is_new) order_.push_back(at);
    Link& link = found->second;
    if (link.count < 2) link.neighbours[static_cast<std::size_t>(link.count++)] = neighbour;
  }

  Polyline walk(std::size_t start) {
    Polyline line;
    for (std::size_t at = start;;) {
      Link& link = links_.at(at);
      link.done = true;
      line.push_back(link.at);
      std::size_t next = at;
      for (int k = 0; k < link.count; ++k)
        if (const std::size_t other = link.neighbours[static_cast<std::size_t>(k)];
            !links_.at(other).done)
          next = other;
      if (next == at) break;
      at = next;
    }
    if (links_.at(start).count == 2) line.push_back(line.front());
    return line;
  }

  const GridData& grid_;
  double level_;
  std::unordered_map<std::size_t, Link> links_;
  std::vector<std::size_t> order_;
};

}  // namespace

std::vector<Polyline> contour_lines(const GridData& grid, double level) {
  Links links(grid, level);
  for (std::size_t i = 0; i + 1 < grid.x.size(); ++i)
    for (std::size_t j = 0; j + 1 < grid.y.size(); ++j) {
      const std::array<Node, 4> at = corners(i, j);
      std::array<bool, 4> above{};
      bool has_all = true;
      for (std::size_t k = 0; k < 4; ++k) {
        const double value = grid.at(at[k].i, at[k].j);
        above[k] = value >= level;
        has_all = has_all && std::isfinite(value);
      }
      if (!has_all) continue;
      // Each run of corners below is cut off by one line: where both pairs of opposite corners
      // differ, what is above hangs together.
      for (std::size_t k = 0; k < 4; ++k) {
        if (!above[k] || above[(k + 1) % 4]) continue;  // A run of those below begins at k + 1.
        std::size_t last = k + 1;
        while (!above[(last + 1) % 4]) ++last;
        links.join(at[k], at[(k + 1) % 4], at[last % 4], at[(last + 1) % 4]);
      }
    }
  return links.lines();
}

}  // namespace prs
