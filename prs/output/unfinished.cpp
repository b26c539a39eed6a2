#include "prs/output/unfinished.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <utility>

namespace prs {
namespace {

/// More at once are not in the list, and left where a signal ends the program.
std::array<std::atomic<const char*>, 512> paths;
std::atomic<bool> ending;

void remove_path(const char* path) {
  if (::unlink(path) != 0) ::rmdir(path);
}

/// Who removes paths reads them until the end.
void wait_if_ending() {
  while (ending) ::pause();
}

}  // namespace

SignalsHeld::SignalsHeld() {
  sigset_t all;
  sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before_);
}

SignalsHeld::~SignalsHeld() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

UnfinishedPath::UnfinishedPath(const std::filesystem::path& path)
    : path_(std::make_unique<std::string>(path.string())) {
  for (auto& slot : paths) {
    const char* free = nullptr;
    if (slot.compare_exchange_strong(free, path_->c_str())) break;
  }
  if (ending) remove_path(path_->c_str());
  wait_if_ending();
}

UnfinishedPath::UnfinishedPath(UnfinishedPath&& other) noexcept = default;

UnfinishedPath& UnfinishedPath::operator=(UnfinishedPath&& other) noexcept {
  std::swap(path_, other.path_);
  return *this;
}

UnfinishedPath::~UnfinishedPath() {
  if (!path_) return;
  for (auto& slot : paths) {
    const char* known = path_->c_str();
    if (slot.compare_exchange_strong(known, nullptr)) break;
  }
  wait_if_ending();
}

void remove_unfinished() noexcept {
  ending = true;
  for (const auto remove : {::unlink, ::rmdir})  // Folders when they are empty.
    for (const auto& path : paths)
      if (const char* name = path) remove(name);
}

}  // namespace prs
