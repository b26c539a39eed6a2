#pragma once

#include "prs/output/files.h"

namespace prs {

/// A ZIP archive of files as they are, without compression; the same files give the same bytes.
/// Names are ASCII with `/` between folders, and of at most 65,535 files of less than 4 GiB in all.
std::string zip(const std::vector<OutputFile>& files);

}  // namespace prs
