#include "prs/record/csv_writer.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <cstring>
#include <system_error>

#include "prs/model/units.h"
#include "prs/record/short_number.h"

namespace prs {
namespace {

/// A number, alone or with its unit behind a blank: no formula however it starts.
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

/// Whether a spreadsheet would compute the text in place of showing it.
bool is_formula(std::string_view text) {
  return !text.empty() && std::string_view("=+-@\t\r\n").find(text.front()) != text.npos &&
         !is_quantity(text);
}

}  // namespace

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

void load_header(CsvWriter& csv) {
  csv.fields("case", "axial_force_N", "direction", "position_mm");
}

void load_fields(CsvWriter& csv, const LoadCase& load) {
  csv.fields(load.name, load.axial_force, load.direction ? name(*load.direction) : "",
             scaled(load.position, per_si::millimetre));
}

}  // namespace prs
