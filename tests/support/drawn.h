#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <vector>

#include "prs/output/plots.h"
#include "tests/support/temporary_directory.h"

namespace test {

/// Fails for each picture that is missing; skips the test where there is no gnuplot.
inline void expect_drawn(const prs::Undrawn& undrawn) {
  for (const std::string& error : undrawn.errors) ADD_FAILURE() << error;
  const auto& notes = undrawn.notes;
  if (!notes.empty() && notes[0].find("No such file") != std::string::npos)
    GTEST_SKIP() << notes[0];
  for (const std::string& note : notes) ADD_FAILURE() << note;
}

/// Draws the pictures; each of those named has its script beside both images.
inline void expect_drawn(const std::vector<prs::Figure>& figures,
                         std::initializer_list<const char*> names) {
  const TemporaryDirectory temporary;
  ASSERT_NO_FATAL_FAILURE(expect_drawn(prs::draw_figures(figures, temporary.path())));
  if (testing::Test::IsSkipped()) return;
  for (const std::string name : names) {
    const std::string base = temporary.path() / "plots" / name;
    EXPECT_GT(content_of(base + ".gp").size(), 1000) << name;
    EXPECT_NE(content_of(base + ".svg").find("</svg>"), std::string::npos) << name;
    EXPECT_EQ(content_of(base + ".png").substr(1, 3), "PNG") << name;
  }
}

}  // namespace test
