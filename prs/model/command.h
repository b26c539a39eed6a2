#pragma once

#include <string_view>

namespace prs {

/// Commands that the program can run on a case.
enum class Command {
  check,
  contact,
  solve,
  compare,
  slip,
  preload,
  life,
  measures,
  study,
  optimize
};

inline constexpr std::string_view kCommandNames[] = {"check", "contact", "solve", "compare",
                                                     "slip",  "preload", "life",  "measures",
                                                     "study", "optimize"};

/// Name on the command line and in studies.
constexpr std::string_view name(Command command) {
  return kCommandNames[static_cast<int>(command)];
}

}  // namespace prs
