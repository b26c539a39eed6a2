#pragma once

#include "fe/lanes.h"

namespace fe {

/// Whether two lanes are the halves of one chain of twice as many stations, from its first station
/// on and from its last one back to the middle, every interval of the second half being told in the
/// sense of its walk. Loads are {load, 0}, and mirrored(x) swaps the lanes. The halves are
/// eliminated at once and meet in the middle (twisted factorization: Parlett, Dhillon, Linear
/// Algebra Appl. 267, 1997): a single solve waits for half as many pivots one after the other.
template <class Station>
inline constexpr bool kFolded = requires {
  requires Station::kFolded;
};

/// Sum over the chain of what each lane has summed.
template <class Station, class Real>
[[gnu::always_inline]] inline Real total(const Real& sum) {
  if constexpr (kFolded<Station>)
    return sum + mirrored(sum);
  else
    return sum;
}

/// Largest over the chain of what is each lane's largest.
template <class Station, class Real>
[[gnu::always_inline]] inline Real of_both(const Real& worst) {
  if constexpr (kFolded<Station>)
    return max(worst, mirrored(worst));
  else
    return worst;
}

}  // namespace fe
