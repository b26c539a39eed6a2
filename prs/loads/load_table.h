#pragma once

#include "prs/loads/result.h"
#include "prs/record/csv_writer.h"

namespace prs {

/// The load cases at a glance: one row per case and the warnings below, as a rule within
/// `kTableWidth` columns. Beyond 24 cases a range shows its first, middle and last point.
std::string load_case_table(const Result& result);

/// One case thread by thread: the load rate at both interfaces [%] as bars. For a case without an
/// answer, one line that says why.
std::string load_distribution_chart(const LoadCaseResult& result);

/// `load_cases.csv`: one row a load case, failed ones included. Units stand in the header, a field
/// is empty where the case does not define it. Quoted as in RFC 4180.
std::string load_cases_csv(const Result& result, const CsvStyle& style = {});

/// `load_distribution.csv`: one row a thread of every load case that has an answer.
std::string load_distribution_csv(const Result& result, const CsvStyle& style = {});

/// What the threads say, within 100 columns: the mechanism part by part, the contact of the roller
/// with screw and nut, the loads and stresses of the cases with equal shares, and the warnings.
/// Angles are Sandu's theta [deg], lengths in mm. A row is left out where nothing defines it: Hertz
/// constants without materials, backlash where pitches differ. Beyond 24 cases a range shows its
/// first, middle and last point.
std::string contact_table(const Result& result);

}  // namespace prs
