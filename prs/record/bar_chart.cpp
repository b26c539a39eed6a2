#include "prs/record/bar_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "prs/record/table_text.h"

namespace prs {
namespace {

constexpr int kBarCells = 36;
constexpr std::size_t kBarColumn = kBarCells + 9;
constexpr std::string_view kEighths[] = {"", "▏", "▎", "▍", "▌", "▋", "▊", "▉"};

/// A bar to an eighth of a character.
std::string bar(double value, double largest) {
  const double share = largest > 0.0 ? std::clamp(value / largest, 0.0, 1.0) : 0.0;
  const auto [cells, eighths] = std::div(static_cast<int>(std::lround(8 * kBarCells * share)), 8);
  std::string text;
  for (int k = 0; k < cells; ++k) text += "█";
  return text.append(kEighths[eighths]);
}

double largest_of(const PerInterface<std::vector<double>>& values) {
  double largest = 0.0;
  for (const Interface i : kInterfaces)
    for (const double value : values[i]) largest = std::max(largest, value);
  return largest;
}

}  // namespace

std::string bar_chart(const PerInterface<std::vector<double>>& values, int decimals,
                      std::string_view unit) {
  const double largest = largest_of(values);
  const auto bar_and_value = [&](double value) {
    return fmt::format("{} {:.{}f} {}", bar(value, largest), value, decimals, unit);
  };
  std::string chart = fmt::format("     {}  nut\n", padded("screw", kBarColumn, true));
  for (std::size_t k = 0; k < values.screw.size(); ++k)
    chart += fmt::format("{:3}  {}  {}\n", k + 1,
                         padded(bar_and_value(values.screw[k]), kBarColumn, true),
                         bar_and_value(values.nut[k]));
  return chart;
}

}  // namespace prs
