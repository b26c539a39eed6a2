#include "prs/output/staged_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include <stdexcept>

#include "tests/support/temporary_directory.h"

namespace prs {
namespace {

/// A file, opened anew each time: each has its own locks, like another process.
class FileLock : public testing::Test {
 protected:
  FileDescriptor open(int flags = O_RDWR) const {
    return FileDescriptor(::open(path.c_str(), flags | O_CREAT | O_CLOEXEC, 0666));
  }

  const test::TemporaryDirectory temporary;
  const std::filesystem::path path = temporary.path() / "lock";
};

TEST_F(FileLock, IsTakenOnceItsHolderIsGone) {
  FileDescriptor holder = open();
  const FileDescriptor next = open();
  ASSERT_TRUE(lock_file(holder, LOCK_EX, path));
  int waits = 0;
  EXPECT_TRUE(lock_file(next, LOCK_EX, path, [&] {
    if (++waits == kMostLockTries - 1) holder.close();
  }));
  EXPECT_EQ(waits, kMostLockTries - 1);
}

TEST_F(FileLock, IsGivenUpWhereItsHolderStays) {
  const FileDescriptor holder = open(), next = open();
  ASSERT_TRUE(lock_file(holder, LOCK_SH, path));
  int waits = 0;
  EXPECT_FALSE(lock_file(next, LOCK_EX, path, [&] { ++waits; }));
  EXPECT_EQ(waits, kMostLockTries - 1);
  EXPECT_TRUE(lock_file(next, LOCK_SH, path, [] { FAIL() << "shared locks wait for each other"; }));
}

TEST_F(FileLock, OfAFileThatHasNoneIsAnErrorThatNamesIt) {
  open();
  // A descriptor without access: flock(2) refuses it, as on a file system without locks.
  const FileDescriptor name(::open(path.c_str(), O_PATH | O_CLOEXEC));
  try {
    lock_file(name, LOCK_EX, path, [] { FAIL() << "nothing to wait for"; });
    FAIL() << "locked all the same";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("cannot lock '" + path.string() + "': "));
  }
}

}  // namespace
}  // namespace prs
