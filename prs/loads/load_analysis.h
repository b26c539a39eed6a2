#pragma once

#include <initializer_list>

#include "prs/loads/analysis_options.h"
#include "prs/loads/result.h"
#include "prs/record/analysis.h"

namespace prs {

/// Adds the contacts, under `contact`, and the threads by themselves, under `threads`, as in every document; no threads
/// if no heights are given.
void put_contacts(Json& document, const Contacts& contacts);

/// Adds contacts and model, and an empty list for the load cases.
void put_loads(Json& document, const Result& result);
/// Document of a load case: units are in the keys, arrays start at the thread next to the loaded end of the screw.
/// Undefined and non-finite numbers are omitted. Absent after the last load case.
std::optional<Json> load_case_json(const Result& result, std::size_t k);

/// `places` after those of contacts and loads.
std::vector<Place> with_loads(std::initializer_list<Place> places = {});
/// `places` after those of contacts.
std::vector<Place> with_contacts(std::initializer_list<Place> places);

/// The analysis of the command `contact`.
const Analysis<Result>& contact_analysis();

bool all_converged(const Result& result);

/// Warnings of a result for the terminal, each once with its load cases.
std::vector<std::string> summary_of_warnings(const Result& result);

/// Largest number of load cases that a terminal shows thread by thread; points of a range are not.
inline constexpr std::size_t kMostCharts = 1;

/// Tables of load cases and of their threads, as `solve` writes them.
std::vector<OutputFile> load_files(const Result& result, const CsvStyle& style);

/// Overview of the load cases: one row per case and the warnings below, usually within `kTableWidth` columns. Beyond 24
/// cases a range shows its first, middle and last point.
std::string load_case_table(const Result& result);

/// One case thread by thread: the load rate at both interfaces [%] as bars. For a failed case one line with the reason.
std::string load_distribution_chart(const LoadCaseResult& result);

/// `load_cases.csv`: one row per load case, failed ones included. Units are in the header, a field is empty if the case
/// does not define it. Quoted as in RFC 4180.
std::string load_cases_csv(const Result& result, const CsvStyle& style = {});

/// `load_distribution.csv`: one row per thread of every load case with a result.
std::string load_distribution_csv(const Result& result, const CsvStyle& style = {});

/// `travel.csv`, one row per position of each load case, and `travel_loads.csv`, one row per thread; none without a
/// travel.
std::vector<OutputFile> travel_files(const Result& result, const CsvStyle& style);

/// Lowest frequency and the speeds at which orders of the parts meet it, if masses are stated.
std::vector<Headline> frequencies(const Result& result);

/// Table of the threads, within 100 columns: the mechanism part by part, the contact of the roller with screw and nut,
/// the loads and stresses of the cases with equal shares, and the warnings. Angles are Sandu's theta [deg], lengths in
/// mm. Undefined rows are left out: Hertz constants without materials, backlash if pitches differ. Beyond 24 cases a
/// range shows its first, middle and last point.
std::string contact_table(const Result& result);

}  // namespace prs
