#pragma once

#include "prs/input/source.h"
#include "prs/model/life.h"
#include "prs/model/load_history.h"

namespace prs::input {

/// Reads the columns of a history from a text of comma-separated values, see `CsvReader`: the first
/// row is the heading, every further row a sample; numbers have a decimal point. `name` stands
/// for the file in messages, `source` is the input that names columns and units under
/// `life.history`.
///
/// Throws InputError: `FILE:LINE:COLUMN: error: NAME: got VALUE; expected ..` for a value that is
/// not a finite number and for time that runs backwards; at the place in the input for a column
/// that the file lacks and for a unit that does not fit.
LoadHistory parse_force_history(std::string_view text, const std::string& name,
                                const HistorySource& history, const Source& source);

/// The file that the history names, relative to the input file: at most 1 GiB. It must lie in the
/// folder of the input or below it, links followed, unless an override names it: inputs come from
/// others too; with its SHA-256 it may stand anywhere. Throws InputError, also for another hash.
std::string force_history_text(const HistorySource& history, const Source& source);

/// Where that file stands, absolute; its name where there is no folder to find it in.
std::filesystem::path place_of_history(const HistorySource& history, const Source& source);

/// The source with the text of that file, which no run reads again.
Source with_files(Source source, const HistorySource& history);

/// The history of that file.
LoadHistory read_force_history(const HistorySource& history, const Source& source);

}  // namespace prs::input
