#pragma once

#include <string_view>

#include "prs/record/figure.h"

namespace prs {

/// Those of `Colour`.
inline constexpr std::string_view kColours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                "#e69f00", "#56b4e9", "#000000", "#7f7f7f",
                                                "#555555", "#aaaaaa", "#cc3311"};
/// Colours of scales, from the least to the largest value, in equal steps.
inline constexpr std::string_view kScaleColours[] = {"#ffffe5", "#fee391", "#fec44f", "#ec7014",
                                                     "#cc4c02"};
/// Widths of lines and sizes of marks, by `Weight`.
inline constexpr double kLineWidths[] = {1.0, 1.6, 2.4};
inline constexpr double kMarkSizes[] = {0.4, 0.75, 1.1};

/// The entry of a table by an enumerator.
template <class Table, class Value>
const auto& look(const Table& table, Value value) {
  return table[static_cast<std::size_t>(value)];
}

/// The colours that a scale shows: one per band between its levels, or so many steps that they look
/// continuous.
class ScaleSteps {
 public:
  explicit ScaleSteps(const ColourScale& scale);

  /// Which of the colours a value has, from 0; -1 where there is none.
  int step(double value) const;
  std::string colour(double value) const {
    const int at = step(value);
    return at < 0 ? "none" : colours_[static_cast<std::size_t>(at)];
  }
  const std::vector<std::string>& colours() const { return colours_; }

 private:
  double place(double value) const;

  ColourScale scale_;
  std::vector<std::string> colours_;
};

/// Attributes of a line: class, width and dashes.
std::string stroke(const Style& style);

/// The rules that the classes of all pictures follow. On a page (`themed`) colours are the
/// variables of its theme, `--ink`, `--quiet`, `--line` and `--paper`, and those of `svg_style`;
/// else those on white paper.
std::string svg_rules(bool themed);

}  // namespace prs
