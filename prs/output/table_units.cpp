#include "prs/output/table_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "prs/output/case_table.h"

namespace prs {
namespace {

thread_local UnitSystem system_of_tables = UnitSystem::si;

// By definition (NIST SP 811, appendix B).
constexpr double kPerInch = 1.0 / 0.0254;
constexpr double kPerPound = 1.0 / 0.45359237;
constexpr double kPerPoundForce = kPerPound / 9.80665;

struct UsUnit {
  std::string_view si;  ///< As documents write it.
  ShownUnit us;
};

/// Speeds of rotation, angles, times and powers are the same: torques go with rpm and W.
constexpr UsUnit kUsUnits[] = {
    {"N/mm^1.5", {"", "lbf/in^1.5", kPerPoundForce * 0.004048093872429343}},  // 0.0254^1.5
    {"mm/N^(1/3)", {"", "in/lbf^(1/3)", kPerInch * 1.6446070162173028}},      // 4.4482216^(1/3)
    {"mm/rad", {"", "in/rad", kPerInch}},
    {"kN/kg", {"", "lbf/lb", kPerPoundForce / kPerPound}},
    {"W/mm²", {"", "W/in²", 1.0 / (kPerInch * kPerInch)}},
    {"N/µm", {"", "lbf/in", kPerPoundForce / kPerInch}},
    {"mm/s", {"", "in/s", kPerInch}},
    {"kg/m", {"", "lb/in", kPerPound / kPerInch}},
    {"kg mm²", {"", "lb in²", kPerPound* kPerInch* kPerInch}},
    {"1/mm", {"", "1/in", 1.0 / kPerInch}},
    {"N mm", {"", "lbf in", kPerPoundForce* kPerInch}},
    {"N m", {"", "lbf in", kPerPoundForce* kPerInch}},
    {"cm³", {"", "in³", kPerInch* kPerInch* kPerInch}},
    {"GPa", {"", "ksi", 1e-3 * kPerPoundForce / (kPerInch * kPerInch)}},
    {"MPa", {"", "ksi", 1e-3 * kPerPoundForce / (kPerInch * kPerInch)}},
    {"km", {"", "10^6 in", 1e-6 * kPerInch}},
    {"kg", {"", "lb", kPerPound}},
    {"kN", {"", "lbf", kPerPoundForce}},
    {"mm", {"", "in", kPerInch}},
    {"µm", {"", "µin", 1e6 * kPerInch}},
    {"nm", {"", "µin", 1e6 * kPerInch}},
    {"N", {"", "lbf", kPerPoundForce}},
    {"m", {"", "in", kPerInch}},
};

const ShownUnit& documents_unit(std::string_view text) {
  const auto* const unit = std::ranges::find(kShownUnits, text, &ShownUnit::text);
  return unit == std::end(kShownUnits) ? kNoUnit : *unit;
}

/// Decimals that the smaller or larger unit needs to show the same digits.
int decimals_in(const ShownUnit& shown, const ShownUnit& unit, int decimals) {
  const int more = static_cast<int>(std::ceil(-std::log10(shown.factor / unit.factor)));
  return std::max(0, decimals + more);
}

}  // namespace

TableUnits::TableUnits(UnitSystem system) : before_(system_of_tables) { system_of_tables = system; }
TableUnits::~TableUnits() { system_of_tables = before_; }

const ShownUnit& table_unit(const ShownUnit& unit) {
  if (system_of_tables == UnitSystem::si) return unit;
  const auto* const us = std::ranges::find(kUsUnits, unit.text, &UsUnit::si);
  return us == std::end(kUsUnits) ? unit : us->us;
}

const ShownUnit& table_unit(std::string_view text) { return table_unit(documents_unit(text)); }

std::string with_table_unit(std::string_view label) {
  if (system_of_tables == UnitSystem::us)
    for (const UsUnit& unit : kUsUnits) {
      if (!label.ends_with(unit.si)) continue;
      const std::string_view before = label.substr(0, label.size() - unit.si.size());
      if (before.empty() || before.ends_with(' ')) return fmt::format("{}{}", before, unit.us.text);
    }
  return std::string(label);
}

double shown(double si, std::string_view unit) { return si * table_unit(unit).factor; }

std::string fixed(std::optional<double> si, std::string_view unit, int decimals) {
  const ShownUnit& documents = documents_unit(unit);
  const ShownUnit& tables = table_unit(documents);
  return fixed(si, tables.factor, decimals_in(tables, documents, decimals));
}

std::string fixed_with_unit(std::optional<double> si, std::string_view unit, int decimals) {
  if (!si) return std::string(kAbsent);
  return fmt::format("{} {}", fixed(si, unit, decimals), table_unit(unit).text);
}

double table_factor(const ShownUnit& unit) { return table_unit(unit).factor / unit.factor; }

std::string TableResponse::text() const {
  return title.unit.empty() ? title.name : fmt::format("{} ({})", title.name, title.unit);
}

TableResponse table_response(std::string_view path) {
  TableResponse response{response_title(path)};
  const ShownUnit& unit = documents_unit(response.title.unit);
  if (unit.text.empty()) return response;
  response.factor = table_factor(unit);
  response.title.unit = table_unit(unit).text;
  return response;
}

}  // namespace prs
