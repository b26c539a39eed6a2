#include "prs/text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace prs {
namespace {

TEST(Text, PrintableKeepsWellFormedTextOnly) {
  EXPECT_EQ(printable("µm – 漢 😀"), "µm – 漢 😀");
  EXPECT_EQ(printable("a\tb\x1b\x7f\xC2\x85"), "a b   ");
  EXPECT_EQ(printable("\xff"), "\uFFFD");
  EXPECT_EQ(printable("\xE2\x82"), "\uFFFD\uFFFD");                      // Cut short.
  EXPECT_EQ(printable("\xC0\xAF"), "\uFFFD\uFFFD");                      // Overlong.
  EXPECT_EQ(printable("\xED\xA0\x80").find("\xED"), std::string::npos);  // A surrogate.
}

TEST(Text, PrintableShowsWhereTextIsHiddenOrTurned) {
  for (const char* hidden : {"\u061c", "\u200b", "\u200e", "\u200f", "\u202a", "\u202e", "\u2060", "\u2066", "\u2069",
                             "\ufeff", "\ufffb", "\U000e0041"})
    EXPECT_EQ(printable("a" + std::string(hidden) + "b"), "a\uFFFDb") << hidden;
  for (const char* control : {"\u0080", "\u009b", "\u009f", "\u2028", "\u2029"})
    EXPECT_EQ(printable("a" + std::string(control) + "b"), "a b");
  EXPECT_EQ(printable("\u00a0\u0639\u05d0\u0301\u2030"), "\u00a0\u0639\u05d0\u0301\u2030");
}

TEST(Text, PrintableLinesKeepsLinesOnly) {
  EXPECT_EQ(printable_lines("a\nb\n"), "a\nb\n");
  EXPECT_EQ(printable_lines("a\n\tb\r\x1b\u202e\n"), "a\n b  \uFFFD\n");
}

TEST(Text, WideLinesBreakBetweenWords) {
  EXPECT_EQ(wrapped_lines("one two three\nfour\n  five six\n", 9), "one two\n  three\nfour\n  five\n    six\n");
  EXPECT_EQ(wrapped_lines("one two three", 9), "one two\n  three");
  EXPECT_EQ(wrapped_lines("a\n\nb", 9), "a\n\nb");
}

TEST(Text, PrintableJsonSaysTheSame) {
  const nlohmann::json json{{"name", "a\u0085\u202e\x7f\U000e0041\u2028\ufeff µ 😀\n\x1b"}};
  const std::string text = printable_json(json.dump(2));
  EXPECT_EQ(nlohmann::json::parse(text), json);
  EXPECT_EQ(printable_lines(text), text);
  EXPECT_NE(text.find("µ 😀"), std::string::npos);
}

TEST(Text, ShortenedCountsCharacters) {
  EXPECT_EQ(shortened("µµµ", 3), "µµµ");
  EXPECT_EQ(shortened("aµbcµd", 5), "aµ…µd");
  EXPECT_EQ(shortened("abcd", 1), "…");
}

TEST(Text, WrappedBreaksAtSpacesAndIndents) {
  EXPECT_EQ(wrapped("one two three", "  ", 9), "  one two\n  three\n");
  EXPECT_EQ(wrapped("indivisible", "  ", 5), "  indivisible\n");
}

}  // namespace
}  // namespace prs
