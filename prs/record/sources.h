#pragma once

#include <string_view>

/// Sources that several tables of quantities cite.
namespace prs::source {

inline constexpr std::string_view kHertz = "Hertz with exact ellipticity";
inline constexpr std::string_view kLife = "Jung 2017, (8.25); ISO 281";

}  // namespace prs::source
