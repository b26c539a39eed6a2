#include "prs/input/csv_reader.h"

#include <csv.h>
#include <fmt/format.h>

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cstring>
#include <new>
#include <regex>

#include "prs/indices.h"

namespace prs::input {
namespace {

constexpr std::size_t kLongestRow = std::size_t{1} << 20;

/// Length of a line, with its line end.
std::size_t line_length(std::string_view text) {
  const void* end = text.empty() ? nullptr : std::memchr(text.data(), '\n', text.size());
  if (end == nullptr) return text.size();
  return static_cast<std::size_t>(static_cast<const char*>(end) - text.data()) + 1;
}

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t\r\n") == std::string_view::npos; }

/// The first separator of a line outside quotes.
char separator_of(std::string_view line) {
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == ',' || c == ';' || c == '\t')) return c;
  }
  return ',';
}

constexpr std::size_t kMostColumns = 1024;  ///< Number of columns in which points may stand between thousands.
/// Longer fields are not numbers, and would exhaust the stack of std::regex.
constexpr std::size_t kLongestNumber = 64;

/// Pattern of a number with a decimal comma: sign, groups of thousands, decimals.
const std::regex& decimal_comma_number() {
  static const std::regex number(R"(\s*([+-]?(?:\d+|\d{1,3}(?:[. ']\d{3})+))(?:,(\d+(?:[eE][+-]?\d+)?))?\s*)",
                                 std::regex::optimize);
  return number;
}

/// The field with plain blanks in place of those at which no line breaks, which spreadsheets write between thousands.
std::string with_plain_blanks(std::string_view field) {
  std::string plain(field);
  for (const char* blank : {"\u00a0", "\u202f"}) boost::replace_all(plain, blank, " ");
  return plain;
}

/// Marks columns of a line whose numbers have a decimal comma. Between semicolons any comma is a decimal one; between
/// tabs `1,500` may be fifteen hundred, and other numbers of the line must show which.
void mark_decimal_commas(std::string_view line, char separator, std::vector<bool>& columns) {
  std::size_t column = 0, begin = 0;
  bool quoted = false;
  for (std::size_t at = 0; at <= line.size(); ++at) {
    const char c = at < line.size() ? line[at] : '\n';
    if (c == '"') quoted = !quoted;
    if (quoted || (c != separator && c != '\n' && c != '\r')) continue;
    std::string_view field = line.substr(begin, at - begin);
    begin = at + 1;
    const std::size_t here = column++;
    if (field.size() > kLongestNumber || field.find(',') == field.npos) continue;
    if (field.size() > 1 && field.front() == '"' && field.back() == '"') field = field.substr(1, field.size() - 2);
    std::smatch parts;
    const std::string plain = with_plain_blanks(field);
    if (!std::regex_match(plain, parts, decimal_comma_number())) continue;
    if (separator != ';' && parts.length(2) == 3 && parts.str(1) != "0") continue;
    if (columns.size() <= here) columns.resize(here + 1);
    columns[here] = true;
  }
}

/// Meaning of the points in the numbers of a text without decimal commas.
enum class Points { decimal, between_thousands, unclear };

/// Only numbers such as `2.50` or `0.500` show decimal points, `1.000.000` those between thousands. Without any point
/// they are decimal.
Points points_of(std::string_view text, char separator) {
  static const std::regex thousands(R"([+-]?[1-9]\d{0,2}(?:\.\d{3})+)", std::regex::optimize);
  static const std::regex decimal(R"([+-]?\d*\.\d*(?:[eE][+-]?\d+)?)", std::regex::optimize);
  Points points = Points::decimal;
  for (std::string_view rest = text; !rest.empty(); rest.remove_prefix(line_length(rest))) {
    if (rest.front() == '#') continue;
    std::string_view line = rest.substr(0, line_length(rest));
    while (!line.empty()) {
      const std::size_t end = std::min(line.find(separator), line.size());
      std::string field(line.substr(0, end));
      line.remove_prefix(std::min(end + 1, line.size()));
      if (field.find('.') == field.npos || field.size() > kLongestNumber) continue;
      boost::trim_if(field, boost::is_any_of("\" \r\n"));
      if (!std::regex_match(field, thousands)) {
        if (std::regex_match(field, decimal)) return Points::decimal;
      } else if (std::ranges::count(field, '.') > 1) {
        points = Points::between_thousands;
      } else if (points == Points::decimal) {
        points = Points::unclear;
      }
    }
  }
  return points;
}

