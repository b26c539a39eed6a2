#include "prs/svg/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "prs/svg/layout.h"

namespace prs {
namespace {

constexpr std::string_view kDashes[] = {"", "", "7 5", "2 4", "9 4 2 4"};
constexpr std::size_t kContinuous = 128;

int channel_of(std::string_view colour, std::size_t channel) {
  int level = 0;
  std::from_chars(&colour[1 + 2 * channel], &colour[1 + 2 * channel] + 2, level, 16);
  return level;
}

/// At a share of the scale's length.
std::string colour_at(double share) {
  constexpr auto kLast = static_cast<double>(std::size(kScaleColours) - 1);
  const double at = std::clamp(share, 0.0, 1.0) * kLast;
  const auto k = static_cast<std::size_t>(std::min(std::floor(at), kLast - 1.0));
  std::string colour = "#";
  for (std::size_t channel = 0; channel < 3; ++channel)
    colour += fmt::format("{:02x}", std::lround(std::lerp(channel_of(kScaleColours[k], channel),
                                                          channel_of(kScaleColours[k + 1], channel),
                                                          at - static_cast<double>(k))));
  return colour;
}

}  // namespace

ScaleSteps::ScaleSteps(const ColourScale& scale) : scale_(scale) {
  const std::size_t count = scale.levels.size() > 2 ? scale.levels.size() - 1 : kContinuous;
  for (std::size_t k = 0; k < count; ++k)
    colours_.push_back(colour_at(static_cast<double>(k) / static_cast<double>(count - 1)));
}

double ScaleSteps::place(double value) const {
  return scale_.logarithmic ? std::log(value) : value;
}

int ScaleSteps::step(double value) const {
  if (!std::isfinite(value)) return -1;
  const int last = static_cast<int>(colours_.size()) - 1;
  const auto& levels = scale_.levels;
  if (levels.size() > 2) {
    const auto band = std::ranges::upper_bound(levels, value) - levels.begin() - 1;
    return std::clamp(static_cast<int>(band), 0, last);
  }
  const double share =
      (place(value) - place(scale_.from)) / (place(scale_.to) - place(scale_.from));
  return std::isfinite(share) ? static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * last))
                              : 0;
}

std::string stroke(const Style& style) {
  std::string attributes =
      fmt::format("class=\"s{}\" stroke-width=\"{}\"", static_cast<int>(style.colour),
                  look(kLineWidths, style.weight));
  if (const std::string_view dash = look(kDashes, style.dash); !dash.empty())
    attributes += fmt::format(" stroke-dasharray=\"{}\"", dash);
  return attributes;
}

std::string svg_rules(bool themed) {
  const auto role = [&](const char* variable, const char* on_paper) {
    return themed ? fmt::format("var({})", variable) : std::string(on_paper);
  };
  const std::string ink = role("--ink", "#1a1a1a"), quiet = role("--quiet", "#555"),
                    line = role("--line", "#ddd"), paper = role("--paper", "#fff");
  std::string rules = fmt::format(
      "svg rect,.c{{shape-rendering:crispEdges}}\n"
      "svg{{font-size:{4}px}}\n"
      "svg text{{fill:{0}}}svg .q{{fill:{1}}}svg .m{{text-anchor:middle}}svg "
      ".e{{text-anchor:end}}svg .b{{font-weight:600}}\n"
      "svg .h{{paint-order:stroke;stroke:{3};stroke-width:4px;stroke-linejoin:round}}\n"
      ".t{{stroke:{1};stroke-width:1;fill:none}}.g{{stroke:{2};stroke-width:1}}.o{{stroke:#000;"
      "stroke-opacity:.55;stroke-width:.6}}\n"
      ".w{{stroke:#8c510a;stroke-width:.3;stroke-opacity:.5}}.l{{stroke:#8c510a;stroke-width:.7;"
      "fill:none}}svg "
      ".n{{fill:#1a1a1a;text-anchor:middle;font-size:13px;paint-order:stroke;stroke:#fff;stroke-"
      "opacity:.6;stroke-width:3px}}\n",
      ink, quiet, line, paper, kFontSize);
  for (std::size_t k = 0; k < std::size(kColours); ++k)
    rules += fmt::format(
        ".s{0}{{stroke:{1};fill:none}}.f{0}{{fill:{1}}}.p{0}{{fill:{1};fill-opacity:.22}}\n", k,
        themed ? fmt::format("var(--c{})", k) : std::string(kColours[k]));
  return rules;
}

}  // namespace prs
