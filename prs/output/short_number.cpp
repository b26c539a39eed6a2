#include "prs/output/short_number.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace prs {
namespace {

/// Powers of ten that doubles have exactly.
constexpr auto kPowers = [] {
  std::array<double, 23> powers{};
  double power = 1.0;
  for (double& p : powers) {
    p = power;
    power *= 10.0;
  }
  return powers;
}();

constexpr int kMostDigits = 12;     ///< A product's rounding is then below 1e-3 of the last digit.
constexpr int kLeastExponent = -4;  ///< Below, and from `digits` on, numbers have an exponent.

double power(int exponent) { return kPowers[static_cast<std::size_t>(exponent)]; }

/// Two digits for each number below 100.
constexpr auto kPairs = [] {
  std::array<char, 200> pairs{};
  for (std::size_t k = 0; k < 100; ++k) {
    pairs[2 * k] = static_cast<char>('0' + k / 10);
    pairs[2 * k + 1] = static_cast<char>('0' + k % 10);
  }
  return pairs;
}();

/// The last `count` digits of a number, before `end`.
void write_digits(char* end, std::uint64_t number, int count) {
  for (; count > 1; count -= 2, number /= 100)
    std::memcpy(end -= 2, &kPairs[2 * (number % 100)], 2);
  if (count == 1) *--end = static_cast<char>('0' + number % 10);
}

}  // namespace

char* write_short(char* at, double value, int digits) {
  const double size = std::abs(value);
  const auto by_fmt = [&] { return fmt::format_to(at, "{:.{}g}", value, digits); };
  if (digits > kMostDigits || !(size >= 1e-4 && size < power(digits))) return by_fmt();
  int exponent = 0;  // Of the first digit.
  if (size >= 1.0)
    while (size >= power(exponent + 1)) ++exponent;
  else
    while (exponent > kLeastExponent && size * power(-exponent) < 1.0) --exponent;
  const double scaled = size * power(digits - 1 - exponent), whole = std::floor(scaled);
  if (std::abs(scaled - whole - 0.5) < 1e-3) return by_fmt();
  const double rounded = scaled - whole < 0.5 ? whole : whole + 1.0;
  // At a power of ten the exponent is that of the rounded number.
  if (rounded < power(digits - 1) || rounded >= power(digits)) return by_fmt();
  std::array<char, kMostDigits> text;
  write_digits(text.data() + digits, static_cast<std::uint64_t>(rounded), digits);
  int used = digits;
  while (used > 1 && text[static_cast<std::size_t>(used - 1)] == '0') --used;
  if (value < 0.0) *at++ = '-';
  const auto put = [&](int first, int last) {
    if (last > first) {
      std::memcpy(at, text.data() + first, static_cast<std::size_t>(last - first));
      at += last - first;
    }
  };
  if (exponent < 0) {
    std::memcpy(at, "0.000", 1 - kLeastExponent);
    at += 1 - exponent;
    put(0, used);
    return at;
  }
  put(0, exponent + 1);
  if (used > exponent + 1) {
    *at++ = '.';
    put(exponent + 1, used);
  }
  return at;
}

}  // namespace prs
