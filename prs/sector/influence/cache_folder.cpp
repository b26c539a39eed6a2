#include "prs/sector/influence/cache_folder.h"

#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <algorithm>
#include <compare>
#include <ctime>
#include <random>
#include <system_error>
#include <vector>

#include "prs/regular_file.h"

namespace prs {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDigits = 64;
constexpr std::string_view kExtension = ".matrices";

/// Age of a draft that counts as left behind where the file system has no locks [s].
constexpr std::time_t kLongestWrite = 3600;

std::string name_of(const std::string& digest) { return digest + std::string(kExtension); }

bool starts_as_entry(std::string_view name) {
  return name.size() >= kDigits + kExtension.size() &&
         name.find_first_not_of("0123456789abcdef") == kDigits &&
         name.substr(kDigits).starts_with(kExtension);
}

bool is_entry(std::string_view name) {
  return starts_as_entry(name) && name.size() == kDigits + kExtension.size();
}

/// `DIGEST.matrices.RANDOM`.
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

/// The folder, made where it is missing.
OpenFolder make_folder(const fs::path& path) {
  std::error_code ignored;
  fs::create_directories(path.parent_path(), ignored);
  ::mkdir(path.c_str(), 0700);
  return open_folder(path);
}

/// A regular file of the user.
std::optional<FileDescriptor> open_own(const FileDescriptor& folder, const std::string& name) {
  RegularFile opened = open_regular(name.c_str(), O_RDONLY, 0, folder.get());
  struct stat status {};
  if (!opened.file.is_open() || ::fstat(opened.file.get(), &status) != 0 ||
      status.st_uid != ::geteuid())
    return std::nullopt;
  return std::move(opened.file);
}

/// Writers hold a lock on their drafts, which ends with them.
bool is_left_behind(const FileDescriptor& draft) {
  if (::flock(draft.get(), LOCK_EX | LOCK_NB) == 0) return true;
  if (errno == EWOULDBLOCK) return false;
  struct stat status {};
  return ::fstat(draft.get(), &status) == 0 &&
         std::time(nullptr) - status.st_mtim.tv_sec > kLongestWrite;
}

/// What a file of so many bytes takes, in whole blocks.
std::uintmax_t on_disk(std::uintmax_t bytes) { return (bytes + 4095) / 4096 * 4096; }

struct Entry {
  std::time_t seconds = 0;  ///< When it was used last.
  long nanoseconds = 0;
  std::string name;
  std::uintmax_t bytes = 0;

  auto operator<=>(const Entry&) const = default;
};

void remove(const FileDescriptor& folder, const std::string& name) {
  ::unlinkat(folder.get(), name.c_str(), 0);
}

std::vector<std::string> names_in(const fs::path& path) {
  std::vector<std::string> names;
  std::error_code ended;
  for (fs::directory_iterator at(path, ended); !ended && at != fs::directory_iterator();
       at.increment(ended))
    names.push_back(at->path().filename().string());
  return names;
}

/// Drafts that were left behind, and what was not used for longest of more than `most` bytes.
void clear_up(const FileDescriptor& folder, const fs::path& path, std::uintmax_t most) {
  std::vector<Entry> entries;
  std::uintmax_t total = 0;
  for (const std::string& name : names_in(path)) {
    if (!starts_as_entry(name)) continue;
    struct stat status {};
    if (is_draft(name)) {
      const std::optional<FileDescriptor> draft = open_own(folder, name);
      if (draft && is_left_behind(*draft)) remove(folder, name);
    } else if (::fstatat(folder.get(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 &&
               S_ISREG(status.st_mode)) {
      entries.push_back({status.st_mtim.tv_sec, status.st_mtim.tv_nsec, name,
                         on_disk(static_cast<std::uintmax_t>(status.st_size))});
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

CacheFolder::CacheFolder(fs::path path, std::uintmax_t most_bytes)
    : path_(std::move(path)), most_bytes_(most_bytes) {
  // A slash at its end would follow the folder where it is a link.
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
  FileDescriptor file(
      ::openat(folder, draft.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600));
  if (!file.is_open()) return;
  ::flock(file.get(), LOCK_EX | LOCK_NB);
  if (write_all(file, bytes) != 0 ||
      ::renameat(folder, draft.c_str(), folder, name_of(digest).c_str()) != 0)
    remove(opened.folder, draft);
  clear_up(opened.folder, path_, most_bytes_);
}

std::string CacheFolder::refusal() const { return open_folder(path_).refusal; }

}  // namespace prs
