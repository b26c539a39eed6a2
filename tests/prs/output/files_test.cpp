#include "prs/output/files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <system_error>

#include "support/small_files.h"
#include "support/temporary_directory.h"

namespace prs {
namespace {

namespace fs = std::filesystem;
using test::content_of;
using test::TemporaryDirectory;

std::size_t entries(const fs::path& directory) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(directory), fs::directory_iterator()));
}

/// Text of the error, which names the path; empty if there was none.
std::string write_error(const fs::path& directory, const std::vector<OutputFile>& files) {
  try {
    write_files(directory, files);
    return {};
  } catch (const std::system_error& error) {
    return error.what();
  }
}

TEST(WriteFiles, CreatesDirectoriesAndReplacesFiles) {
  const TemporaryDirectory temporary;
  const fs::path directory = temporary.path() / "a" / "b";
  write_files(directory, {{"x.csv", "old"}});
  write_files(directory, {{"x.csv", "new"}, {"y.csv", ""}});
  EXPECT_EQ(content_of(directory / "x.csv"), "new");
  EXPECT_EQ(entries(directory), 2);
}

/// A device or a pipe would be replaced by a regular file.
TEST(WriteFiles, LinksPipesAndDevicesStay) {
  const TemporaryDirectory temporary;
  const fs::path pipe = temporary.path() / "pipe", link = temporary.path() / "link";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  fs::create_symlink("/dev/null", link);
  for (const fs::path& path : {pipe, link}) {
    try {
      write_files(temporary.path(), {{path.filename(), "new"}});
      ADD_FAILURE() << path;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("expected a regular file"), std::string::npos) << error.what();
    }
  }
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(entries(temporary.path()), 2);
}

TEST(WriteFiles, ErrorNamesPathAndReason) {
  const TemporaryDirectory temporary;
  write_files(temporary.path(), {{"file", ""}});
  const fs::path directory = temporary.path() / "file" / "below";
  const std::string error = write_error(directory, {{"x", ""}});
  EXPECT_NE(error.find(directory.string()), std::string::npos) << error;
  EXPECT_NE(error.find("Not a directory"), std::string::npos) << error;
}

TEST(WriteFiles, FailedWriteLeavesEarlierFilesAlone) {
  const TemporaryDirectory temporary;
  write_files(temporary.path(), {{"a", "old"}, {"b", "old"}});
  {
    const test::SmallFilesOnly full_disk(4096);
    const std::string error = write_error(temporary.path(), {{"a", "new"}, {"b", std::string(10000, 'x')}});
    EXPECT_NE(error.find("File too large"), std::string::npos) << error;
  }
  EXPECT_EQ(content_of(temporary.path() / "a"), "old");
  EXPECT_EQ(content_of(temporary.path() / "b"), "old");
  EXPECT_EQ(entries(temporary.path()), 2);
}

}  // namespace
}  // namespace prs
