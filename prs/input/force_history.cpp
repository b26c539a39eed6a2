#include "prs/input/force_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <optional>

#include "prs/input/did_you_mean.h"
#include "prs/input/fail_at.h"
#include "prs/input/field.h"
#include "prs/input/units.h"

namespace prs::input {
namespace {

constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30;
constexpr double kLargest = 1e30;

std::string_view trimmed(std::string_view text) {
  const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view unquoted(std::string_view text) {
  text = trimmed(text);
  return text.size() >= 2 && text.front() == '"' && text.back() == '"'
             ? text.substr(1, text.size() - 2)
             : text;
}

/// A column that is read: where it stands, and what turns its numbers into SI.
struct WantedColumn {
  std::string_view key;  ///< Below `life.history`.
  const CsvColumn* name;
  const Dimension* dimension;
  std::vector<double>* values;
  double factor = 1.0;
  std::size_t field = 0;
};

/// Cuts a text into lines and counts them.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
  }

  /// The next line that is neither empty nor a comment.
  bool next(std::string_view& line) {
    while (!rest_.empty()) {
      const char* end = static_cast<const char*>(std::memchr(rest_.data(), '\n', rest_.size()));
      const std::size_t length = end ? static_cast<std::size_t>(end - rest_.data()) : rest_.size();
      line = rest_.substr(0, length);
      rest_.remove_prefix(std::min(length + 1, rest_.size()));
      ++number_;
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (!line.empty() && line.front() != '#' && !trimmed(line).empty()) return true;
    }
    return false;
  }
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

char separator_of(std::string_view heading) {
  const std::size_t at = heading.find_first_of(",;\t");
  return at == std::string_view::npos ? ',' : heading[at];
}

std::string nearest(std::string_view column, std::vector<std::string_view> names) {
  std::erase_if(names, [](std::string_view name) { return name.size() > kLongestText; });
  const std::string hint = did_you_mean(column, names);
  return hint.empty() ? "check the heading" : shown(hint);
}

class HistoryParser {
 public:
  HistoryParser(std::string_view text, const std::string& name, const Source& source)
      : lines_(text), name_(name), source_(source) {}

  void parse(std::vector<WantedColumn>& columns) {
    read_heading(columns);
    std::ranges::sort(columns, {}, &WantedColumn::field);
    for (std::string_view line; lines_.next(line);) read_row(line, columns);
    if (columns.front().values->size() < 2)
      fail_at(source_, "life.history.file",
              fmt::format("got {} rows in {}; expected at least 2 samples; check the file",
                          columns.front().values->size(), name_));
  }

 private:
  void read_heading(std::vector<WantedColumn>& columns) {
    std::string_view heading;
    if (!lines_.next(heading))
      fail_at(source_, "life.history.file",
              fmt::format("got {}, which has no heading; expected a line with the names of the "
                          "columns, then a row a sample",
                          name_));
    separator_ = separator_of(heading);
    std::vector<std::string_view> names;
    for (std::size_t begin = 0; begin <= heading.size();) {
      const std::size_t end = std::min(heading.find(separator_, begin), heading.size());
      names.push_back(unquoted(heading.substr(begin, end - begin)));
      begin = end + 1;
    }
    width_ = names.size();
    for (WantedColumn& c : columns) {
      if (std::ranges::count(names, c.name->column) > 1)
        fail_at(source_, fmt::format("life.history.{}.column", c.key),
                fmt::format("got {}, which stands twice in the heading of {}; expected one column "
                            "of that name; rename the other one",
                            shown(c.name->column), name_));
      const auto found = std::ranges::find(names, c.name->column);
      if (found == names.end())
        fail_at(source_, fmt::format("life.history.{}.column", c.key),
                fmt::format("got {}; expected a column of {}: {}; {}", shown(c.name->column), name_,
                            shown(fmt::format("{}", fmt::join(names, ", "))),
                            nearest(c.name->column, names)));
      c.field = static_cast<std::size_t>(found - names.begin());
    }
  }

  void read_row(std::string_view line, std::vector<WantedColumn>& columns) {
    const char* at = line.data();
    const char* const end = at + line.size();
    std::size_t field = 0;
    for (WantedColumn& c : columns) {
      for (; field < c.field; ++field) {
        at = at == nullptr ? nullptr
                           : static_cast<const char*>(
                                 std::memchr(at, separator_, static_cast<std::size_t>(end - at)));
        if (at == nullptr)
          refuse(line, line.size(), c.name->column, "nothing",
                 fmt::format("a number in field {}", c.field + 1), "complete the row");
        ++at;
      }
      c.values->push_back(c.factor * number(line, at, end, c.name->column));
      if (c.key == "time") check_time(line, at, c);
    }
    check_width(line, at, field);
  }

  /// A decimal comma between commas would move all fields behind it.
  void check_width(std::string_view line, const char* last, std::size_t field) const {
    const auto behind = std::count(last, line.data() + line.size(), separator_);
    const std::size_t width = field + 1 + static_cast<std::size_t>(behind);
    if (width <= width_) return;
    refuse(line, 0, "row", fmt::format("{} fields", width),
           fmt::format("at most {} as in the heading", width_),
           "write decimal marks as points, or quote texts that hold the separator");
  }

