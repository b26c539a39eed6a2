// The command line: help, suggestions, errors, standard input, manual and completions.

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "prs/file_descriptor.h"
#include "tests/support/processes.h"
#include "tests/support/program.h"
#include "tests/support/temporary_directory.h"

namespace prs {
namespace {

using test::Outcome;
using test::run_prs;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kScrew = "configs/01_config_1_to_3.yaml";

TEST(Usage, ErrorsSayWhatWasFoundWhatIsAllowedAndWhereHelpIs) {
  const std::string screw = kScrew;
  for (const auto& [arguments, message] : std::vector<std::pair<std::string, std::string>>{
           {"lists", "got lists; expected a command; did you mean `list`? See `prs help`"},
           {"frobnicate", "got frobnicate; expected a command; see `prs help`"},
           {"slove - --json", "got slove; expected a command; did you mean `solve`? See `prs help`"},
           {"new standard --starts 99999999999999999999",
            "--starts: got 99999999999999999999; expected a whole number from 1 to 100"},
           {"case.yaml",
            "got case.yaml; expected a command before it, for example `prs check "
            "case.yaml`; see `prs help`"},
           {"solve", "FILE is missing; expected `prs solve [OPTIONS] FILE`; see `prs help solve`"},
           {"study", "FILE is missing; expected a case, a YAML file; see `prs help study`"},
           {"solve a b", "got b; expected no further word; see `prs help solve`"},
           {"solve a --jsn",
            "got --jsn; expected an option of `prs solve`; did you mean `--json`? See `prs help "
            "solve`"},
           {"study a --thread=3",
            "got --thread; expected an option of `prs study`; did you mean `--threads`? See `prs "
            "help study`"},
           {"--json solve a",
            "got --json before `solve`; expected it after the command: `prs solve .. --json`; see "
            "`prs help solve`"},
           {"list comands", "WHAT: got comands; expected one of commands, inputs"},
           {"list comands", "; did you mean `commands`? See `prs help list`"},
           {"study a --threads 0", "--threads: got 0; expected a whole number from 1 to 4096; see `prs help study`"},
           {"study a --threads 2.5", "--threads: got 2.5; expected a whole number"},
           {"study a --threads", "--threads: got no value; expected `--threads N`; see"},
           {"study a --shard 3", "--shard: got 3; expected i/n, from 1/n to n/n"},
           {"study a --shard 1/2", "--shard is given alone; expected --output DIR with it"},
           {"study a merge b", "got FILE a before `merge`; expected `prs study merge DIR..`"},
           {"study merge",
            "DIR is missing; expected `prs study merge [OPTIONS] DIR..`; see `prs "
            "help study merge`"},
           {"solve a --json=3", "--json: got a value; expected none; see `prs help solve`"},
           {"solve a -o x -o y", "--output: got it 2 times; expected it once"},
           {"solve a -o ''", "--output: got nothing; expected a folder"},
           {"check " + screw + " --set mechanism.rollers",
            "--set: got mechanism.rollers; expected PATH=VALUE, for example"},
           {"check " + screw + " --set =9", "--set: got =9; expected PATH=VALUE"},
           {"check " + screw + " --set ''", "--set: got nothing; expected PATH=VALUE"},
           {"compare " + screw + " ''", "OTHER: got nothing; expected a file; see `prs help compare`"},
           {"list commands ''", "FILE: got nothing; expected a file"},
           {"manual solve -o ''", "--output: got nothing; expected a folder"},
           {"manual -o README.md", "--output: got README.md, which is a file; expected a folder"},
           {"new ''", "TYPE: got nothing; expected standard|inverted|recirculating"},
           {"new standard ''", "FILE: got nothing; expected a file"},
           {"study merge ''", "DIR: got nothing; expected a folder"},
           {"configurations --lead 5mm --screw-diameter 25mm --write 1 ''", "--write: got nothing; expected a file"},
           {"configurations --lead 5mm --screw-diameter 25mm --json --write 1 -",
            "got --json and `-` for a case; expected one document; give a file for the case"},
           {"'a b.yaml'", "for example `prs check 'a b.yaml'`"},
           {"configurations --lead 3mm",
            "--screw-diameter: missing; expected this or `--nut-diameter`; give one of them"},
           {"configurations --screw-diameter 24 --lead 3mm",
            "--screw-diameter: got 24; expected a length with its unit"},
           {"size configs/32_press.yaml --write 1 x.yaml --write 2 ./x.yaml",
            "--write: got ./x.yaml twice; expected a file for each candidate; give another name"},
           {"configurations --write 3", "--write: got 3; expected `--write N FILE`"},
           {"new sideways", "TYPE: got sideways; expected one of standard, inverted"},
           {"new standard README.md", "README.md: the file exists already; give another name"},
           {"help sovle", "got sovle; expected a command; did you mean `solve`?"},
           {"help solve x", "got x; expected a command; see `prs help help`"},
           {"manual sovle", "got sovle; expected a command; did you mean `solve`? See `prs help manual`"},
           {"schema new", "WHAT: got new; expected one of input, results, figures, requirement, check"},
           {"completion csh", "SHELL: got csh; expected bash"},
           {"list units x", "got x; expected no further word; see `prs help list`"},
           {"list inputs " + screw, "got " + screw + "; expected no further word"},
           {"solve a --influence", "expected an option of `prs solve`; `prs compare` has it; see"},
           {"solve a --threads 2", "expected an option of `prs solve`; see `prs help solve`"},
           {"--json", "got --json; expected an option of `prs`; see `prs help`"},
           {"solve a --csv german", "--csv: got german; expected one of plain, european; see"},
           {"solve a --csv-digits 0", "--csv-digits: got 0; expected a whole number from 1 to 17"},
           {"solve a --units xx", "--units: got xx; expected one of si, us; see"},
           {"new --lesson 99", "--lesson: got 99; expected a number from 1 to"},
           {"new --lesson 14 case.yaml --lead 5mm",
            "--lead: got a value; expected none with --lesson, which copies what is there; change "
            "the copy; see `prs help new`"},
           {"solve --explain zzz",
            "--explain: got zzz; expected a measure or the path of a result; `prs schema results`"},
           {"measures --explain efficency",
            "--explain: got efficency; expected a measure or the path of a result; did you mean "
            "`efficiency`?"},
           {"validate a b", "got b; expected no further word; see `prs help validate`"}}) {
    SCOPED_TRACE(arguments);
    const Outcome run = run_prs(arguments);
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_THAT(run.err, AllOf(StartsWith("prs: error: "), HasSubstr(message)));
    EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
  }
}

TEST(Usage, OnATerminalErrorsBreakBetweenWords) {
  const FileDescriptor screen(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
  if (::grantpt(screen.get()) != 0) GTEST_SKIP() << "needs pseudo-terminals: /dev/pts is not mounted";
  ASSERT_EQ(::unlockpt(screen.get()), 0);
  const std::string name = ::ptsname(screen.get());
  const FileDescriptor terminal(::open(name.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
  const winsize size{.ws_row = 24, .ws_col = 60, .ws_xpixel = 0, .ws_ypixel = 0};
  ASSERT_EQ(::ioctl(terminal.get(), TIOCSWINSZ, &size), 0);
  test::Process process({"sh", "-c", "exec '" + std::string(test::program()) + "' solve a --jsn 2>" + name});
  EXPECT_EQ(process.wait(), 2);
  std::string shown(1000, '\0');
  shown.resize(static_cast<std::size_t>(std::max<ssize_t>(0, ::read(screen.get(), shown.data(), shown.size()))));
  EXPECT_EQ(shown,
            "prs: error: got --jsn; expected an option of `prs solve`;\r\n"
            "  did you mean `--json`? See `prs help solve`\r\n");
}

TEST(Usage, AFileInPlaceOfTheOutputFolderIsToldBeforeAnythingIsComputed) {
  const test::TemporaryDirectory folder;
  std::ofstream(folder.path() / "file") << "x";
  for (const std::string command : {"solve", "study", "optimize", "check"}) {
    const Outcome run = run_prs(command + " missing.yaml -o file", folder.path());
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.err,
              "prs: error: --output: got file, which is a file; expected a folder; give another "
              "name; see `prs help " +
                  command + "`\n");
  }
}

TEST(Usage, WithoutACommandTheCommandsStandByPurpose) {
  const Outcome run = run_prs("");
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, "");
  for (const char* said :
       {"Analyse a case:\n", "  solve  ", "Compute many designs:\n", "  study  ", "`prs help COMMAND`"})
    EXPECT_THAT(run.err, HasSubstr(said));
}

/// Calls `see` with each command, including subcommands: `study merge`.
void for_each_command(const nlohmann::json& program,
                      const std::function<void(const std::string&, const nlohmann::json&)>& see) {
  for (const nlohmann::json& command : program.value("commands", nlohmann::json::array())) {
    see(command["name"].get<std::string>().substr(4), command);
    for_each_command(command, see);
  }
}

TEST(Help, AGroupOfCommandsStandsOnce) {
  for (const char* page : {"--help", "help", "manual"}) {
    const std::string text = run_prs(page).out;
    const std::string group = page == std::string("manual") ? "\n.SH ANALYSE A CASE\n" : "\nAnalyse a case:\n";
    const std::size_t first = text.find(group);
    ASSERT_NE(first, std::string::npos) << page;
    EXPECT_EQ(text.find(group, first + 1), std::string::npos) << page;
  }
}

TEST(Help, ManualAndHelpHaveEveryOptionOfEveryCommand) {
  const auto program = nlohmann::json::parse(run_prs("help --json").out);
  const std::regex request(R"(^\.(TH|SH|TP|nf|fi|BR) ?.*$)");
  int commands = 0;
  for_each_command(program, [&](const std::string& name, const nlohmann::json& command) {
    SCOPED_TRACE(name);
    ++commands;
    const Outcome help = run_prs("help " + name), manual = run_prs("manual " + name);
    EXPECT_EQ(help.status, 0);
    EXPECT_EQ(help.err, "");
    if (name != "validate") {  // A separate program with the same table.
      EXPECT_EQ(run_prs(name + " --help").out, help.out);
    }
    EXPECT_THAT(help.out, HasSubstr("\nExamples:\n  "));
    for (const nlohmann::json& option : command["options"])
      for (const std::string option_name : option["names"]) {
        EXPECT_THAT(help.out, HasSubstr(option_name));
        EXPECT_THAT(manual.out, HasSubstr(std::regex_replace(option_name, std::regex("-"), "\\-")));
      }
    std::istringstream lines(manual.out);
    for (std::string line; std::getline(lines, line);)
      EXPECT_TRUE(line.empty() || line[0] != '.' || std::regex_match(line, request)) << line;
    std::istringstream help_lines(help.out);
    for (std::string line; std::getline(help_lines, line);) EXPECT_LE(line.size(), 90u) << line;
  });
  EXPECT_GT(commands, 15);
  const std::string statuses = run_prs("help solve").out;
  for (const auto& [status, meaning] : program["exit_status"].items())
    EXPECT_THAT(statuses, HasSubstr("  " + status + " ")) << meaning;
  EXPECT_GE(program["exit_status"].size(), 5u);
}

TEST(Help, PagesOfTheManualAreFiles) {
  const test::TemporaryDirectory folder;
  EXPECT_EQ(run_prs("manual --output '" + folder.path().string() + "'").status, 0);
  for (const char* page : {"prs.1", "prs-solve.1", "prs-study.1", "prs-study-merge.1"})
    EXPECT_THAT(test::content_of(folder.path() / page), StartsWith(".TH prs"));
}

TEST(Help, VersionHasAShortOption) { EXPECT_EQ(run_prs("-V").out, run_prs("--version").out); }

TEST(StandardInput, IsACaseLikeAFile) {
  const Outcome file = run_prs("solve 01_config_1_to_3.yaml --json", PRS_SOURCE_DIR "/configs"),
                piped = run_prs("solve - --json <01_config_1_to_3.yaml", PRS_SOURCE_DIR "/configs");
  EXPECT_EQ(piped.status, 0);
  const auto cases = [](const Outcome& run) { return nlohmann::json::parse(run.out)["load_cases"]; };
  EXPECT_EQ(cases(piped), cases(file));
  // The history is beside the current folder's files.
  const std::string life = "life - --json --quiet <14_flight_spectrum.yaml";
  EXPECT_EQ(run_prs(life, PRS_SOURCE_DIR "/configs").status, 0);
  EXPECT_THAT(run_prs("check - --set mechanism.lead=5 <configs/01_config_1_to_3.yaml").err,
              StartsWith("<stdin>:21:3: error: mechanism.lead: got 5;"));
}

TEST(StandardInput, IsAlsoThatOfAStudyInAFolder) {
  const test::TemporaryDirectory folder;
  const std::string output = " --output '" + folder.path().string() + "' --quiet ";
  ASSERT_EQ(run_prs("study -" + output + "<configs/10_parametric_study.yaml").status, 0);
  ASSERT_EQ(run_prs("solve -" + output + "<configs/10_parametric_study.yaml").status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "study.json"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "result.json"));
  // Another case: the files of the first one are out of date.
  ASSERT_EQ(run_prs("check -" + output + "<configs/01_config_1_to_3.yaml").status, 0);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "result.json"));
}

