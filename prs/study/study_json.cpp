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
#include "prs/record/record_table.h"
#include "prs/study/designs.h"
#include "prs/study/schedule.h"

namespace prs {
namespace {

using Json = nlohmann::ordered_json;

/// A row of the document as text, indented as there.
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
  put_object(document, StudyDocument{&result, false});
  return document;
}

Json study_json(const StudyResult& result, const DocumentInfo& info) {
  Json document = document_head(info, result.warnings);
  put_object(document, StudyDocument{&result});
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
