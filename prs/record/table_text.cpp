#include "prs/record/table_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "prs/text.h"

namespace prs {
namespace {

/// Whether a number, as it is shown, is nothing but zeros.
bool is_zero(std::string_view text) { return text.find_first_not_of("+-0.") == text.npos; }

}  // namespace

std::string fixed(std::optional<double> si, double factor, int decimals) {
  if (!si) return std::string(kAbsent);
  std::string text = fmt::format("{:.{}f}", *si * factor, decimals);
  if (text.starts_with('-') && is_zero(text)) text.erase(0, 1);
  return text;
}

std::string fixed_change(double value, int decimals) {
  std::string text = fmt::format("{:+.{}f}", value, decimals);
  if (is_zero(text)) text[0] = '+';
  return text;
}

std::string significant(std::optional<double> value, int digits) {
  if (!value || !std::isfinite(*value)) return std::string(kAbsent);
  const double size = std::abs(*value);
  const double digit = std::pow(10.0, std::floor(std::log10(size)) + 1.0 - digits);
  if (!(digit >= 1.0 && size < 1e9)) return fmt::format("{:.{}g}", *value, digits);
  return fmt::format("{:.0f}", std::round(*value / digit) * digit);
}

std::string digits(std::optional<double> value, int digits) {
  return value && std::isfinite(*value) ? fmt::format("{:.{}g}", *value, digits)
                                        : std::string(kAbsent);
}

std::string all_in(std::string_view file) {
  return fmt::format("all in {}, with --output DIR", file);
}

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
  for (const std::string& cell : cells)
    line.append(gap, ' ').append(padded(cell, cell_width, false));
  return ended(line.append(remark));
}

std::string hanging(const std::string& label, std::size_t columns, std::string_view text) {
  return wrapped(text, std::string(columns, ' '), kTableWidth)
      .replace(0, columns, padded(label, columns, true));
}

std::string ended(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line += '\n';
}

std::string words_of_text(std::string_view text) {
  constexpr std::pair<std::string_view, std::string_view> kWords[] = {
      {"flank_edge", "flank's edge"}, {"lemor", "Lemor's formula"}, {"given", "stated value"}};
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