TEST(Interrupt, EndsEveryCommandWithStatus130) {
  const test::TemporaryDirectory folder;
  const std::string pipe = (folder.path() / "pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const FileDescriptor end(::open(pipe.c_str(), O_RDWR | O_CLOEXEC));
  test::Process process({"sh", "-c", "exec '" + std::string(test::program()) + "' solve - <" + pipe});
  ASSERT_EQ(::write(end.get(), "a", 1), 1);
  // The program has then reached the reading of the case.
  for (int unread = 1; unread > 0;) ASSERT_EQ(::ioctl(end.get(), FIONREAD, &unread), 0);
  process.signal(SIGINT);
  EXPECT_EQ(process.wait(), 130);
}

TEST(Explain, SaysWhatAMeasureOrAResultIs) {
  const Outcome by_name = run_prs("measures --explain buckling_load_N");
  EXPECT_EQ(by_name.status, 0);
  EXPECT_THAT(by_name.out, AllOf(StartsWith("measures."), HasSubstr("source: ")));
  // Every command explains every result, by any end of its path and with any index.
  for (const char* name :
       {"load_cases[3].screw.peak_pressure_MPa", "screw.peak_pressure_MPa.max", "screw.peak_pressure_MPa"}) {
    const Outcome run = run_prs(std::string("solve --explain '") + name + "'");
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr("load_cases[].screw.peak_pressure_MPa\n")) << name;
  }
  const Outcome json = run_prs("measures --json --explain peak_pressure_MPa");
  const auto found = nlohmann::json::parse(json.out)["explanations"];
  EXPECT_GE(found.size(), 2u);
  for (const auto& place : found) EXPECT_EQ(place["key"], "peak_pressure_MPa");
}

