#pragma once

namespace prs {

/// How much of a result to compute.
enum class Detail {
  complete,
  numbers,  ///< Without warnings and without stresses below the surface, for studies.
};

}  // namespace prs
