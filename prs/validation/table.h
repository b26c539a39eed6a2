#pragma once

#include <optional>
#include <string>
#include <vector>

namespace prs {

/// Numbers that a source's code contributes beside the printed ones.
struct ValidationTable {
  struct Row {
    std::string label;
    std::vector<double> values;
  };
  std::string title;
  std::vector<std::string> columns;  ///< Of the labels, then of the values, units included.
  std::vector<Row> rows;
  std::optional<int> decimals = {};  ///< In the text; six significant digits where absent.
};

}  // namespace prs
