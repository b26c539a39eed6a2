#pragma once

#include <initializer_list>

#include "prs/loads/analysis_options.h"
#include "prs/loads/result.h"
#include "prs/record/analysis.h"

namespace prs {

/// Adds what every document says of the contacts, under `contact`, and of the threads by
/// themselves, under `threads`; nothing of these where no heights are given.
void put_contacts(Json& document, const Contacts& contacts);

/// Adds contacts and model, and an empty list for the load cases.
void put_loads(Json& document, const Result& result);
/// A load case: units stand in the keys, arrays start at the thread next to the loaded end of the
/// screw. What the result does not define is absent, as is a number that is not finite. Absent
/// behind the last.
std::optional<Json> load_case_json(const Result& result, std::size_t k);

/// `places` behind those of contacts and loads.
std::vector<Place> with_loads(std::initializer_list<Place> places = {});
/// `places` behind those of contacts.
std::vector<Place> with_contacts(std::initializer_list<Place> places);

const Analysis<Result>& contact_analysis();

bool all_converged(const Result& result);

/// The warnings of a result for the terminal, each once with its load cases.
std::vector<std::string> summary_of_warnings(const Result& result);

/// A terminal shows a load case thread by thread, but not the points of a range.
inline constexpr std::size_t kMostCharts = 1;

/// Tables of load cases and of their threads, as `solve` writes them.
std::vector<OutputFile> load_files(const Result& result, const CsvStyle& style);

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

/// `travel.csv`, a row each position of each load case, and `travel_loads.csv`, a row each thread;
/// none without a travel.
std::vector<OutputFile> travel_files(const Result& result, const CsvStyle& style);

/// Lowest frequency and the speeds at which orders of the parts meet it, where masses are stated.
std::vector<Headline> frequencies(const Result& result);

/// What the threads say, within 100 columns: the mechanism part by part, the contact of the roller
/// with screw and nut, the loads and stresses of the cases with equal shares, and the warnings.
/// Angles are Sandu's theta [deg], lengths in mm. A row is left out where nothing defines it: Hertz
/// constants without materials, backlash where pitches differ. Beyond 24 cases a range shows its
/// first, middle and last point.
std::string contact_table(const Result& result);

}  // namespace prs
