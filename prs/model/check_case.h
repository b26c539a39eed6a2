#pragma once

#include <string>
#include <vector>

#include "prs/model/case.h"

namespace prs {

/// What is wrong with one value of a case.
struct Problem {
  std::string path;     ///< Key path in the input: `structure.nut.length`.
  std::string message;  ///< `got VALUE; expected WHAT; how to fix it`
};

/// What the program is asked to do with a case.
enum class Command { check, contact, solve, slip, preload, life, measures };

/// Values that contradict each other or that no mechanism can have. Each value is taken to lie in
/// its own bounds, as the reader of the input makes sure. At most one problem for each path.
std::vector<Problem> check_case(const Case& c);

/// What a command needs and the case lacks.
std::vector<Problem> check_requirements(const Case& c, Command command);

}  // namespace prs
