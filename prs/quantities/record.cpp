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

std::optional<std::size_t> take_index(std::string_view& path) {
  const std::size_t end = path.find(']');
  if (!path.starts_with('[') || end == std::string_view::npos) return std::nullopt;
  std::size_t index = 0;
  const auto [stop, error] = std::from_chars(path.data() + 1, path.data() + end, index);
  if (error != std::errc{} || stop != path.data() + end) return std::nullopt;
  path.remove_prefix(end + 1);
  return index;
}

RowOfWord split_row(std::string_view word) {
  std::string_view rest = word;
  const std::optional<std::size_t> row = take_index(rest);
  return row && rest.starts_with('[') ? RowOfWord{row, rest} : RowOfWord{{}, word};
}

SeriesReader summary_named(std::string_view word, double factor) {
  using Values = std::span<const double>;
  // A document has null in place of a number that is not finite, and no summary of such a list.
  const auto of_finite = [](auto summary) {
    return [summary](Values v) {
      const bool known =
          !v.empty() && std::ranges::all_of(v, [](double x) { return std::isfinite(x); });
      return known ? std::optional(summary(v)) : std::nullopt;
    };
  };
  if (word == ".max") return of_finite([factor](Values v) { return std::ranges::max(v) * factor; });
  if (word == ".min") return of_finite([factor](Values v) { return std::ranges::min(v) * factor; });
  if (word == ".mean")
    return of_finite([factor](Values v) {
      return std::accumulate(v.begin(), v.end(), 0.0,
                             [factor](double sum, double x) { return sum + x * factor; }) /
             static_cast<double>(v.size());
    });
  std::string_view rest = word;
  const std::optional<std::size_t> index = take_index(rest);
  if (!index || !rest.empty()) return {};
  return [index = *index, factor](Values v) {
    return index < v.size() && std::isfinite(v[index]) ? std::optional(v[index] * factor)
                                                       : std::nullopt;
  };
}

}  // namespace prs
