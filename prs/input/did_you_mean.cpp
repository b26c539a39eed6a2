#include "prs/input/did_you_mean.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "prs/indices.h"

namespace prs::input {
namespace {

/// Lower-case letter; the characters that join words become one.
char plain(char c) {
  if (c == '-' || c == '_') return ' ';
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
}

/// Number of letters to change, insert or delete to turn one word into another.
struct EditDistance {
  std::size_t whole;
  std::size_t beginning;  ///< Smallest distance to a beginning of the other word.
};

EditDistance edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (const auto i : indices(a)) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (const auto j : indices(b)) {
      const std::size_t replaced = diagonal + (plain(a[i]) == plain(b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return {row.back(), *std::ranges::min_element(row)};
}

/// Distance of whole words, or slightly more than the distance of a word to a beginning of the other.
std::size_t distance(std::string_view word, std::string_view known) {
  const std::size_t beginning = std::min(edit_distance(word, known).beginning, edit_distance(known, word).beginning);
  return std::min(edit_distance(word, known).whole, beginning + 1);
}

}  // namespace

std::vector<std::string_view> near_words(std::string_view word, const std::vector<std::string_view>& known) {
  constexpr std::size_t kMost = 3, kFarther = 2;
  word = word.substr(0, 80);
  std::vector<std::pair<std::size_t, std::string_view>> by_distance;
  for (const std::string_view k : known) by_distance.emplace_back(distance(word, k), k);
  std::ranges::stable_sort(by_distance, {}, &std::pair<std::size_t, std::string_view>::first);
  std::vector<std::string_view> near;
  for (const auto& [distance, k] : by_distance)
    if (near.size() < kMost && distance <= std::min(word.size(), k.size()) / 2 &&
        distance <= by_distance[0].first + kFarther)
      near.push_back(k);
  return near;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known) {
  const std::vector<std::string_view> near = near_words(word, known);
  return near.empty() ? "" : fmt::format("did you mean `{}`?", near[0]);
}

}  // namespace prs::input
