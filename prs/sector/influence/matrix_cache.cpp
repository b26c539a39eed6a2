#include "prs/sector/influence/matrix_cache.h"

#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <compare>
#include <cstdlib>
#include <ctime>
#include <random>
#include <system_error>

#include "prs/bytes.h"
#include "prs/sha256.h"

namespace prs {
namespace {

namespace fs = std::filesystem;

/// Largest number of entries in memory; the oldest is dropped. A screw has about ten.
constexpr std::size_t kMostKept = 512;
constexpr std::size_t kDigestLength = 64;  // Hexadecimal digits of SHA-256.
/// Largest number of rows or columns that is read from a file.
constexpr std::uint64_t kLargestSide = 100'000;

/// Text with key, matrices and, at the end, the digest of both.
std::string encoded(const std::string& key, const MatrixCache::Matrices& matrices) {
  std::string bytes;
  put(bytes, key);
  put(bytes, matrices.size());
  for (const Eigen::MatrixXd& m : matrices) {
    for (const Eigen::Index side : {m.rows(), m.cols()}) put(bytes, static_cast<std::uint64_t>(side));
    bytes.append(reinterpret_cast<const char*>(m.data()), static_cast<std::size_t>(m.size()) * sizeof(double));
  }
  return bytes + sha256(bytes);
}

std::optional<MatrixCache::Matrices> decoded(std::string_view bytes, const std::string& key) {
  if (bytes.size() < kDigestLength) return std::nullopt;
  const std::string_view content = bytes.substr(0, bytes.size() - kDigestLength);
  if (sha256(content) != bytes.substr(content.size())) return std::nullopt;

  Cursor rest(content);
  if (rest.text() != key) return std::nullopt;
  MatrixCache::Matrices matrices;
  for (std::uint64_t left = rest.number(); left > 0; --left) {
    const std::uint64_t rows = rest.number(), columns = rest.number();
    if (rows > kLargestSide || columns > kLargestSide) return std::nullopt;
    const std::string_view raw = rest.text(rows * columns * sizeof(double));
    if (!rest.good()) return std::nullopt;
    Eigen::MatrixXd& m = matrices.emplace_back(rows, columns);
    if (!raw.empty()) std::memcpy(m.data(), raw.data(), raw.size());
    if (!m.allFinite()) return std::nullopt;
  }
  return rest.good() ? std::optional(std::move(matrices)) : std::nullopt;
}

constexpr std::string_view kExtension = ".matrices";

/// Age at which a draft counts as abandoned if the file system has no locks [s].
constexpr std::time_t kLongestWrite = 3600;

std::string name_of(const std::string& digest) { return digest + std::string(kExtension); }

bool starts_as_entry(std::string_view name) {
  return name.size() >= kDigestLength + kExtension.size() &&
         name.find_first_not_of("0123456789abcdef") == kDigestLength &&
         name.substr(kDigestLength).starts_with(kExtension);
}

bool is_entry(std::string_view name) {
  return starts_as_entry(name) && name.size() == kDigestLength + kExtension.size();
}

/// Whether a name is `DIGEST.matrices.RANDOM`.
bool is_draft(std::string_view name) { return starts_as_entry(name) && !is_entry(name); }

std::string random_suffix() {
  std::random_device random;
  return fmt::format(".{:08x}{:08x}{:08x}", random(), random(), random());
}

struct OpenFolder {
  FileDescriptor folder;
  std::string refusal;
};

OpenFolder open_folder(const fs::path& path) {
  struct stat name {
  }, status{};
  OpenFolder opened;
  if (::lstat(path.c_str(), &name) != 0) return opened;
  FileDescriptor folder(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!folder.is_open() || ::fstat(folder.get(), &status) != 0) return opened;
  constexpr std::string_view kInstead = "matrices are kept in memory only";
  if (name.st_uid != ::geteuid() || status.st_uid != ::geteuid())
    opened.refusal = fmt::format(
        "the cache folder '{}' belongs to another user; {}; set PRS_CACHE_DIR to a "
        "folder of your own",
        path.string(), kInstead);
  else if ((status.st_mode & S_IWOTH) != 0)
    opened.refusal = fmt::format(
        "everybody may write into the cache folder '{}'; {}; take that right away (chmod o-w), or "
        "set PRS_CACHE_DIR",
        path.string(), kInstead);
  else
    opened.folder = std::move(folder);
  return opened;
}

/// Opens the folder, creating it if missing.
OpenFolder make_folder(const fs::path& path) {
  std::error_code ignored;
  fs::create_directories(path.parent_path(), ignored);
  ::mkdir(path.c_str(), 0700);
  return open_folder(path);
}

/// Opens a regular file of the user.
std::optional<FileDescriptor> open_own(const FileDescriptor& folder, const std::string& name) {
  RegularFile opened = open_regular(name.c_str(), O_RDONLY, 0, folder.get());
  struct stat status {};
  if (!opened.file.is_open() || ::fstat(opened.file.get(), &status) != 0 || status.st_uid != ::geteuid())
    return std::nullopt;
  return std::move(opened.file);
}

/// Whether a draft is abandoned: writers hold a lock on their drafts, which ends with them.
bool is_left_behind(const FileDescriptor& draft) {
  if (::flock(draft.get(), LOCK_EX | LOCK_NB) == 0) return true;
  if (errno == EWOULDBLOCK) return false;
  struct stat status {};
  return ::fstat(draft.get(), &status) == 0 && std::time(nullptr) - status.st_mtim.tv_sec > kLongestWrite;
}

/// Space of a file of this many bytes, in whole blocks.
std::uintmax_t on_disk(std::uintmax_t bytes) { return (bytes + 4095) / 4096 * 4096; }

struct Entry {
  std::time_t seconds = 0;  ///< Time of the last use.
  long nanoseconds = 0;
  std::string name;
  std::uintmax_t bytes = 0;

