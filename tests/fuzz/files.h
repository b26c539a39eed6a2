#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "prs/bytes.h"
#include "support/temporary_directory.h"

namespace prs::fuzz {

/// Texts, each after its length; the last one may be cut short.
inline std::vector<std::string> pieces(std::string_view input, std::size_t most) {
  std::vector<std::string> found;
  for (Cursor rest(input); found.size() < most && rest.good() && !rest.at_end();) {
    const std::string_view left = input.substr(std::min<std::size_t>(input.size(), 8));
    const std::uint64_t length = rest.number();
    if (!rest.good()) break;
    found.emplace_back(rest.text(std::min<std::uint64_t>(length, left.size())));
    input = left.substr(found.back().size());
    rest = Cursor(input);
  }
  return found;
}

inline std::string joined(const std::vector<std::string>& pieces) {
  std::string bytes;
  for (const std::string& piece : pieces) put(bytes, piece);
  return bytes;
}

/// A folder for the files of one input after the other.
inline const std::filesystem::path& scratch_folder() {
  static const test::TemporaryDirectory folder;
  return folder.path();
}

inline void write_bytes(const std::filesystem::path& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace prs::fuzz
