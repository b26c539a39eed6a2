#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "prs/input/source.h"

namespace prs::cli {

/// Folder of data that comes with the program: `lessons` or `validation`. It is searched in the folder named by
/// PRS_SHARE, else in `../share/prs` beside this program's folder, for programs in `libexec/prs` in `../../share/prs`.
/// A build folder has links there to the sources. Throws std::runtime_error if there is none.
std::filesystem::path data_folder(const std::string& name);

/// Folder of the engine and the scripts of live pages, `web`, in the same places; empty if there is none.
std::filesystem::path live_parts_folder();

/// A numbered example case.
struct Lesson {
  std::string name;   ///< `14_flight_spectrum`
  std::string title;  ///< `life under a flight's loads`, without a full stop.
  std::filesystem::path file;

  int number() const { return std::stoi(name); }
};

/// All lessons in the order of their numbers.
std::vector<Lesson> lessons();

/// The lesson with a number or a name, `14`, `14_flight_spectrum` or `flight_spectrum`. Throws InputError if there is
/// none.
Lesson lesson(const std::string& asked);

/// Files that a case or a requirement reads, by the names in it.
std::vector<std::string> companions(const input::Source& source);

}  // namespace prs::cli
