#pragma once

#include <nlohmann/json.hpp>

#include "prs/configurations/configurations.h"
#include "prs/record/document.h"
#include "prs/record/record.h"

namespace prs {

/// The document of `prs configurations --json`; `number` is what `--write` takes.
nlohmann::ordered_json configurations_json(const Configurations& all, const DocumentInfo& info);

template <>
Record<Configurations> record_of();

/// `standard` or `inverted`.
std::string_view type_name(Mechanism::Type type);

}  // namespace prs
