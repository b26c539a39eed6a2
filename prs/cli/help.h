#pragma once

#include "prs/cli/command_line.h"

namespace prs::cli {

/// Last word of a name: `merge` of `prs study merge`.
std::string last_word(const CommandText& command);

/// `prs solve [OPTIONS] FILE`.
std::string usage(const CommandText& command);

/// Output of `prs help COMMAND`.
std::string help_text(const CommandText& command);

/// Help for programs: names, arguments, options and commands, each with its help.
nlohmann::ordered_json help_json(const CommandText& command);

/// The commands by purpose: output of the program without arguments.
std::string overview(const CommandText& program);

/// The manual page of a command in roff, as `man -l` reads it.
std::string manual_page(const CommandText& command, std::string_view version);

/// File name of the manual page: `prs-study-merge.1`.
std::string manual_file(const CommandText& command);

}  // namespace prs::cli
