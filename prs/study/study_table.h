#pragma once

#include "prs/study/study_result.h"

namespace prs {

/// A study within 100 columns. Where designs differ in one value: their rows, one table per factor
/// with the base case in it. Otherwise what matters most to each response, by shares of its
/// variance or contributions to its linear surface, then statistics and, of a grid, the extremes.
/// What has no room stands in study.csv and study.json. Last come the designs without an answer.
std::string study_table(const StudyResult& result);

/// What is wrong with the designs that have no answer, of the first ones; empty where all have one.
std::string study_failures(const StudyResult& result);

/// `120 of 500 designs (40 from the journal), 850 a second, 0:12 left`; `done` counts the `found`
/// ones of the journal too, which took no time.
std::string progress_line(std::size_t done, std::size_t total, double seconds,
                          std::size_t found = 0);

}  // namespace prs
