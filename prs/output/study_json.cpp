#include <nlohmann/json.hpp>

#include "prs/output/json_values.h"
#include "prs/output/study_files.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

std::string_view name(Command command) {
  switch (command) {
    case Command::contact:
      return "contact";
    case Command::solve:
      return "solve";
    default:
      return "slip";
  }
}

Json level_json(const Level& level) {
  Json json;
  json["value"] = level.text;
  put(json, "number", level.number);
  return json;
}

Json factor_json(const Factor& factor) {
  Json json;
  json["path"] = factor.path;
  json["label"] = factor.label;
  if (!factor.unit.empty()) json["unit"] = factor.unit;
  if (factor.base) json["base"] = level_json(*factor.base);
  return json;
}

Json study_head(const Study& study) {
  Json json;
  json["command"] = name(study.command);
  json["plan"] = "one_at_a_time";
  json["factors"] = Json::array();
  for (const Factor& factor : study.factors) json["factors"].push_back(factor_json(factor));
  json["responses"] = study.responses;
  return json;
}

Json row_json(const Study& study, const StudyRow& row) {
  Json json;
  json["settings"] = Json::object();
  for (const Setting& setting : row.design.settings)
    json["settings"][study.factors[setting.factor].path] = level_json(setting.level);
  json["base"] = is_base(study, row.design);
  json["converged"] = row.status.converged();
  json["status"] = row.status.name;
  if (!row.status.reason.empty()) json["reason"] = row.status.reason;
  json["responses"] = Json::object();
  for (std::size_t k = 0; k < row.responses.size(); ++k)
    put(json["responses"], study.responses[k], row.responses[k]);
  return json;
}

}  // namespace

Json study_json(const StudyResult& result, const DocumentInfo& info) {
  Json document = document_head(info, {});
  document["study"] = study_head(result.study);
  document["designs"] = Json::array();
  for (const StudyRow& row : result.rows)
    document["designs"].push_back(row_json(result.study, row));
  return document;
}

}  // namespace prs
