#include "prs/record/csv_writer.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <system_error>

#include "prs/model/units.h"

namespace prs {
namespace {

/// Powers of ten that doubles represent exactly.
constexpr auto kPowers = [] {
  std::array<double, 23> powers{};
  double power = 1.0;
  for (double& p : powers) {
    p = power;
    power *= 10.0;
  }
  return powers;
}();

constexpr int kMostDigits = 12;  ///< Most digits for which a product's rounding is below 1e-3 of the last one.
/// Decimal exponent below which, as from `digits` on, numbers are written with an exponent.
constexpr int kLeastExponent = -4;

constexpr auto kWholePowers = [] {
  std::array<std::uint64_t, kMostDigits + 1> powers{1};
  for (std::size_t k = 1; k < powers.size(); ++k) powers[k] = 10 * powers[k - 1];
  return powers;
}();

double power(int exponent) { return kPowers[static_cast<std::size_t>(exponent)]; }

/// Exponent of the first digit of a number from 1e-4 on; at a power of ten possibly one too large.
int first_exponent(double size) {
  static constexpr auto kStarts = [] {
    std::array<double, kMostDigits + 8> starts{1e-4, 1e-3, 1e-2, 1e-1};
    for (std::size_t k = 4; k < starts.size(); ++k) starts[k] = kPowers[k - 4];
    return starts;
  }();
  // log10(2) = 0.30103; the binary exponent alone is off by one at most.
  std::uint64_t bits = 0;
  std::memcpy(&bits, &size, sizeof bits);
  const auto binary = static_cast<int>(bits >> 52U) - 1023;
  const int below = (binary * 1233) >> 12;
  return below + (size >= kStarts[static_cast<std::size_t>(below + 1 - kLeastExponent)] ? 1 : 0);
}

/// Digits of numbers below 10,000 side by side, 32 bits for each, the first one in the lowest byte: halves of two
/// digits, then of one, are split in parallel.
std::uint64_t digits_of(std::uint64_t fours) {
  const std::uint64_t hundreds = ((fours * 10'486) >> 20U) & 0x7F'0000'007F;
  const std::uint64_t twos = hundreds | (fours - 100 * hundreds) << 16U;
  const std::uint64_t tens = ((twos * 103) >> 10U) & 0xF'000F'000F'000F;
  return tens | (twos - 10 * tens) << 8U;
}

/// Sixteen characters, the first one in the lowest byte.
struct Characters {
  std::uint64_t low, high;

  void drop(int count) {
    if (count >= 8) {
      low = std::exchange(high, 0);
      count -= 8;
    }
    const auto bits = static_cast<unsigned>(8 * count);
    low = low >> bits | (high << 1U) << (63U - bits);
    high >>= bits;
  }
  void write(char* at) const {
    for (std::uint64_t word : {low, high}) {
      if constexpr (std::endian::native == std::endian::big) word = __builtin_bswap64(word);
      std::memcpy(at, &word, sizeof word);
      at += sizeof word;
    }
  }
};

/// Whether a text is a number, alone or with its unit after a blank, and so never a formula.
bool is_quantity(std::string_view text) {
  if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
  double number = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return false;
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return text.empty() || (text.starts_with(' ') && std::ranges::all_of(text, [](char c) {
                            return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                                   std::string_view(" /^.%").find(c) != std::string_view::npos;
                          }));
}

bool is_number(std::string_view text) {
  double number = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && stop == text.data() + text.size();
}

/// Whether a spreadsheet would compute the text instead of showing it.
bool is_formula(std::string_view text) {
  return !text.empty() && std::string_view("=+-@\t\r\n").find(text.front()) != text.npos && !is_quantity(text);
}

}  // namespace

char* write_short(char* at, double value, int digits) {
  const double size = std::abs(value);
  const auto by_fmt = [&] { return fmt::format_to(at, "{:.{}g}", value, digits); };
  if (digits > kMostDigits || !(size >= 1e-4 && size < power(digits))) return by_fmt();
  const int exponent = first_exponent(size);
  const double scaled = size * power(digits - 1 - exponent);
  const auto number = static_cast<std::int64_t>(scaled + 0.5);
  if (std::abs(scaled - static_cast<double>(number)) > 0.499) return by_fmt();
  // At a power of ten the exponent of the rounded number counts.
  const auto whole = static_cast<std::uint64_t>(number);
  if (whole < kWholePowers[static_cast<std::size_t>(digits - 1)] ||
      whole >= kWholePowers[static_cast<std::size_t>(digits)])
    return by_fmt();

  const std::uint64_t high = whole / 100'000'000, low = whole % 100'000'000;
  const std::uint64_t first = digits_of(high), last = digits_of(low / 10'000 | (low % 10'000) << 32U);
  const int zeros = last != 0 ? std::countl_zero(last) / 8 : 4 + std::countl_zero(first) / 8;
  constexpr std::uint64_t kZeros = 0x3030'3030'3030'3030;
  Characters text{(first | last << 32U) + kZeros, (last >> 32U) + kZeros};
  text.drop(kMostDigits - digits);
  const int used = digits - zeros;
  if (value < 0.0) *at++ = '-';
  if (exponent < 0) {
    std::memcpy(at, "0.000", 1 - kLeastExponent);
    at += 1 - exponent;
    text.write(at);
    return at + used;
  }
  text.write(at);
  at += exponent + 1;
  if (used <= exponent + 1) return at;
  *at++ = '.';
  text.drop(exponent + 1);
  text.write(at);
  return at + (used - exponent - 1);
}

CsvWriter::CsvWriter(const CsvStyle& style, Part part) : style_(style) {
  if (style.european && part == Part::whole) put("\uFEFF");
}

void CsvWriter::text(std::string_view value) {
  separate();
  if (is_number(value)) {
    std::memcpy(room(value.size()), value.data(), value.size());
    return take_number(csv_.data() + size_ + value.size());
  }
  const bool formula = is_formula(value);
  if (!formula && value.find_first_of("\"\r\n") == std::string_view::npos &&
      value.find(style_.separator()) == std::string_view::npos)
    return put(value);
  put(formula ? "\"'" : "\"");
  for (const char& c : value) put(c == '"' ? std::string_view("\"\"") : std::string_view(&c, 1));
  put("\"");
}

void CsvWriter::word(std::string_view value) {
  separate();
  put(value);
}

void CsvWriter::number(std::optional<double> si, double factor) {
  separate();
  if (!si || !std::isfinite(*si)) return;
  char* const at = room(kShortNumberSize);
  const double value = *si * factor;
  take_number(style_.digits >= CsvStyle::kAllDigits ? fmt::format_to(at, FMT_COMPILE("{}"), value)
                                                    : write_short(at, value, style_.digits));
}

void CsvWriter::integer(std::optional<std::size_t> value) {
  separate();
  if (!value) return;
  const fmt::format_int digits(*value);
  put({digits.data(), digits.size()});
}

void CsvWriter::end_row() {
  put("\n");
  row_is_empty_ = true;
}

void CsvWriter::put(std::string_view text) {
  if (!text.empty()) std::memcpy(room(text.size()), text.data(), text.size());
  size_ += text.size();
}

void CsvWriter::take_number(const char* end) {
  char* const first = csv_.data() + size_;
  const auto length = static_cast<std::size_t>(end - first);
  if (style_.decimal_mark() != '.') std::replace(first, first + length, '.', style_.decimal_mark());
  size_ += length;
}

void load_header(CsvWriter& csv) { csv.fields("case", "axial_force_N", "direction", "position_mm"); }

void load_fields(CsvWriter& csv, const LoadCase& load) {
  csv.fields(load.name, load.axial_force, load.direction ? name(*load.direction) : "",
             scaled(load.position, per_si::millimetre));
}

}  // namespace prs
