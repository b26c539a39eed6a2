#pragma once

#include "prs/cli/commands.h"

namespace prs::cli {

/// Throws UsageError if the new file exists already, or is standard output that has a document already.
void refuse_taken(const OutputOptions& options, const std::filesystem::path& file);
/// Writes a case into a new file, and says so with the next step; prints it for `-`.
void write_new(const OutputOptions& options, const std::string& file, const std::string& text, const std::string& said);
/// Lists the geometries that a screw diameter and a lead allow.
int configurations(const Options& options);
void add_new_options(CLI::App& command, NewOptions& options);
/// Prints a commented case, or writes it to a new file; or copies a lesson.
int new_case(const Options& options);

}  // namespace prs::cli
