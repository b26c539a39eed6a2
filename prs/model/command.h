#pragma once

#include <compare>
#include <string_view>

namespace prs {

struct Case;
class Problems;

/// A command that the program runs on a case: its name on the command line and in studies, and the inputs it needs.
struct Command {
  std::string_view word;
  /// Adds inputs that the case lacks: each with the block to add and an example.
  void (*needs)(const Case&, Problems&) = nullptr;
  /// Whether the loads of threads that it takes are those of a running screw; none where it takes none.
  bool (*takes_running_loads)(const Case&) = nullptr;

  // Commands that other sources name. Blocks of searches: see input::unmet.
  static const Command check, contact, solve, compare, slip, preload, life, measures, response, study, optimize, fit,
      size;

  friend constexpr bool operator==(const Command& a, const Command& b) { return a.word == b.word; }
  friend constexpr auto operator<=>(const Command& a, const Command& b) { return a.word <=> b.word; }
};

// Requirements of the commands, see check_case.cpp and load_case_check.cpp.
void need_solve(const Case& c, Problems& problems);
void need_compare(const Case& c, Problems& problems);
void need_slip(const Case& c, Problems& problems);
void need_preload(const Case& c, Problems& problems);
void need_life(const Case& c, Problems& problems);
void need_measures(const Case& c, Problems& problems);
void need_response(const Case& c, Problems& problems);

inline bool takes_loads_at_rest(const Case&) { return false; }
bool solve_takes_running_loads(const Case& c);
bool slip_takes_running_loads(const Case& c);
bool life_takes_running_loads(const Case& c);

inline constexpr Command Command::check{"check"};
inline constexpr Command Command::contact{"contact", nullptr, takes_loads_at_rest};
inline constexpr Command Command::solve{"solve", need_solve, solve_takes_running_loads};
inline constexpr Command Command::compare{"compare", need_compare, takes_loads_at_rest};
inline constexpr Command Command::slip{"slip", need_slip, slip_takes_running_loads};
inline constexpr Command Command::preload{"preload", need_preload, takes_loads_at_rest};
inline constexpr Command Command::life{"life", need_life, life_takes_running_loads};
inline constexpr Command Command::measures{"measures", need_measures, takes_loads_at_rest};
inline constexpr Command Command::response{"response", need_response};
inline constexpr Command Command::study{"study"};
inline constexpr Command Command::optimize{"optimize"};
inline constexpr Command Command::fit{"fit"};
inline constexpr Command Command::size{"size"};

constexpr std::string_view name(Command command) { return command.word; }

}  // namespace prs
