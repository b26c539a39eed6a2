#pragma once

#include <cmath>
#include <numbers>

// Units in which the tests state their numbers; everything else is SI.
inline constexpr double mm = 1e-3;
inline constexpr double um = 1e-6;
inline constexpr double per_mm = 1e3;
inline constexpr double GPa = 1e9;
inline constexpr double MPa = 1e6;
inline constexpr double deg = std::numbers::pi / 180.0;
inline const double N_per_mm1_5 = std::pow(1e3, 1.5);
