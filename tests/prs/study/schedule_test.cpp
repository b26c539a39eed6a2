#include "prs/study/study_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <new>
#include <stdexcept>

#include "prs/study/journal.h"
#include "synthetic_study.h"

namespace prs {
namespace {

/// Distributes [0, designs).
class Counter {
 public:
  explicit Counter(std::size_t designs) : designs_(designs) {}

  std::optional<DesignRange> operator()(std::size_t most) {
    const std::lock_guard lock(mutex_);
    if (next_ == designs_) return std::nullopt;
    const DesignRange range{next_, std::min(most, designs_ - next_)};
    next_ = range.end();
    return range;
  }

 private:
  std::size_t designs_;
  std::size_t next_ = 0;
  std::mutex mutex_;
};

TEST(Schedule, EvaluatesEachDesignOnceOnAnyNumberOfThreads) {
  for (const std::size_t threads : {1, 2, 3, 8}) {
    Counter next(10'001);
    std::vector<int> times(10'001, 0);
    run_schedule(
        threads, 64, [&](std::size_t most) { return next(most); }, test::synthetic_rows,
        [&](const std::string& record) {
          const DesignRange range = designs_of(record);
          EXPECT_EQ(record, encode(test::synthetic_rows(range.first, range.count)));
          for (std::size_t k = range.first; k < range.end(); ++k) ++times[k];
        });
    EXPECT_EQ(times, std::vector<int>(10'001, 1)) << threads;
  }
}

/// Only the first of the requested designs, as if they took long.
RowBlock first_rows(std::size_t first, std::size_t count) {
  return test::synthetic_rows(first, std::min<std::size_t>(count, 1 + first % 7));
}

TEST(Schedule, TakesWhatSlowDesignsGiveInPieces) {
  for (const std::size_t threads : {1, 2}) {
    Counter next(1001);
    std::mutex mutex;
    std::vector<int> times(1001, 0);
    run_schedule(
        threads, 32, [&](std::size_t most) { return next(most); }, first_rows,
        [&](const std::string& record) {
          const std::lock_guard lock(mutex);
          const DesignRange range = designs_of(record);
          for (std::size_t k = range.first; k < range.end(); ++k) ++times[k];
        });
    EXPECT_EQ(times, std::vector<int>(1001, 1)) << threads;
  }
}

TEST(Schedule, KeepsWhatIsDoneWhereItIsInterrupted) {
  Counter next(100);
  std::size_t taken = 0;
  run_schedule(
      1, 10, [&](std::size_t most) { return next(most); },
      [](std::size_t first, std::size_t count) {
        return first < 3 ? test::synthetic_rows(first, 1) : RowBlock{first, 0 * count, {}, {}};
      },
      [&](const std::string& record) { taken += designs_of(record).count; });
  EXPECT_EQ(taken, 3u);
}

TEST(Schedule, SlowTakerHoldsTheRestBack) {
  constexpr std::size_t kThreads = 4;
  Counter next(2'000);
  std::atomic<std::size_t> given = 0;
  std::size_t taken = 0;
  std::size_t most_on_their_way = 0;
  run_schedule(
      kThreads, 1,
      [&](std::size_t most) {
        ++given;
        return next(most);
      },
      test::synthetic_rows,
      [&](const std::string&) {
        most_on_their_way = std::max(most_on_their_way, given - taken);
        ++taken;
      });
  EXPECT_EQ(taken, 2'000u);
  EXPECT_LE(most_on_their_way, 4 * kThreads + 1);
}

TEST(Schedule, WhatGoesWrongEndsIt) {
  for (const std::size_t threads : {1, 2}) {
    Counter next(1'000'000);
    std::atomic<int> evaluated = 0;
    const auto failing = [&](std::size_t first, std::size_t count) {
      if (++evaluated == 10) throw std::bad_alloc();
      return test::synthetic_rows(first, count);
    };
    const auto give = [&](std::size_t most) { return next(most); };
    EXPECT_THROW(run_schedule(threads, 1, give, failing, [](const std::string&) {}), std::bad_alloc);
    EXPECT_LT(evaluated, 1000);
    const auto refuse = [](const std::string&) { throw std::runtime_error("full"); };
    EXPECT_THROW(run_schedule(threads, 1, give, test::synthetic_rows, refuse), std::runtime_error);
  }
}

TEST(RunInOrder, TakesWhatThreadsPreparedInOrder) {
  for (const std::size_t threads : {1, 2, 3, 8}) {
    std::vector<std::size_t> order;
    run_in_order(1000, threads, [&](std::size_t k) {
      volatile double work = 0.0;
      for (std::size_t j = 0; j < (k * 7919) % 500; ++j) work = work + 1.0;
      return [&order, k] { order.push_back(k); };
    });
    ASSERT_EQ(order.size(), 1000u);
    EXPECT_TRUE(std::ranges::is_sorted(order));
  }
  run_in_order(0, 2, [](std::size_t) -> std::function<void()> { throw std::logic_error("none"); });
}

}  // namespace
}  // namespace prs
