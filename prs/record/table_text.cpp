#include "prs/record/table_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

}  // namespace prs
