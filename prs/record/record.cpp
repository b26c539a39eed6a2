#include "prs/record/record.h"

#include <charconv>

#include "prs/indices.h"
#include "prs/record/record_table.h"

namespace prs {

const ShownUnit& unit_at(std::string_view path) {
  while (!path.empty()) {
    const std::size_t dot = path.rfind('.');
    std::string_view key = path.substr(dot == path.npos ? 0 : dot + 1);
    key = key.substr(0, key.find('['));
    if (is_ratio(key)) return kNoUnit;
    if (const ShownUnit& unit = unit_of(key); !unit.text.empty()) return unit;
    path = path.substr(0, dot == path.npos ? 0 : dot);
  }
  return kNoUnit;
}

std::string words_of(std::string_view key) {
  std::string words(key.substr(0, key.size() - unit_of(key).suffix.size()));
  std::ranges::replace(words, '_', ' ');
  if (words.starts_with("max ")) words.replace(0, 3, "largest");
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

struct Extreme {
  double value = 0.0;
  bool all_finite = false;
};

/// Largest f(x), computed as four maxima side by side, and whether all are finite: 0 times any other value is not 0.
template <class F>
Extreme extreme_of(std::span<const double> v, F f) {
  double of[4] = {f(v[0]), f(v[0]), f(v[0]), f(v[0])};
  double zero[4] = {};
  std::size_t k = 0;
  for (; k + 4 <= v.size(); k += 4)
    for (const auto j : up_to(4)) {
      const double x = f(v[k + j]);
      of[j] = x > of[j] ? x : of[j];
      zero[j] += 0.0 * x;
    }
  for (; k < v.size(); ++k) {
    of[0] = std::max(of[0], f(v[k]));
    zero[0] += 0.0 * v[k];
  }
  return {std::max(std::max(of[0], of[1]), std::max(of[2], of[3])), (zero[0] + zero[1]) + (zero[2] + zero[3]) == 0.0};
}

}  // namespace

std::optional<double> SeriesReader::operator()(std::span<const double> v) const {
  // Documents have null for a number that is not finite, and no summary of a list with one.
  const auto shown = [&](double value, bool finite) { return finite ? std::optional(value * factor) : std::nullopt; };
  if (word == Word::one) return index < v.size() ? shown(v[index], std::isfinite(v[index])) : std::nullopt;
  if (v.empty()) return std::nullopt;
  if (word == Word::smallest) {
    const Extreme e = extreme_of(v, std::negate());
    return shown(-e.value, e.all_finite);
  }
  const Extreme e = extreme_of(v, std::identity());
  if (word == Word::largest || !e.all_finite) return shown(e.value, e.all_finite);
  double sum = 0.0;
  for (const double x : v) sum += x * factor;
  return sum / static_cast<double>(v.size());
}

SeriesReader summary_named(std::string_view word, double factor) {
  using enum SeriesReader::Word;
  if (word == ".max") return {largest, factor};
  if (word == ".min") return {smallest, factor};
  if (word == ".mean") return {mean, factor};
  const std::optional<std::size_t> index = take_index(word);
  return index && word.empty() ? SeriesReader{one, factor, *index} : SeriesReader();
}

namespace detail {

Json object_for(std::size_t entries) {
  Json::object_t object;
  object.reserve(entries);
  return object;
}

Json array_of(std::span<const double> si, const ShownUnit& unit) {
  Json::array_t array;
  array.reserve(si.size());
  for (const double value : si)
    if (std::isfinite(value))
      array.emplace_back(value * unit.factor);
    else
      array.emplace_back(nullptr);
  return array;
}

Json arrays_of(std::span<const double> si, std::size_t row, const ShownUnit& unit) {
  if (row == 0) return array_of(si, unit);
  auto rows = Json::array();
  for (std::size_t first = 0; first < si.size(); first += row) rows.push_back(array_of(si.subspan(first, row), unit));
  return rows;
}

}  // namespace detail

}  // namespace prs