  double number(std::string_view line, const char* at, const char* end, std::string_view column) {
    const char* begin = at;
    while (begin != end && (*begin == ' ' || *begin == '"')) ++begin;
    const char* digits = begin != end && *begin == '+' ? begin + 1 : begin;
    double value = 0.0;
    const auto [stop, error] = std::from_chars(digits, end, value);
    const char* rest = stop;
    while (rest != end && (*rest == ' ' || *rest == '"' || *rest == '\t') && *rest != separator_)
      ++rest;
    if (error == std::errc{} && (rest == end || *rest == separator_) &&
        std::abs(value) <= kLargest)  // Also keeps out NaN.
      return value;
    const char* field_end = std::find(at, end, separator_);
    const std::string_view field = trimmed({at, static_cast<std::size_t>(field_end - at)});
    refuse(line, static_cast<std::size_t>(at - line.data()), column,
           field.empty() ? "nothing" : shown(field), "a finite number, without unit",
           field.find(',') != std::string_view::npos ? "write the decimal mark as a point"
                                                     : "mend or delete the row");
  }

  void check_time(std::string_view line, const char* at, const WantedColumn& c) {
    const std::size_t n = c.values->size();
    if (n < 2 || (*c.values)[n - 1] >= (*c.values)[n - 2]) return;
    refuse(line, static_cast<std::size_t>(at - line.data()), c.name->column,
           fmt::format("{:.10g} {}", (*c.values)[n - 1] / c.factor, c.name->unit),
           fmt::format("a time not before that of the sample above, {:.10g} {}",
                       (*c.values)[n - 2] / c.factor, c.name->unit),
           "sort the rows");
  }

  [[noreturn]] void refuse(std::string_view line, std::size_t offset, std::string_view column,
                           std::string_view got, std::string_view expected,
                           std::string_view mend) const {
    const auto before = line.substr(0, offset);
    const auto characters = std::ranges::count_if(
        before, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
    throw InputError(fmt::format("{}:{}:{}: error: {}: got {}; expected {}; {}", name_,
                                 lines_.number(), characters + 1, shown(column), got, expected,
                                 mend));
  }

  Lines lines_;
  const std::string& name_;
  const Source& source_;
  char separator_ = ',';
  std::size_t width_ = 0;  ///< Fields of the heading.
};

double factor_to_si(const WantedColumn& c, const Source& source) {
  const ParsedQuantity one = parse_quantity("1 " + c.name->unit, *c.dimension);
  if (!one.value)
    fail_at(source, fmt::format("life.history.{}.unit", c.key),
            fmt::format("got {}; expected the unit of {}: {}; write for example `unit: {}`",
                        shown(c.name->unit), c.dimension->name, unit_list(*c.dimension),
                        c.dimension->canonical));
  return *one.value;
}

}  // namespace

LoadHistory parse_force_history(std::string_view text, const std::string& name,
                                const HistorySource& history, const Source& source) {
  LoadHistory h;
  h.interval = history.interval;
  std::vector<WantedColumn> columns = {{"force", &history.force, &unit::force, &h.force}};
  if (history.time) columns.push_back({"time", &*history.time, &unit::duration, &h.time});
  if (history.position)
    columns.push_back({"position", &*history.position, &unit::length, &h.position});
  if (history.speed)
    columns.push_back({"speed", &*history.speed, &unit::rotational_speed, &h.speed});
  for (WantedColumn& c : columns) {
    c.factor = factor_to_si(c, source);
    // A row of a few numbers is rarely shorter.
    c.values->reserve(text.size() / 16);
  }
  HistoryParser(text, name, source).parse(columns);
  return h;
}

namespace {

/// As messages show it.
std::filesystem::path shown_path(const HistorySource& history, const Source& source) {
  return std::filesystem::path(source.name).parent_path() / history.file;
}

std::filesystem::path path_of(const HistorySource& history, const Source& source) {
  return source.folder.empty() ? shown_path(history, source) : source.folder / history.file;
}

}  // namespace

std::string force_history_text(const HistorySource& history, const Source& source) {
  const std::filesystem::path path = path_of(history, source);
  const auto refuse = [&](const std::string& why) {
    fail_at(source, "life.history.file", fmt::format("got {}; {}", shown(history.file), why));
  };
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
    refuse(
        fmt::format("expected a file of comma-separated values; {} is none; give its path "
                    "relative to this file",
                    shown(shown_path(history, source).string())));
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size > kMostBytes)
    refuse(fmt::format("expected at most {} MiB; shorten the history or keep fewer columns",
                       kMostBytes >> 20));
  std::string text(static_cast<std::size_t>(size), '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(text.data(), static_cast<std::streamsize>(size)))
    refuse(fmt::format("expected a file that can be read; check the rights of {}",
                       shown(shown_path(history, source).string())));
  return text;
}

LoadHistory read_force_history(const HistorySource& history, const Source& source) {
  return parse_force_history(force_history_text(history, source),
                             shown_path(history, source).string(), history, source);
}

}  // namespace prs::input
