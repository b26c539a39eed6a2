#pragma once

#include "prs/slip/slip_model.h"

namespace prs {

/// Film over roughness below which flanks begin to touch, and below which touching flanks carry
/// most: the usual bounds of lubrication (Hamrock, Schmid, Jacobson, Fundamentals of Fluid Film
/// Lubrication, 2004, chapter 3).
inline constexpr double kFullFilm = 3.0, kTouchingFlanks = 1.0;

/// `boundary`, `mixed` or `full film`.
std::string_view lubrication(double film_ratio);

/// A warning that there is no slip: a contact jams, or no slip ratio balances. `where`: the result that lacks it.
Warning no_slip(bool jammed, const std::string& where);

/// A warning where the film of a lubricant cannot be compared with the roughness of the flanks.
std::optional<Warning> unknown_film_ratio(const Conditions& c);

/// Normal loads of a running screw over those at rest: of the largest, and of all threads, which change whatever the
/// guides do.
struct OverStatic {
  double largest = 1.0, all = 1.0;
};

/// Change of the largest load that is worth a warning.
inline constexpr double kMuchOverStatic = 0.2;

/// Whether friction does more in one place than in another one: a much larger load before any smaller one.
inline bool is_worse(const OverStatic& a, const OverStatic& b) {
  if (std::max(a.largest, b.largest) > 1.0 + kMuchOverStatic) return a.largest > b.largest;
  return std::abs(a.largest - 1.0) > std::abs(b.largest - 1.0);
}

/// A warning where friction changes the largest load of screw or nut by more than a fifth: by how much, and
/// for which guidance.
std::optional<Warning> guides_press(const Conditions& c, const PerInterface<OverStatic>& over_static);

/// Adds the warnings about the slip of a load case. `model`: that of the screw that turns; null if it is held.
void add_slip_warnings(const Conditions& c, const Contacts& contacts, const SlipModel* model, LoadCaseResult& loaded);

}  // namespace prs
