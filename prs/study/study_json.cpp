#include "prs/study/study_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>

#include "prs/loads/load_json.h"
#include "prs/printable.h"
#include "prs/record/json_values.h"
#include "prs/study/designs.h"
#include "prs/study/schedule.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

Json level_json(const Level& level) {
  Json json;
  json["value"] = level.text;
  put(json, "number", level.number);
  return json;
}

/// `{"uniform": {"from": 29, "to": 31}}`, in the factor's unit.
Json distribution_json(const Distribution& distribution) {
  const auto [kind, first, second] = distribution;
  switch (kind) {
    case Distribution::Kind::uniform:
      return {{"uniform", {{"from", first}, {"to", second}}}};
    case Distribution::Kind::log_uniform:
      return {{"log_uniform", {{"from", first}, {"to", second}}}};
    case Distribution::Kind::normal:
      return {{"normal", {{"mean", first}, {"deviation", second}}}};
    case Distribution::Kind::levels:
      break;
  }
  return {{"levels", true}};
}

Json factor_json(const Factor& factor, bool sampled) {
  Json json;
  json["path"] = factor.path;
  json["label"] = factor.label;
  if (!factor.unit.empty()) json["unit"] = factor.unit;
  if (factor.base) json["base"] = level_json(*factor.base);
  if (sampled) json["distribution"] = distribution_json(factor.distribution);
  for (const Factor& companion : factor.companions)
    json["with"].push_back(factor_json(companion, false));
  return json;
}

Json study_head(const Study& study) {
  const bool sampled = is_sampled(study.plan);
  Json json;
  json["command"] = name(study.command);
  json["plan"] = prs::name(study.plan);
  if (sampled) {
    json["samples"] = study.samples;
    json["seed"] = study.seed;
  }
  json["factors"] = Json::array();
  for (const Factor& factor : study.factors)
    json["factors"].push_back(factor_json(factor, sampled));
  json["responses"] = study.responses;
  return json;
}

Json statistics_json(const ResponseStatistics& s) {
  Json json;
  json["count"] = s.count;
  if (s.count == 0) return json;
  json["mean"] = s.mean;
  put(json, "standard_deviation", s.standard_deviation);
  json["min"] = s.min;
  json["min_design"] = s.min_design;
  json["max"] = s.max;
  json["max_design"] = s.max_design;
  for (std::size_t k = 0; k < kProbabilities.size(); ++k)
    json["quantiles"][fmt::format("{:g}", kProbabilities[k])] = s.quantiles[k];
  if (s.values_kept < s.count) json["quantiles_from"] = s.values_kept;
  if (!s.histogram.counts.empty())
    json["histogram"] = {
        {"from", s.histogram.from}, {"to", s.histogram.to}, {"counts", s.histogram.counts}};
  return json;
}

Json fit_json(const Study& study, const LinearFit& fit) {
  Json json;
  json["r_squared"] = fit.r_squared;
  put(json, "adjusted_r_squared", fit.adjusted_r_squared);
  json["intercept"] = fit.intercept;
  json["factors"] = Json::array();
  for (const FactorEffect& effect : fit.effects) {
    Json factor;
    factor["path"] = study.factors[effect.factor].path;
    factor["contribution_percent"] = effect.contribution_percent;
    factor["coefficient"] = effect.coefficient;
    put(factor, "standard_error", effect.standard_error);
    json["factors"].push_back(std::move(factor));
  }
  return json;
}

Json surfaces_json(const Study& study, const ResponseSurfaces& surfaces) {
  Json json;
  json["designs"] = surfaces.designs;
  if (!surfaces.reason.empty()) json["reason"] = surfaces.reason;
  for (std::size_t k = 0; k < surfaces.fits.size(); ++k)
    if (surfaces.fits[k])
      json["responses"][study.responses[k]] = fit_json(study, *surfaces.fits[k]);
  return json;
}

Json estimate_json(const Estimate& estimate) {
  Json json;
  json["value"] = estimate.value;
  put(json, "half_width_95", estimate.half_width);
  return json;
}

Json indices_json(const Study& study, const ResponseIndices& indices) {
  Json json;
  json["samples"] = indices.samples;
  json["samples_left_out"] = indices.left_out;
  json["variance"] = indices.variance;
  json["factors"] = Json::array();
  for (const FactorIndices& factor : indices.factors)
    json["factors"].push_back({{"path", study.factors[factor.factor].path},
                               {"first", estimate_json(factor.first)},
                               {"total", estimate_json(factor.total)}});
  return json;
}

Json summary_json(const StudyResult& result) {
  const Study& study = result.study;
  Json json;
  json["designs"] = result.designs;
  json["refused"] = result.refused;
  json["not_converged"] = result.failed;
  json["statistics"] = Json::object();
  for (std::size_t k = 0; k < result.summary.statistics.size(); ++k)
    json["statistics"][study.responses[k]] = statistics_json(result.summary.statistics[k]);
  if (result.summary.surfaces)
    json["response_surface"] = surfaces_json(study, *result.summary.surfaces);
  for (std::size_t k = 0; k < result.summary.indices.size(); ++k)
    json["sobol_indices"][study.responses[k]] = indices_json(study, result.summary.indices[k]);
  return json;
}

