#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace prs {

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

  /// Writes a value by its type: a text, a flag, a whole number, a number that may be absent, times the factor, or all
  /// elements of a vector.
  template <class T>
  void field(const T& value, double factor = 1.0) {
    if constexpr (std::is_same_v<T, bool>)
      word(value ? "true" : "false");
    else if constexpr (std::is_integral_v<T>)
      integer(static_cast<std::size_t>(value));
    else if constexpr (std::is_same_v<T, std::optional<std::size_t>>)
      integer(value);
    else if constexpr (std::is_convertible_v<T, std::string_view>)
      text(value);
    else if constexpr (std::is_convertible_v<T, std::optional<double>>)
      number(value, factor);
    else
      for (const auto& element : value) field(element);
  }
  template <class... Values>
  void fields(const Values&... values) {
    (field(values), ...);
  }
  template <class... Values>
  void row(const Values&... values) {
    fields(values...);
    end_row();
  }

  void reserve(std::size_t characters) { csv_.reserve(csv_.size() + characters); }
  std::string take() { return std::move(csv_); }

 private:
  void separate() {
    if (!row_is_empty_) csv_ += style_.separator();
    row_is_empty_ = false;
  }
  /// Sets the decimal mark in a number that was written from `first` on.
  void set_mark(std::size_t first) {
    std::replace(csv_.begin() + static_cast<std::ptrdiff_t>(first), csv_.end(), '.', style_.decimal_mark());
  }

  CsvStyle style_;
  std::string csv_;
  bool row_is_empty_ = true;
};

/// The scaled value; absent if the value is.
inline std::optional<double> scaled(std::optional<double> si, double factor) {
  return si ? std::optional(*si * factor) : std::nullopt;
}

}  // namespace prs
