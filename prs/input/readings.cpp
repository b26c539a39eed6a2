#include "prs/input/readings.h"

#include <charconv>
#include <filesystem>

#include "prs/input/document.h"
#include "prs/input/force_history.h"

namespace prs::input {
namespace {

/// The dimension that has a unit, or null.
const Dimension* dimension_with(std::string_view unit) {
  for (const Dimension* d : dimensions())
    if (find_unit(unit, *d)) return d;
  return nullptr;
}

}  // namespace

std::string with_unit(double number, std::string_view unit) {
  return unit.empty() ? fmt::format("{}", number) : fmt::format("{} {}", number, unit);
}

std::optional<Conversion> conversion(std::string_view from, std::string_view to) {
  if (from == to) return Conversion{};
  if (to.empty()) return from == "%" ? std::optional(Conversion{0.01}) : std::nullopt;
  const auto zero = number_in(with_unit(0.0, from), to), one = number_in(with_unit(1.0, from), to);
  if (from.empty() || !zero || !one) return std::nullopt;
  return Conversion{*one - *zero, *zero};
}

std::string units_like(std::string_view unit) {
  if (unit.empty()) return "no unit, or \"%\"";
  const Dimension* d = dimension_with(unit);
  return d ? unit_list(*d) : std::string(unit);
}

Readings::Readings(const std::string& file, const std::string& at, const Source& source)
    : source_(source),
      text_(named_file_text(file, at + ".file", source)),
      name_(std::filesystem::path(name_in_messages(file, source)).lexically_normal().string()),
      reader_(text_) {
  if (!next()) refuse_file("which has no heading");
  for (const std::string_view name : reader_.fields()) names_.emplace_back(name);
}

std::size_t Readings::column(const std::string& name, const std::string& key) const {
  const auto found = std::ranges::find(names_, name);
  if (found == names_.end() || std::ranges::count(names_, name) > 1)
    fail_at(source_, key, "got {}; expected {} of {}: {}; {}", shown(name),
            found == names_.end() ? "a column" : "a name that stands once", name_,
            shown(fmt::format("{}", fmt::join(names_, ", "))),
            found == names_.end() ? "check the heading" : "rename the other column");
  return static_cast<std::size_t>(found - names_.begin());
}

bool Readings::next() {
  try {
    if (!reader_.next()) return false;
  } catch (const CsvError& error) {
    throw InputError(fmt::format("{}: error: {}", place_in(name_, text_, error.offset()), error.what()));
  }
  const std::size_t offset = reader_.row_offset();
  line_ += static_cast<std::size_t>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(counted_),
                                               text_.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
  counted_ = offset;
  if (!names_.empty() && reader_.fields().size() > names_.size())
    refuse(0, fmt::format("{} fields", reader_.fields().size()), "at most as many as in the heading");
  return true;
}

std::size_t Readings::column_at(std::size_t field) const {
  return 1 + reader_.field_offset(reader_.row_offset(), field) - reader_.row_offset();
}

std::string Readings::text(std::size_t field) const {
  if (field >= reader_.fields().size()) refuse(reader_.fields().size() - 1, "nothing", "a value in each column");
  std::string_view text = reader_.fields()[field];
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return std::string(text);
}

double Readings::number(std::size_t field) const {
  const std::string field_text = text(field);
  const char *first = field_text.data(), *last = first + field_text.size();
  double value = 0.0;
  const bool has_plus = field_text.starts_with('+') && !field_text.starts_with("+-");
  const auto [stop, error] = std::from_chars(first + (has_plus ? 1 : 0), last, value);
  if (error != std::errc{} || stop != last || !(std::abs(value) <= 1e30))
    refuse(field, field_text.empty() ? "nothing" : shown(field_text),
           field_text.find(',') == field_text.npos ? "a finite number, without unit"
                                                   : "a finite number, with a point as its decimal mark");
  return value;
}

void Readings::refuse(std::size_t field, const std::string& got, const std::string& expected) const {
  throw InputError(fmt::format("{}: error: {}: got {}; expected {}; fix or delete the row",
                               place_in(name_, text_, reader_.field_offset(reader_.row_offset(), field)),
                               field < names_.size() ? shown(names_[field]) : "row", got, expected));
}

void Readings::refuse_name(std::size_t field, const std::string& expected) const {
  throw InputError(fmt::format("{}: error: heading: got {}; {}",
                               place_in(name_, text_, reader_.field_offset(reader_.row_offset(), field)),
                               names_[field].empty() ? "nothing" : shown(names_[field]), expected));
}

void Readings::refuse_file(const std::string& what) const {
  throw InputError(
      fmt::format("{0}:1:1: error: got {0}, {1}; expected a line with the names of the columns, then one row per "
                  "reading; check the "
                  "file",
                  name_, what));
}

}  // namespace prs::input
