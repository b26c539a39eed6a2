#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "contact/viscosity.h"

namespace prs {

/// A lubricant that the program knows: what its standard or data sheet states.
struct NamedLubricant {
  std::string_view name;  ///< As a file names it: `iso-vg-100`.
  std::string_view what;
  contact::BaseOil base;
  double viscosity_40;  ///< Kinematic, of the oil or the base oil of the grease, at 40 degC [m^2/s]
  double viscosity_100;  ///< The same at 100 degC [m^2/s]
  double density;        ///< At 15 degC [kg/m^3]
  std::string_view source;
};

/// All of them, in the order in which they are shown.
std::span<const NamedLubricant> named_lubricants();

/// Place in `named_lubricants`.
enum class LubricantName : std::size_t {};

const NamedLubricant& data_of(LubricantName name);

}  // namespace prs
