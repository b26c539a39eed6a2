#pragma once

#include <numbers>

/// Factors from SI to the units shown: shown = SI * factor.
namespace prs::per_si {

inline constexpr double kilonewton = 1e-3;
inline constexpr double newton_millimetre = 1e3;
inline constexpr double kilometre = 1e-3;
inline constexpr double millimetre = 1e3;
inline constexpr double micrometre = 1e6;
inline constexpr double nanometre = 1e9;
inline constexpr double square_millimetre = 1e6;
inline constexpr double megapascal = 1e-6;
inline constexpr double gigapascal = 1e-9;
inline constexpr double percent = 100.0;
inline constexpr double degree = 180.0 / std::numbers::pi;
inline constexpr double revolution_per_minute = 30.0 / std::numbers::pi;
inline constexpr double newton_per_micrometre = 1e-6;

}  // namespace prs::per_si
