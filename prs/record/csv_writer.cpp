#include "prs/record/csv_writer.h"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <system_error>

namespace prs {
namespace {

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

CsvWriter::CsvWriter(const CsvStyle& style, Part part) : style_(style) {
  if (style.european && part == Part::whole) csv_ = "\uFEFF";
}

void CsvWriter::text(std::string_view value) {
  const std::size_t first = csv_.size() + (row_is_empty_ ? 0 : 1);
  if (is_number(value)) return word(value), set_mark(first);
  const bool formula = is_formula(value);
  if (!formula && value.find_first_of("\"\r\n") == std::string_view::npos &&
      value.find(style_.separator()) == std::string_view::npos)
    return word(value);
  word(formula ? "\"'" : "\"");
  for (const char c : value) csv_.append(c == '"' ? 2 : 1, c);
  csv_ += '"';
}

void CsvWriter::word(std::string_view value) {
  separate();
  csv_ += value;
}

void CsvWriter::number(std::optional<double> si, double factor) {
  separate();
  if (!si || !std::isfinite(*si)) return;
  const std::size_t first = csv_.size();
  const double value = *si * factor;
  if (style_.digits >= CsvStyle::kAllDigits)
    fmt::format_to(std::back_inserter(csv_), FMT_COMPILE("{}"), value);
  else
    fmt::format_to(std::back_inserter(csv_), FMT_COMPILE("{:.{}g}"), value, style_.digits);
  set_mark(first);
}

void CsvWriter::integer(std::optional<std::size_t> value) {
  const fmt::format_int digits(value.value_or(0));
  word(value ? std::string_view(digits.data(), digits.size()) : std::string_view());
}

void CsvWriter::end_row() {
  csv_ += '\n';
  row_is_empty_ = true;
}

}  // namespace prs
