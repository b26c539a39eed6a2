#pragma once

#include <string>

#include "prs/figures/figure.h"

namespace prs {

/// A gnuplot script with the data inside that draws `NAME.svg` and `NAME.png` into the working
/// directory. Titles may hold any text: it is drawn as it stands and never interpreted.
std::string gnuplot_script(const Figure& figure);

}  // namespace prs
