#pragma once

#include <vector>

namespace fe {

/// Upper triangle of a symmetric matrix, compressed by columns, rows ascending in each column.
/// The pattern is fixed at birth; `value` is refilled in place.
struct SparseSymmetric {
  std::vector<int> column_start;  ///< size() + 1 entries.
  std::vector<int> row;
  std::vector<double> value;

  int size() const { return static_cast<int>(column_start.size()) - 1; }
};

}  // namespace fe
