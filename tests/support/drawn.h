#pragma once

#include <gtest/gtest.h>

#include <string>

#include "prs/output/plots.h"

namespace test {

/// Fails for each picture that is missing; skips the test where there is no gnuplot.
inline void expect_drawn(const prs::Undrawn& undrawn) {
  for (const std::string& error : undrawn.errors) ADD_FAILURE() << error;
  const auto& notes = undrawn.notes;
  if (!notes.empty() && notes[0].find("No such file") != std::string::npos)
    GTEST_SKIP() << notes[0];
  for (const std::string& note : notes) ADD_FAILURE() << note;
}

}  // namespace test
