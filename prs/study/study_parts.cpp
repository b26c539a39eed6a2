#include "prs/study/study_parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "prs/record/table_units.h"

namespace prs {
namespace {

constexpr std::size_t kLongNumber = 14;
constexpr std::size_t kMaxTitle = 36;

constexpr std::size_t kMostOfName = 36;
constexpr std::size_t kMostWholeTicks = 13;
constexpr double kLargestWholeTick = 9999.0;

/// `µm` for `um`, in whatever stands with it.
std::string shown_unit(const std::string& unit) {
  std::string shown = printable(unit);
  if (const std::size_t at = shown.find("um"); at != std::string::npos) shown.replace(at, 2, "µm");
  return shown;
}

}  // namespace

std::string level_text(const Level& level, const std::string& unit) {
  const std::string text = printable(level.text);
  if (!level.number || width(text) <= kLongNumber || text.starts_with('{')) return text;
  return fmt::format("{:.6g}{}{}", *level.number, unit.empty() ? "" : " ", printable(unit));
}

std::string factor_title(const Factor& factor) {
  const std::string text = shortened(printable(factor.label), kMaxTitle);
  return factor.label == factor.path ? text : capitalised(text);
}

std::string study_figure_name(std::size_t index, const std::string& label) {
  std::string name = fmt::format("{:02}_", index + 1);
  for (const char c : label.substr(0, kMostOfName)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z');
    if (plain || name.back() != '_') name += plain ? c : '_';
  }
  while (name.back() == '_') name.pop_back();
  return name;
}

std::vector<std::size_t> chosen_responses(const std::vector<std::string>& responses,
                                          const FigureOptions& options) {
  if (options.response) {
    const auto found = std::ranges::find(responses, *options.response);
    if (found == responses.end())
      throw NoFigure(fmt::format("no response {}; there is {}", *options.response,
                                 fmt::join(responses, ", ")));
    return {static_cast<std::size_t>(found - responses.begin())};
  }
  const std::size_t first = std::min(responses.size(), kMostStudyFigures);
  return spread(first, first);
}

Figure response_figure(const std::vector<std::string>& responses, std::size_t response) {
  const std::string& path = responses[response];
  Figure figure{study_figure_name(response, path), capitalised(response_title(path).name)};
  figure.y = response_axis(path);
  return figure;
}

std::string factor_name(const Factor& factor) {
  constexpr std::size_t kMost = 34;
  if (factor.label != factor.path) return shortened(factor_title(factor), kMost);
  std::string words = printable(factor.path.substr(factor.path.find('.') + 1));
  std::ranges::replace_if(
      words, [](char c) { return c == '_' || c == '.'; }, ' ');
  return shortened(capitalised(words), kMost);
}

Axis factor_axis(const Factor& factor, const std::vector<double>& values) {
  Axis axis{factor_name(factor), factor.is_numeric() ? shown_unit(factor.unit) : ""};
  Range range;
  for (const double value : values) range.include(value);
  if (range.empty()) return axis;
  if (range.from == range.to || !factor.is_numeric()) range.from -= 0.5, range.to += 0.5;
  axis.from = range.from;
  axis.to = range.to;
  axis.logarithmic =
      (factor.logarithmic || factor.distribution.kind == Distribution::Kind::log_uniform) &&
      axis.from > 0.0;
  if (!factor.is_numeric()) {
    for (std::size_t k = 0; k < factor.levels.size(); ++k)
      axis.ticks.push_back(
          {static_cast<double>(k + 1), shortened(printable(factor.levels[k].text), 16)});
    return axis;
  }
  axis.whole = factor.unit.empty() && std::ranges::all_of(values, [](double value) {
                 return value == std::round(value) && std::abs(value) <= kLargestWholeTick;
               });
  if (axis.whole && values.size() <= kMostWholeTicks)
    for (const double value : values) axis.ticks.push_back({value});
  return axis;
}

Axis response_axis(const std::string& path) {
  constexpr std::size_t kMost = 44;
  const ResponseTitle title = response_title(path);
  return {capitalised(shortened(title.name, kMost)), title.unit};
}

std::vector<double> positions(const Factor& factor) {
  std::vector<double> values;
  for (std::size_t k = 0; k < factor.levels.size(); ++k)
    values.push_back(factor.is_numeric() ? *factor.levels[k].number : static_cast<double>(k + 1));
  return values;
}

std::vector<std::size_t> spread(std::size_t count, std::size_t most) {
  std::vector<std::size_t> some(std::min(count, most));
  for (std::size_t k = 0; k < some.size(); ++k)
    some[k] = some.size() == 1 ? 0 : k * (count - 1) / (some.size() - 1);
  return some;
}

std::size_t columns_for(std::size_t panels) {
  return panels == 1 ? 1 : panels == 2 || panels == 4 ? 2 : 3;
}

Figure ranked_bars(Figure figure, const std::vector<std::string>& names,
                   const std::vector<double>& values) {
  Series grows{figure.add("grows with the factor", area_of(Colour::blue))};
  Series falls{figure.add("falls", area_of(Colour::vermillion))};
  Panel panel;
  Range range{0.0, 0.0};
  for (const double value : values) range.include(value);
  const double gap = 0.01 * (range.to - range.from);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double value = values[k], at = rank_position(k, values.size());
    (value < 0.0 ? falls : grows)
        .parts.push_back(
            rectangle(std::min(value, 0.0), std::max(value, 0.0), at - 0.35, at + 0.35));
    panel.labels.push_back({fmt::format("{}{:.3g}", value < 0.0 ? "−" : "", std::abs(value)),
                            value < 0.0 ? value - gap : value + gap, at, false,
                            value < 0.0 ? Label::Anchor::right : Label::Anchor::left});
  }
  panel.series = {std::move(grows), std::move(falls)};
  panel.references.push_back({figure.add(kZeroStyle), 0.0, true});
  const double room = 0.14 * std::max(range.to - range.from, 1e-12);
  figure.x.from = range.from - (range.from < 0.0 ? room : 0.0);
  figure.x.to = range.to + (range.to > 0.0 ? room : 0.0);
  figure.y = ranked_axis(names);
  figure.aspect = 0.08 + 0.045 * static_cast<double>(values.size());
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace prs
