#include "prs/study/distributed.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>

#include "prs/bytes.h"
#include "prs/sha256.h"

namespace prs {
namespace {

using Clock = std::chrono::steady_clock;

/// Messages to the first rank, and its answer.
enum Tag {
  kHello,   ///< How many blocks the rank wants to have on their way.
  kRecord,  ///< An encoded block, the last of what the rank was given at once.
  kPart,    ///< One before it.
  kRange,   ///< The next in its place; without designs: none.
};

/// Between two looks at the mail: waiting inside MPI would take a processor.
constexpr auto kPause = std::chrono::microseconds(100);

/// Time that a rank should spend on what it is given at once, so that the first rank is not asked
/// too often, and the most blocks of that.
constexpr double kGrantSeconds = 0.02;
constexpr double kMostChunks = 64.0;

/// Blocks on their way, a thread.
constexpr std::size_t kPlacesPerThread = 3;

/// Whether a launcher started this process as one of several.
bool is_launched() {
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"})
    if (const char* size = std::getenv(variable); size && std::atoi(size) > 1) return true;
  return false;
}

std::string content_of(std::initializer_list<std::uint64_t> numbers) {
  std::string content;
  for (const std::uint64_t number : numbers) put(content, number);
  return content;
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
  communicator_ = modules::loaded<MpiModule>().join();
  rank_ = communicator_->rank();
  size_ = communicator_->size();
}

Ranks::~Ranks() {
  if (!communicator_ || served_) return;
  if (rank_ == 0)
    serve([](std::size_t) { return std::nullopt; }, [](const std::string&) {}, 1);
  else
    communicator_->send(0, kHello, content_of({0}));
}

std::size_t Ranks::threads() const {
  if (size_ == 1) return default_threads();
  return static_cast<std::size_t>(communicator_->processors_each());
}

bool Ranks::agree(const std::string& text) const {
  if (size_ == 1) return true;
  const std::string own = sha256(text);
  std::optional<std::string> first = own;
  communicator_->broadcast(first);
  return communicator_->all(first == own);
}

std::optional<std::string> Ranks::share(const std::function<std::string()>& make) const {
  std::optional<std::string> text;
  std::exception_ptr error;
  if (rank_ == 0) {
    try {
      text = make();
    } catch (...) {
      error = std::current_exception();
    }
  }
  if (size_ > 1) communicator_->broadcast(text);
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
    communicator_->send(rank, kRange, content_of({range.first, range.count}));
    if (range.count == 0) ++idle;
  };
  while (heard_of < size_ || idle < places) {
    const std::optional<Communicator::Message> message = communicator_->receive();
    if (!message) {
      std::this_thread::sleep_for(kPause);
    } else if (message->tag == kHello) {
      const std::size_t wanted = Cursor(message->content).number();
      ++heard_of;
      places += wanted;
      for (std::size_t k = 0; k < wanted; ++k) answer(message->rank);
    } else {
      take(message->content);
      grant.took(designs_of(message->content).count);
      if (message->tag == kRecord) answer(message->rank);
    }
  }
}

void Ranks::assist(const Evaluate& evaluate, std::size_t threads) {
  served_ = true;
  Mailbox<DesignRange> ranges;
  std::set<std::size_t> ends;  ///< Of the ranges that were given and are not done.
  Mailbox<std::string> records;
  std::size_t places = kPlacesPerThread * threads;
  communicator_->send(0, kHello, content_of({places}));
  std::thread work([&] {
    const auto next = [&](std::size_t) {
      const DesignRange range = ranges.wait();
      return range.count > 0 ? std::optional(range) : std::nullopt;
    };
    try {
      run_schedule(threads, 1, next, evaluate, [&](const std::string& r) { records.put(r); });
    } catch (const std::exception&) {
      communicator_->abort();
    }
  });
  while (places > 0) {
    if (const std::optional<std::string> record = records.take()) {
      communicator_->send(0, ends.erase(designs_of(*record).end()) > 0 ? kRecord : kPart, *record);
    } else if (const auto message = communicator_->receive()) {
      Cursor numbers(message->content);
      const DesignRange range{numbers.number(), numbers.number()};
      if (range.count > 0) {
        ends.insert(range.end());
        ranges.put(range);
      } else {
        --places;
      }
    } else {
      std::this_thread::sleep_for(kPause);
    }
  }
  ranges.put({});
  work.join();
}

}  // namespace prs
