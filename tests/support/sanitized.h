#pragma once

extern "C" __attribute__((weak)) void __asan_init();

namespace test {

/// Whether the program under test is built with the address sanitizer.
inline bool sanitized() { return __asan_init != nullptr; }

}  // namespace test

/// Skips a test of numbers that takes long under sanitizers, if other tests call its functions there.
#define SKIP_UNDER_SANITIZERS() \
  if (::test::sanitized()) GTEST_SKIP() << "numbers, which the release build tests"
