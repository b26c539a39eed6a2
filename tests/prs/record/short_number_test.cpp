#include "prs/record/csv_writer.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>

namespace prs {
namespace {

std::string written(double value, int digits) {
  char text[kShortNumberSize];
  return {text, write_short(text, value, digits)};
}

TEST(ShortNumber, IsWhatFmtWritesToTheLastCharacter) {
  std::mt19937_64 random(5);
  const auto expect_as_fmt = [](double value) {
    for (const int digits : {1, 2, 6, 10, 12, 13, 16})
      ASSERT_EQ(written(value, digits), fmt::format("{:.{}g}", value, digits))
          << fmt::format("{:.17g}", value) << " with " << digits << " digits";
  };
  for (int k = 0; k < 20'000; ++k) {
    const double size = std::uniform_real_distribution<double>(-7.0, 18.0)(random);
    const double value = (k % 2 == 0 ? 1.0 : -1.0) * std::pow(10.0, size);
    ASSERT_NO_FATAL_FAILURE(expect_as_fmt(value));
    // Short numbers, as people write them, ties and powers of ten among them.
    ASSERT_NO_FATAL_FAILURE(expect_as_fmt(std::round(value * 1e3) / std::pow(10.0, static_cast<double>(k % 12))));
    const double any = std::bit_cast<double>(random());
    ASSERT_NO_FATAL_FAILURE(expect_as_fmt(std::isfinite(any) ? any : 1.0));
  }
  for (double power = 1e-8; power < 1e20; power *= 10.0)
    for (const double value : {std::nextafter(power, 0.0), power, std::nextafter(power, 1e30)})
      ASSERT_NO_FATAL_FAILURE(expect_as_fmt(value));
  for (const double value : {0.0, -0.0, 0.5, 2.5, 1e-4, 9.9999999995, 99999999995.0, 5e-324})
    ASSERT_NO_FATAL_FAILURE(expect_as_fmt(value));
}

}  // namespace
}  // namespace prs
