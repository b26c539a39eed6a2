#include "prs/input/force_history.h"

#include <sys/stat.h>

#include <algorithm>
#include <charconv>

#include "prs/input/csv_reader.h"
#include "prs/input/did_you_mean.h"
#include "prs/input/document.h"
#include "prs/sha256.h"

namespace prs::input {
namespace {

constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30;
constexpr double kLargestNumber = 1e30;

/// A quoted field keeps the blanks around its number.
std::string_view trimmed(std::string_view text) {
  const auto is_space = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

std::string nearest(std::string_view column, std::vector<std::string_view> names) {
  std::erase_if(names, [](std::string_view name) { return name.size() > kLongestText; });
  const std::string hint = did_you_mean(column, names);
  return hint.empty() ? "check the heading" : shown(hint);
}

class HistoryParser {
 public:
  HistoryParser(std::string_view text, const std::string& name, std::string_view block, const Source& source)
      : text_(text), reader_(text), name_(name), block_(block), source_(source) {}

  void parse(std::vector<WantedColumn>& columns) {
    read_heading(columns);
    while (next_row()) read_row(columns);
    const std::size_t rows = columns.front().values->size();
    if (rows < 2)
      fail_at(source_, fmt::format("{}.file", block_),
              fmt::format("got {} row{} of numbers in {}; expected at least 2; check the file", rows,
                          rows == 1 ? "" : "s", name_));
  }

 private:
  bool next_row() {
    try {
      return reader_.next();
    } catch (const CsvError& error) {
      refuse_at(error.offset(), error.what());
    }
  }

  void read_heading(std::vector<WantedColumn>& columns) {
    if (!next_row())
      fail_at(source_, fmt::format("{}.file", block_),
              fmt::format("got {}, which has no heading; expected a line with the names of the "
                          "columns, then one row per sample; check the file",
                          name_));
    const std::vector<std::string_view>& names = reader_.fields();
    width_ = names.size();
    for (WantedColumn& c : columns) {
      if (std::ranges::count(names, c.name->column) > 1)
        fail_at(source_, fmt::format("{}.{}.column", block_, c.key),
                fmt::format("got {}, which occurs twice in the heading of {}; expected one column "
                            "of that name; rename the other one",
                            shown(c.name->column), name_));
      const auto found = std::ranges::find(names, c.name->column);
      if (found == names.end())
        fail_at(source_, fmt::format("{}.{}.column", block_, c.key),
                fmt::format("got {}; expected a column of {}: {}; {}", shown(c.name->column), name_,
                            shown(fmt::format("{}", fmt::join(names, ", "))), nearest(c.name->column, names)));
      c.field = static_cast<std::size_t>(found - names.begin());
    }
  }

  void read_row(std::vector<WantedColumn>& columns) {
    const std::size_t width = reader_.fields().size();
    // A decimal comma in a file separated by commas would shift all later fields.
    if (width > width_)
      refuse(0, "row", fmt::format("{} fields", width), fmt::format("at most {} as in the heading", width_),
             "write decimal marks as points, or quote texts that hold the separator");
    for (WantedColumn& c : columns) {
      if (c.field >= width)
        refuse(width, c.name->column, "nothing", fmt::format("a number in field {}", c.field + 1), "complete the row");
      c.values->push_back(c.factor * number(c));
      if (c.key == "time") check_time(c);
    }
  }

  double number(const WantedColumn& c) const {
    const std::string_view field = trimmed(reader_.fields()[c.field]);
    const char* const end = field.data() + field.size();
    double value = 0.0;
    const auto [stop, error] = std::from_chars(field.data() + (field.starts_with('+') ? 1 : 0), end, value);
    if (error == std::errc{} && stop == end && std::abs(value) <= kLargestNumber)  // false for NaN.
      return value;
    refuse(c.field, c.name->column, field.empty() ? "nothing" : shown(field), "a finite number, without unit",
           field.find(',') != std::string_view::npos ? "write the decimal mark as a point" : "fix or delete the row");
  }

  void check_time(const WantedColumn& c) const {
    const std::size_t n = c.values->size();
    if (n < 2 || (*c.values)[n - 1] >= (*c.values)[n - 2]) return;
    refuse(c.field, c.name->column, fmt::format("{:.10g} {}", (*c.values)[n - 1] / c.factor, c.name->unit),
           fmt::format("a time not before that of the sample above, {:.10g} {}", (*c.values)[n - 2] / c.factor,
                       c.name->unit),
           "sort the rows");
  }

  [[noreturn]] void refuse(std::size_t field, std::string_view column, std::string_view got, std::string_view expected,
                           std::string_view fix) const {
    refuse_at(reader_.field_offset(reader_.row_offset(), field),
              fmt::format("{}: got {}; expected {}; {}", shown(column), got, expected, fix));
  }

  [[noreturn]] void refuse_at(std::size_t offset, std::string_view message) const {
    throw InputError(fmt::format("{}: error: {}", place_in(name_, text_, offset), message));
  }

  std::string_view text_;
  CsvReader reader_;
  const std::string& name_;
  std::string_view block_;
  const Source& source_;
  std::size_t width_ = 0;  ///< Fields of the heading.
};

double factor_to_si(const WantedColumn& c, std::string_view block, const Source& source) {
  const ParsedQuantity one = parse_quantity("1 " + c.name->unit, *c.dimension);
  if (!one.value)
    fail_at(source, fmt::format("{}.{}.unit", block, c.key),
            fmt::format("got {}; expected the unit of {}: {}; write for example `unit: {}`", shown(c.name->unit),
                        c.dimension->name, unit_list(*c.dimension), c.dimension->canonical));
  return *one.value;
}

}  // namespace

void read_columns(std::string_view text, const std::string& name, std::string_view block,
                  std::vector<WantedColumn>& columns, const Source& source) {
  for (WantedColumn& c : columns) {
    c.factor = factor_to_si(c, block, source);
    // Rows of a few numbers are rarely shorter.
    c.values->reserve(text.size() / 16);
  }
  HistoryParser(text, name, block, source).parse(columns);
}

LoadHistory parse_force_history(std::string_view text, const std::string& name, const HistorySource& history,
                                const Source& source) {
  LoadHistory h;
  h.interval = history.interval;
  h.speed_along_axis = history.speed && is_travel_speed("1 " + history.speed->unit);
  std::vector<WantedColumn> columns = {{"force", &history.force, &unit::force, &h.force}};
  if (history.time) columns.push_back({"time", &*history.time, &unit::duration, &h.time});
  if (history.position) columns.push_back({"position", &*history.position, &unit::length, &h.position});
  if (history.speed)
    columns.push_back(
        {"speed", &*history.speed, h.speed_along_axis ? &unit::travel_speed : &unit::rotational_speed, &h.speed});
  read_columns(text, name, "life.history", columns, source);
  return h;
}

namespace {

/// Path in messages. A name in angle brackets is that of data without a file, such as an argument of Python.
std::filesystem::path shown_path(const std::string& file, const Source& source) {
  if (file.starts_with('<')) return file;
  return std::filesystem::path(source.name).parent_path() / file;
}

std::filesystem::path path_of(const std::string& file, const Source& source) {
  return source.folder.empty() ? shown_path(file, source) : source.folder / file;
}

/// Absolute path, or the path itself if there is none; error messages are not used.
std::filesystem::path in_full(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path found = std::filesystem::absolute(path, error);
  return error ? path : found;
}

/// Whether a file is, links followed, below the folder of the case; of an open file the opened one counts, not a later
/// one of that name.
bool stands_with_case(const std::filesystem::path& file, const Source& source) {
  namespace fs = std::filesystem;
  fs::path folder = source.folder.empty() ? fs::path(source.name).parent_path() : source.folder;
  if (folder.empty()) folder = ".";
  std::error_code error;
  const fs::path from = fs::weakly_canonical(folder, error);
  if (error) return false;
  const fs::path to = fs::weakly_canonical(in_full(file), error);
  return !error && std::mismatch(from.begin(), from.end(), to.begin(), to.end()).first == from.end();
}

/// Name of an open file in the system.
std::filesystem::path name_of_open(const FileDescriptor& file) { return fmt::format("/proc/self/fd/{}", file.get()); }

/// Whether `--set` names the file: then the user chose it, while a case may come from anyone.
bool names_file_by_override(std::string_view path, const Source& source) {
  ErrorList errors(source);
  return locate(read_document(source, errors), path).argument >= 0;
}

}  // namespace

std::string named_file_text(const std::string& name, std::string_view key, const Source& source,
                            bool may_stand_anywhere) {
  const auto refuse = [&](const std::string& why) {
    fail_at(source, key, fmt::format("got {}; {}", shown(name), why));
  };
  if (source.files) {
    const auto found = source.files->find(name);
    if (found != source.files->end()) return found->second;
    if (source.folder.empty()) refuse("expected the name of a file that was given; give its text under this name");
  }
  const std::filesystem::path path = path_of(name, source);
  may_stand_anywhere = may_stand_anywhere || names_file_by_override(key, source);
  const auto require_place = [&](const std::filesystem::path& place) {
    if (!may_stand_anywhere && !stands_with_case(place, source))
      refuse(
          fmt::format("expected a file in the folder of the case or below it; move it there, or "
                      "allow it by `--set {}=PATH`",
                      key));
  };
  require_place(path);
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  const int why = file.is_open() ? 0 : errno;
  throw_if_scarce(why, path.string());
  struct stat status {};
  if (why == ENOENT || why == ENOTDIR || why == ENXIO ||
      (why == 0 && (::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode))))
    refuse(fmt::format("expected a file of comma-separated values; {} {}; give its path relative to this file",
                       shown(name_in_messages(name, source)),
                       why == ENOENT || why == ENOTDIR ? "does not exist" : "is no file"));
  if (why == 0) require_place(name_of_open(file));
  if (static_cast<std::uintmax_t>(status.st_size) > kMostBytes)
    refuse(fmt::format("expected at most {} MiB; shorten the history or keep fewer columns", kMostBytes >> 20));
  std::optional<std::string> text = why == 0 ? content_of(file, kMostBytes) : std::optional<std::string>();
  if (!text)
    refuse(
        fmt::format("expected a file that can be read; check the rights of {}", shown(name_in_messages(name, source))));
  return *std::move(text);
}

std::string name_in_messages(const std::string& file, const Source& source) {
  return shown_path(file, source).string();
}

std::string force_history_text(const HistorySource& history, const Source& source) {
  // A case that states the hash does not reveal anything by reading the file.
  std::string text = named_file_text(history.file, "life.history.file", source, history.sha256.has_value());
  if (history.sha256 && sha256(text) != *history.sha256)
    fail_at(source, "life.history.sha256",
            fmt::format("got {}; expected that of {}, which is another file or has changed; give "
                        "the file that is meant, or leave this key out",
                        shown(*history.sha256), shown(history.file)));
  return text;
}

std::filesystem::path place_of_file(const std::string& name, const Source& source) {
  if (source.files && source.folder.empty()) return name;
  return in_full(path_of(name, source)).lexically_normal();
}

Source with_files(Source source, const HistorySource& history) {
  std::string text = force_history_text(history, source);
  source.files.emplace();
  source.files->emplace(history.file, std::move(text));
  return source;
}

LoadHistory read_force_history(const HistorySource& history, const Source& source) {
  return parse_force_history(force_history_text(history, source), name_in_messages(history.file, source), history,
                             source);
}

}  // namespace prs::input
