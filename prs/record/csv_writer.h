#pragma once

#include <algorithm>

#include "prs/model/load_case.h"

namespace prs {

/// Space that `write_short` needs for one number; the bytes after its end may be overwritten.
inline constexpr int kShortNumberSize = 32;

/// Writes a finite number with at most `digits` significant digits, 1 to 17, identical to fmt's `{:.Ng}`, and returns
/// the end. Nearly all numbers, those whose digits are not close to a tie, take one product and one integer conversion.
char* write_short(char* at, double value, int digits);

/// Style of CSV files; JSON and journals always have all digits.
struct CsvStyle {
  static constexpr int kAllDigits = 17;

  /// Whether to write for spreadsheets of a European locale: fields separated by `;`, decimal commas, and a byte order
  /// mark. Else `,` and a decimal point.
  bool european = false;
  /// Significant digits; kAllDigits: as many as it takes to read the same number back.
  int digits = 10;

  constexpr char separator() const { return european ? ';' : ','; }
  constexpr char decimal_mark() const { return european ? ',' : '.'; }
};

/// Fields and rows of a CSV file, quoted as in RFC 4180. A text that a spreadsheet
/// would take for a formula (it begins with = + - @, a tab or the end of a line, and is no
/// quantity) gets an apostrophe before it.
class CsvWriter {
 public:
  enum class Part { whole, rows };

  /// `rows` continues a file that has been begun.
  explicit CsvWriter(const CsvStyle& style, Part part = Part::whole);

  void text(std::string_view value);
  /// Writes a text that needs no quotes: a word of the program, or none.
  void word(std::string_view value);
  /// Writes SI * factor; empty if absent or not finite.
  void number(std::optional<double> si, double factor = 1.0);
  void integer(std::optional<std::size_t> value);
  void end_row();

  /// Writes fields by their types: texts, flags, whole numbers, numbers that may be absent, and all elements of a
  /// vector.
  template <class... Values>
  void fields(const Values&... values) {
    (field(values), ...);
  }
  template <class... Values>
  void row(const Values&... values) {
    fields(values...);
    end_row();
  }

  void reserve(std::size_t characters) { room(characters); }
  std::string take() {
    csv_.resize(size_);
    return std::move(csv_);
  }

 private:
  /// Address for the next characters, with space for this many.
  char* room(std::size_t characters) {
    if (csv_.size() - size_ < characters) csv_.resize(size_ + std::max(size_, characters));
    return csv_.data() + size_;
  }
  template <class T>
  void field(const T& value) {
    if constexpr (std::is_same_v<T, bool>)
      word(value ? "true" : "false");
    else if constexpr (std::is_integral_v<T>)
      integer(static_cast<std::size_t>(value));
    else if constexpr (std::is_same_v<T, std::optional<std::size_t>>)
      integer(value);
    else if constexpr (std::is_convertible_v<T, std::string_view>)
      text(value);
    else if constexpr (std::is_convertible_v<T, std::optional<double>>)
      number(value);
    else
      for (const auto& element : value) field(element);
  }
  void put(std::string_view text);
  void separate() {
    if (!row_is_empty_) {
      *room(1) = style_.separator();
      ++size_;
    }
    row_is_empty_ = false;
  }
  /// Accepts a number that was written at the address from `room`.
  void take_number(const char* end);

  CsvStyle style_;
  std::string csv_;  ///< Buffer of which `size_` characters are written.
  std::size_t size_ = 0;
  bool row_is_empty_ = true;
};

/// The scaled value; absent if the value is.
inline std::optional<double> scaled(std::optional<double> si, double factor) {
  return si ? std::optional(*si * factor) : std::nullopt;
}

/// Writes the names of the fields that identify the load case of a row.
void load_header(CsvWriter& csv);
void load_fields(CsvWriter& csv, const LoadCase& load);

}  // namespace prs
