#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

namespace fe {

/// Upper triangle of a symmetric matrix, compressed by columns, rows ascending in each column. The pattern is fixed at
/// construction; `value` is overwritten in place.
struct SparseSymmetric {
  std::vector<int> column_start;  ///< size() + 1 entries.
  std::vector<int> row;
  std::vector<double> value;

  int size() const { return static_cast<int>(column_start.size()) - 1; }
};

enum class FactorizationStatus { ok, not_positive_definite };

/// Smallest pivot over the largest: smaller ones leave no correct digit in the solution.
inline constexpr double kSmallestPivotRatio = 1e-17;

/// Element i of a standard container, with the signed indices of freedoms and matrices.
template <class Container>
auto& at(Container& c, int i) {
  return c[static_cast<std::size_t>(i)];
}

/// Positions of an upper triangle, in any order, repeated or not.
class Places {
 public:
  void add(int i, int j) { places_.push_back({std::min(i, j), std::max(i, j)}); }

  SparseSymmetric compressed(int size) const {
    std::vector<int> begin(static_cast<std::size_t>(size) + 1, 0);
    for (const Place& p : places_) ++at(begin, p.column + 1);
    for (int j = 0; j < size; ++j) at(begin, j + 1) += at(begin, j);
    std::vector<int> rows(places_.size()), next = begin;
    for (const Place& p : places_) at(rows, at(next, p.column)++) = p.row;

    SparseSymmetric m;
    m.column_start.push_back(0);
    std::vector<int> seen_in(static_cast<std::size_t>(size), -1);
    for (int j = 0; j < size; ++j) {
      for (int k = at(begin, j); k < at(begin, j + 1); ++k) {
        const int row = at(rows, k);
        if (std::exchange(at(seen_in, row), j) != j) m.row.push_back(row);
      }
      std::sort(m.row.begin() + m.column_start.back(), m.row.end());
      m.column_start.push_back(static_cast<int>(m.row.size()));
    }
    m.value.assign(m.row.size(), 0.0);
    return m;
  }

 private:
  struct Place {
    int row, column;
  };
  std::vector<Place> places_;
};

/// Inverse permutation: entry order[k] becomes k.
inline std::vector<int> inverse(const std::vector<int>& order) {
  std::vector<int> place(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) at(place, order[k]) = static_cast<int>(k);
  return place;
}

/// The pattern with row i moved to place[i].
inline SparseSymmetric permuted(const SparseSymmetric& m, const std::vector<int>& place) {
  Places places;
  for (int j = 0; j < m.size(); ++j)
    for (int k = at(m.column_start, j); k < at(m.column_start, j + 1); ++k)
      places.add(at(place, at(m.row, k)), at(place, j));
  return places.compressed(m.size());
}

/// Index of the value in row i and column j, or j and i.
inline int slot_in(const SparseSymmetric& m, int i, int j) {
  if (i > j) std::swap(i, j);
  const auto begin = m.row.begin() + at(m.column_start, j);
  const auto end = m.row.begin() + at(m.column_start, j + 1);
  const auto found = std::lower_bound(begin, end, i);
  assert(found != end && *found == i);
  return static_cast<int>(found - m.row.begin());
}

}  // namespace fe
