#pragma once

namespace prs {

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

}  // namespace prs
