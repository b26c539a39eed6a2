#pragma once

#include "prs/configurations/configurations.h"

namespace prs {

/// Lubricant of a written case.
struct CaseLubricant {
  std::string name = "iso-vg-100";
  double temperature = 333.15;              ///< [K]
  std::string temperature_as_written = {};  ///< Empty if it is assumed.
  bool assumed = true;                      ///< Whether the name is assumed.
};

/// The screw as a commented case with all inputs of every command except `preload`, `study` and `optimize`. `origin`
/// says in its first lines where the data come from. A full mechanism has supports and lateral loads as well. Throws
/// CaseError if `prs life` would refuse it.
std::string screw_case(const CompleteScrew& screw, const CaseLubricant& lubricant, const std::string& origin,
                       ModelOptions::Mechanism mechanism = ModelOptions::Mechanism::sector);

/// First half of the case: heading, mechanism, structure and materials.
std::string screw_text(const CompleteScrew& screw, const std::string& origin,
                       ModelOptions::Mechanism mechanism = ModelOptions::Mechanism::sector);

/// The screw with the values of those lines, whose digits are limited.
CompleteScrew as_written(CompleteScrew screw);

/// A line of `prs configurations` as a commented case.
std::string configuration_case(const Configuration& c);

}  // namespace prs
