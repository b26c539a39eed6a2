#include "python/engine/interpreter_guard.h"

#include <pthread.h>

#include <condition_variable>
#include <set>

#include "prs/sector/influence/matrix_cache.h"

namespace nb = nanobind;

namespace prs::python {
namespace {

/// Count of all work in progress.
struct UnderWay {
  std::mutex mutex;
  std::condition_variable changed;
  std::set<Supervision*> supervised;
  std::size_t away = 0;  ///< Threads that have released the interpreter.
  bool ending = false;
};

/// Never destroyed: threads may outlive the module.
UnderWay& under_way() {
  static auto* all = new UnderWay;
  return *all;
}

void lock_for_fork() {
  under_way().mutex.lock();
  shared_matrix_cache().lock();
}

void unlock_after_fork() {
  shared_matrix_cache().unlock();
  under_way().mutex.unlock();
}

/// A forked process has only the forking thread, without the work of the others. Locks held by those would stay locked
/// forever.
void register_fork_handlers() {
  ::pthread_atfork(lock_for_fork, unlock_after_fork, [] {
    under_way().away = 0;
    under_way().supervised.clear();
    unlock_after_fork();
  });
}

void end_all() {
  constexpr std::chrono::seconds kPatience{10};
  const nb::gil_scoped_release release;
  UnderWay& all = under_way();
  std::unique_lock lock(all.mutex);
  all.ending = true;
  for (Supervision* supervision : all.supervised) supervision->stop();
  all.changed.wait_for(lock, kPatience, [&] { return all.away == 0; });
}

}  // namespace

GilRelease::GilRelease() {
  {
    const std::lock_guard lock(under_way().mutex);
    if (under_way().ending) return;
    ++under_way().away;
  }
  state_ = PyEval_SaveThread();
}

GilRelease::~GilRelease() {
  if (state_ == nullptr) return;
  PyEval_RestoreThread(state_);
  const std::lock_guard lock(under_way().mutex);
  --under_way().away;
  under_way().changed.notify_all();
}

Supervision::Supervision() {
  const std::lock_guard lock(under_way().mutex);
  stop_ = under_way().ending;
  under_way().supervised.insert(this);
}

Supervision::~Supervision() {
  const std::lock_guard lock(under_way().mutex);
  under_way().supervised.erase(this);
}

void end_work_with(nb::module_& module) {
  register_fork_handlers();
  module.def("end_work", &end_all, "Called when the interpreter ends.");
  nb::module_::import_("atexit").attr("register")(module.attr("end_work"));
}

}  // namespace prs::python
