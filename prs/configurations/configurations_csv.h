#pragma once

#include <string>

#include "prs/configurations/configurations.h"
#include "prs/record/csv_style.h"

namespace prs {

/// `configurations.csv`: one row per configuration.
std::string configurations_csv(const Configurations& all, const CsvStyle& style = {});

/// `gear_pairs.csv`: one row per pair of gears, with the number of its configuration.
std::string gear_pairs_csv(const Configurations& all, const CsvStyle& style = {});

}  // namespace prs
