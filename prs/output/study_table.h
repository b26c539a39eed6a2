#pragma once

#include <cstddef>
#include <string>

#include "prs/study/run.h"

namespace prs {

/// The rows of a study, a table a factor with the base case in it, within 110 columns. Responses
/// beyond the width and the rows between of long ranges stand in study.csv only.
std::string study_table(const StudyResult& result);

/// `120 of 500 designs, 850 a second, 0:12 left`
std::string progress_line(std::size_t done, std::size_t total, double seconds);

}  // namespace prs
