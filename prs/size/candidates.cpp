#include "prs/size/candidates.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>

#include "prs/configurations/screw_case.h"
#include "prs/input/csv_reader.h"
#include "prs/input/document.h"
#include "prs/input/fail_at.h"
#include "prs/input/force_history.h"
#include "prs/model/case_error.h"
#include "prs/model/quantity_text.h"

namespace prs {
namespace {

constexpr std::size_t kMostCandidates = 100'000;
constexpr std::string_view kFile = "candidates.catalogue.file";

/// A number of a row, in the unit of the column's name.
struct NumberColumn {
  std::string_view name;
  double factor;  ///< To SI.
  bool needed, whole, signed_number;
  std::function<void(CandidateData&, double)> take;
};

const std::vector<NumberColumn>& number_columns() {
  static const std::vector<NumberColumn> columns{
      {"screw_diameter_mm", 1e3, true, false, false,
       [](CandidateData& c, double x) { c.screw.screw_diameter = x; }},
      {"lead_mm", 1e3, true, false, true, [](CandidateData& c, double x) { c.screw.lead = x; }},
      {"starts", 1.0, true, true, false,
       [](CandidateData& c, double x) { c.screw.starts = static_cast<int>(x); }},
      {"rollers", 1.0, false, true, false,
       [](CandidateData& c, double x) { c.screw.rollers = static_cast<int>(x); }},
      {"nut_diameter_mm", 1e3, false, false, false,
       [](CandidateData& c, double x) { c.screw.nut_diameter = x; }},
      {"nut_length_mm", 1e3, false, false, false,
       [](CandidateData& c, double x) { c.screw.nut_length = x; }},
      {"dynamic_capacity_kN", 1e-3, false, false, false,
       [](CandidateData& c, double x) { c.dynamic_capacity = x; }},
      {"static_capacity_kN", 1e-3, false, false, false,
       [](CandidateData& c, double x) { c.static_capacity = x; }},
      {"efficiency", 1.0, false, false, false,
       [](CandidateData& c, double x) { c.efficiency = x; }},
      {"back_driving_efficiency", 1.0, false, false, false,
       [](CandidateData& c, double x) { c.back_driving_efficiency = x; }},
  };
  return columns;
}

/// Columns that are texts, or shown and not used.
constexpr std::string_view kOtherColumns[] = {"name",
                                              "screw",
                                              "type",
                                              "nut_and_rollers_kg",
                                              "screw_kg_per_m",
                                              "screw_inertia_kg_mm2_per_m",
                                              "nut_inertia_kg_mm2",
                                              "roller_inertia_seen_by_screw_kg_mm2",
                                              "screw_outer_diameter_mm",
                                              "screw_root_diameter_mm"};

class CatalogueReader {
 public:
  CatalogueReader(std::string_view text, std::string name, const input::Source& source)
      : text_(text), name_(std::move(name)), source_(source), reader_(text) {}

  std::vector<CandidateData> read(std::vector<Warning>& warnings) {
    if (!next()) fail("has no heading; expected the names of the columns, then a screw per row");
    for (const std::string_view column : reader_.fields()) heading_.emplace_back(column);
    check_heading(warnings);
    std::vector<CandidateData> rows;
    while (next()) {
      rows.push_back(row());
      rows.back().number = rows.size();
      if (rows.size() > kMostCandidates)
        fail(fmt::format("has more than {} rows; expected as many at most", kMostCandidates));
    }
    if (rows.empty()) fail("has no rows; expected a screw per row below the heading");
    return rows;
  }

 private:
  [[noreturn]] void fail(std::string_view what) const {
    input::fail_at(source_, kFile, fmt::format("got {}, which {}; check the file", name_, what));
  }
  [[noreturn]] void refuse_at(std::size_t offset, std::string_view message) const {
    throw input::InputError(
        fmt::format("{}: error: {}", input::place_in(name_, text_, offset), message));
  }
  [[noreturn]] void refuse(std::size_t field, std::string_view expected,
                           std::string_view fix) const {
    const auto& fields = reader_.fields();
    refuse_at(
        reader_.field_offset(reader_.row_offset(), field),
        fmt::format("{}: got {}; expected {}; {}",
                    field < heading_.size() ? input::shown(heading_[field]) : "row",
                    field < fields.size() && !fields[field].empty() ? input::shown(fields[field])
                                                                    : "nothing",
                    expected, fix));
  }
  bool next() {
    try {
      return reader_.next();
    } catch (const input::CsvError& error) {
      refuse_at(error.offset(), error.what());
    }
  }

  void check_heading(std::vector<Warning>& warnings) const {
    for (const NumberColumn& c : number_columns())
      if (c.needed && std::ranges::find(heading_, c.name) == heading_.end())
        fail(fmt::format("lacks the column {}; expected {} at least", c.name,
                         "screw_diameter_mm, lead_mm, starts"));
    for (const std::string& column : heading_) {
      if (std::ranges::count(heading_, column) > 1)
        fail(fmt::format("has two columns {}; expected one of that name", input::shown(column)));
      if (std::ranges::find(number_columns(), column, &NumberColumn::name) ==
              number_columns().end() &&
          std::ranges::find(kOtherColumns, column) == std::end(kOtherColumns))
        warnings.push_back({std::string(kFile), "unknown_column_" + column,
                            fmt::format("the column {} of {} is not known, and not used",
                                        input::shown(column), name_),
                            "see docs/size.md for the columns"});
    }
  }

