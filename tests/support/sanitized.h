#pragma once

extern "C" __attribute__((weak)) void __asan_init();

namespace test {

/// Whether the program under test is built with the address sanitizer; tests are compiled without.
inline bool sanitized() { return __asan_init != nullptr; }

}  // namespace test