/// Rewrites a number with a decimal comma or marks between thousands in the usual form; false for other fields. In a
/// column without a decimal comma, beside columns that have it, `1.250` is ambiguous and is written so that it is not
/// read as a number.
bool write_with_point(std::string_view field, bool has_commas, std::string& number) {
  if (field.size() > kLongestNumber || field.find_first_of(",. '\xA0\xAF") == field.npos) return false;
  std::smatch parts;
  const std::string plain = with_plain_blanks(field);
  if (!std::regex_match(plain, parts, decimal_comma_number())) return false;
  number = parts.str(1);
  if (number.starts_with("0.") || number.starts_with("-0.") || number.starts_with("+0.")) return false;
  std::erase_if(number, [](char c) { return c == '.' || c == ' ' || c == '\''; });
  if (parts[2].matched) number += '.' + parts.str(2);
  if (!has_commas && parts.str(1).find('.') != std::string::npos) number = fmt::format("{} or {}", field, number);
  return true;
}

/// libcsv's parser: takes bytes, reports fields and ends of rows.
class FieldParser {
 public:
  explicit FieldParser(char separator) {
    if (csv_init(&parser_, CSV_STRICT | CSV_STRICT_FINI) != 0) throw std::bad_alloc();
    csv_set_delim(&parser_, static_cast<unsigned char>(separator));
    csv_set_blk_size(&parser_, 4096);
  }
  ~FieldParser() { csv_free(&parser_); }
  FieldParser(const FieldParser&) = delete;
  FieldParser& operator=(const FieldParser&) = delete;

  void clear() {
    text_.clear();
    ends_.clear();
    rows_ = 0;
  }

  /// Parses bytes; returns how many precede the first malformed one.
  std::size_t take(std::string_view bytes) {
    const std::size_t taken = csv_parse(&parser_, bytes.data(), bytes.size(), on_field, on_row, this);
    check();
    return taken;
  }

  /// Ends the text; false within quotes.
  bool finish() {
    const bool complete = csv_fini(&parser_, on_field, on_row, this) == 0;
    check();
    return complete;
  }

  std::size_t rows() const { return rows_; }
  std::size_t field_count() const { return ends_.size(); }

  void get_fields(std::vector<std::string_view>& fields) const {
    fields.clear();
    std::size_t begin = 0;
    for (const std::size_t end : ends_) {
      fields.push_back(std::string_view(text_).substr(begin, end - begin));
      begin = end;
    }
  }

 private:
  // Exceptions must not pass through the C library.
  static void on_field(void* bytes, std::size_t size, void* self) {
    auto& parser = *static_cast<FieldParser*>(self);
    try {
      parser.text_.append(static_cast<const char*>(bytes), size);
      parser.ends_.push_back(parser.text_.size());
    } catch (const std::bad_alloc&) {
      parser.out_of_memory_ = true;
    }
  }
  static void on_row(int, void* self) { ++static_cast<FieldParser*>(self)->rows_; }

  void check() {
    if (out_of_memory_ || csv_error(&parser_) == CSV_ENOMEM) throw std::bad_alloc();
  }

  csv_parser parser_{};
  std::string text_;  ///< Text of all fields of a row.
  std::vector<std::size_t> ends_;
  std::size_t rows_ = 0;
  bool out_of_memory_ = false;
};

}  // namespace

struct CsvReader::Parts {
  explicit Parts(std::string_view given)
      : text(given),
        next(text.starts_with("\xEF\xBB\xBF") ? 3 : 0),
        separator(separator_of_first_row()),
        decimal_commas(columns_with_commas()),
        parser(separator) {}

  std::string_view line() const {
    const std::string_view rest = text.substr(next);
    return rest.substr(0, line_length(rest));
  }

  char separator_of_first_row() {
    skip_to_row();
    return separator_of(line());
  }

