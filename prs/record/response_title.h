#pragma once

#include <string>
#include <string_view>

namespace prs {

/// Title of a response for people.
struct ResponseTitle {
  std::string name;  ///< `largest peak pressure, screw`
  std::string unit;  ///< `MPa`; empty if the path names none.
};

/// `screw.peak_pressure_MPa.max` -> `largest peak pressure, screw`, `MPa`: a quantity in the words of catalogues, then
/// the part of the mechanism and the thread; `slip`, `contact`, `heat` and `measures` are left out.
ResponseTitle response_title(std::string_view path);

}  // namespace prs
