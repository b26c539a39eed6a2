#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "prs/cli/command_line.h"

namespace prs::cli {

/// `prs solve [OPTIONS] FILE`.
std::string usage(const CommandText& command);

/// What `prs help COMMAND` prints.
std::string help_text(const CommandText& command);

/// The same for programs: names, arguments, options and commands, each with its help.
nlohmann::ordered_json help_json(const CommandText& command);

/// The commands by purpose: what the program says that got nothing to do.
std::string overview(const CommandText& program);

/// The manual page of a command in roff, as `man -l` reads it.
std::string manual_page(const CommandText& command, std::string_view version);

/// File of the manual page: `prs-study-merge.1`.
std::string manual_file(const CommandText& command);

}  // namespace prs::cli
