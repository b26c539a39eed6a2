#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "prs/figures/figure.h"

namespace prs {

/// The pictures that are missing after a drawing, a line each.
struct Undrawn {
  std::vector<std::string> notes;   ///< There was no gnuplot, or nothing to draw.
  std::vector<std::string> errors;  ///< Gnuplot failed, or could not write the whole picture.
};

/// Writes `plots/NAME.gp` below `directory` for every figure and has gnuplot draw `NAME.svg` and
/// `NAME.png` beside it: both, or none of them. Throws std::system_error where the scripts cannot
/// be written.
Undrawn draw_figures(const std::vector<Figure>& figures, const std::filesystem::path& directory);

}  // namespace prs
