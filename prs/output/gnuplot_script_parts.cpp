#include "prs/output/gnuplot_script_parts.h"

#include <fmt/format.h>

#include <cmath>

#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kMaxTitle = 44;  // Characters that fit above a panel.

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

std::string panel_title(std::string_view text) { return shortened(printable(text), kMaxTitle); }

double tic_distance(double length, int count) {
  const double least = length / count;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= least) return step * power;
  return 10.0 * power;
}

}  // namespace prs
