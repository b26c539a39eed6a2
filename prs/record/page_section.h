#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace prs {

/// Rows of a record that stand open, under a heading where one is needed.
struct OpenRows {
  std::string record;  ///< Its place in the document or in a load case: `life.system`.
  std::vector<std::string> rows;
  std::string heading = {};
};

/// How the page shows a result: what a reader asks for first, and what folds. Without open rows all
/// numbers stand open.
struct PageSection {
  std::vector<OpenRows> in_cases = {}, in_document = {};
  std::vector<std::string> folded = {};  ///< Pictures.
  std::vector<std::string> estimates =
      {};                 ///< Keys that are left out: each quantity has one headline.
  std::string note = {};  ///< Above all.
};

/// The title of an analysis on the page, and where it stands among the others; none where another
/// section shows it.
struct PagePlace {
  std::string_view title = {};
  int order = 100;
};

}  // namespace prs
