#include "prs/output/text.h"

#include <gtest/gtest.h>

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
