#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace prs {

/// Files that later runs find again, in a folder of the user's own.
///
/// Other users can neither redirect what is written nor provide what is read: drafts are new files that only the user
/// may read, symbolic links are not followed, and only regular files of the user count. A folder that belongs to
/// another user, or that everybody may write into, is not used.
class CacheFolder {
 public:
  /// Largest space on the disk of all files together, some 400 screws; beyond it the files unused for longest are
  /// removed.
  static constexpr std::uintmax_t kMostBytes = std::uintmax_t{64} << 20;

  explicit CacheFolder(std::filesystem::path path, std::uintmax_t most_bytes = kMostBytes);

  /// Reads the file of a digest (64 hexadecimal digits) and marks it as used now.
  std::optional<std::string> read(const std::string& digest) const;

  /// Writes a file completely or not at all, also if others write the same one; errors are ignored. Removes files
  /// beyond the bound, and the drafts of processes that have ended.
  void write(const std::string& digest, std::string_view bytes) const;

  /// Reason why the folder is not used and how to fix it, one line; empty if it is used, or is absent.
  std::string refusal() const;

 private:
  std::filesystem::path path_;
  std::uintmax_t most_bytes_;
};

/// Error: a cache that must not compute lacks the matrices.
class NotKept : public std::runtime_error {
 public:
  explicit NotKept(std::string key)
      : std::runtime_error("matrices of `influence` that are not kept"), key_(std::move(key)) {}
  const std::string& key() const { return key_; }

 private:
  std::string key_;
};

/// Expensive matrices, kept under the text of all that they depend on: in memory and, if a directory is given, in a
/// CacheFolder there that later runs find by the text's SHA-256. A file that is damaged or belongs to another text
/// counts as absent; errors of writing are ignored. May be used from several threads.
class MatrixCache {
 public:
  using Matrices = std::vector<Eigen::MatrixXd>;

  /// Keeps nothing in files if `directory` is empty.
  explicit MatrixCache(std::filesystem::path directory = {}) { keep_in(std::move(directory)); }

  /// Selects the contents of another cache, in memory and in files, without computing: absent matrices throw NotKept.
  struct KeptOnly {};
  MatrixCache(const MatrixCache& other, KeptOnly);

  void keep_in(std::filesystem::path directory);

  /// Callback, from any thread, when a computation begins or ends: whether one still goes on, and how many have ended.
  using Progress = std::function<void(bool working, int computed)>;
  void report_to(Progress progress);

  /// Matrices kept under `key`, else the result of `compute`, which is then kept. Matrices of a file count only if they
  /// satisfy `fits`: anybody may have made a file, whatever its key says.
  std::shared_ptr<const Matrices> get(const std::string& key, const std::function<Matrices()>& compute,
                                      const std::function<bool(const Matrices&)>& fits = {});

  /// Number of matrices computed so far, found neither in memory nor in a file.
  int computed() const;

  /// Reason why matrices were not looked up in files, one line; empty if they were.
  std::string refusal() const;

  /// Locks the cache, so that no thread is within it and the process may fork.
  void lock() { mutex_.lock(); }
  void unlock() { mutex_.unlock(); }

 private:
  class Computation;

  mutable std::mutex mutex_;
  bool computes_ = true;
  Progress progress_;
  int working_ = 0;
  std::optional<CacheFolder> folder_;
  std::map<std::string, std::shared_ptr<const Matrices>> kept_;
  std::vector<std::string> oldest_first_;
  int computed_ = 0;
};

/// Whether there is this number of matrices, each of these rows and columns.
bool have_sizes(const MatrixCache::Matrices& matrices,
                std::initializer_list<std::pair<Eigen::Index, Eigen::Index>> sizes);

/// Folder in which bodies are kept between runs: PRS_CACHE_DIR (empty: none), else the user's cache.
std::filesystem::path cache_directory();

/// The cache shared by the program's commands.
MatrixCache& shared_matrix_cache();

}  // namespace prs
