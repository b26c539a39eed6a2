#include "prs/study/distributed.h"

// The C++ bindings that MPI has dropped.
#define OMPI_SKIP_MPICXX
#include <mpi.h>
#include <sched.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstdlib>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>

#include "prs/sha256.h"

namespace prs {
namespace {

using Clock = std::chrono::steady_clock;

/// Messages to the first rank, and its answer.
enum Tag {
  kHello,   ///< How many blocks the rank wants to have on their way.
  kRecord,  ///< An encoded block, one of these.
  kRange,   ///< The next in its place; without designs: none.
};

/// Between two looks at the mail: waiting inside MPI would take a processor.
constexpr auto kPause = std::chrono::microseconds(100);

/// Time that a rank should spend on what it is given at once, so that the first rank is not asked
/// too often, and the most blocks of that.
constexpr double kGrantSeconds = 0.02;
constexpr double kMostChunks = 64.0;

/// Blocks on their way, a thread.
constexpr std::size_t kBlocksPerThread = 3;

/// Whether a launcher started this process as one of several.
bool is_launched() {
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"})
    if (const char* size = std::getenv(variable); size && std::atoi(size) > 1) return true;
  return false;
}

bool has_mail(MPI_Status& status) {
  int there = 0;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
  return there != 0;
}

std::string receive_text(const MPI_Status& status) {
  int length = 0;
  MPI_Get_count(&status, MPI_CHAR, &length);
  std::string text(static_cast<std::size_t>(length), '\0');
  MPI_Recv(text.data(), length, MPI_CHAR, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return text;
}

template <std::size_t n>
std::array<std::uint64_t, n> receive_numbers(const MPI_Status& status) {
  std::array<std::uint64_t, n> numbers{};
  MPI_Recv(numbers.data(), n, MPI_UINT64_T, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return numbers;
}

template <std::size_t n>
void send_numbers(const std::array<std::uint64_t, n>& numbers, int rank, Tag tag) {
  MPI_Send(numbers.data(), n, MPI_UINT64_T, rank, tag, MPI_COMM_WORLD);
}

/// Values from one thread for another.
template <class Value>
class Mailbox {
 public:
  void put(Value value) {
    {
      const std::lock_guard lock(mutex_);
      values_.push_back(std::move(value));
    }
    filled_.notify_one();
  }
  Value wait() {
    std::unique_lock lock(mutex_);
    filled_.wait(lock, [&] { return !values_.empty(); });
    return pop();
  }
  std::optional<Value> take() {
    const std::lock_guard lock(mutex_);
    return values_.empty() ? std::nullopt : std::optional(pop());
  }

 private:
  Value pop() {
    Value value = std::move(values_.front());
    values_.pop_front();
    return value;
  }

  std::mutex mutex_;
  std::condition_variable filled_;
  std::deque<Value> values_;
};

/// How many designs a rank should get at once: as many as it does in `kGrantSeconds`.
class GrantSize {
 public:
  explicit GrantSize(std::size_t chunk) : chunk_(chunk) {}

  void took(std::size_t designs) { taken_ += designs; }
  std::size_t of(std::size_t places) const {
    if (taken_ == 0) return chunk_;
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    const double rate = static_cast<double>(taken_) / (seconds * static_cast<double>(places));
    const double chunks = kGrantSeconds * rate / static_cast<double>(chunk_);
    return chunk_ * static_cast<std::size_t>(std::clamp(chunks, 1.0, kMostChunks));
  }

 private:
  std::size_t chunk_;
  std::size_t taken_ = 0;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

Ranks::Ranks(bool join) {
  if (!join || !is_launched()) return;
  int level = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &level);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Ranks::~Ranks() {
  int initialised = 0;
  MPI_Initialized(&initialised);
  if (!initialised) return;
  if (!served_ && rank_ == 0)
    serve([](std::size_t) { return std::nullopt; }, [](const std::string&) {}, 1);
  if (!served_ && rank_ > 0) send_numbers<1>({0}, 0, kHello);
  // MPI_Finalize would wait for the first rank, which writes files now, with a busy processor.
  MPI_Request barrier = MPI_REQUEST_NULL;
  MPI_Ibarrier(MPI_COMM_WORLD, &barrier);
  for (int done = 0; done == 0; std::this_thread::sleep_for(kPause))
    MPI_Test(&barrier, &done, MPI_STATUS_IGNORE);
  MPI_Finalize();
}

std::size_t Ranks::threads() const {
  if (size_ == 1) return available_processors();
  cpu_set_t own;
  CPU_ZERO(&own);
  sched_getaffinity(0, sizeof own, &own);
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  int ranks = 1;
  MPI_Comm_size(machine, &ranks);
  cpu_set_t all;
  CPU_ZERO(&all);
  MPI_Allreduce(&own, &all, sizeof own, MPI_BYTE, MPI_BOR, machine);
  MPI_Comm_free(&machine);
  return static_cast<std::size_t>(std::max(1, CPU_COUNT(&all) / ranks));
}

bool Ranks::agree(const std::string& text) const {
  if (size_ == 1) return true;
  const std::string own = sha256(text);
  std::string first = own;
  MPI_Bcast(first.data(), static_cast<int>(first.size()), MPI_CHAR, 0, MPI_COMM_WORLD);
  int same = first == own ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &same, 1, MPI_INT, MPI_LAND, MPI_COMM_WORLD);
  return same != 0;
}

std::optional<std::string> Ranks::share(const std::function<std::string()>& make) const {
  std::string text;
  std::exception_ptr error;
  if (rank_ == 0) {
    try {
      text = make();
    } catch (...) {
      error = std::current_exception();
    }
  }
  if (size_ > 1) {
    int length = error ? -1 : static_cast<int>(text.size());
    MPI_Bcast(&length, 1, MPI_INT, 0, MPI_COMM_WORLD);
    if (length >= 0) {
      text.resize(static_cast<std::size_t>(length));
      MPI_Bcast(text.data(), length, MPI_CHAR, 0, MPI_COMM_WORLD);
    } else if (rank_ > 0) {
      return std::nullopt;
    }
  }
  if (error) std::rethrow_exception(error);
  return text;
}

void Ranks::lead(const NextRange& next, const TakeRecord& take, std::size_t chunk,
                 const RunDesigns& run) {
  if (size_ == 1) return run(next, take);
  std::exception_ptr error;
  std::atomic<bool> failed = false;
  // After an error nobody gets more.
  const auto next_unless_failed = [&](std::size_t most) {
    return failed ? std::nullopt : next(most);
  };
  std::thread own([&] {
    try {
      run(next_unless_failed, take);
    } catch (...) {
      error = std::current_exception();
      failed = true;
    }
  });
  std::exception_ptr others_error;
  const auto take_or_fail = [&](const std::string& record) {
    try {
      if (!failed) take(record);
    } catch (...) {
      others_error = std::current_exception();
      failed = true;
    }
  };
  serve(next_unless_failed, take_or_fail, chunk);
  own.join();
  if (error) std::rethrow_exception(error);
  if (others_error) std::rethrow_exception(others_error);
}

void Ranks::serve(const NextRange& next, const TakeRecord& take, std::size_t chunk) {
  served_ = true;
  GrantSize grant(chunk);
  std::size_t places = 0;  // Of all ranks heard of: each has a block on its way, or none any more.
  std::size_t idle = 0;
  int heard_of = 1;
  const auto answer = [&](int rank) {
    const DesignRange range = next(grant.of(places)).value_or(DesignRange{});
    send_numbers<2>({range.first, range.count}, rank, kRange);
    if (range.count == 0) ++idle;
  };
  while (heard_of < size_ || idle < places) {
    MPI_Status status;
    if (!has_mail(status)) {
      std::this_thread::sleep_for(kPause);
    } else if (status.MPI_TAG == kHello) {
      const std::size_t wanted = receive_numbers<1>(status)[0];
      ++heard_of;
      places += wanted;
      for (std::size_t k = 0; k < wanted; ++k) answer(status.MPI_SOURCE);
    } else {
      const std::string record = receive_text(status);
      take(record);
      grant.took(designs_of(record).count);
      answer(status.MPI_SOURCE);
    }
  }
}

void Ranks::assist(const Evaluate& evaluate, std::size_t threads) {
  served_ = true;
  Mailbox<DesignRange> ranges;
  Mailbox<std::string> records;
  std::size_t places = kBlocksPerThread * threads;
  send_numbers<1>({places}, 0, kHello);
  std::thread work([&] {
    const auto next = [&](std::size_t) {
      const DesignRange range = ranges.wait();
      return range.count > 0 ? std::optional(range) : std::nullopt;
    };
    try {
      run_schedule(threads, 1, next, evaluate, [&](const std::string& r) { records.put(r); });
    } catch (const std::exception&) {
      MPI_Abort(MPI_COMM_WORLD, 1);
    }
  });
  while (places > 0) {
    MPI_Status status;
    if (const std::optional<std::string> record = records.take()) {
      MPI_Send(record->data(), static_cast<int>(record->size()), MPI_CHAR, 0, kRecord,
               MPI_COMM_WORLD);
    } else if (has_mail(status)) {
      const auto [first, count] = receive_numbers<2>(status);
      if (count == 0) --places;
      if (count > 0) ranges.put({first, count});
    } else {
      std::this_thread::sleep_for(kPause);
    }
  }
  ranges.put({});
  work.join();
}

}  // namespace prs
