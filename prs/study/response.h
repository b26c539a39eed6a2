#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "prs/model/command.h"

namespace prs {

/// The number at a path of the first load case of a result document or, where that has none, of the
/// document: `slip.efficiency`, `screw.peak_pressure_MPa.max`, `contact.nut.backlash_mm`,
/// `load_cases[1].axial_displacement_um`. Arrays take `[k]` from 0, `.max`, `.min` and `.mean`.
std::optional<double> response(const nlohmann::ordered_json& document, std::string_view path);

/// Every path of a document that has a response, of an array `.max` only.
std::vector<std::string> response_paths(const nlohmann::ordered_json& document);

/// Responses recorded for a command where the study lists none.
std::vector<std::string> default_responses(Command command);

}  // namespace prs
