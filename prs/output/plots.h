#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "prs/figures/figure.h"
#include "prs/loads/result.h"
#include "prs/slip/slip.h"

namespace prs {

/// The pictures that are missing after a drawing, a line each.
struct Undrawn {
  std::vector<std::string> notes;   ///< There was no gnuplot, or nothing to draw.
  std::vector<std::string> errors;  ///< Gnuplot failed, or could not write the whole picture.
};

/// Writes `plots/NAME.gp` below `directory` for every figure of the result (see result_figures.h)
/// and has gnuplot draw `NAME.svg` and `NAME.png` beside it: both, or none of them. Throws
/// std::system_error where the scripts cannot be written.
Undrawn draw_plots(const Result& result, const std::filesystem::path& directory);

/// The same for the pictures of the contacts (see contact_figures.h).
Undrawn draw_contact_plots(const Result& result, const std::filesystem::path& directory);

/// The same for slip (see slip_figures.h). Patches and residue are drawn for the load cases, given
/// by their indices, whose pictures are there; of several their files end in `_1`, `_2`, ...
Undrawn draw_slip_plots(const Result& result,
                        const std::vector<std::pair<std::size_t, SlipPictures>>& pictures,
                        const std::filesystem::path& directory);

/// The same for figures at hand.
Undrawn draw_figures(const std::vector<Figure>& figures, const std::filesystem::path& directory);

}  // namespace prs
