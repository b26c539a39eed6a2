#pragma once

#include "prs/loads/load_json.h"
#include "prs/record/csv_writer.h"
#include "validation/jung_2017/measures.h"

namespace prs::jung_2017 {

/// How the columns of tables 7.1 and 7.2 are computed from three diameters.
struct Recipe {
  std::string_view name;
  Measures (*measures)(const Diameters&);
  std::string_view title;
};

/// `jung-as-printed` and `jung-corrected`.
const std::vector<Recipe>& recipes();
/// The recipe of this name, or null.
const Recipe* find_recipe(std::string_view name);

/// Rows of diameters from a file, where one is named, then from texts such as `54 mm, 27 mm, 9 mm`
/// (nut outer, screw, roller), each the value of an option `--diameters`. The file is YAML,
///
///     diameters:
///       - {nut_outer: 54 mm, screw: 27 mm, roller: 9 mm}
///
/// or, where its name ends in `.csv`, comma-separated values with the columns nut_outer_mm,
/// screw_mm and roller_mm. Throws input::InputError, also where there is no row, where rollers and
/// screw do not fit into the nut and where the ratio of diameters is outside the range of Lemor's
/// factor.
std::vector<Diameters> read_diameters(const std::string& file,
                                      const std::vector<std::string>& texts);

/// The columns with the decimals that table 7.1 prints.
std::string recipe_text(const Recipe& recipe, const std::vector<Diameters>& rows);
std::string recipe_csv(const Recipe& recipe, const std::vector<Diameters>& rows,
                       const CsvStyle& style = {});
nlohmann::ordered_json recipe_json(const Recipe& recipe, const std::vector<Diameters>& rows,
                                   const DocumentInfo& info);

/// Value of each column of a row by its key, diameters first.
nlohmann::ordered_json row_json(const Recipe& recipe, const Diameters& d);

}  // namespace prs::jung_2017
