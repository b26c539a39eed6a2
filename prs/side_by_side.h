#pragma once

#include <future>

namespace prs {

/// How `std::async` runs parts of one computation: side by side where there are threads, else each when it is awaited.
#ifdef __EMSCRIPTEN__
inline constexpr auto kSideBySide = std::launch::deferred;
#else
inline constexpr auto kSideBySide = std::launch::async | std::launch::deferred;
#endif

}  // namespace prs
