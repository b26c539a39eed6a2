#include "prs/sector/influence/matrix_cache.h"

#include <algorithm>
#include <cstdlib>

#include "prs/bytes.h"
#include "prs/sha256.h"

namespace prs {
namespace {

namespace fs = std::filesystem;

/// Entries in memory; the oldest gives way. A screw has about ten.
constexpr std::size_t kMostKept = 512;
constexpr std::size_t kDigestLength = 64;
constexpr std::uint64_t kLargestSide = 100'000;

/// Key, matrices and, at the end, the digest of both.
std::string encoded(const std::string& key, const MatrixCache::Matrices& matrices) {
  std::string bytes;
  put(bytes, key);
  put(bytes, matrices.size());
  for (const Eigen::MatrixXd& m : matrices) {
    for (const Eigen::Index side : {m.rows(), m.cols()})
      put(bytes, static_cast<std::uint64_t>(side));
    bytes.append(reinterpret_cast<const char*>(m.data()),
                 static_cast<std::size_t>(m.size()) * sizeof(double));
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

}  // namespace

/// Says when it begins and when it ends.
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

std::shared_ptr<const MatrixCache::Matrices> MatrixCache::get(
    const std::string& key, const std::function<Matrices()>& compute,
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
    if (const std::optional<std::string> bytes = folder->read(digest))
      matrices = decoded(*bytes, key);
  if (matrices && fits && !fits(*matrices)) matrices.reset();
  const bool found = matrices.has_value();
  if (!found) {
    if (!computes_) throw NotKept(key);
    const Computation computation(*this);
    matrices = compute();
    if (folder) folder->write(digest, encoded(key, *matrices));
  }

  const std::lock_guard lock(mutex_);
  const auto [entry, is_new] =
      kept_.try_emplace(key, std::make_shared<const Matrices>(std::move(*matrices)));
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
  if (const char* home = std::getenv("HOME"); home && *home)
    return std::filesystem::path(home) / ".cache" / "prs";
  return {};
}

MatrixCache& shared_matrix_cache() {
  static MatrixCache cache;
  return cache;
}

}  // namespace prs
