#include "prs/page/live_parts.h"

#include <gmock/gmock.h>

#include "prs/page/page.h"
#include "tests/support/made_up_live_parts.h"
#include "tests/support/program.h"

namespace prs {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string kNotBuilt = "the engine of live pages is not built; `scripts/web.sh` builds it";
const std::string kOther =
    "the engine of live pages is of other sources than this program; `scripts/web.sh` builds it anew";

TEST(LiveParts, AreReadWhereTheyAreOfTheseSources) {
  const test::TemporaryDirectory folder;
  test::write_live_parts(folder.path());
  const LiveParts parts = read_live_parts(folder.path());
  EXPECT_EQ(parts.absent, "");
  EXPECT_EQ(parts.engine.size(), 1'350'000u);
  EXPECT_EQ(parts.mechanism.script, "mechanism.js.gz");
  EXPECT_EQ(parts.mechanism.hash, "mechanism.hash");
}

TEST(LiveParts, OfOtherSourcesAreRefused) {
  const test::TemporaryDirectory folder;
  for (const std::string& id : {source_id() + "0", source_id().substr(1), std::string("1.0.0")}) {
    test::write_live_parts(folder.path(), id);
    EXPECT_EQ(read_live_parts(folder.path()).absent, kOther) << id;
    EXPECT_THAT(read_live_parts(folder.path()).engine, IsEmpty());
  }
}

TEST(LiveParts, ThatAreNotCompleteAreNone) {
  const test::TemporaryDirectory folder;
  EXPECT_EQ(read_live_parts({}).absent, kNotBuilt);
  EXPECT_EQ(read_live_parts(folder.path() / "nowhere").absent, kNotBuilt);
  EXPECT_EQ(read_live_parts(folder.path()).absent, kNotBuilt);
  for (const char* name : {"source_id", "engine.wasm.lzma", "start.js", "workbench.hash"}) {
    test::write_live_parts(folder.path());
    fs::remove(folder.path() / name);
    EXPECT_EQ(read_live_parts(folder.path()).absent, kNotBuilt) << name;
  }
}

TEST(StaticPage, SaysOnceWhyItIsStaticAndRunsNothing) {
  const test::TemporaryDirectory folder;
  test::write_live_parts(folder.path() / "other", "other");
  const input::Source source = input::load_source(PRS_SOURCE_DIR "/configs/04_contacts_from_geometry.yaml", {});
  const std::string asked = make_report(source, {.live = false}).html;
  EXPECT_THAT(asked, Not(HasSubstr("This page is static")));
  for (const auto& [parts, reason, line] :
       {std::tuple("none", kNotBuilt, "not built; <code>scripts/web.sh</code> builds it.</p>"),
        std::tuple("other", kOther,
                   "of other sources than this program; <code>scripts/web.sh</code> builds it anew.</p>")}) {
    const Report report = make_report(source, {.live_parts = folder.path() / parts});
    EXPECT_THAT(report.notes, Contains("the page is static: " + reason));
    const std::string start = "<p id=\"static\">This page is static: the engine of live pages is ";
    const std::size_t at = report.html.find(start + line);
    ASSERT_NE(at, std::string::npos);
    for (const char* none : {"<script>", "<script type=\"module\"", "text/plain", "script-src", "id=\"live\""})
      EXPECT_THAT(report.html, Not(HasSubstr(none)));
    // The rest equals the page that `--static` writes.
    std::string rest = report.html;
    rest.erase(at, (start + line + "\n").size());
    EXPECT_EQ(rest, asked);
  }
}

/// The program with a folder of data that has the lessons, and live parts written by a test.
class ProgramOfPages : public testing::Test {
 protected:
  test::TemporaryDirectory folder;
  fs::path share = folder.path() / "share", out = folder.path() / "out";
  void SetUp() override {
    fs::create_directories(out);
    fs::create_directories(share);
    fs::create_directory_symlink(PRS_SOURCE_DIR "/configs", share / "lessons");
  }
  test::Outcome prs(const std::string& arguments) const {
    return test::run_prs(arguments, out, "PRS_SHARE='" + share.string() + "'");
  }
};

TEST_F(ProgramOfPages, NotesOnTheTerminalThatAPageIsStatic) {
  const std::string report = "report '" PRS_SOURCE_DIR "/configs/05_standard_screw.yaml' --output page.html";
  const auto line = [](const std::string& reason) { return "prs: the page is static: " + reason + "\n"; };
  const test::Outcome absent = prs(report);
  EXPECT_EQ(absent.status, 0);
  EXPECT_THAT(absent.err, HasSubstr(line(kNotBuilt)));
  EXPECT_THAT(prs(report + " --static").err, Not(HasSubstr("static")));
  test::write_live_parts(share / "web", "other");
  EXPECT_THAT(prs(report).err, HasSubstr(line(kOther)));
  test::write_live_parts(share / "web");
  EXPECT_THAT(prs(report).err, Not(HasSubstr("static")));
  EXPECT_NE(test::content_of(out / "page.html").find("script-src"), std::string::npos);
}

TEST_F(ProgramOfPages, WritesNoWorkbenchAndExploresNothingWithoutAnEngine) {
  for (const std::string& id : {std::string(), std::string("other")}) {
    if (!id.empty()) test::write_live_parts(share / "web", id);
    const std::string refused = "prs: error: " + (id.empty() ? kNotBuilt : kOther) + "\n";
    for (const char* command : {"workbench", "explore '" PRS_SOURCE_DIR "/configs/05_standard_screw.yaml'"}) {
      const test::Outcome run = prs(std::string(command) + " --output page.html");
      EXPECT_EQ(run.status, 1);
      EXPECT_EQ(run.err, refused);
      EXPECT_EQ(run.out, "");
      EXPECT_TRUE(fs::is_empty(out));
    }
  }
  test::write_live_parts(share / "web");
  EXPECT_EQ(prs("workbench --output page.html --quiet").status, 0);
  const std::string page = test::content_of(out / "page.html");
  for (const char* part : {"'workbench.hash'", "worker.js</script>", "<script type=\"module\">start.js</script>"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace prs
