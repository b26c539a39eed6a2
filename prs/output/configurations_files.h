#pragma once

#include <string>

#include "prs/configurations/configurations.h"
#include "prs/output/csv_style.h"

namespace prs {

/// `configurations.csv`: one row per configuration.
std::string configurations_csv(const Configurations& all, const CsvStyle& style = {});

/// `gear_pairs.csv`: one row per pair of gears, with the number of its configuration.
std::string gear_pairs_csv(const Configurations& all, const CsvStyle& style = {});

/// The configuration as a commented case, ready for `prs check` and `prs solve`: structure,
/// material and load are proposals, the load such that equal shares give 1.8 GPa. Throws CaseError
/// where the contacts have no Hertz contact, as those of `configurations` always have.
std::string configuration_case(const Configuration& c);

}  // namespace prs
