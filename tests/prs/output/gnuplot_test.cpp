#include "prs/output/gnuplot.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "support/temporary_directory.h"

namespace prs {
namespace {

TEST(GnuplotProcess, EndsItsScriptWhereTheTerminalInterruptsIt) {
  const test::TemporaryDirectory folder;
  std::ofstream(folder.path() / "s.gp") << "x = system('kill -INT $PPID')\n"
                                        << "set print 'done'\nprint 'drawn'\n";
  EXPECT_EQ(GnuplotProcess(folder.path(), "s.gp").wait(), "");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "done"));
}

TEST(GnuplotProcess, SaysWhatIsWrongWithAScript) {
  const test::TemporaryDirectory folder;
  std::ofstream(folder.path() / "s.gp") << "plot no such thing\n";
  EXPECT_NE(GnuplotProcess(folder.path(), "s.gp").wait(), "");
}

}  // namespace
}  // namespace prs
