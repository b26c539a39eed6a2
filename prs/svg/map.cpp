#include "prs/svg/map.h"

#include <algorithm>
#include <unordered_map>

#include "prs/indices.h"
#include "prs/svg/png.h"

namespace prs {
namespace {

using Point = std::array<double, 2>;

/// A corner of a cell, by the indices of its node.
struct Node {
  std::size_t i, j;
};

/// Corners of a cell, anticlockwise from its lower left.
std::array<Node, 4> corners(std::size_t i, std::size_t j) { return {{{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}}; }

Point crossing(const GridData& grid, Node a, Node b, double level) {
  const double from = grid.at(a.i, a.j), to = grid.at(b.i, b.j), share = (level - from) / (to - from);
  return {std::lerp(grid.x[a.i], grid.x[b.i], share), std::lerp(grid.y[a.j], grid.y[b.j], share)};
}

/// Points of the lines, one on an edge of the grid, and their neighbours along the lines.
class Links {
 public:
  explicit Links(const GridData& grid, double level) : grid_(grid), level_(level) {}

  /// Joins the edges between nodes a and b, and c and d.
  void join(Node a, Node b, Node c, Node d) {
    const std::size_t first = edge(a, b), second = edge(c, d);
    add(first, second, crossing(grid_, a, b, level_));
    add(second, first, crossing(grid_, c, d, level_));
  }

  std::vector<Polyline> lines() {
    std::vector<Polyline> all;
    for (const bool open : {true, false})
      for (const std::size_t start : order_)
        if (const Link& link = links_.at(start); !link.done && (link.count == 1) == open) all.push_back(walk(start));
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
        if (const std::size_t other = link.neighbours[static_cast<std::size_t>(k)]; !links_.at(other).done)
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

/// Lines on which a grid has a value, linear along the edges of its cells (marching squares). Cells that have a node
/// without a number have none.
std::vector<Polyline> contour_lines(const GridData& grid, double level) {
  Links links(grid, level);
  for (std::size_t i = 0; i + 1 < grid.x.size(); ++i)
    for (std::size_t j = 0; j + 1 < grid.y.size(); ++j) {
      const std::array<Node, 4> at = corners(i, j);
      std::array<bool, 4> above{};
      bool has_all = true;
      for (const auto k : up_to(4)) {
        const double value = grid.at(at[k].i, at[k].j);
        above[k] = value >= level;
        has_all = has_all && std::isfinite(value);
      }
      if (!has_all) continue;
      // One line cuts off each run of corners below the level: if both pairs of opposite corners differ, the part above
      // is connected.
      for (const auto k : up_to(4)) {
        if (!above[k] || above[(k + 1) % 4]) continue;  // A run of corners below begins at k + 1.
        std::size_t last = k + 1;
        while (!above[(last + 1) % 4]) ++last;
        links.join(at[k], at[(k + 1) % 4], at[last % 4], at[(last + 1) % 4]);
      }
    }
  return links.lines();
}

constexpr std::size_t kManyNodes = 2500;  // Largest number of nodes that are drawn as cells; more become an image.

/// Half the distances to the neighbours of a node, in pixels.
std::pair<double, double> cell(const std::vector<double>& nodes, std::size_t k, const Ruler& ruler) {
  const auto middle = [&](std::size_t a, std::size_t b) { return ruler(0.5 * (nodes[a] + nodes[b])); };
  const double at = ruler(nodes[k]);
  const bool single = nodes.size() < 2;
  double before = k > 0 ? middle(k - 1, k) : single ? ruler.start : 2.0 * at - middle(k, k + 1);
  double behind = k + 1 < nodes.size() ? middle(k, k + 1) : single ? ruler.end : 2.0 * at - before;
  if (before > behind) std::swap(before, behind);
  const auto [least, most] = std::minmax(ruler.start, ruler.end);
  return {std::clamp<double>(before, least, most), std::clamp<double>(behind, least, most)};
}

/// A path of rectangles for each colour, with runs of one colour along y joined.
std::string cells_svg(const GridData& grid, const ColourScale& scale, const Frame& f) {
  const ScaleSteps steps(scale);
  std::vector<std::string> paths(steps.colours().size());
  const auto tenths = [](std::pair<double, double> ends) {
    return std::pair{std::lround(10.0 * ends.first), std::lround(10.0 * ends.second)};
  };
  for (const auto i : indices(grid.x)) {
    const std::pair<long, long> sides = tenths(cell(grid.x, i, f.across));
    for (std::size_t j = 0; j < grid.y.size();) {
      const int step = steps.step(grid.at(i, j));
      std::pair<long, long> ends = tenths(cell(grid.y, j, f.up));
      while (++j < grid.y.size() && steps.step(grid.at(i, j)) == step) {
        const std::pair<long, long> more = tenths(cell(grid.y, j, f.up));
        ends = {std::min(ends.first, more.first), std::max(ends.second, more.second)};
      }
      if (step < 0) continue;
      std::string& d = paths[static_cast<std::size_t>(step)] += 'M';
      append_tenths(d, sides.first, true);
      append_tenths(d, ends.first, false);
      append_tenths(d += 'h', sides.second - sides.first, true);
      append_tenths(d += 'v', ends.second - ends.first, true);
      append_tenths(d += 'h', sides.first - sides.second, true);
      d += 'z';
    }
  }
  std::string all;
  for (const auto k : indices(paths))
    if (!paths[k].empty()) all += "<path d=\"" + paths[k] + "\" class=\"c\" fill=\"" + steps.colours()[k] + "\"/>";
  return all;
}

/// Nodes around a coordinate, and the share of the distance from the lower one.
struct Place {
  std::size_t node = 0;
  double share = 0.0;
};
std::optional<Place> place_of(const std::vector<double>& nodes, double at, bool is_cell) {
  if (is_cell && nodes.size() > 1) {  // The outer cells extend beyond their nodes.
    const double first = 1.5 * nodes[0] - 0.5 * nodes[1];
    const double last = 1.5 * nodes.back() - 0.5 * nodes[nodes.size() - 2];
    if (at >= first && at <= last) at = std::clamp(at, nodes.front(), nodes.back());
  }
  if (!(at >= nodes.front() && at <= nodes.back())) return std::nullopt;
  const auto above = std::ranges::upper_bound(nodes, at) - nodes.begin();
  const std::size_t node = std::min(static_cast<std::size_t>(above), nodes.size() - 1) - 1;
  return Place{node, (at - nodes[node]) / (nodes[node + 1] - nodes[node])};
}

/// Place of each pixel along one side.
std::vector<std::optional<Place>> places_of(const std::vector<double>& nodes, const Ruler& ruler, int fineness,
                                            bool is_cell) {
  std::vector<std::optional<Place>> places;
  const int length = fineness * std::abs(ruler.end - ruler.start);
  const double start = std::min(ruler.start, ruler.end);
  for (int k = 0; k < length; ++k)
    places.push_back(place_of(nodes, ruler.value_at(start + (k + 0.5) / fineness), is_cell));
  return places;
}

double between(const GridData& grid, const Place& x, const Place& y, bool nearest) {
  if (nearest) return grid.at(x.node + (x.share > 0.5 ? 1 : 0), y.node + (y.share > 0.5 ? 1 : 0));
  return std::lerp(std::lerp(grid.at(x.node, y.node), grid.at(x.node + 1, y.node), x.share),
                   std::lerp(grid.at(x.node, y.node + 1), grid.at(x.node + 1, y.node + 1), x.share), y.share);
}

/// An image over the panel.
std::string image_svg(const Map& map, const ColourScale& scale, const Frame& f) {
  // Number of its pixels along one pixel of the picture.
  const int fineness = map.grid.values.size() > kManyNodes ? 1 : 2;
  const ScaleSteps steps(scale);
  const auto across = places_of(map.grid.x, f.across, fineness, map.cells);
  const auto up = places_of(map.grid.y, f.up, fineness, map.cells);
  Image image{across.size(), up.size(), steps.colours(), {}};
  for (const std::optional<Place>& y : up)
    for (const std::optional<Place>& x : across)
      image.pixels += static_cast<char>(x && y ? 1 + steps.step(between(map.grid, *x, *y, map.cells)) : 0);
  return "<image x=\"" + std::to_string(f.box.left) + "\" y=\"" + std::to_string(f.box.top) + "\" width=\"" +
         std::to_string(f.box.width()) + "\" height=\"" + std::to_string(f.box.height()) +
         "\" preserveAspectRatio=\"none\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
         "xlink:href=\"" +
         png_address(image) + "\"/>";
}

}  // namespace

std::string map_svg(const Map& map, const ColourScale& scale, const Frame& f) {
  const GridData& grid = map.grid;
  const bool flat = grid.x.size() < 2 || grid.y.size() < 2;
  const bool few = map.cells && grid.values.size() <= kManyNodes;
  return flat || few ? cells_svg(grid, scale, f) : image_svg(map, scale, f);
}

std::vector<Contours> contours_of(const Map& map, const ColourScale& scale) {
  std::vector<Contours> all;
  if (!map.cells)
    for (std::size_t k = 1; k + 1 < scale.levels.size(); ++k)
      all.push_back({scale.levels[k], contour_lines(map.grid, scale.levels[k])});
  return all;
}

std::string contours_svg(const std::vector<Contours>& contours, const Frame& f) {
  std::string d;
  for (const Contours& at : contours)
    for (const Polyline& line : at.lines) d += way(line, f, false);
  return d.empty() ? d : "<path d=\"" + d + "\" class=\"l\"/>";
}

std::string contour_numbers(const std::vector<Contours>& contours, const Frame& f, std::vector<TextBox>& taken) {
  constexpr double kMargin = 4.0, kShortest = 60.0;  // Lengths in pixels.
  std::string all;
  for (const auto& [level, lines] : contours) {
    const std::string number = tick_text(level, 0.0);
    for (const Polyline& line : lines) {
      double length = 0.0;
      for (std::size_t k = 1; k < line.size(); ++k)
        length += std::hypot(f.across(line[k][0]) - f.across(line[k - 1][0]), f.up(line[k][1]) - f.up(line[k - 1][1]));
      if (length < kShortest) continue;
      // First free position from the middle of the line outwards.
      for (const auto k : indices(line)) {
        const std::size_t half = (k + 1) / 2, middle = line.size() / 2;
        const std::size_t at = k % 2 ? middle - std::min(middle, half) : std::min(middle + half, line.size() - 1);
        const double x = f.across(line[at][0]), y = f.up(line[at][1]) + 4.5;
        const TextBox box = text_box(number, x, y, 0.5);
        const TextBox wide{box.left - kMargin, box.right + kMargin, box.top - kMargin, box.bottom + kMargin};
        const bool inside =
            wide.left > f.box.left && wide.right < f.box.right && wide.top > f.box.top && wide.bottom < f.box.bottom;
        if (!inside || std::ranges::any_of(taken, [&](const TextBox& other) { return wide.overlaps(other); })) continue;
        taken.push_back(box);
        all += text(x, y, "n", number);
        break;
      }
    }
  }
  return all;
}

}  // namespace prs
