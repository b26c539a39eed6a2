#pragma once

#include "prs/input/source.h"

namespace prs {

/// The text of a source with its overrides, and more of them, written into it, and `remark` as its
/// first line. Values take the place of those in the file, or are added to it, and nothing else of
/// the text changes. Where that would not give the document that the overrides mean, as with
/// aliases, it is written anew, without comments.
std::string case_with(const input::Source& source, const std::vector<std::string>& overrides,
                      const std::string& remark);

}  // namespace prs
