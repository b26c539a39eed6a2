#pragma once

#include <filesystem>
#include <string>

namespace prs {

/// Identity of the sources of this program and of its pages (cmake/source_id.cmake).
std::string source_id();

/// Files that make a page live and that no compiler of the program writes: `scripts/web.sh` builds them.
struct LiveParts {
  std::string engine = {};  ///< The module of WebAssembly, packed as .lzma.
  std::string worker = {};  ///< Script in which the engine answers questions.
  std::string start = {};   ///< Script that unpacks the others.
  /// A script packed by gzip, and the hash of its text by which policies of pages name it.
  struct Packed {
    std::string script = {}, hash = {};
  };
  Packed report = {}, mechanism = {}, workbench = {};
  /// Why there are no parts, and how to get them; empty where they are complete.
  std::string absent = {};
};

/// Reads the parts in `folder`, which may be absent. Parts of other sources than those of this program are
/// refused: `absent` says so. Throws std::system_error where the machine lacks descriptors or memory to open them.
LiveParts read_live_parts(const std::filesystem::path& folder);

}  // namespace prs
