#include "prs/sector/influence/matrix_cache.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "prs/sector/influence/flexibility.h"
#include "support/temporary_directory.h"

namespace prs {
namespace {

namespace fs = std::filesystem;
using Matrices = MatrixCache::Matrices;

Matrices sample() { return {Eigen::MatrixXd::Random(3, 2), Eigen::MatrixXd(0, 4), Eigen::MatrixXd::Random(1, 1)}; }

fs::path only_file(const fs::path& directory) {
  fs::path found;
  int files = 0;
  for (const auto& entry : fs::directory_iterator(directory)) {
    found = entry.path();
    ++files;
  }
  EXPECT_EQ(files, 1);
  return found;
}

TEST(MatrixCache, ComputesOnceForEachKey) {
  MatrixCache cache;
  int calls = 0;
  const auto compute = [&] {
    ++calls;
    return sample();
  };
  const auto first = cache.get("a", compute), again = cache.get("a", compute);
  EXPECT_EQ(first, again);
  cache.get("b", compute);
  EXPECT_EQ(calls, 2);
  EXPECT_EQ(cache.computed(), 2);
}

TEST(MatrixCache, OneThatKeepsOnlyFindsWhatAnotherHolds) {
  const test::TemporaryDirectory directory;
  const Matrices matrices = sample();
  const auto given = [&] { return matrices; };
  MatrixCache(directory.path()).get("in a file", given);
  MatrixCache whole(directory.path());
  whole.get("in memory", given);
  MatrixCache kept(whole, MatrixCache::KeptOnly{});
  for (const char* key : {"in a file", "in memory"}) EXPECT_EQ((*kept.get(key, sample))[0], matrices[0]) << key;
  EXPECT_THROW(kept.get("absent", sample), NotKept);
  EXPECT_EQ(kept.computed(), 0);
}

TEST(MatrixCache, ReportsWhenItComputes) {
  MatrixCache cache;
  std::vector<std::pair<bool, int>> reports;
  cache.report_to([&](bool working, int computed) { reports.emplace_back(working, computed); });
  cache.get("a", sample);
  cache.get("a", sample);
  cache.get("b", sample);
  const std::vector<std::pair<bool, int>> expected = {{true, 0}, {false, 1}, {true, 1}, {false, 2}};
  EXPECT_EQ(reports, expected);
}

TEST(MatrixCache, FilesGiveTheSameBits) {
  const test::TemporaryDirectory directory;
  const Matrices kept = sample();
  MatrixCache(directory.path()).get("key", [&] { return kept; });
  MatrixCache later(directory.path());
  const auto found = later.get("key", [&]() -> Matrices { throw std::logic_error("computed"); });
  EXPECT_EQ(later.computed(), 0);
  ASSERT_EQ(found->size(), kept.size());
  for (std::size_t k = 0; k < kept.size(); ++k) {
    EXPECT_EQ((*found)[k].rows(), kept[k].rows());
    EXPECT_EQ((*found)[k], kept[k]);
  }
}

TEST(MatrixCache, DamagedFilesCountAsAbsent) {
  const test::TemporaryDirectory directory;
  const Matrices kept = sample();
  MatrixCache(directory.path()).get("key", [&] { return kept; });
  const fs::path file = only_file(directory.path());
  std::ifstream in(file, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(in), {}};
  in.close();
  const auto with = [&](const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
    MatrixCache cache(directory.path());
    EXPECT_EQ((*cache.get("key", [&] { return kept; }))[0], kept[0]);
    return cache.computed();
  };
  for (const std::size_t length : {std::size_t{0}, std::size_t{7}, whole.size() - 1})
    EXPECT_EQ(with(whole.substr(0, length)), 1) << length;
  for (std::size_t at = 0; at < whole.size(); at += 13) {
    std::string flipped = whole;
    flipped[at] = static_cast<char>(flipped[at] ^ 1);
    EXPECT_EQ(with(flipped), 1) << at;
  }
  EXPECT_EQ(with(whole), 0);
}

TEST(MatrixCache, FilesWithOtherMatricesThanTheKeyCanHaveCountAsAbsent) {
  const test::TemporaryDirectory directory;
  MatrixCache(directory.path()).get("key", sample);
  MatrixCache cache(directory.path());
  const Matrices other{Eigen::MatrixXd::Ones(2, 2)};
  const auto found = cache.get(
      "key", [&] { return other; },
      [](const Matrices& m) {
        return have_sizes(m, {{2, 2}});
      });
  EXPECT_EQ(*found, other);
  EXPECT_EQ(cache.computed(), 1);
}

TEST(MatrixCache, FilesWithNumbersThatAreNotFiniteCountAsAbsent) {
  for (const double odd : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    const test::TemporaryDirectory directory;
    Matrices odd_ones = sample();
    odd_ones[0](2, 1) = odd;
    MatrixCache(directory.path()).get("key", [&] { return odd_ones; });
    MatrixCache cache(directory.path());
    cache.get("key", sample);
    EXPECT_EQ(cache.computed(), 1) << odd;
  }
}

TEST(MatrixCache, SizesAreThoseOfEveryMatrix) {
  EXPECT_TRUE(have_sizes(sample(), {{3, 2}, {0, 4}, {1, 1}}));
  EXPECT_FALSE(have_sizes(sample(), {{3, 2}, {0, 4}}));
  EXPECT_FALSE(have_sizes(sample(), {{3, 2}, {0, 4}, {1, 1}, {1, 1}}));
  EXPECT_FALSE(have_sizes(sample(), {{2, 3}, {0, 4}, {1, 1}}));
}

TEST(MatrixCache, DirectoryThatCannotBeWrittenIsNoError) {
  MatrixCache cache("/proc/no such place");
  EXPECT_EQ(cache.get("key", sample)->size(), 3u);
}

MatrixCache::Matrices size_of(const GroovedShape& shape) {
  return {Eigen::MatrixXd::Constant(1, 1, shape.end - shape.start)};
}
bool is_size(const GroovedShape&, const Matrices& m) { return have_sizes(m, {{1, 1}}); }

TEST(CachedMatrices, EveryNumberOfWhatTheyAreMadeFromCounts) {
  MatrixCache cache;
  GroovedShape shape;
  int made = 0;
  const auto is_another = [&](auto change) {
    change();
    for (int i = 0; i < 2; ++i) cached(cache, "body", shape, size_of, is_size);
    EXPECT_EQ(cache.computed(), ++made);
  };
  is_another([] {});
  is_another([&] { shape.groove.dedendum = 1.0; });
  is_another([&] { shape.far_radius = 1.0; });
  is_another([&] { shape.ridges = {0.0, 0.0}; });
  is_another([&] { shape.ridges->second = 1.0; });
  is_another([&] { shape.plain_end = PlainEnd{}; });
  is_another([&] { shape.collars = {{}}; });
  is_another([&] { shape.collars[0].radius = 1.0; });
  is_another([&] { shape.sections = {1.0}; });
  is_another([&] { std::swap(shape.sections, shape.radii); });
  cached(cache, "another body", shape, size_of, is_size);
  EXPECT_EQ(cache.computed(), made + 1);
}

}  // namespace
}  // namespace prs
