#pragma once

#include <limits>

#include "prs/record/record.h"

namespace prs {

/// Unit of a shown quantity, with shown = number of the document * factor.
struct ReportUnit {
  std::string text;
  double factor = 1.0;
};

/// Unit of a quantity by its key or path, with the unit of documents: efficiencies are shown in percent, pressures in
/// GPa, forces in kN if the largest of them reaches 1000 N; in US units as in tables.
ReportUnit report_unit(std::string_view key, std::string_view unit,
                       double largest = std::numeric_limits<double>::infinity());

/// A number as the report shows it, never with a separator of thousands. Lengths and angles, which follow from the
/// geometry, have five digits, results of models of loads four, lives and temperatures three, stiffness has one
/// decimal. `unit` as people write it.
std::string report_number(double value, std::string_view unit);

/// A sentence as a page shows it: what stands between backquotes as code, units with the signs of print, `µm`, `°C`,
/// `kg/m³`.
std::string prose_html(std::string_view sentence);

/// The name of a load case with the sign of degrees.
std::string name_with_signs(const std::string& name);

/// A name or a path as HTML that breaks where its parts end.
std::string breakable_html(std::string_view name);

/// Value of a document as HTML: range of long arrays; empty if it is no number or text.
std::string report_value(const Json& value, const ReportUnit& unit, bool is_range = false);

/// A column of a table of quantities.
struct RecordColumn {
  std::string title;
  const Json* record = nullptr;
};

/// Choice of the quantities in a table.
struct RecordChoice {
  std::vector<std::string> without = {};  ///< Keys to leave out.
  std::vector<std::string> only = {};     ///< Keys to show; empty: all others.
  std::vector<std::string> hidden = {};   ///< Keys to leave out in nested records, too.
  Reach reach = Reach::complete;          ///< `document`: only quantities about the solution.
};

/// All single values of records, one row each, with titles and units of the table of results; empty if there are none.
std::string record_table(const RecordInfo& info, const std::vector<RecordColumn>& columns,
                         const RecordChoice& choice = {});

/// Values under a key of each column; null if it has none.
std::vector<RecordColumn> columns_in(const std::vector<RecordColumn>& columns, std::string_view key);

/// The record under a key; null if there is none.
const RecordInfo* record_in(const RecordInfo& info, std::string_view key);

/// Content folded under a heading; empty if there is none. On paper only opened parts appear.
std::string folded_html(std::string_view title, const std::string& body, bool is_printed = false);

/// A table of texts that are HTML; the first cell of each row is its heading. A row of one cell is
/// a heading over the next ones.
std::string plain_table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows,
                        bool of_numbers = false);

}  // namespace prs
