#pragma once

#include "prs/output/files.h"

namespace prs {

/// A ZIP archive of uncompressed files; the same files give the same bytes. Names are ASCII with `/` between folders;
/// at most 65,535 files of less than 4 GiB in all.
std::string zip(const std::vector<OutputFile>& files);

}  // namespace prs
