#include "prs/input/did_you_mean.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace prs::input {

namespace {

/// Letters to change, insert or delete to get from one word to the other.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known) {
  if (known.empty()) return {};
  const auto distance = [word](std::string_view k) { return edit_distance(word.substr(0, 80), k); };
  const std::string_view nearest = *std::ranges::min_element(known, {}, distance);
  if (distance(nearest) > 1 + nearest.size() / 2) return {};
  return fmt::format("did you mean `{}`?", nearest);
}

}  // namespace prs::input
