#include "prs/input/document.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace prs::input {
namespace {

struct ReadText {
  Node root;
  std::string error;
};

ReadText read_text(const std::string& text, std::vector<std::string> overrides = {}) {
  const Source source{"case.yaml", text, std::move(overrides)};
  ErrorList errors(source);
  try {
    Node root = read_document(source, errors);
    errors.throw_if_any();
    return {root, ""};
  } catch (const InputError& e) {
    return {{}, e.what()};
  }
}

std::string where(const std::string& text, const std::string& path) {
  const Source source{"case.yaml", text, {}};
  ErrorList errors(source);
  return errors.where(locate(read_document(source, errors), path));
}

std::string repeated(const std::string& part, std::size_t bytes) {
  std::string text;
  while (text.size() < bytes) text += part;
  return text;
}

TEST(Document, KeepsOrderKindsAndQuotes) {
  const Node root = read_text("b: 5\na: [\"5\", {c: x}, ~]\n").root;
  ASSERT_EQ(root.children.size(), 2U);
  EXPECT_EQ(root.children[0].key, "b");
  EXPECT_EQ(scalar_type(root.children[0]), ScalarType::number);
  const Node& list = root.children[1];
  EXPECT_EQ(list.kind, Node::Kind::sequence);
  EXPECT_EQ(scalar_type(list.children[0]), ScalarType::text);
  EXPECT_EQ(list.children[1].kind, Node::Kind::map);
  EXPECT_EQ(list.children[2].kind, Node::Kind::null);
}

TEST(Document, PlacesCountLinesAndCharactersFromOne) {
  const std::string text = "a: 1\nb:\n  - {µ: 2, c: 3}\r\n  - 4\n";
  EXPECT_EQ(where(text, "a"), "case.yaml:1:4");
  EXPECT_EQ(where(text, "b[0].c"), "case.yaml:3:15");
  EXPECT_EQ(where(text, "b[1]"), "case.yaml:4:5");
}

TEST(Document, PlaceOfAnAbsentValueIsItsInnermostMap) {
  const std::string text = "a:\n  b: {c: 1}\n";
  EXPECT_EQ(where(text, "a.b.x"), "case.yaml:2:3");
  EXPECT_EQ(where(text, "a.x.y"), "case.yaml:1:1");
  EXPECT_EQ(where(text, "x"), "case.yaml:1:1");
}

TEST(Document, AliasesStandForTheirValue) {
  const Node root = read_text("a: &x {b: 1}\nc: *x\n").root;
  EXPECT_EQ(root.children[1].key, "c");
  EXPECT_EQ(root.children[1].children[0].text, "1");
}

TEST(Document, OverridesReplaceAndCreate) {
  const Node root = read_text("a: {b: 1}\nc: [{d: 1}]\n", {"a.b=2", "c[0].d=20 kN", "e.f.g={h: 3}", "a.b=4"}).root;
  EXPECT_EQ(find(*find(root, "a"), "b")->text, "4");
  EXPECT_EQ(find(find(root, "c")->children[0], "d")->text, "20 kN");
  EXPECT_EQ(find(*find(*find(*find(root, "e"), "f"), "g"), "h")->text, "3");
}

TEST(Document, ErrorsOfAnOverrideNameTheOverride) {
  const auto error = [](const char* text, const char* override) { return read_text(text, {override}).error; };
  EXPECT_EQ(error("a: [1]", "a[1]=2").rfind("case.yaml:1:1: error: a[1]: got the index 1", 0), 0U);
  EXPECT_EQ(error("b: 1\na: 1", "a.b=2").rfind("case.yaml:2:1: error: a.b: ", 0), 0U);
  EXPECT_EQ(error("a: 1", "b={").rfind("case.yaml:1:1: error: b: malformed YAML", 0), 0U);
  EXPECT_EQ(error("a: 1", "b={c: 1, c: 2}").rfind("case.yaml:1:1: error: b.c: dup", 0), 0U);
  EXPECT_NE(error("a: 1", "b={").find("(from --set b={)"), std::string::npos);
  for (const char* bad : {"", "=", "a", "a b", "=1", ".a=1", "a.=1", "a..b=1", "a[=1", "a[]=1", "a[0]b=1", "[0]=1"})
    EXPECT_NE(read_text("a: [1]", {bad}).error.find("; expected path=value"), std::string::npos) << bad;
}

TEST(Document, OverridesFindEntriesByTheirNames) {
  const std::string text = "c: [{d: 1}, {name: push 2.5, d: 2}, {name: pull, d: 3}, {name: pull}]\n";
  const Node root = read_text(text, {"c[push 2.5].d=5", "c[push 2.5].e.f=6", "c[0].d=7"}).root;
  const std::vector<Node>& entries = find(root, "c")->children;
  EXPECT_EQ(find(entries[0], "d")->text, "7");
  EXPECT_EQ(find(entries[1], "d")->text, "5");
  EXPECT_EQ(find_path(root, "c[push 2.5].e.f")->text, "6");
  EXPECT_EQ(with_indices(root, "c[push 2.5].e.f"), "c[1].e.f");
  for (const char* same : {"c[0].d", "c[none].d", "c[pull].d", "x[push 2.5]", "c[", ""})
    EXPECT_EQ(with_indices(root, same), same);
  const auto error = [&](const char* override) { return read_text(text, {override}).error; };
  EXPECT_NE(error("c[pul].d=1")
                .find("c[pul].d: got the name pul; expected that of an entry (push 2.5, "
                      "pull, pull), or an index below 4"),
            std::string::npos)
      << error("c[pul].d=1");
  EXPECT_NE(error("c[pul].d=1").find("did you mean `pull`?"), std::string::npos);
  EXPECT_NE(error("c[pull].d=1").find("which 2 entries have"), std::string::npos);
  for (const char* bad : {"a[-1]=1", "a[x]=1", "a[99999999999999999999]=1"})
    EXPECT_NE(read_text("a: [1]", {bad}).error.find("of which none has one, or an index below 1"), std::string::npos)
        << bad;
}

TEST(Document, NestingIsBounded) {
  for (const char* opening : {"[", "{a: ", "- ", "? ", "[a, ", "{? "})
    EXPECT_NE(read_text(repeated(opening, 60'000)).error.find("more than 64 nested levels"), std::string::npos)
        << opening;
  EXPECT_EQ(read_text(std::string(60, '[') + std::string(60, ']')).error, "");
}

TEST(Document, AliasExpansionIsBounded) {
  std::string bomb = "a0: &a0 [x,x,x,x,x,x,x,x,x,x]\n";
  for (int i = 1; i < 11; ++i) {
    const std::string alias = "*a" + std::to_string(i - 1);
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + alias;
    for (int k = 1; k < 10; ++k) bomb += ", " + alias;
    bomb += "]\n";
  }
  EXPECT_NE(read_text(bomb).error.find("more than 200000 values, aliases expanded"), std::string::npos);
  const std::string large = "a: &a \"" + std::string(900'000, 'x') + "\"\nb: [";
  EXPECT_NE(read_text(large + repeated("*a, ", 80'000) + "*a]").error.find("more than 200000 values"),
            std::string::npos);
  EXPECT_NE(read_text("a: &a [*a]").error.find("alias of a value that contains it"), std::string::npos);
}

TEST(Document, TextsAreBoundedLikeFiles) {
  constexpr std::size_t kMiB = std::size_t{1} << 20;
  EXPECT_EQ(source_of_text("case", std::string(kMiB, 'a'), {}).text.size(), kMiB);
  try {
    source_of_text("case", std::string(kMiB + 1, 'a'), {});
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(e.what(),
                 "case:1:1: error: got a text of 1048577 bytes; expected a YAML text of at most 1 "
                 "MiB; check that it is the right one");
  }
}

TEST(Document, WhatIsNoRegularFileIsRefused) {
  const auto refusal = [](const std::string& file) -> std::string {
    try {
      load_source(file, {});
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  EXPECT_EQ(refusal("/no/such/file.yaml").rfind("/no/such/file.yaml:1:1: error: got no such file", 0), 0U);
  EXPECT_NE(refusal(folder.string()).find(":1:1: error: got a folder"), std::string::npos);
  EXPECT_NE(refusal("/dev/zero").find(":1:1: error: got no regular file"), std::string::npos);

  const std::filesystem::path large = folder / "prs-input-document-test.yaml";
  std::ofstream(large) << repeated("a: 1\n", 5'000'000);
  EXPECT_NE(refusal(large.string()).find("at most 1 MiB"), std::string::npos);
  std::filesystem::remove(large);
}

TEST(Document, AByteOrderMarkIsNoPartOfTheText) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "prs-input-document-bom-test.yaml";
  std::ofstream(file) << "\xEF\xBB\xBF"
                         "a: 1\n";
  EXPECT_EQ(load_source(file.string(), {}).text, "a: 1\n");
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace prs::input
