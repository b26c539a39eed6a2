#pragma once

#include <string_view>

#include "prs/model/check_case.h"

namespace prs {

/// As it stands on the command line and in studies.
constexpr std::string_view name(Command command) {
  switch (command) {
    case Command::check:
      return "check";
    case Command::contact:
      return "contact";
    case Command::solve:
      return "solve";
    case Command::slip:
      return "slip";
    case Command::preload:
      return "preload";
    case Command::life:
      return "life";
    case Command::measures:
      break;
  }
  return "measures";
}

}  // namespace prs
