#include "prs/output/derivatives_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "prs/output/case_table.h"
#include "prs/output/csv_writer.h"
#include "prs/output/json_values.h"
#include "prs/output/response_title.h"
#include "prs/output/text.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostFigures = 24;
constexpr std::size_t kMostBars = 16;
constexpr std::size_t kLabelWidth = 40;

/// Factors that have an elasticity of a response, the strongest first.
std::vector<std::size_t> ranked(const CaseDerivatives& result, std::size_t response) {
  std::vector<std::size_t> order;
  const auto strength = [&](std::size_t factor) {
    return std::abs(*result.factors[factor].responses[response]->elasticity);
  };
  for (std::size_t k = 0; k < result.factors.size(); ++k) {
    const std::optional<Derivative>& d = result.factors[k].responses[response];
    if (d && d->elasticity) order.push_back(k);
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

std::string label_of(const Factor& factor) {
  return shortened(printable(factor.label), kLabelWidth);
}

Polyline bar(double from, double to, double at) {
  constexpr double half = 0.36;
  return {{from, at - half}, {to, at - half}, {to, at + half}, {from, at + half}};
}

}  // namespace

Json derivatives_json(const CaseDerivatives& result, const DocumentInfo& info) {
  Json document = document_head(info, {});
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

std::string derivatives_csv(const CaseDerivatives& result) {
  CsvWriter csv;
  for (const char* key : {"response", "value", "factor", "label", "at", "unit", "derivative",
                          "percent_per_percent", "error", "reason"})
    csv.text(key);
  csv.end_row();
  for (std::size_t k = 0; k < result.values.size(); ++k)
    for (std::size_t f = 0; f < result.factors.size(); ++f) {
      const Factor& factor = result.study.factors[f];
      const std::optional<Derivative>& d = result.factors[f].responses[k];
      csv.text(result.study.responses[k]);
      csv.number(result.values[k]);
      csv.text(factor.path);
      csv.text(factor.label);
      csv.number(factor.base ? factor.base->number : std::nullopt);
      csv.text(factor.unit);
      csv.number(d ? std::optional(d->value) : std::nullopt);
      csv.number(d ? d->elasticity : std::nullopt);
      csv.number(d ? std::optional(d->error) : std::nullopt);
      csv.text(d ? "" : result.factors[f].reason);
      csv.end_row();
    }
  return csv.take();
}

std::string derivatives_table(const CaseDerivatives& result) {
  std::string text;
  for (std::size_t k = 0; k < result.values.size(); ++k) {
    const ResponseTitle title = response_title(result.study.responses[k]);
    text += fmt::format("{}{}: {}{}\n", k > 0 ? "\n" : "", title.name,
                        result.values[k] ? fmt::format("{:.6g}", *result.values[k]) : "absent",
                        title.unit.empty() ? "" : " " + title.unit);
    text += fmt::format("  {:<{}}  {:>16}  {:>16}  {}\n", "factor", kLabelWidth, "% per 1 %",
                        "derivative", "per");
    for (const std::size_t f : ranked(result, k)) {
      const Factor& factor = result.study.factors[f];
      const Derivative& d = *result.factors[f].responses[k];
      text += fmt::format("  {}  {:>16.5f}  {:>16.7g}  {}\n",
                          padded(label_of(factor), kLabelWidth, true), *d.elasticity, d.value,
                          factor.unit.empty() ? "1" : printable(factor.unit));
    }
  }
  for (std::size_t f = 0; f < result.factors.size(); ++f)
    if (!result.factors[f].reason.empty())
      text += "\n" + wrapped(fmt::format("{}: no derivative of some responses: {}",
                                         printable(result.study.factors[f].label),
                                         printable(result.factors[f].reason)),
                             "  ", kTableWidth);
  return text;
}

std::vector<Figure> derivatives_figures(const CaseDerivatives& result) {
  std::vector<Figure> figures;
  for (std::size_t k = 0; k < std::min(result.values.size(), kMostFigures); ++k) {
    std::vector<std::size_t> order = ranked(result, k);
    if (order.empty()) continue;
    order.resize(std::min(order.size(), kMostBars));
    const ResponseTitle title = response_title(result.study.responses[k]);
    Figure figure;
    figure.name = fmt::format("{:02}_derivatives", k + 1);
    figure.title = fmt::format("{}: change by 1 % of each factor", title.name);
    figure.styles = {fill_of("#004488")};
    const auto rows = static_cast<double>(order.size());
    figure.y = {"", -0.5, rows - 0.5};
    Panel panel;
    Line bars{0, {}};
    double least = 0.0, most = 0.0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const double at = rows - 1.0 - static_cast<double>(i);
      const double elasticity = *result.factors[order[i]].responses[k]->elasticity;
      bars.parts.push_back(bar(0.0, elasticity, at));
      least = std::min(least, elasticity);
      most = std::max(most, elasticity);
    }
    // Room for the labels beside the bars.
    const double span = std::max(most - least, 1e-12);
    figure.x = {fmt::format("{} per 1 % (%)", title.name), least - 0.05 * span, most + 0.9 * span};
    for (std::size_t i = 0; i < order.size(); ++i) {
      const double elasticity = *result.factors[order[i]].responses[k]->elasticity;
      panel.labels.push_back(
          {fmt::format("{} ({:+.3f})", label_of(result.study.factors[order[i]]), elasticity),
           std::max(elasticity, 0.0) + 0.02 * span, rows - 1.0 - static_cast<double>(i)});
    }
    panel.lines.push_back(std::move(bars));
    figure.panels.push_back(std::move(panel));
    figure.panel_height = static_cast<int>(60 + 26 * order.size());
    figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace prs