  double number(std::size_t field, const NumberColumn& c) const {
    const std::string_view text = reader_.fields()[field];
    double value = 0.0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool sound = error == std::errc{} && stop == text.data() + text.size() &&
                       std::isfinite(value) && (c.signed_number ? value != 0.0 : value > 0.0);
    if (!sound || (c.whole && (value != std::round(value) || value > 1000.0)))
      refuse(field,
             c.whole           ? "a whole number > 0"
             : c.signed_number ? "a number other than 0"
                               : "a number > 0",
             "fix the field, or write `-` for a value that is not printed");
    if (c.name.ends_with("efficiency") && value > 1.0)
      refuse(field, "a fraction up to 1", "write 0.85 for 85 %");
    return value / c.factor;
  }

  CandidateData row() const {
    const auto& fields = reader_.fields();
    if (fields.size() > heading_.size())
      refuse(heading_.size(), fmt::format("{} fields as in the heading", heading_.size()),
             "write decimal marks as points, or quote texts that hold the separator");
    CandidateData c;
    c.is_row = true;
    for (std::size_t k = 0; k < heading_.size(); ++k) {
      const std::string_view text = k < fields.size() ? fields[k] : std::string_view();
      const std::string& column = heading_[k];
      const auto known = std::ranges::find(number_columns(), column, &NumberColumn::name);
      const bool absent = text.empty() || text == "-";
      if (known != number_columns().end()) {
        if (!absent) known->take(c, number(k, *known));
        if (absent && known->needed) refuse(k, "a number", "complete the row");
      } else if (!absent && (column == "name" || (column == "screw" && c.name.empty()))) {
        c.name = text;
      } else if (!absent && column == "type") {
        if (text != "standard" && text != "inverted")
          refuse(k, "standard or inverted", "write one of these");
        c.screw.type = text == "standard" ? Mechanism::Type::standard : Mechanism::Type::inverted;
      }
    }
    return c;
  }

  std::string_view text_;
  std::string name_;
  const input::Source& source_;
  input::CsvReader reader_;
  std::vector<std::string> heading_;
};

std::string size_name(const ScrewData& d) {
  return fmt::format("{:.6g}x{:.6g}", 1e3 * d.screw_diameter, 1e3 * d.lead);
}

void add_designs(const Requirement::Designs& d, const input::Source& source,
                 std::vector<CandidateData>& all) {
  const std::vector<double> diameters = d.screw_diameter.values(), leads = d.lead.values();
  const std::vector<double> starts = d.starts ? d.starts->values() : std::vector<double>{0.0};
  const double count = static_cast<double>(d.type.size()) * static_cast<double>(diameters.size()) *
                       static_cast<double>(leads.size()) * static_cast<double>(starts.size());
  if (count + static_cast<double>(all.size()) > static_cast<double>(kMostCandidates))
    input::fail_at(source, "candidates",
                   fmt::format("got {:.0f} candidates; expected at most {}; take fewer diameters, "
                               "leads or starts",
                               count + static_cast<double>(all.size()), kMostCandidates));
  std::size_t number = 0;
  for (const Mechanism::Type type : d.type)
    for (const double diameter : diameters)
      for (const double lead : leads)
        for (const double n : starts) {
          CandidateData& c = all.emplace_back();
          c.number = ++number;
          c.screw.type = type;
          c.screw.screw_diameter = diameter;
          c.screw.lead = lead;
          if (n > 0.0) c.screw.starts = static_cast<int>(n);
        }
}

}  // namespace

std::vector<CandidateData> candidates_of(const SizeInput& in, std::vector<Warning>& warnings) {
  const Requirement::Candidates& from = *in.values.candidates;
  std::vector<CandidateData> all;
  if (from.catalogue && !from.catalogue->file.empty()) {
    const std::string& file = from.catalogue->file;
    const std::string text = input::named_file_text(file, kFile, in.source);
    all = CatalogueReader(text, input::name_in_messages(file, in.source), in.source).read(warnings);
  } else if (from.catalogue || !from.designs) {
    all = CatalogueReader(standard_screws(), "standard_screws.csv", in.source).read(warnings);
  }
  if (from.designs) add_designs(*from.designs, in.source, all);
  for (CandidateData& c : all)
    if (c.name.empty()) c.name = size_name(c.screw);
  return all;
}

CompleteScrew screw_of(const CandidateData& candidate, const std::optional<double>& stroke) {
  CompleteScrew screw = complete_screw(candidate.screw);
  if (candidate.screw.type == Mechanism::Type::inverted && stroke) {
    const double threads = screw.c.mechanism.contacts_per_roller * axial_pitch(screw.c.mechanism);
    const double least = *stroke + threads + 2.0 * screw.c.structure->roller.end_length;
    if (candidate.screw.nut_length) {
      if (*candidate.screw.nut_length < least * (1.0 - 1e-9))
        throw CaseError("nut_length",
                        fmt::format("got {}; expected at least {}, in which the rollers travel {}",
                                    mm(*candidate.screw.nut_length), mm(least), mm(*stroke)));
    } else {
      ScrewData longer = candidate.screw;
      longer.nut_length = 1e-3 * std::ceil(1e3 * std::max(least, threads / kThreadedShare) - 1e-9);
      screw = complete_screw(longer);
    }
  }
  require_capacity(screw);
  return as_written(std::move(screw));
}

}  // namespace prs
