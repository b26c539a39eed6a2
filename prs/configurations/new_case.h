#pragma once

#include "prs/configurations/configurations.h"
#include "prs/input/field.h"

namespace prs {

/// Options that describe a new screw; quantities as the user wrote them.
struct NewOptions {
  std::string type, file;  ///< If `lesson` is given, `type` may hold the file.
  std::optional<std::string> lesson;
  std::optional<std::string> screw_diameter, lead, nut_diameter, nut_length, roller_diameter, roller_profile_radius;
  std::optional<std::string> load, speed, lubricant, temperature, mechanism;
  std::optional<int> starts, rollers;
};

/// A complete, commented case of the screw; without a screw that of an example. Throws CaseError with the name of an
/// option of `prs new`, `--lead`.
std::string new_case_text(const NewOptions& options);

/// First given option that describes the case; empty if there is none.
std::string first_given(const NewOptions& options);

/// Values of the case that were not given.
std::string assumptions(const NewOptions& options);

/// The value of an option [SI] within bounds that `expected` describes. A blank between number and unit may be missing.
/// Throws CaseError with the name of the option.
double quantity_of_option(std::string_view option, const std::string& text, const input::Dimension& dimension,
                          const input::Bounds& bounds, std::string_view expected);

}  // namespace prs
