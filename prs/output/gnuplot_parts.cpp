#include "prs/output/gnuplot_parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "prs/text.h"

namespace prs {
namespace {

/// gnuplot takes the text of a tick for a format of its number.
std::string tick_text(const std::string& text) {
  std::string format;
  for (const char c : text) format += c == '%' ? std::string("%%") : std::string(1, c);
  return gnuplot_string(format);
}

}  // namespace

std::string gnuplot_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : printable(text))
    if (std::string_view("\"'\\`@$#{}!").find(c) == std::string_view::npos)
      result += c;
    else
      result += fmt::format("\\{:03o}", static_cast<unsigned char>(c));
  return result + '"';
}

std::string gnuplot_fitted(std::string_view text, int pixels) {
  std::string result;
  for (const std::string& line : fitted_lines(text, pixels))
    result += (result.empty() ? "" : ".\"\\n\".") + gnuplot_string(line);
  return result;
}

std::string gnuplot_ticks(const Axis& axis, int pixels, bool is_horizontal) {
  if (axis.hidden) return "()";
  std::vector<std::string> ticks;
  if (!axis.ticks.empty()) {
    for (const Tick& tick : axis.ticks)
      ticks.push_back(tick.text.empty() ? fmt::format("{:.7g}", tick.at)
                                        : fmt::format("{} {:.7g}", tick_text(tick.text), tick.at));
  } else if (!has_range(axis)) {
    return axis.whole ? "1" : "autofreq";
  } else if (axis.logarithmic) {
    for (const double tick : ticks_of(axis, pixels, is_horizontal))
      ticks.push_back(fmt::format("{:.7g}", tick));
  } else {
    return fmt::format("{:.7g}", tick_step(axis, pixels, is_horizontal));
  }
  return fmt::format("({})", fmt::join(ticks, ", "));
}

}  // namespace prs
