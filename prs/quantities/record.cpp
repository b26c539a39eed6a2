#include "prs/quantities/record.h"

#include <algorithm>
#include <charconv>
#include <functional>
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

namespace {

/// The largest of f(x), four maxima side by side.
template <class F>
double largest(std::span<const double> v, F f) {
  double of[4] = {f(v[0]), f(v[0]), f(v[0]), f(v[0])};
  std::size_t k = 0;
  for (; k + 4 <= v.size(); k += 4)
    for (std::size_t j = 0; j < 4; ++j) {
      const double x = f(v[k + j]);
      of[j] = x > of[j] ? x : of[j];
    }
  for (; k < v.size(); ++k) of[0] = std::max(of[0], f(v[k]));
  return std::max(std::max(of[0], of[1]), std::max(of[2], of[3]));
}

/// Whether all are finite: what is not leaves a sum of zeros that is not 0.
bool all_finite(std::span<const double> v) {
  double zero[4] = {};
  std::size_t k = 0;
  for (; k + 4 <= v.size(); k += 4)
    for (std::size_t j = 0; j < 4; ++j) zero[j] += 0.0 * v[k + j];
  for (; k < v.size(); ++k) zero[0] += 0.0 * v[k];
  return (zero[0] + zero[1]) + (zero[2] + zero[3]) == 0.0;
}

}  // namespace

SeriesReader summary_named(std::string_view word, double factor) {
  using Values = std::span<const double>;
  // A document has null in place of a number that is not finite, and no summary of such a list.
  const auto of_finite = [](auto summary) {
    return [summary](Values v) {
      return !v.empty() && all_finite(v) ? std::optional(summary(v)) : std::nullopt;
    };
  };
  if (word == ".max")
    return of_finite([factor](Values v) { return largest(v, std::identity()) * factor; });
  if (word == ".min")
    return of_finite([factor](Values v) { return -largest(v, std::negate()) * factor; });
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
