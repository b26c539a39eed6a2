#pragma once

#include <string_view>

namespace prs {

/// Sources, program and licence of the unit, which are part of the program.
struct EmbeddedUnit {
  std::string_view curves_h, curves_c, fmi2_h, unit_c, licence;
  std::string_view library;   ///< Shared object for `platform`.
  std::string_view platform;  ///< Folder of FMI 2.0: `linux64`; empty: the standard has none.
};

EmbeddedUnit embedded_unit();

}  // namespace prs
