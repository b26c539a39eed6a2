#include "prs/record/table_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "prs/indices.h"
#include "prs/text.h"

namespace prs {

std::string all_in(std::string_view file) { return fmt::format("all in {}, with --output DIR", file); }

std::string padded(const std::string& text, std::size_t columns, bool left_aligned) {
  const std::string space(columns - std::min(columns, width(text)), ' ');
  return left_aligned ? text + space : space + text;
}

std::string fitted(std::string_view text, std::size_t columns, bool left_aligned) {
  return padded(shortened(text, columns), columns, left_aligned);
}

std::string TableRows::operator()(const std::string& label, const std::vector<std::string>& cells,
                                  std::string_view remark) const {
  std::string line = padded(label, label_width, true);
  for (const std::string& cell : cells) line.append(gap, ' ').append(padded(cell, cell_width, false));
  return ended(line.append(remark));
}

std::string hanging(const std::string& label, std::size_t columns, std::string_view text) {
  return wrapped(text, std::string(columns, ' '), kTableWidth).replace(0, columns, padded(label, columns, true));
}

std::string ended(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line += '\n';
}

std::string words_of_text(std::string_view text) {
  constexpr std::pair<std::string_view, std::string_view> kWords[] = {
      {"flank_edge", "edge loading"}, {"lemor", "Lemor's formula"}, {"given", "stated value"}, {"static", "at rest"}};
  for (const auto& [known, words] : kWords)
    if (text == known) return std::string(words);
  std::string words(text);
  std::ranges::replace(words, '_', ' ');
  return words;
}

namespace {

constexpr int kBarCells = 36;
constexpr std::size_t kBarColumn = kBarCells + 9;
constexpr std::string_view kEighths[] = {"", "▏", "▎", "▍", "▌", "▋", "▊", "▉"};

/// A bar with a resolution of an eighth of a character.
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

std::string bar_chart(const PerInterface<std::vector<double>>& values, int decimals, std::string_view unit) {
  const double largest = largest_of(values);
  const auto bar_and_value = [&](double value) {
    return fmt::format("{} {:.{}f} {}", bar(value, largest), value, decimals, unit);
  };
  std::string chart = fmt::format("     {}  nut\n", padded("screw", kBarColumn, true));
  for (const auto k : indices(values.screw))
    chart += fmt::format("{:3}  {}  {}\n", k + 1, padded(bar_and_value(values.screw[k]), kBarColumn, true),
                         bar_and_value(values.nut[k]));
  return chart;
}

}  // namespace prs
