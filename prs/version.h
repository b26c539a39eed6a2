#pragma once

namespace prs {

inline constexpr const char* kVersion = "0.1.0";
/// Of input and output names; grows where they are extended.
inline constexpr const char* kSchemaVersion = "1";

}  // namespace prs