  std::vector<bool> columns_with_commas() const {
    std::vector<bool> columns;
    if (separator == ',') return columns;
    const bool any = text.find(',') != text.npos;
    for (std::string_view rest = text.substr(next); any && !rest.empty(); rest.remove_prefix(line_length(rest)))
      if (rest.front() != '#') mark_decimal_commas(rest.substr(0, line_length(rest)), separator, columns);
    if (!columns.empty() || separator != ';') return columns;
    const Points points = points_of(text.substr(next), separator);
    columns.resize(points == Points::decimal ? 0 : kMostColumns, points == Points::between_thousands);
    return columns;
  }

  /// Skips empty lines, comments and the line in which a spreadsheet names its separator.
  void skip_to_row() {
    const auto names_separator = [&] { return !any_row && line().starts_with("sep="); };
    while (next < text.size() && (text[next] == '#' || is_blank(line()) || names_separator())) next += line().size();
  }

  /// Takes the fields of the row without empty ones beyond the columns.
  void take_fields() {
    parser.get_fields(fields);
    while (fields.size() > std::max<std::size_t>(most_fields, 1) && fields.back().empty()) fields.pop_back();
    if (most_fields == 0) most_fields = fields.size();
  }

  /// Whether neither the row nor what comes after it has a value.
  bool is_left_over() const {
    return std::ranges::all_of(fields, [](std::string_view field) { return field.empty(); }) &&
           text.substr(next).find_first_not_of(",;\t \r\n") == text.npos;
  }

  void read_row() {
    parser.clear();
    const bool is_first = !std::exchange(any_row, true);
    if (is_first && (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") || line().find('\0') != text.npos))
      throw CsvError(row, "got a text in UTF-16 or a file that is none; expected UTF-8; save it as `CSV UTF-8`");
    while (parser.rows() == 0) {
      if (next == text.size()) {
        if (parser.finish()) return;
        throw CsvError(row,
                       "got a quote that never closes; expected `\"` at the end of the field; "
                       "add it, or delete the one at the start of the field");
      }
      const std::string_view bytes = line();
      if (next + bytes.size() - row > kLongestRow)
        throw CsvError(row, fmt::format("got a row of more than {} KiB; expected a shorter one; "
                                        "check that each quote is closed",
                                        kLongestRow >> 10U));
      if (const std::size_t taken = parser.take(bytes); taken < bytes.size())
        throw CsvError(next + taken,
                       "got a quote within a field; expected quotes around whole "
                       "fields; double each quote that belongs to the text");
      next += bytes.size();
    }
    if (parser.rows() > 1)
      throw CsvError(row,
                     "got a carriage return within a line; expected lines that end with LF or "
                     "CR LF; save the file with such line ends");
  }

  std::string_view text;
  std::size_t next;     ///< Offset of the next line.
  std::size_t row = 0;  ///< Offset at which the row begins.
  bool any_row = false;
  std::size_t most_fields = 0;  ///< Number of fields of the first row.
  char separator;
  std::vector<bool> decimal_commas;  ///< Flags by column; empty: no column has decimal commas.
  FieldParser parser;
  std::vector<std::string_view> fields;
  std::vector<std::string> numbers;  ///< Fields with decimal commas, in the usual form.
};

CsvReader::CsvReader(std::string_view text) : parts_(std::make_unique<Parts>(text)) {}
CsvReader::~CsvReader() = default;

bool CsvReader::next() {
  parts_->skip_to_row();
  parts_->row = parts_->next;
  if (parts_->next == parts_->text.size()) return false;
  parts_->read_row();
  parts_->take_fields();
  if (parts_->is_left_over()) return false;
  const std::vector<bool>& columns = parts_->decimal_commas;
  if (columns.empty()) return true;
  parts_->numbers.resize(parts_->fields.size());
  for (const auto k : indices(parts_->fields))
    if (write_with_point(parts_->fields[k], k < columns.size() && columns[k], parts_->numbers[k]))
      parts_->fields[k] = parts_->numbers[k];
  return true;
}

const std::vector<std::string_view>& CsvReader::fields() const { return parts_->fields; }

std::size_t CsvReader::row_offset() const { return parts_->row; }

std::size_t CsvReader::field_offset(std::size_t row, std::size_t field) const {
  FieldParser parser(parts_->separator);
  const std::string_view text = parts_->text;
  std::size_t at = row;
  while (parser.field_count() < field && at < text.size() && parser.rows() == 0) parser.take(text.substr(at++, 1));
  // The end of the row is not part of it.
  if (parser.rows() > 0) --at;
  return at;
}

}  // namespace prs::input
