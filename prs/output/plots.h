#pragma once

#include <filesystem>
#include <vector>

#include "prs/record/figure.h"

namespace prs {

/// Writes `plots/NAME.svg` below `directory` for every figure, with `png` also `NAME.png`: all of
/// them, or none. Throws std::system_error, with `png` also modules::Missing.
void draw_figures(const std::vector<Figure>& figures, const std::filesystem::path& directory,
                  bool png = false);

}  // namespace prs
