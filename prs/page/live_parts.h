#pragma once

#include <filesystem>
#include <string>

namespace prs {

/// Identity of the sources of this program and of its pages (cmake/source_id.cmake).
std::string source_id();

/// Files that make a page live but are not compiled with the program: `scripts/web.sh` builds them.
struct LiveParts {
  std::string engine = {};  ///< WebAssembly module, packed as .lzma.
  std::string worker = {};  ///< Script in which the engine answers questions.
  std::string start = {};   ///< Script that unpacks the others.
  /// A script packed by gzip, and the hash of its text, which policies of pages contain.
  struct Packed {
    std::string script = {}, hash = {};
  };
  Packed report = {}, mechanism = {}, workbench = {};
  /// Reason why there are no parts, and how to get them; empty if they are complete.
  std::string absent = {};
};

/// Reads the parts in `folder`, which may be absent. Parts of other sources than those of this program are refused:
/// `absent` says so. Throws std::system_error if the machine lacks descriptors or memory to open them.
LiveParts read_live_parts(const std::filesystem::path& folder);

}  // namespace prs
