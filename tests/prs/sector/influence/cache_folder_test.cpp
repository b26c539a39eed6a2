#include "prs/sector/influence/matrix_cache.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>

#include "prs/file_descriptor.h"
#include "support/temporary_directory.h"

namespace prs {
namespace {

namespace fs = std::filesystem;
using test::content_of;

class CacheFolderTest : public testing::Test {
 protected:
  CacheFolderTest() : umask_(::umask(022)) {}  // Folders made by tests are not writable for others.
  ~CacheFolderTest() override { ::umask(umask_); }

  static std::string digest(char digit) { return std::string(64, digit); }
  fs::path file(char digit) const { return path / fmt::format("{}.matrices", digest(digit)); }
  static void write(const fs::path& to, const std::string& text) { std::ofstream(to, std::ios::binary) << text; }

  const test::TemporaryDirectory temporary;
  const fs::path path = temporary.path() / "cache";
  const CacheFolder folder{path};

 private:
  const mode_t umask_;
};

TEST_F(CacheFolderTest, FindsWhatWasWrittenInAFolderOfTheUserAlone) {
  EXPECT_FALSE(folder.read(digest('a')));
  folder.write(digest('a'), std::string("\0bytes", 6));
  EXPECT_EQ(folder.read(digest('a')), std::string("\0bytes", 6));
  struct stat status {};
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0700u);
  ASSERT_EQ(::stat(file('a').c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0600u);
  EXPECT_EQ(folder.refusal(), "");
}

TEST_F(CacheFolderTest, LinksAreNeitherReadNorWrittenThrough) {
  const fs::path other = temporary.path() / "other";
  write(other, "precious");
  fs::create_directory(path);
  fs::create_symlink(other, file('a'));
  EXPECT_FALSE(folder.read(digest('a')));
  folder.write(digest('a'), "new");
  EXPECT_EQ(content_of(other), "precious");
  EXPECT_FALSE(fs::is_symlink(file('a')));
  EXPECT_EQ(folder.read(digest('a')), "new");
}

TEST_F(CacheFolderTest, APipeCountsAsAbsent) {
  fs::create_directory(path);
  ASSERT_EQ(::mkfifo(file('a').c_str(), 0600), 0);
  EXPECT_FALSE(folder.read(digest('a')));
  folder.write(digest('a'), "new");
  EXPECT_EQ(folder.read(digest('a')), "new");
}

TEST_F(CacheFolderTest, WhatWasNotUsedForLongestGoesFirst) {
  const CacheFolder small(path, 3 * 4096);  // Room for three of its files.
  for (const char digit : {'a', 'b', 'c'}) {
    small.write(digest(digit), std::string(30, digit));
    // Last used long ago, in this order.
    fs::last_write_time(file(digit), fs::file_time_type::clock::now() - std::chrono::hours(100 - (digit - 'a')));
  }
  ASSERT_TRUE(small.read(digest('a')));  // The file is now used.
  write(path / "notes.txt", std::string(100'000, 'x'));
  small.write(digest('d'), std::string(30, 'd'));
  EXPECT_TRUE(fs::exists(file('a')));
  EXPECT_FALSE(fs::exists(file('b')));
  EXPECT_TRUE(fs::exists(file('c')));
  EXPECT_TRUE(fs::exists(file('d')));
  EXPECT_TRUE(fs::exists(path / "notes.txt"));
  small.write(digest('e'), std::string(3 * 4096 + 1, 'e'));
  EXPECT_FALSE(fs::exists(file('e')));
  EXPECT_TRUE(fs::exists(file('a')));
}

TEST_F(CacheFolderTest, FilesFromTheFutureCountAsOthersDo) {  // Same as if the clock was set back.
  const auto in_years = [](int years) { return fs::file_time_type::clock::now() + std::chrono::years(years); };
  const CacheFolder small(path, 2 * 4096);
  const fs::path left = file('c').string() + ".4711.0";
  for (const char digit : {'a', 'b'}) small.write(digest(digit), "old");
  write(left, "half");
  for (const fs::path& each : {file('a'), file('b'), left}) fs::last_write_time(each, in_years(60));
  EXPECT_EQ(small.read(digest('a')), "old");
  EXPECT_LT(fs::last_write_time(file('a')), in_years(1));  // The file is now used: it ages like others.
  small.write(digest('d'), "new");
  EXPECT_FALSE(fs::exists(left));
  EXPECT_FALSE(fs::exists(file('a')));
  EXPECT_TRUE(fs::exists(file('b')));
  EXPECT_EQ(small.read(digest('d')), "new");
}

TEST_F(CacheFolderTest, DraftsGoOnceTheirWritersAreGone) {
  fs::create_directory(path);
  const fs::path left = file('a').string() + ".4711.0", at_work = file('b').string() + ".0123abcd";
  write(left, "half");
  write(at_work, "half");
  const FileDescriptor writer(::open(at_work.c_str(), O_WRONLY | O_CLOEXEC));
  ASSERT_EQ(::flock(writer.get(), LOCK_EX), 0);
  folder.write(digest('c'), "whole");
  EXPECT_FALSE(fs::exists(left));
  EXPECT_TRUE(fs::exists(at_work));
}

TEST_F(CacheFolderTest, AFolderThatEverybodyMayWriteIntoIsNotUsed) {
  folder.write(digest('a'), "old");
  ASSERT_EQ(::chmod(path.c_str(), 0777), 0);
  EXPECT_FALSE(folder.read(digest('a')));
  folder.write(digest('b'), "new");
  EXPECT_FALSE(fs::exists(file('b')));
  EXPECT_NE(folder.refusal().find("everybody may write"), std::string::npos) << folder.refusal();
}

TEST_F(CacheFolderTest, AFolderOrLinkOfAnotherUserIsNotUsed) {
  if (::geteuid() != 0) GTEST_SKIP() << "needs the right to give files away";
  fs::create_directory(path);
  const fs::path link = temporary.path() / "link";
  fs::create_directory_symlink(path, link);
  EXPECT_EQ(CacheFolder(link).refusal(), "");
  if (::lchown(link.c_str(), 1, 1) != 0) GTEST_SKIP() << "there is no other user here: " << std::strerror(errno);
  for (const fs::path& name : {link, link / ""}) {
    const CacheFolder other(name);
    EXPECT_NE(other.refusal().find("belongs to another user"), std::string::npos) << name;
    other.write(digest('a'), "new");
    EXPECT_FALSE(fs::exists(file('a')));
  }
  ASSERT_EQ(::chown(path.c_str(), 1, 1), 0);
  folder.write(digest('a'), "new");
  EXPECT_FALSE(fs::exists(file('a')));
}

}  // namespace
}  // namespace prs
