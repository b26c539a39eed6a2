#pragma once

#include "prs/configurations/complete_screw.h"
#include "prs/configurations/configurations.h"
#include "prs/model/model_options.h"

namespace prs {

/// The lubricant of a case that is written.
struct CaseLubricant {
  std::string name = "iso-vg-100";
  double temperature = 333.15;              ///< [K]
  std::string temperature_as_written = {};  ///< Empty where it is assumed.
  bool assumed = true;                      ///< The name.
};

/// The screw as a commented case for which every command but `preload`, `study` and `optimize` has
/// all it needs. `origin` says in its first lines where the data come from. A full mechanism has
/// supports and loads across the axis as well. Throws CaseError where `prs life` would refuse it.
std::string screw_case(const CompleteScrew& screw, const CaseLubricant& lubricant,
                       const std::string& origin,
                       ModelOptions::Mechanism mechanism = ModelOptions::Mechanism::sector);

/// The first half of that: heading, mechanism, structure and materials.
std::string screw_text(const CompleteScrew& screw, const std::string& origin,
                       ModelOptions::Mechanism mechanism = ModelOptions::Mechanism::sector);

/// The screw with the values that those lines have, whose digits are limited.
CompleteScrew as_written(CompleteScrew screw);

/// Throws CaseError where the ratio of diameters is beyond Lemor's capacity, which `prs life`
/// needs.
void require_capacity(const CompleteScrew& screw);

/// A line of `prs configurations` as such a case.
std::string configuration_case(const Configuration& c);

}  // namespace prs
