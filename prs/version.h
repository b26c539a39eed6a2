#pragma once

namespace prs {

inline constexpr const char* kVersion = "1.0.0";
/// Version of the input and output names; raised when names are added.
inline constexpr const char* kSchemaVersion = "1";

}  // namespace prs
