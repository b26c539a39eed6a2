#include "prs/study/study_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "prs/study/designs.h"
#include "prs/study/row_block.h"

namespace prs {
namespace {

/// The words that a factor can have, that of the file among them.
std::vector<std::string> words_of(const Factor& factor) {
  std::vector<std::string> words;
  if (factor.is_numeric()) return words;
  for (const Level& level : factor.levels) words.push_back(level.text);
  if (factor.base && std::ranges::find(words, factor.base->text) == words.end())
    words.push_back(factor.base->text);
  return words;
}

FactorColumn column_of(const Factor& factor) {
  FactorColumn column{factor.path, words_of(factor), kNoResponse};
  if (column.is_numeric() && !factor.unit.empty()) column.name += "_" + unit_key(factor.unit);
  if (!factor.base) return column;
  if (column.is_numeric())
    column.base = factor.base->number.value_or(kNoResponse);
  else
    column.base = static_cast<double>(std::ranges::find(column.words, factor.base->text) -
                                      column.words.begin());
  return column;
}

double value_of(const Factor& factor, const FactorColumn& column, const Draw& draw) {
  switch (draw.kind) {
    case Draw::Kind::number:
      return draw.number;
    case Draw::Kind::level:
      return column.is_numeric() ? *factor.levels[draw.level].number
                                 : static_cast<double>(draw.level);
    case Draw::Kind::as_in_file:
      break;
  }
  return column.base;
}

}  // namespace

std::string unit_key(const std::string& unit) {
  if (unit == "%") return "percent";
  std::string key;
  for (const char c : unit.starts_with("1/") ? unit.substr(1) : unit) {
    if (c == '/')
      key += key.empty() ? "per_" : "_per_";
    else if (c == '.')
      key += '_';
    else if (c != ' ' && c != '^')
      key += c;
  }
  return key;
}

std::vector<FactorColumn> factor_columns(const Study& study) {
  std::vector<FactorColumn> columns;
  std::map<std::string, int> uses;
  for (const std::string& response : study.responses) ++uses[response];
  for (const DrawnInput& drawn : drawn_inputs(study)) {
    FactorColumn& column = columns.emplace_back(column_of(*drawn.input));
    if (const int use = ++uses[column.name]; use > 1) column.name += fmt::format("_{}", use);
  }
  return columns;
}

std::vector<double> factor_values(const Study& study, const std::vector<FactorColumn>& columns,
                                  std::size_t first, std::size_t count) {
  const std::vector<DrawnInput> inputs = drawn_inputs(study);
  std::vector<double> values;
  values.reserve(count * columns.size());
  std::vector<Draw> drawn;
  for (std::size_t k = first; k < first + count; ++k) {
    set_draws(study, k, drawn);
    for (std::size_t f = 0; f < columns.size(); ++f)
      values.push_back(value_of(*inputs[f].input, columns[f], drawn[inputs[f].factor]));
  }
  return values;
}

}  // namespace prs
