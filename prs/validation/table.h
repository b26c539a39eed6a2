#pragma once

#include <optional>
#include <string>
#include <vector>

namespace prs {

/// Numbers that a source's code adds to the printed ones.
struct ValidationTable {
  struct Row {
    std::string label;
    std::vector<double> values;
  };
  std::string title;
  std::vector<std::string> columns;  ///< Headings of labels and values, with units.
  std::vector<Row> rows;
  std::optional<int> decimals = {};  ///< In the text; six significant digits where absent.
};

}  // namespace prs
