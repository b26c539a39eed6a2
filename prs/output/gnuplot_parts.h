#pragma once

#include <string>
#include <string_view>

#include "prs/output/figure_layout.h"

// Text and ticks as gnuplot takes them.
namespace prs {

/// A gnuplot string in which nothing is interpreted: what means something to gnuplot becomes an
/// octal escape. (Single quotes would not do: gnuplot 5.4 takes a leading doubled quote for the
/// end.)
std::string gnuplot_string(std::string_view text);

/// `fitted_lines` as one string.
std::string gnuplot_fitted(std::string_view text, int pixels);

/// Ticks as `set xtics` takes them, with room for their numbers in a panel of that size.
std::string gnuplot_ticks(const Axis& axis, int pixels, bool is_horizontal);

}  // namespace prs
