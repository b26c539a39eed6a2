#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace test {

/// Fails for each note of a drawing; skips the test where there is no gnuplot.
inline void expect_no_notes(const std::vector<std::string>& notes) {
  if (!notes.empty() && notes[0].find("No such file") != std::string::npos)
    GTEST_SKIP() << notes[0];
  for (const std::string& note : notes) ADD_FAILURE() << note;
}

}  // namespace test
