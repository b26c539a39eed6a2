#pragma once

#include "prs/cli/printing.h"
#include "prs/record/delivery.h"

namespace prs::cli {

/// A text of lines as a note; none where it is empty.
std::vector<std::string> notes_of(std::string text);

/// Writes the files and pictures of a result, prints its document or table, and returns the exit
/// status of the program.
int deliver(const Delivery& delivery, const DocumentInfo& info, const OutputOptions& options);

}  // namespace prs::cli
