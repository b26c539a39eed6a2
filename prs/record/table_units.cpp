#include "prs/record/table_units.h"

#include <fmt/format.h>

#include <algorithm>

#include "prs/input/units.h"
#include "prs/model/quantity_text.h"
#include "prs/text.h"

namespace prs {
namespace {

thread_local UnitSystem system_of_tables = UnitSystem::si;

/// Whether the text of a number has only zeros.
bool is_zero(std::string_view text) { return text.find_first_not_of("+-0.") == text.npos; }

/// Decimals needed in the smaller or larger unit for the same digits.
int decimals_in(const ShownUnit& shown, const ShownUnit& unit, int decimals) {
  const int more = static_cast<int>(std::ceil(-std::log10(shown.factor / unit.factor)));
  return std::max(0, decimals + more);
}

}  // namespace

TableUnits::TableUnits(UnitSystem system) : before_(system_of_tables) { system_of_tables = system; }
TableUnits::~TableUnits() { system_of_tables = before_; }

ShownUnit table_unit(const ShownUnit& unit) {
  if (system_of_tables == UnitSystem::si || unit.us_text.empty()) return unit;
  return {"", unit.us_text, unit.us_factor};
}

ShownUnit table_unit(std::string_view text) { return table_unit(unit_written(text)); }

std::string with_table_unit(std::string_view label) {
  if (system_of_tables == UnitSystem::us)
    for (const ShownUnit& unit : kShownUnits) {
      if (unit.us_text.empty() || !label.ends_with(unit.text)) continue;
      const std::string_view before = label.substr(0, label.size() - unit.text.size());
      if (before.empty() || before.ends_with(' ')) return fmt::format("{}{}", before, unit.us_text);
    }
  return std::string(label);
}

UnitSystem table_system() { return system_of_tables; }

std::string table_number(std::string_view number, std::string_view unit) {
  constexpr std::string_view kMinus = "−";
  if (number.starts_with(kMinus)) return std::string(kMinus) + table_number(number.substr(kMinus.size()), unit);
  const double factor = table_factor(unit);
  const std::string_view all = number.substr(0, number.find('e'));
  const std::size_t first = std::min(all.find_first_of("123456789"), all.size());
  const auto digits = std::ranges::count_if(all.substr(first), [](char c) { return c != '.'; });
  return factor == 1.0
             ? std::string(number)
             : significant(factor * input::parse_number(number).value_or(0.0), std::max(3, static_cast<int>(digits)));
}

std::string in_table_unit(std::string_view quantity) {
  const std::size_t blank = quantity.find(' ');
  const std::string_view unit = quantity.substr(blank + 1);
  return fmt::format("{} {}", table_number(quantity.substr(0, blank), unit), table_unit(unit).text);
}

std::string table_sentence(const Warning& warning) { return with_quantities(marked_sentence(warning), in_table_unit); }

double shown(double si, std::string_view unit) { return si * table_unit(unit).factor; }

std::string fixed(std::optional<double> si, std::string_view unit, int decimals) {
  const ShownUnit& documents = unit_written(unit);
  const ShownUnit tables = table_unit(documents);
  return fixed(si, tables.factor, decimals_in(tables, documents, decimals));
}

std::string fixed_with_unit(std::optional<double> si, std::string_view unit, int decimals) {
  if (!si) return std::string(kAbsent);
  return fmt::format("{} {}", fixed(si, unit, decimals), table_unit(unit).text);
}

double table_factor(const ShownUnit& unit) { return table_unit(unit).factor / unit.factor; }

double table_factor(std::string_view unit) { return table_factor(unit_written(unit)); }

std::string TableResponse::text() const {
  return title.unit.empty() ? title.name : fmt::format("{} ({})", title.name, title.unit);
}

TableResponse table_response(std::string_view path) {
  TableResponse response{response_title(path)};
  const ShownUnit& unit = unit_written(response.title.unit);
  if (unit.text.empty()) return response;
  response.factor = table_factor(unit);
  response.title.unit = table_unit(unit).text;
  return response;
}

std::string fixed(std::optional<double> si, double factor, int decimals) {
  if (!si) return std::string(kAbsent);
  std::string text = fmt::format("{:.{}f}", *si * factor, decimals);
  if (text.starts_with('-') && is_zero(text)) text.erase(0, 1);
  return text;
}

std::string fixed_change(double value, int decimals) {
  std::string text = fmt::format("{:+.{}f}", value, decimals);
  if (is_zero(text)) text[0] = '+';
  return text;
}

std::string significant(std::optional<double> value, int digits) {
  if (!value || !std::isfinite(*value)) return std::string(kAbsent);
  const double size = std::abs(*value);
  const double digit = std::pow(10.0, std::floor(std::log10(size)) + 1.0 - digits);
  if (!(digit >= 1.0 && size < 1e9)) return fmt::format("{:.{}g}", *value, digits);
  return fmt::format("{:.0f}", std::round(*value / digit) * digit);
}

std::string significant_with_unit(std::optional<double> si, std::string_view unit, int digits) {
  if (!si) return std::string(kAbsent);
  return fmt::format("{} {}", significant(shown(*si, unit), digits), table_unit(unit).text);
}

std::string digits(std::optional<double> value, int digits) {
  return value && std::isfinite(*value) ? fmt::format("{:.{}g}", *value, digits) : std::string(kAbsent);
}

}  // namespace prs
