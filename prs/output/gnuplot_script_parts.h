#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "prs/figures/figure.h"

/// Parts of the gnuplot scripts that figure.h writes.
namespace prs {

/// A gnuplot string in which nothing is interpreted: what means something to gnuplot becomes an
/// octal escape. (Single quotes would not do: gnuplot 5.4 takes a leading doubled quote for the
/// end.)
std::string gnuplot_string(std::string_view text);

/// What fits above a panel.
std::string panel_title(std::string_view text);

/// Distance of tics, 1, 2 or 5 times a power of ten, at which at most `count` fit in the length.
double tic_distance(double length, int count);

/// The data of the surface of panel `index`, and what draws it into a part of the image that is
/// given in shares of it from its lower left.
std::string surface_data(std::size_t index, const Surface& surface);
struct ScreenBox {
  double left = 0.0, bottom = 0.0, width = 1.0, height = 1.0;
};
std::string surface_lines(std::size_t index, const Panel& panel, const Axis& x, const Axis& y,
                          const ScreenBox& box);

}  // namespace prs
