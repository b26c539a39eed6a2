#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string_view>

#include "prs/measures/analyze_measures.h"
#include "prs/quantities/json.h"

namespace prs {

/// Takes the pieces of a text.
using TextSink = std::function<void(std::string_view)>;

/// `to_json` and `measures_json` with an empty list of load cases.
nlohmann::ordered_json outline_json(const Result& result, const DocumentInfo& info);
nlohmann::ordered_json outline_json(const MeasuresResult& result, const DocumentInfo& info);

/// What stands in the list; absent behind the last.
std::optional<nlohmann::ordered_json> load_case_json(const Result& result, std::size_t k);
std::optional<nlohmann::ordered_json> load_case_json(const MeasuresResult& result, std::size_t k);

/// What `json_text` gives of a document whose list of load cases is empty in `outline` and filled
/// by `load_case`, one after the other: memory for one of them is enough.
void write_with_load_cases(
    const nlohmann::ordered_json& outline,
    const std::function<std::optional<nlohmann::ordered_json>(std::size_t)>& load_case,
    const TextSink& sink);

}  // namespace prs
