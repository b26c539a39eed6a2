#include "prs/optimize/optimize_json.h"

#include <fmt/format.h>

#include <cmath>

#include "prs/optimize/optimize_designs.h"
#include "prs/record/json_values.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

std::string_view name(Compromise::By by) {
  switch (by) {
    case Compromise::By::ideal:
      return "ideal";
    case Compromise::By::knee:
      return "knee";
    case Compromise::By::weights:
      return "weights";
    case Compromise::By::best:
      break;
  }
  return "best";
}

Json variable_json(const Factor& variable) {
  Json json;
  json["path"] = variable.path;
  json["label"] = variable.label;
  if (!variable.unit.empty()) json["unit"] = variable.unit;
  if (variable.distribution.kind == Distribution::Kind::levels) {
    json["values"] = Json::array();
    for (const Level& level : variable.levels) json["values"].push_back(level.text);
  } else {
    json["from"] = variable.distribution.first;
    json["to"] = variable.distribution.second;
  }
  for (const Factor& linked : variable.companions) json["with"].push_back(linked.path);
  return json;
}

/// A response of a design that has an answer.
void put_response(Json& json, const std::string& key, double value) {
  if (std::isfinite(value)) json[key] = value;
}

Json design_json(const OptimizationResult& result, const EvaluatedDesign& design) {
  const Study& study = result.optimization.study;
  Json json;
  json["variables"] = Json::object();
  for (const DrawnInput& drawn : drawn_inputs(study))
    if (const auto value = value_in(*drawn.input, design.draws[drawn.factor])) {
      Json& entry = json["variables"][drawn.input->path];
      entry["value"] = value->text;
      put(entry, "number", value->number);
    }
  json["status"] = design.status.name;
  if (!design.status.reason.empty()) json["reason"] = design.status.reason;
  json["feasible"] = design.is_feasible();
  put_response(json, "violation", design.violation);
  json["responses"] = Json::object();
  for (std::size_t k = 0; k < design.responses.size(); ++k)
    put_response(json["responses"], study.responses[k], design.responses[k]);
  return json;
}

Json constraints_json(const OptimizationResult& result, const EvaluatedDesign& design) {
  Json list = Json::array();
  for (const Constraint& constraint : result.optimization.constraints) {
    Json json;
    json["name"] = constraint.name;
    json["constraint"] = constraint_text(result, constraint);
    put_response(json, "value", design.responses[constraint.response]);
    put_response(json, "limit", limit_of(constraint, design, result.initial));
    json["satisfied"] = keeps(constraint, design, result.initial);
    list.push_back(std::move(json));
  }
  return list;
}

/// With what a reader wants of it next to the file's own design.
Json chosen_json(const OptimizationResult& result, std::size_t index) {
  const Optimization& optimization = result.optimization;
  const EvaluatedDesign& design = result.design(index);
  Json json;
  json["design"] = index + 1;
  json["algorithm"] = name(result.search_of(index).algorithm);
  json.update(design_json(result, design));
  json["change_percent"] = Json::object();
  for (std::size_t k = 0; k < design.responses.size(); ++k)
    put(json["change_percent"], optimization.study.responses[k],
        change_percent(design.responses[k], result.initial.responses[k]));
  json["constraints"] = constraints_json(result, design);
  json["set"] = settings_of(optimization, design);
  return json;
}

Json search_json(const OptimizationResult& result, const Search& search, std::size_t first) {
  const SearchCounts counts = count(search);
  Json json;
  json["algorithm"] = name(search.algorithm);
  json["designs"] = counts.designs;
  json["feasible"] = counts.feasible;
  json["without_answer"] = counts.without_answer;
  json["front"] = Json::array();
  for (const std::size_t k : search.front) {
    Json design;
    design["design"] = first + k;
    design.update(design_json(result, search.designs[k]));
    json["front"].push_back(std::move(design));
  }
  return json;
}

Json head_json(const Optimization& optimization) {
  const Study& study = optimization.study;
  Json json;
  json["command"] = name(study.command);
  json["variables"] = Json::array();
  for (const Factor& variable : study.factors) json["variables"].push_back(variable_json(variable));
  json["objectives"] = Json::array();
  for (const Objective& objective : optimization.objectives)
    json["objectives"].push_back(
        {{objective.maximize ? "maximize" : "minimize", study.responses[objective.response]}});
  json["algorithm"] = name(optimization.algorithm);
  if (optimization.check) json["check"] = name(*optimization.check);
  json["population"] = optimization.population;
  json["generations"] = optimization.generations;
  json["seed"] = optimization.seed;
  json["compromise"]["by"] = name(optimization.compromise.by);
  if (optimization.compromise.by == Compromise::By::weights)
    json["compromise"]["weights"] = optimization.compromise.weights;
  if (optimization.compromise.by == Compromise::By::best)
    json["compromise"]["of"] =
        study.responses[optimization.objectives[optimization.compromise.objective].response];
  return json;
}

Json comparison_json(const OptimizationResult& result) {
  const FrontComparison& comparison = *result.comparison;
  Json json;
  json["hypervolume"] = comparison.hypervolume;
  json["check_hypervolume"] = comparison.check_hypervolume;
  json["best"] = Json::array();
  for (std::size_t k = 0; k < comparison.best.size(); ++k) {
    const std::size_t response = result.optimization.objectives[k].response;
    Json best;
    best["objective"] = result.optimization.study.responses[response];
    best["value"] = comparison.best[k];
    best["check_value"] = comparison.check_best[k];
    put(best, "difference_percent", change_percent(comparison.check_best[k], comparison.best[k]));
    json["best"].push_back(std::move(best));
  }
  return json;
}

}  // namespace

Json optimize_json(const OptimizationResult& result, const DocumentInfo& info) {
  Json document = document_head(info, {});
  document["optimize"] = head_json(result.optimization);
  document["initial"] = design_json(result, result.initial);
  document["initial"]["constraints"] = constraints_json(result, result.initial);
  if (result.compromise) document["compromise"] = chosen_json(result, *result.compromise);
  if (result.nearest) document["nearest"] = chosen_json(result, *result.nearest);
  document["front"] = Json::array();
  for (const std::size_t k : result.front) document["front"].push_back(k + 1);
  document["search"] = search_json(result, result.search, 1);
  if (result.check)
    document["check"] = search_json(result, *result.check, 1 + result.search.designs.size());
  if (result.comparison) document["comparison"] = comparison_json(result);
  return document;
}

}  // namespace prs
