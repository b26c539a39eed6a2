#pragma once

#include <string>

#include "modules/module.h"

namespace prs {

struct PictureModule : modules::Module {
  static constexpr modules::Name kName{"prs_rsvg.so", "librsvg", "librsvg2-dev",
                                       ", or leave out --png"};

  /// An SVG file as a PNG file, so many times as large. Throws std::runtime_error.
  std::string (*png)(const std::string& svg, double scale);
};

}  // namespace prs
