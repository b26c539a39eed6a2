#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace prs {

/// Files that later runs find again, in a folder of the user's own.
///
/// Nobody else redirects what is written or provides what is read: drafts are new files that only
/// the user may read, symbolic links are not followed, and only regular files of the user count. A
/// folder that belongs to another user, or that everybody may write into, is not used.
class CacheFolder {
 public:
  /// On the disk, of all files together, some 400 screws; beyond it those go first that were not
  /// used for longest.
  static constexpr std::uintmax_t kMostBytes = std::uintmax_t{64} << 20;

  explicit CacheFolder(std::filesystem::path path, std::uintmax_t most_bytes = kMostBytes);

  /// The file of that digest (64 hexadecimal digits), which counts as used now.
  std::optional<std::string> read(const std::string& digest) const;

  /// Complete or not at all, whoever else writes the same file; what cannot be written is left out.
  /// Removes what is beyond the bound, and the drafts of processes that are gone.
  void write(const std::string& digest, std::string_view bytes) const;

  /// Why the folder is not used and what to do, one line; empty if it is, or is absent.
  std::string refusal() const;

 private:
  std::filesystem::path path_;
  std::uintmax_t most_bytes_;
};

}  // namespace prs
