#pragma once

#include <cstddef>
#include <string>

#include "prs/model/study.h"
#include "prs/text.h"

namespace prs {

/// A level as it is written, long numbers with six digits.
std::string level_text(const Level& level, const std::string& unit);

/// A factor as a heading: its label, or its path as it stands.
std::string factor_title(const Factor& factor);

}  // namespace prs
