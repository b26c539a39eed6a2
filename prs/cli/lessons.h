#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace prs::cli {

/// A numbered case that teaches.
struct Lesson {
  std::string name;   ///< `14_flight_spectrum`
  std::string title;  ///< `life under a flight's loads`, without a point at its end.
  std::filesystem::path file;

  int number() const { return std::stoi(name); }
};

/// All lessons in the order of their numbers.
std::vector<Lesson> lessons();

/// The lesson with a number or a name, `14`, `14_flight_spectrum` or `flight_spectrum`. Throws
/// InputError where there is none.
Lesson lesson(const std::string& asked);

/// The files beside a lesson that it reads, by the names that it has for them.
std::vector<std::string> companions(const Lesson& lesson);

}  // namespace prs::cli
