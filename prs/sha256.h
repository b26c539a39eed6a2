#pragma once

#include "prs/file_descriptor.h"

namespace prs {

/// SHA-256 of the bytes, 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

/// SHA-256 of an open file from its beginning; absent if it cannot be read.
std::optional<std::string> sha256(const FileDescriptor& file);

}  // namespace prs
