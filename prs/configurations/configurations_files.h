#pragma once

#include "prs/configurations/configurations.h"
#include "prs/record/delivery.h"
#include "prs/record/record.h"

namespace prs {

/// The document of `prs configurations --json`; `number` is the argument of `--write`.
nlohmann::ordered_json configurations_json(const Configurations& all, const DocumentInfo& info);

Record<Configurations> record_of(Type<Configurations>);

/// The configurations, one numbered line each, then the reasons for omitted ones, within 110 columns.
std::string configurations_table(const ConfigurationQuery& query, const Configurations& all);

/// Reasons why starts are left out, starts with the same reason together; details if they are few.
std::string left_out_text(const Configurations& all);

/// `configurations.csv`: one row per configuration.
std::string configurations_csv(const Configurations& all, const CsvStyle& style = {});

/// `gear_pairs.csv`: one row per pair of gears, with the number of its configuration.
std::string gear_pairs_csv(const Configurations& all, const CsvStyle& style = {});

}  // namespace prs
