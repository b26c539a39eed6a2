#pragma once

#include "prs/cli/commands.h"

namespace prs::cli {

/// Lists the geometries that a screw diameter and a lead allow.
int configurations(const Options& options);
void add_new_options(CLI::App& command, NewOptions& options);
/// Prints a commented case, or writes it to a new file; or copies a lesson.
int new_case(const Options& options);

}  // namespace prs::cli