std::string_view name(Envelope::Combine combine) {
  return combine == Envelope::Combine::product ? "product" : "sum";
}

std::string_view name(Envelope::Normalise normalise) {
  return normalise == Envelope::Normalise::rms   ? "rms"
         : normalise == Envelope::Normalise::max ? "max"
                                                 : "none";
}

/// A map as rows along the second factor; null where there is no number.
Json map_json(const GridMaps& maps, const GridMap& map) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < maps.axes[0].nodes(); ++i) {
    Json row = Json::array();
    for (std::size_t j = 0; j < maps.axes[1].nodes(); ++j) {
      const double value = map[maps.node(i, j)];
      row.push_back(std::isfinite(value) ? Json(value) : Json());
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

Json point_json(const StudyResult& result, const EnvelopePoint& point) {
  const Study& study = result.study;
  Json json;
  json["name"] = point.name;
  if (!point.reason.empty()) {
    json["reason"] = point.reason;
    return json;
  }
  if (point.design) json["design"] = *point.design;
  const std::vector<DrawnInput> inputs = drawn_inputs(study);
  for (std::size_t k = 0; k < inputs.size(); ++k)
    json["settings"][inputs[k].input->path] = level_json(point.inputs[k]);
  json["responses"] = Json::object();
  for (std::size_t k = 0; k < study.responses.size(); ++k)
    if (std::isfinite(point.responses[k]))
      json["responses"][study.responses[k]] = point.responses[k];
  json["normalised"] = Json::object();
  for (std::size_t k = 0; k < point.normalised.size(); ++k)
    if (std::isfinite(point.normalised[k]))
      json["normalised"][study.responses[result.summary.envelope->measures[k].response]] =
          point.normalised[k];
  if (std::isfinite(point.envelope)) json["envelope"] = point.envelope;
  return json;
}

Json envelope_json(const StudyResult& result) {
  const Study& study = result.study;
  const GridMaps& maps = *result.summary.maps;
  const EnvelopeResult& envelope = *result.summary.envelope;
  const bool with_maps = maps.nodes() <= kMostRowsShown;
  Json json;
  json["combine"] = name(study.envelope->combine);
  json["normalise"] = name(study.envelope->normalise);
  json["axes"] = Json::array();
  for (const MapAxis& axis : maps.axes) {
    Json shown{{"path", study.factors[axis.factor].path}};
    if (!study.factors[axis.factor].unit.empty()) shown["unit"] = study.factors[axis.factor].unit;
    shown["numbers"] = axis.numbers;
    json["axes"].push_back(std::move(shown));
  }
  json["measures"] = Json::array();
  for (const MeasureMap& measure : envelope.measures) {
    Json shown{{"response", study.responses[measure.response]},
               {"weight", measure.weight},
               {"rms", measure.rms},
               {"normalised_by", measure.normalised_by},
               {"designs_without", measure.without}};
    if (with_maps) shown["normalised"] = map_json(maps, normalised(maps, measure));
    json["measures"].push_back(std::move(shown));
  }
  json["rms"] = envelope.rms;
  json["designs_without"] = envelope.without;
  if (envelope.best) {
    json["max"] = envelope.values[*envelope.best];
    json["max_design"] = maps.design(*envelope.best);
  }
  if (with_maps)
    json["values"] = map_json(maps, envelope.values);
  else
    json["maps_in"] = "envelope.csv";
  json["points"] = Json::array();
  for (const EnvelopePoint& point : envelope.points)
    json["points"].push_back(point_json(result, point));
  return json;
}

Json row_json(const Study& study, const StudyRow& row) {
  Json json;
  json["settings"] = Json::object();
  for (const Setting& setting : row.design.settings) {
    const Factor& factor = study.factors[setting.factor];
    json["settings"][factor.path] = level_json(setting.level);
    for (std::size_t k = 0; k < factor.companions.size(); ++k)
      json["settings"][factor.companions[k].path] = level_json(setting.companions[k]);
  }
  json["base"] = is_base(study, row.design);
  json["converged"] = row.status.converged();
  json["status"] = row.status.name;
  if (!row.status.reason.empty()) json["reason"] = row.status.reason;
  json["responses"] = Json::object();
  for (std::size_t k = 0; k < row.responses.size(); ++k)
    put(json["responses"], study.responses[k], row.responses[k]);
  return json;
}

/// `row_json` as text, indented as in the document.
class RowText {
 public:
  explicit RowText(const Study& study) : study_(study) {
    for (const Factor& factor : study.factors) {
      std::vector<std::string>& keys = inputs_.emplace_back();
      keys.push_back(key(factor.path));
      for (const Factor& companion : factor.companions) keys.push_back(key(companion.path));
    }
    for (const std::string& path : study.responses) responses_.push_back(key(path));
  }

  void append(std::string& text, const StudyRow& row) const {
    text += "    {\n      \"settings\": {";
    bool first = true;
    for (const Setting& setting : row.design.settings) {
      const std::vector<std::string>& keys = inputs_[setting.factor];
      append_level(text, keys[0], setting.level, first);
      for (std::size_t k = 1; k < keys.size(); ++k)
        append_level(text, keys[k], setting.companions[k - 1], first);
    }
    text += first ? "},\n" : "\n      },\n";
    text += is_base(study_, row.design) ? "      \"base\": true,\n" : "      \"base\": false,\n";
    text +=
        row.status.converged() ? "      \"converged\": true,\n" : "      \"converged\": false,\n";
    text += "      \"status\": ";
    append_text(text, row.status.name);
    if (!row.status.reason.empty()) {
      text += ",\n      \"reason\": ";
      append_text(text, row.status.reason);
    }
    text += ",\n      \"responses\": {";
    first = true;
    for (std::size_t k = 0; k < row.responses.size(); ++k) {
      if (!row.responses[k] || !std::isfinite(*row.responses[k])) continue;
      begin_item(text, first);
      text += responses_[k];
      append_number(text, *row.responses[k]);
    }
    text += first ? "}\n    }" : "\n      }\n    }";
  }

 private:
  static std::string quoted(std::string_view text) {
    return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  static std::string key(std::string_view path) { return "        " + quoted(path) + ": "; }
  static void begin_item(std::string& text, bool& first) {
    text += first ? "\n" : ",\n";
    first = false;
  }
  static void append_text(std::string& text, std::string_view value) {
    const bool plain = std::ranges::all_of(
        value, [](char c) { return c >= 0x20 && c < 0x7F && c != '"' && c != '\\'; });
    if (plain)
      text.append("\"").append(value).append("\"");
    else
      text += quoted(value);
  }
  static void append_number(std::string& text, double value) {
    std::array<char, 64> digits;
    const char* end = nlohmann::detail::to_chars(digits.data(), digits.data() + 64, value);
    text.append(digits.data(), static_cast<std::size_t>(end - digits.data()));
  }
  static void append_level(std::string& text, const std::string& key, const Level& level,
                           bool& first) {
    begin_item(text, first);
    text.append(key).append("{\n          \"value\": ");
    append_text(text, level.text);
    if (level.number && std::isfinite(*level.number)) {
      text += ",\n          \"number\": ";
      append_number(text, *level.number);
    }
    text += "\n        }";
  }

  const Study& study_;
  std::vector<std::vector<std::string>> inputs_;  ///< Of each factor its key, then companions'.
  std::vector<std::string> responses_;
};

}  // namespace

std::string_view name(Plan plan) {
  constexpr std::array kNames{"one_at_a_time", "grid",          "latin_hypercube", "sobol",
                              "monte_carlo",   "sobol_indices", "derivatives"};
  return kNames.at(static_cast<std::size_t>(plan));
}

Json study_outline(const StudyResult& result, const DocumentInfo& info) {
  Json document = document_head(info, result.warnings);
  document["study"] = study_head(result.study);
  document["summary"] = summary_json(result);
  if (result.summary.envelope) document["envelope"] = envelope_json(result);
  if (result.rows.size() < result.designs) document["designs_shown"] = result.rows.size();
  document["designs"] = Json::array();
  return document;
}

Json study_json(const StudyResult& result, const DocumentInfo& info) {
  Json document = study_outline(result, info);
  for (const StudyRow& row : result.rows)
    document["designs"].push_back(row_json(result.study, row));
  return document;
}

std::string study_text(const Json& outline, const StudyResult& result, std::size_t threads) {
  std::string text = json_text(outline);
  // JSON escapes line ends in texts, so this line can only be the key of the document.
  constexpr std::string_view kEmpty = "\n  \"designs\": []";
  const std::size_t list = text.find(kEmpty);
  if (list == std::string::npos || result.rows.empty()) return text;
  const std::size_t first = list + kEmpty.size() - 1;
  const std::string end = text.substr(first);
  text.resize(first);
  const RowText row_text(result.study);
  constexpr std::size_t kRowsAtOnce = 64;
  const std::size_t rows = result.rows.size(), parts = (rows + kRowsAtOnce - 1) / kRowsAtOnce;
  run_in_order(parts, threads, [&](std::size_t k) -> std::function<void()> {
    auto part = std::make_shared<std::string>();
    for (std::size_t row = k * kRowsAtOnce; row < std::min(rows, (k + 1) * kRowsAtOnce); ++row) {
      *part += row == 0 ? "\n" : ",\n";
      row_text.append(*part, result.rows[row]);
      // The second row is as long as most.
      if (row == k * kRowsAtOnce + 1) part->reserve((kRowsAtOnce + 2) * part->size() / 2);
    }
    if (!is_plain_lines(*part)) *part = printable_json(*part);
    return [&text, part, parts, k] {
      if (k == 0) text.reserve(text.size() + (parts + 1) * (part->size() + part->size() / 8));
      text += *part;
    };
  });
  text.append("\n  ").append(end);
  return text;
}

}  // namespace prs
