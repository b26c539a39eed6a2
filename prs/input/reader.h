#pragma once

#include <string>
#include <vector>

#include "prs/case.h"
#include "prs/check_case.h"
#include "prs/input/echo.h"
#include "prs/input/source.h"

namespace prs::input {

/// A case and every value that it consists of, defaults included.
struct CaseInput {
  Case values;
  std::vector<EchoEntry> fields;
};

/// Reads and checks the input of a command. Throws InputError, which names every error found.
///
/// Ranges of load cases are expanded.
CaseInput read_case_input(const Source& source, Command command);

/// The same, values only. `overrides`: `path=value` each.
Case read_case(const std::string& file, const std::vector<std::string>& overrides, Command command);

/// The same from a text; `name` stands for the file in messages.
Case read_case_text(const std::string& text, const std::string& name,
                    const std::vector<std::string>& overrides, Command command);

}  // namespace prs::input
