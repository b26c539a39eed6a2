#include "prs/quantities/record.h"

#include <algorithm>
#include <charconv>
#include <numeric>

namespace prs {

std::string words_of(std::string_view key) {
  std::string words(key.substr(0, key.size() - unit_of(key).suffix.size()));
  std::ranges::replace(words, '_', ' ');
  return words;
}

RowOfWord split_row(std::string_view word) {
  const std::size_t end = word.find("][");
  std::size_t row = 0;
  if (!word.starts_with('[') || end == std::string_view::npos) return {{}, word};
  const auto [stop, error] = std::from_chars(word.data() + 1, word.data() + end, row);
  if (error != std::errc{} || stop != word.data() + end) return {{}, word};
  return {row, word.substr(end + 1)};
}

std::function<std::optional<double>(std::span<const double>)> summary_named(std::string_view word,
                                                                            double factor) {
  using Values = std::span<const double>;
  const auto of_some = [](auto summary) {
    return [summary](Values v) { return v.empty() ? std::nullopt : std::optional(summary(v)); };
  };
  if (word == ".max") return of_some([factor](Values v) { return std::ranges::max(v) * factor; });
  if (word == ".min") return of_some([factor](Values v) { return std::ranges::min(v) * factor; });
  if (word == ".mean")
    return of_some([factor](Values v) {
      return std::accumulate(v.begin(), v.end(), 0.0,
                             [factor](double sum, double x) { return sum + x * factor; }) /
             static_cast<double>(v.size());
    });
  if (!word.starts_with('[')) return {};
  std::size_t index = 0;
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data() + 1, end, index);
  if (error != std::errc{} || stop + 1 != end || *stop != ']') return {};
  return [index, factor](Values v) {
    return index < v.size() ? std::optional(v[index] * factor) : std::nullopt;
  };
}

}  // namespace prs
