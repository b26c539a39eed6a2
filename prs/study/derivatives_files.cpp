#include "prs/study/derivatives_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "prs/loads/case_table.h"
#include "prs/loads/warnings.h"
#include "prs/record/csv_writer.h"
#include "prs/record/json_values.h"
#include "prs/record/response_title.h"
#include "prs/record/table_units.h"
#include "prs/study/study_text.h"
#include "prs/text.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostBars = 16;
constexpr std::size_t kFactorWidth = 40;

/// Factors that have an elasticity of a response, the strongest first, then those that are 0.
std::vector<std::size_t> ranked(const CaseDerivatives& result, std::size_t response) {
  std::vector<std::size_t> order;
  const auto strength = [&](std::size_t factor) {
    const auto& elasticity = result.factors[factor].responses[response]->elasticity;
    return elasticity ? std::abs(*elasticity) : -1.0;
  };
  for (std::size_t k = 0; k < result.factors.size(); ++k) {
    const std::optional<Derivative>& d = result.factors[k].responses[response];
    const std::optional<Level>& base = result.study.factors[k].base;
    if (d && (d->elasticity || (base && base->number == 0.0))) order.push_back(k);
  }
  std::ranges::stable_sort(order, std::greater{}, strength);
  return order;
}

Json factor_json(const Factor& factor, const std::optional<Derivative>& d,
                 const std::string& reason) {
  Json json;
  json["path"] = factor.path;
  if (!factor.unit.empty()) json["unit"] = factor.unit;
  if (factor.base) put(json, "at", factor.base->number);
  if (!d) {
    json["reason"] = reason;
    return json;
  }
  put(json, "derivative", d->value);
  put(json, "percent_per_percent", d->elasticity);
  put(json, "error", d->error);
  return json;
}

/// The responses that have no derivative by a factor, by name.
std::string without_derivative(const CaseDerivatives& result, std::size_t factor) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < result.study.responses.size(); ++k)
    if (!result.factors[factor].responses[k])
      names.push_back(response_title(result.study.responses[k]).name);
  if (names.size() > 1 && names.size() == result.study.responses.size()) return "any response";
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

Json derivatives_json(const CaseDerivatives& result, const DocumentInfo& info) {
  Json document = document_head(info, result.warnings);
  document["derivatives"] = Json::array();
  for (std::size_t k = 0; k < result.values.size(); ++k) {
    Json json;
    json["response"] = result.study.responses[k];
    put(json, "value", result.values[k]);
    json["by"] = Json::array();
    for (std::size_t f = 0; f < result.factors.size(); ++f)
      json["by"].push_back(factor_json(result.study.factors[f], result.factors[f].responses[k],
                                       result.factors[f].reason));
    document["derivatives"].push_back(std::move(json));
  }
  return document;
}

std::string derivatives_csv(const CaseDerivatives& result, const CsvStyle& style) {
  CsvWriter csv(style);
  csv.row("response", "value", "factor", "label", "at", "unit", "derivative", "percent_per_percent",
          "error", "reason");
  for (std::size_t k = 0; k < result.values.size(); ++k)
    for (std::size_t f = 0; f < result.factors.size(); ++f) {
      const Factor& factor = result.study.factors[f];
      const std::optional<Derivative>& d = result.factors[f].responses[k];
      csv.fields(result.study.responses[k], result.values[k], factor.path, factor.label,
                 factor.base ? factor.base->number : std::nullopt, factor.unit);
      if (d)
        csv.row(d->value, d->elasticity, d->error, "");
      else
        csv.row("", "", "", result.factors[f].reason);
    }
  return csv.take();
}

std::string derivatives_table(const CaseDerivatives& result) {
  std::string text;
  for (std::size_t k = 0; k < result.values.size(); ++k) {
    const auto& [title, shown] = table_response(result.study.responses[k]);
    text +=
        fmt::format("{}{}: {}{}\n", k > 0 ? "\n" : "", title.name,
                    result.values[k] ? fmt::format("{:.6g}", shown * *result.values[k]) : "absent",
                    title.unit.empty() ? "" : " " + title.unit);
    text += fmt::format("  {:<{}}  {:>16}  {:>16}  {}\n", "factor", kFactorWidth, "% per 1 %",
                        "derivative", "per");
    for (const std::size_t f : ranked(result, k)) {
      const Factor& factor = result.study.factors[f];
      const Derivative& d = *result.factors[f].responses[k];
      text += fmt::format(
          "  {}  {}  {:>16.7g}  {}\n", fitted(printable(factor.label), kFactorWidth, true),
          padded(d.elasticity ? fmt::format("{:.5f}", *d.elasticity) : std::string(kAbsent), 16,
                 false),
          shown * d.value, factor.unit.empty() ? "1" : printable(factor.unit));
    }
  }
  for (std::size_t f = 0; f < result.factors.size(); ++f)
    if (!result.factors[f].reason.empty())
      text += "\n" + wrapped(fmt::format("{}: no derivative of {}: {}",
                                         printable(result.study.factors[f].label),
                                         without_derivative(result, f),
                                         printable(result.factors[f].reason)),
                             "  ", kTableWidth);
  return text + warning_section(result.warnings);
}

}  // namespace prs
