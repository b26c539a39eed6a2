#pragma once

#include "prs/input/source.h"
#include "prs/input/units.h"
#include "prs/model/load_case.h"

namespace prs::input {

/// Reads the columns of a history from a text of comma-separated values, see `CsvReader`: the first
/// row is the heading, every further row a sample; numbers have a decimal point. `name` is the
/// file name in messages, `source` is the input that names columns and units under
/// `life.history`.
///
/// Throws InputError: `FILE:LINE:COLUMN: error: NAME: got VALUE; expected ..` for a value that is
/// not a finite number and for time that runs backwards; at the place in the input for a column
/// that the file lacks and for a unit that does not fit.
LoadHistory parse_force_history(std::string_view text, const std::string& name, const HistorySource& history,
                                const Source& source);

/// A column of such a table: the places of its name and unit in the input, and its destination.
struct WantedColumn {
  std::string_view key;  ///< Key below `block`: `force`.
  const CsvColumn* name;
  const Dimension* dimension;
  std::vector<double>* values;  ///< SI
  double factor = 1.0;
  std::size_t field = 0;
};

/// Reads columns of a table, as named in a block of the input such as `life.history`, like `parse_force_history`.
void read_columns(std::string_view text, const std::string& name, std::string_view block,
                  std::vector<WantedColumn>& columns, const Source& source);

/// Text of the file that the input names at a path, relative to the input file: at most 1 GiB. It must lie in the
/// folder of the input or below it, links followed, unless an override names it or it `may_stand_anywhere`: inputs may
/// come from others. Throws InputError.
std::string named_file_text(const std::string& file, std::string_view path, const Source& source,
                            bool may_stand_anywhere = false);
/// Text of a history's file; with its SHA-256 it may be anywhere. Throws InputError, also for a different hash.
std::string force_history_text(const HistorySource& history, const Source& source);
/// The name of such a file in messages.
std::string name_in_messages(const std::string& file, const Source& source);

/// Absolute path of a file that the input names; the name if there is no folder to find it in.
std::filesystem::path place_of_file(const std::string& name, const Source& source);

/// The source together with the text of the history's file, so that no run reads it again.
Source with_files(Source source, const HistorySource& history);

/// Reads the history from its file.
LoadHistory read_force_history(const HistorySource& history, const Source& source);

}  // namespace prs::input
