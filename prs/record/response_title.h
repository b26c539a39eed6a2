#pragma once

#include <string>
#include <string_view>

namespace prs {

/// What a person calls a response.
struct ResponseTitle {
  std::string name;  ///< `max screw peak pressure`
  std::string unit;  ///< `MPa`; empty where the path names none.
};

/// `screw.peak_pressure_MPa.max` -> `max screw peak pressure`, `MPa`: what belongs to a part of the
/// mechanism starts with its name, `slip`, `contact` and `measures` are left out.
ResponseTitle response_title(std::string_view path);

/// Title of an axis along which a quantity runs: `peak_pressure_GPa` -> `Peak pressure (GPa)`. Any
/// unit of `kShownUnits` does, `unit_of` has its factor.
std::string axis_title(std::string_view path);

}  // namespace prs
