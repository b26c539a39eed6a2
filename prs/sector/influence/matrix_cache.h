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

/// Matrices that a cache was asked for, which does not make them.
class NotKept : public std::runtime_error {
 public:
  explicit NotKept(std::string key)
      : std::runtime_error("matrices of `influence` that are not kept"), key_(std::move(key)) {}
  const std::string& key() const { return key_; }

 private:
  std::string key_;
};

/// Matrices that are dear to compute, kept under the text of all that they depend on: in memory
/// and, where a directory is given, in a CacheFolder there that later runs find by the text's
/// SHA-256. A file that is damaged or belongs to another text counts as absent; one that cannot be
/// written is left out. May be used from several threads.
class MatrixCache {
 public:
  using Matrices = std::vector<Eigen::MatrixXd>;

  /// Keeps nothing in files where `directory` is empty.
  explicit MatrixCache(std::filesystem::path directory = {}) { keep_in(std::move(directory)); }

  /// What another cache holds, in memory and in files, and no more: what is absent is NotKept.
  struct KeptOnly {};
  MatrixCache(const MatrixCache& other, KeptOnly);

  void keep_in(std::filesystem::path directory);

  /// Is called, from any thread, when a computation begins and when one ends: whether one still
  /// goes on, and how many have ended.
  using Progress = std::function<void(bool working, int computed)>;
  void report_to(Progress progress);

  /// What is kept under `key`, else the result of `compute`, which is kept from then on. What a
  /// file holds counts only if it `fits`: whatever its key says, anybody may have made it.
  std::shared_ptr<const Matrices> get(const std::string& key, const std::function<Matrices()>& compute,
                                      const std::function<bool(const Matrices&)>& fits = {});

  /// Matrices computed so far, found neither in memory nor in a file.
  int computed() const;

  /// Why what was asked for was not looked up in files, one line; empty where it was.
  std::string refusal() const;

  /// No thread is within the cache while it is locked, so that the process may fork.
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

/// Whether there are so many matrices, each of these rows and columns.
bool have_sizes(const MatrixCache::Matrices& matrices,
                std::initializer_list<std::pair<Eigen::Index, Eigen::Index>> sizes);

/// Folder in which bodies are kept between runs: PRS_CACHE_DIR (empty: nowhere), else the user's cache.
std::filesystem::path cache_directory();

/// The cache that the program's commands share.
MatrixCache& shared_matrix_cache();

}  // namespace prs
