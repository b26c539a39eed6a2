// Files that `prs solve` opens, as the kernel reports them: `strace`.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/program.h"
#include "tests/support/temporary_directory.h"

namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::EndsWith;

struct Touched {
  std::set<std::string> read, written;
  std::vector<std::string> network;
};

/// A name in a log of strace, which writes bytes beyond ASCII as \303\244.
std::string unescaped(const std::string& name) {
  static const std::regex octal(R"re(^\\([0-7]{1,3}))re");
  std::string plain;
  for (auto at = name.begin(); at != name.end();) {
    std::smatch found;
    if (std::regex_search(at, name.end(), found, octal)) {
      plain += static_cast<char>(std::stoi(found[1], nullptr, 8));
      at += found.length();
    } else {
      plain += *at++;
    }
  }
  return plain;
}

/// Files that succeeding calls opened or changed, absolute; calls that only check whether a file exists are left out.
Touched touched(const std::string& log, const fs::path& working) {
  static const std::regex call(R"re(^\d+ +(\w+)\((.*)\) += (-?\d+)(?:<([^>]*)>)?)re");
  static const std::regex named(R"re((?:(?:AT_FDCWD|\d+)<([^>]*)>, )?"([^"]*)")re");
  static const std::regex to_write("O_WRONLY|O_RDWR|O_CREAT|O_TRUNC");
  static const std::set<std::string> changes = {"mkdir",   "mkdirat",   "rename", "renameat", "renameat2",
                                                "unlink",  "unlinkat",  "rmdir",  "link",     "linkat",
                                                "symlink", "symlinkat", "chmod",  "fchmodat", "truncate"};
  static const std::set<std::string> network = {"socket", "connect", "bind", "sendto"};
  Touched all;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    std::smatch found;
    if (!std::regex_search(line, found, call)) continue;
    const std::string name = found[1], arguments = found[2];
    if (network.contains(name)) all.network.push_back(line);
    if (found[3].str().starts_with('-')) continue;
    if (name == "open" || name == "openat" || name == "creat") {
      const bool writes = name == "creat" || std::regex_search(arguments, to_write);
      (writes ? all.written : all.read).insert(unescaped(found[4]));
    } else if (changes.contains(name)) {
      for (std::sregex_iterator path(arguments.begin(), arguments.end(), named), end; path != end; ++path) {
        const fs::path base = (*path)[1].matched ? fs::path(unescaped((*path)[1])) : working;
        all.written.insert((base / unescaped((*path)[2])).lexically_normal().string());
      }
    }
  }
  return all;
}

/// Files outside all folders.
std::vector<std::string> outside(const std::set<std::string>& files, const std::vector<fs::path>& folders) {
  std::vector<std::string> found;
  for (const std::string& file : files)
    if (std::ranges::none_of(folders, [&](const fs::path& folder) {
          return std::ranges::mismatch(folder, fs::path(file)).in1 == folder.end();
        }))
      found.push_back(file);
  return found;
}

TEST(SolveUnderStrace, TouchesInputOutputAndCacheAlone) {
  ASSERT_EQ(std::system("command -v strace >/dev/null"), 0) << "scripts/setup.sh installs strace";
  if (std::system("strace -f -o /dev/null true >/dev/null 2>&1") != 0) GTEST_SKIP() << "this machine forbids tracing";
  const test::TemporaryDirectory temporary;
  const fs::path folder = fs::canonical(temporary.path());
  const fs::path input = folder / "input", output = folder / "output", cache = folder / "cache", log = folder / "log";
  fs::create_directory(input);
  fs::copy_file(PRS_SOURCE_DIR "/configs/13_three_models.yaml", input / "case.yaml");
  // The leak check cannot be traced.
  const test::Outcome run =
      test::run_prs("solve input/case.yaml --output output --quiet", folder,
                    "env ASAN_OPTIONS=detect_leaks=0 PRS_CACHE_DIR='" + cache.string() +
                        "' $(command -v strace) -f -y -s 4096 -o '" + log.string() + "' -e trace=%file,%network");
  ASSERT_EQ(run.status, 0) << run.err;
  const Touched files = touched(test::content_of(log), folder);

  EXPECT_THAT(files.written, Contains(EndsWith("output/load_cases.csv")));
  EXPECT_THAT(outside(files.written, {output, cache, "/dev/null"}), testing::IsEmpty());
  EXPECT_THAT(files.read, Contains((input / "case.yaml").string()));
  // Programs are read too, with the libraries of the system and its own information.
  const fs::path program = fs::canonical(test::program()).parent_path().parent_path().parent_path();
  EXPECT_THAT(outside(files.read, {input, output, cache, program, "/lib", "/lib64", "/usr/lib", "/usr/local/lib",
                                   "/etc/ld.so.cache", "/etc/ld.so.preload", "/proc", "/sys/devices/system", "/dev"}),
              testing::IsEmpty());
  EXPECT_THAT(files.network, testing::IsEmpty());
}

}  // namespace