  auto operator<=>(const Entry&) const = default;
};

void remove(const FileDescriptor& folder, const std::string& name) { ::unlinkat(folder.get(), name.c_str(), 0); }

std::vector<std::string> names_in(const fs::path& path) {
  std::vector<std::string> names;
  std::error_code ended;
  for (fs::directory_iterator at(path, ended); !ended && at != fs::directory_iterator(); at.increment(ended))
    names.push_back(at->path().filename().string());
  return names;
}

/// Removes abandoned drafts and, of more than `most` bytes, the entries unused for longest.
void clear_up(const FileDescriptor& folder, const fs::path& path, std::uintmax_t most) {
  std::vector<Entry> entries;
  std::uintmax_t total = 0;
  for (const std::string& name : names_in(path)) {
    if (!starts_as_entry(name)) continue;
    struct stat status {};
    if (is_draft(name)) {
      const std::optional<FileDescriptor> draft = open_own(folder, name);
      if (draft && is_left_behind(*draft)) remove(folder, name);
    } else if (::fstatat(folder.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISREG(status.st_mode)) {
      entries.push_back(
          {status.st_mtim.tv_sec, status.st_mtim.tv_nsec, name, on_disk(static_cast<std::uintmax_t>(status.st_size))});
      total += entries.back().bytes;
    }
  }
  std::ranges::sort(entries);
  for (const Entry& entry : entries) {
    if (total <= most) return;
    remove(folder, entry.name);
    total -= entry.bytes;
  }
}

}  // namespace

/// Reports the beginning and the end of a computation.
class MatrixCache::Computation {
 public:
  explicit Computation(MatrixCache& cache) : cache_(cache) { change(1); }
  ~Computation() { change(-1); }
  Computation(const Computation&) = delete;
  Computation& operator=(const Computation&) = delete;

 private:
  void change(int by) {
    const std::lock_guard lock(cache_.mutex_);
    cache_.working_ += by;
    if (by < 0) ++cache_.computed_;
    if (cache_.progress_) cache_.progress_(cache_.working_ > 0, cache_.computed_);
  }

