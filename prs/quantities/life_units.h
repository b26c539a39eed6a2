#pragma once

#include <cmath>
#include <optional>

#include "prs/life/analyze_life.h"
#include "prs/model/mechanism.h"

namespace prs {

/// A life in what people count.
struct LifeInUse {
  double revolutions = 0.0;
  std::optional<double> hours;
  double travel = 0.0;           ///< [m]
  std::optional<double> passes;  ///< Of the history or the spectrum.
};

inline LifeInUse in_use(const LifeResult& r, double revolutions) {
  LifeInUse life{revolutions, {}, revolutions * std::abs(r.contacts.mechanism.lead), {}};
  if (r.revolution_rate) life.hours = revolutions / *r.revolution_rate / 3600.0;
  if (r.revolutions_known) life.passes = revolutions / r.revolutions;
  return life;
}

}  // namespace prs
