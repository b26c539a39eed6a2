#pragma once

#include <cstdint>

namespace contact {

/// How the search for a contact point ended.
enum class ContactPointStatus : std::int64_t {
  ok,
  not_computed,
  straight_on_straight,  ///< Neither profile is curved: no point contact.
  out_of_reach,          ///< The axes are so far apart or so close that the flanks never overlap.
  outside_flank,         ///< The point lies beyond the end of a flank.
  not_a_minimum,         ///< The clearance has only a saddle there: the surfaces cut each other.
  not_converged,  ///< The clearance has no minimum on the flanks that the descent could find.
};

}  // namespace contact
