#include <gtest/gtest.h>

#include <fmt/format.h>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "support/temporary_directory.h"

namespace prs {
namespace {

/// Lessons in order, and the comment at the start of each.
struct Lesson {
  std::string name, comment;
};

std::vector<Lesson> lessons_in_order() {
  std::set<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(PRS_SOURCE_DIR "/configs"))
    if (file.path().extension() == ".yaml") files.insert(file.path());
  std::vector<Lesson> lessons;
  for (const auto& file : files) {
    std::istringstream text(test::content_of(file));
    Lesson lesson{file.stem().string(), {}};
    for (std::string line; std::getline(text, line) && line.starts_with('#');) lesson.comment += line + '\n';
    lessons.push_back(lesson);
  }
  return lessons;
}

TEST(Lessons, EachNamesTheNextOne) {
  const std::vector<Lesson> lessons = lessons_in_order();
  for (std::size_t k = 0; k < lessons.size(); ++k) {
    const auto& [name, comment] = lessons[k];
    EXPECT_TRUE(name.starts_with(fmt::format("{:02}_", k + 1))) << name;
    EXPECT_TRUE(comment.starts_with(fmt::format("# Lesson {}: ", k + 1))) << name;
    const std::string next = k + 1 < lessons.size() ? fmt::format("\n# Next: {:02} ", k + 2) : "\n# Next: ";
    EXPECT_NE(comment.find(next), std::string::npos) << name << next;
  }
}

TEST(Lessons, EachWritesIntoAFolderOfItsOwn) {
  const std::regex output("--output ([^/ \n]*/?[^/ \n]*)");
  for (const auto& [name, comment] : lessons_in_order())
    for (auto it = std::sregex_iterator(comment.begin(), comment.end(), output); it != std::sregex_iterator(); ++it)
      EXPECT_EQ((*it)[1].str(), "out/" + name);
}

TEST(Lessons, TheirPageListsThemAll) {
  const std::string page = test::content_of(PRS_SOURCE_DIR "/docs/lessons.md");
  for (const auto& [name, comment] : lessons_in_order())
    EXPECT_NE(page.find("| `" + name + "` | "), std::string::npos) << name;
}

}  // namespace
}  // namespace prs