/// Completions of bash for the last of these words.
std::vector<std::string> completed(const std::vector<std::string>& words) {
  std::string line = "PATH=\"$(dirname '" + std::string(test::program()) + "'):$PATH\"; " +
                     "source <(prs completion bash); COMP_WORDS=(prs";
  for (const std::string& word : words) line += " '" + word + "'";
  line += "); COMP_CWORD=" + std::to_string(words.size()) + "; _prs 2>/dev/null; printf '%s\\n' \"${COMPREPLY[@]}\"";
  const test::TemporaryDirectory folder;
  std::ofstream(folder.path() / "script") << line;
  const std::string command = "cd '" PRS_SOURCE_DIR "' && bash '" + (folder.path() / "script").string() + "' >'" +
                              (folder.path() / "out").string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::istringstream lines(test::content_of(folder.path() / "out"));
  std::vector<std::string> offered;
  for (std::string offer; std::getline(lines, offer);)
    if (!offer.empty()) offered.push_back(offer);
  return offered;
}

TEST(Completion, OffersCommandsOptionsWordsAndCases) {
  using testing::Contains;
  using testing::ElementsAre;
  using testing::Not;
  EXPECT_THAT(completed({"so"}), ElementsAre("solve"));
  EXPECT_THAT(completed({"help", "so"}), ElementsAre("solve"));
  EXPECT_THAT(completed({"list", "com"}), ElementsAre("commands"));
  EXPECT_THAT(completed({"new", "st"}), ElementsAre("standard"));

  EXPECT_THAT(completed({"new", "--lesson", "14"}), ElementsAre("14_flight_spectrum"));
  EXPECT_THAT(completed({"new", "--lubricant", ""}),
              AllOf(Contains("iso-vg-100"), Not(Contains("name")), Not(Contains("nu")), Not(Contains("[1]"))));
  EXPECT_THAT(completed({"configurations", "--type", ""}), ElementsAre("standard", "inverted", "recirculating"));
  EXPECT_THAT(completed({"solve", "--outp"}), ElementsAre("--output"));
  EXPECT_THAT(completed({"study", "merge", "--res"}), ElementsAre());
  EXPECT_THAT(completed({"study", "--res"}), ElementsAre("--restart"));
  EXPECT_THAT(completed({"study", "mer"}), ElementsAre("merge"));
  EXPECT_THAT(completed({"solve", "configs/01"}), ElementsAre("configs/01_config_1_to_3.yaml"));
  EXPECT_THAT(completed({"solve", "--output", "conf"}), ElementsAre("configs"));
  EXPECT_THAT(completed({"solve", "--set", "a", "=", "b", "READ"}), ElementsAre());
  EXPECT_THAT(completed({"solve", "configs/01_config_1_to_3.yaml", "--set", "mechanism.ro"}),
              ElementsAre("mechanism.rollers=", "mechanism.rollers_unloaded="));
}

}  // namespace
}  // namespace prs
