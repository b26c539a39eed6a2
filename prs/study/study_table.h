#pragma once

#include "prs/study/study_files.h"

namespace prs {

/// A study within 100 columns. If designs differ in one value: their rows, one table per factor with the base case in
/// it. Otherwise the most important factors of each response, by shares of its variance or contributions to its linear
/// surface, then statistics and, for a grid, the extremes. Further data are in study.csv and study.json. Last come the
/// designs without a result.
std::string study_table(const StudyResult& result);

/// Reasons of the first designs without a result; empty if all have one.
std::string study_failures(const StudyResult& result);

/// Text `120 of 500 designs (40 from the journal), 850 a second, 0:12 left`; `done` includes the `found` ones of the
/// journal, which took no time.
std::string progress_line(std::size_t done, std::size_t total, double seconds, std::size_t found = 0);

}  // namespace prs
