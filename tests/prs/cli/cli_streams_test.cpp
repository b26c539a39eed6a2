// The program with standard streams that are closed, full or without a reader.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "prs/study/study_run.h"
#include "tests/prs/study/study_file.h"
#include "tests/support/count.h"
#include "tests/support/processes.h"
#include "tests/support/program.h"
#include "tests/support/temporary_directory.h"

namespace {

namespace fs = std::filesystem;
using test::content_of;
using test::files_in;
using testing::HasSubstr;

enum class Stream { open, closed, full, gone };
constexpr Stream kStreams[] = {Stream::open, Stream::closed, Stream::full, Stream::gone};

/// Streams with which the program is started.
struct Streams {
  bool in = true;
  Stream out = Stream::open;
  Stream err = Stream::open;

  std::string text() const {
    const char* const names[] = {"open", "closed", "full", "gone"};
    return std::string("stdin ") + (in ? "open" : "closed") + ", stdout " + names[static_cast<int>(out)] + ", stderr " +
           names[static_cast<int>(err)];
  }
};

/// All pairs of states of the two outputs, standard input open in half of them; the thorough run
/// takes each pair with both.
std::vector<Streams> all_streams() {
  std::vector<Streams> all;
  for (const bool in : {true, false})
    for (const Stream out : kStreams)
      for (const Stream err : kStreams)
        if (test::thorough() || in == ((static_cast<int>(out) + static_cast<int>(err)) % 2 == 0))
          all.push_back({in, out, err});
  return all;
}

class StandardStreams : public testing::Test {
 protected:
  /// Runs `prs ARGUMENTS` from the repository's root.
  test::Outcome prs(const std::string& arguments, const Streams& streams = {}) const {
    const fs::path fifo = temporary.path() / "fifo";
    const auto redirection = [&](int number, Stream stream, const fs::path& file) {
      const std::string to = " " + std::to_string(number) + ">";
      switch (stream) {
        case Stream::open:
          return to + "'" + file.string() + "'";
        case Stream::closed:
          return to + "&-";
        case Stream::full:
          return to + "/dev/full";
        case Stream::gone:
          return to + "&9";
      }
      return std::string();
    };
    for (const fs::path& file : {out, err, fifo}) fs::remove(file);
    // A pipe opens for its writer while there is a reader.
    std::string command = "cd '" PRS_SOURCE_DIR "' && mkfifo '" + fifo.string() + "' && exec 8<>'" + fifo.string() +
                          "' 9>'" + fifo.string() + "' 8>&-; '";
    command += std::string(test::program()) + "' " + arguments;
    command += redirection(1, streams.out, out) + redirection(2, streams.err, err);
    if (!streams.in) command += " <&-";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), content_of(err)};
  }

  const test::TemporaryDirectory temporary;
  const fs::path out = temporary.path() / "out", err = temporary.path() / "err";
};

TEST_F(StandardStreams, DecideTheStatusOnlyWhereTheResultGetsLost) {
  // Cases: no message on standard error, warnings, an error.
  for (const std::string arguments :
       {"solve configs/01_config_1_to_3.yaml --json --quiet", "solve configs/01_config_1_to_3.yaml --json",
        "solve configs/missing.yaml --json"}) {
    const test::Outcome undisturbed = prs(arguments);
    for (const Streams& streams : all_streams()) {
      SCOPED_TRACE(arguments + ": " + streams.text());
      const test::Outcome run = prs(arguments, streams);
      const bool lost = undisturbed.status == 0 && streams.out != Stream::open;
      EXPECT_EQ(run.status, lost ? 1 : undisturbed.status);
      if (streams.out == Stream::open) {
        EXPECT_EQ(run.out, undisturbed.out);
      }
      if (streams.err != Stream::open) continue;
      if (!lost) {
        EXPECT_EQ(run.err, undisturbed.err);
      } else if (streams.out == Stream::gone) {
        EXPECT_EQ(run.err, "");  // Users who pipe into `head` need no message.
      } else {
        EXPECT_THAT(run.err, HasSubstr("prs: error: cannot write to standard output: "));
      }
    }
  }
}

TEST_F(StandardStreams, AreNeededForHelpToo) {
  for (const std::string arguments : {"--help", "--version", "schema", "new", "measures --explain"})
    for (const Stream lost : {Stream::closed, Stream::full, Stream::gone})
      EXPECT_EQ(prs(arguments, {.out = lost}).status, 1) << arguments;
  for (const Stream lost : kStreams) {
    EXPECT_EQ(prs("frobnicate", {.err = lost}).status, 2);
    EXPECT_EQ(prs("study", {.err = lost}).status, 2);
    EXPECT_EQ(prs("validate /nonexistent", {.err = lost}).status, 2);
  }
}

TEST_F(StandardStreams, DoNotKeepADamagedStudyFromGoingOn) {
  const fs::path file = temporary.path() / "study.yaml";
  test::write_study_file(file, 80);
  const fs::path undisturbed = temporary.path() / "undisturbed", begun = temporary.path() / "begun";
  const std::string study = "study '" + file.string() + "' --threads 2 --output '";
  ASSERT_EQ(prs(study + undisturbed.string() + "'").status, 0);
  ASSERT_EQ(prs(study + begun.string() + "' --shard 1/1").status, 0);
  const fs::path journal = prs::journal_path(begun, {});
  std::string bytes = content_of(journal);
  char& of_a_design = bytes[bytes.size() * 3 / 4];  // The header fills half of it.
  of_a_design = static_cast<char>(of_a_design ^ 1);
  std::ofstream(journal, std::ios::binary) << bytes;

  const auto expected = files_in(undisturbed);
  for (const Streams& streams : all_streams()) {
    SCOPED_TRACE(streams.text());
    const fs::path folder = temporary.path() / "folder";
    fs::remove_all(folder);
    fs::copy(begun, folder);
    const test::Outcome run = prs(study + folder.string() + "'", streams);
    EXPECT_EQ(run.status, streams.out == Stream::open ? 0 : 1);
    if (streams.err == Stream::open) {
      EXPECT_THAT(run.err, HasSubstr("warning: damaged"));
    }
    auto files = files_in(folder);
    // The table is lost: the same command prints it without computing again.
    EXPECT_EQ(files.erase(journal.filename().string()), streams.out == Stream::open ? 0 : 1);
    EXPECT_TRUE(files == expected);
  }
}

}  // namespace