  MatrixCache& cache_;
};

MatrixCache::MatrixCache(const MatrixCache& other, KeptOnly) : computes_(false) {
  const std::lock_guard lock(other.mutex_);
  folder_ = other.folder_;
  kept_ = other.kept_;
}

void MatrixCache::report_to(Progress progress) {
  const std::lock_guard lock(mutex_);
  progress_ = std::move(progress);
}

void MatrixCache::keep_in(fs::path directory) {
  const std::lock_guard lock(mutex_);
  folder_.reset();
  if (!directory.empty()) folder_.emplace(std::move(directory));
}

std::shared_ptr<const MatrixCache::Matrices> MatrixCache::get(const std::string& key,
                                                              const std::function<Matrices()>& compute,
                                                              const std::function<bool(const Matrices&)>& fits) {
  std::optional<CacheFolder> folder;
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = kept_.find(key); found != kept_.end()) return found->second;
    folder = folder_;
  }
  const std::string digest = folder ? sha256(key) : std::string();
  std::optional<Matrices> matrices;
  if (folder)
    if (const std::optional<std::string> bytes = folder->read(digest)) matrices = decoded(*bytes, key);
  if (matrices && fits && !fits(*matrices)) matrices.reset();
  const bool found = matrices.has_value();
  if (!found) {
    if (!computes_) throw NotKept(key);
    const Computation computation(*this);
    matrices = compute();
    if (folder) folder->write(digest, encoded(key, *matrices));
  }

  const std::lock_guard lock(mutex_);
  const auto [entry, is_new] = kept_.try_emplace(key, std::make_shared<const Matrices>(std::move(*matrices)));
  const std::shared_ptr<const Matrices> result = entry->second;
  if (is_new) oldest_first_.push_back(key);
  if (oldest_first_.size() > kMostKept) {
    kept_.erase(oldest_first_.front());
    oldest_first_.erase(oldest_first_.begin());
  }
  return result;
}

int MatrixCache::computed() const {
  const std::lock_guard lock(mutex_);
  return computed_;
}

std::string MatrixCache::refusal() const {
  const std::lock_guard lock(mutex_);
  return folder_ && !kept_.empty() ? folder_->refusal() : std::string();
}

bool have_sizes(const MatrixCache::Matrices& matrices,
                std::initializer_list<std::pair<Eigen::Index, Eigen::Index>> sizes) {
  return std::ranges::equal(matrices, sizes, [](const Eigen::MatrixXd& m, const auto& size) {
    return m.rows() == size.first && m.cols() == size.second;
  });
}

std::filesystem::path cache_directory() {
  if (const char* own = std::getenv("PRS_CACHE_DIR")) return own;
  if (const char* user = std::getenv("XDG_CACHE_HOME"); user && *user == '/')
    return std::filesystem::path(user) / "prs";
  std::error_code error;  // A home that is missing is not created.
  if (const char* home = std::getenv("HOME"); home && *home && fs::is_directory(home, error))
    return fs::path(home) / ".cache" / "prs";
  return {};
}

MatrixCache& shared_matrix_cache() {
  static MatrixCache cache;
  return cache;
}

CacheFolder::CacheFolder(fs::path path, std::uintmax_t most_bytes) : path_(std::move(path)), most_bytes_(most_bytes) {
  // With a slash at its end the path would follow the folder if it is a link.
  if (!path_.empty() && !path_.has_filename()) path_ = path_.parent_path();
}

std::optional<std::string> CacheFolder::read(const std::string& digest) const {
  const OpenFolder opened = open_folder(path_);
  if (!opened.folder.is_open()) return std::nullopt;
  const std::optional<FileDescriptor> file = open_own(opened.folder, name_of(digest));
  if (!file) return std::nullopt;
  ::futimens(file->get(), nullptr);
  return content_of(*file, most_bytes_);
}

void CacheFolder::write(const std::string& digest, std::string_view bytes) const {
  if (on_disk(bytes.size()) > most_bytes_) return;
  const OpenFolder opened = make_folder(path_);
  if (!opened.folder.is_open()) return;
  const int folder = opened.folder.get();
  const std::string draft = name_of(digest) + random_suffix();
  FileDescriptor file(::openat(folder, draft.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600));
  if (!file.is_open()) return;
  ::flock(file.get(), LOCK_EX | LOCK_NB);
  if (write_all(file, bytes) != 0 || ::renameat(folder, draft.c_str(), folder, name_of(digest).c_str()) != 0)
    remove(opened.folder, draft);
  clear_up(opened.folder, path_, most_bytes_);
}

std::string CacheFolder::refusal() const { return open_folder(path_).refusal; }

}  // namespace prs
