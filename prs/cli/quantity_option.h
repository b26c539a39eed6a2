#pragma once

#include <string>
#include <string_view>

#include "prs/input/bounds.h"
#include "prs/input/units.h"

namespace prs::cli {

/// Throws UsageError on an option of the command line: `--lead: MESSAGE`.
[[noreturn]] void fail_option(std::string_view option, std::string_view message);

/// The value of an option [SI] within bounds that `expected` puts into words. A blank between
/// number and unit may be missing.
double quantity_option(std::string_view option, const std::string& text,
                       const input::Dimension& dimension, const input::Bounds& bounds,
                       std::string_view expected);

}  // namespace prs::cli
