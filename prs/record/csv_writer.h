#pragma once

#include <algorithm>

#include "prs/model/load_case.h"

namespace prs {

/// Room that `write_short` needs for one number; what lies behind its end may be overwritten.
inline constexpr int kShortNumberSize = 32;

/// Writes a finite number with `digits` significant digits at most, 1 to 17, as fmt's `{:.Ng}` does
/// to the last character, and returns the end. Numbers whose digits end clear of a tie, nearly all,
/// take one product and one whole number.
char* write_short(char* at, double value, int digits);

/// How CSV files are written; JSON and journals always have all digits.
struct CsvStyle {
  static constexpr int kAllDigits = 17;

  /// Fields separated by `;`, numbers with a decimal comma, and the mark by which spreadsheets know
  /// UTF-8: as spreadsheets of a European locale read it. Else `,` and a decimal point.
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

  /// `rows` go on in a file that has begun.
  explicit CsvWriter(const CsvStyle& style, Part part = Part::whole);

  void text(std::string_view value);
  /// A text that needs no quotes: a word of the program, or none.
  void word(std::string_view value);
  /// SI * factor; empty where absent or not finite.
  void number(std::optional<double> si, double factor = 1.0);
  void integer(std::optional<std::size_t> value);
  void end_row();

  /// Fields as their types say: texts, flags, whole numbers, numbers that may be absent, and all
  /// elements of a vector.
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
  /// Address for the next characters, with room for so many.
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
  /// Takes a number that was written into the room.
  void take_number(const char* end);

  CsvStyle style_;
  std::string csv_;  ///< Buffer of which `size_` characters are written.
  std::size_t size_ = 0;
  bool row_is_empty_ = true;
};

/// Absent where the value is.
inline std::optional<double> scaled(std::optional<double> si, double factor) {
  return si ? std::optional(*si * factor) : std::nullopt;
}

/// Names of the fields that say which load case a row belongs to.
void load_header(CsvWriter& csv);
void load_fields(CsvWriter& csv, const LoadCase& load);

}  // namespace prs
