#pragma once

#include <fcntl.h>
#include <sys/types.h>

#include <optional>
#include <string>

#include "prs/file_descriptor.h"

namespace prs {

/// A regular file that was opened, or why there is none.
struct RegularFile {
  FileDescriptor file;
  int error = 0;  ///< System's error number; 0 where the file is open.
  std::string_view
      obstacle;  ///< What stands there in place of a file: "a symbolic link", "a pipe".
};

/// Opens `path`, of `folder` where it is relative, as ::openat does, but nothing other than a
/// regular file: a symbolic link at the end of the path is not followed, a pipe not waited for.
RegularFile open_regular(const char* path, int flags, mode_t mode = 0, int folder = AT_FDCWD);

/// All bytes of an open file from its beginning, absent where it has more than `most` or cannot be
/// read.
std::optional<std::string> content_of(const FileDescriptor& file, std::size_t most);

}  // namespace prs
