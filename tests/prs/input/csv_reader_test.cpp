#include "prs/input/csv_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace prs::input {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
using Rows = std::vector<std::vector<std::string>>;

Rows rows_of(std::string_view text) {
  CsvReader reader(text);
  Rows rows;
  while (reader.next()) rows.emplace_back(reader.fields().begin(), reader.fields().end());
  return rows;
}

/// Error of a text, after its offset.
std::string csv_error_of(std::string_view text) {
  try {
    rows_of(text);
  } catch (const CsvError& error) {
    return std::to_string(error.offset()) + ": " + error.what();
  }
  return "no error";
}

TEST(CsvReader, ReadsTheExamplesOfRfc4180) {
  EXPECT_EQ(rows_of("aaa,bbb,ccc\r\nzzz,yyy,xxx\r\n"), (Rows{{"aaa", "bbb", "ccc"}, {"zzz", "yyy", "xxx"}}));
  EXPECT_EQ(rows_of("aaa,bbb\r\nzzz,yyy"), (Rows{{"aaa", "bbb"}, {"zzz", "yyy"}}));
  EXPECT_EQ(rows_of("\"aaa\",\"b \r\nbb\",\"ccc\" \r\nzzz,yyy,xxx"),
            (Rows{{"aaa", "b \r\nbb", "ccc"}, {"zzz", "yyy", "xxx"}}));
  EXPECT_EQ(rows_of("\"aaa\",\"b\"\"bb\",\"c,cc\"\r\n"), (Rows{{"aaa", "b\"bb", "c,cc"}}));
}

TEST(CsvReader, TakesTheFirstSeparatorOutsideQuotes) {
  EXPECT_EQ(rows_of("\"a,b\";c,d\n"), (Rows{{"a,b", "c,d"}}));
  EXPECT_EQ(rows_of("a b\tc;d\n"), (Rows{{"a b", "c;d"}}));
  EXPECT_EQ(rows_of("alone\n"), (Rows{{"alone"}}));
}

TEST(CsvReader, SkipsBlanksEmptyLinesCommentsAndTheByteOrderMark) {
  EXPECT_EQ(rows_of("\xEF\xBB\xBF# \"odd\n\n a , \"b\" \n  \n#,\n,\n,c\n"), (Rows{{"a", "b"}, {"", ""}, {"", "c"}}));
  EXPECT_EQ(rows_of("a,\"x\n# kept\n\ny\"\n"), (Rows{{"a", "x\n# kept\n\ny"}}));
  EXPECT_TRUE(rows_of("").empty());
  EXPECT_TRUE(rows_of("# nothing").empty());
}

/// Marks and leftovers of spreadsheets.
TEST(CsvReader, SkipsTheNamedSeparatorAndWhatIsEmptyBeyondTheColumns) {
  EXPECT_EQ(rows_of("\xEF\xBB\xBFsep=;\r\na;b;;\r\n1,5;2;;\r\n;;;\r\n3;;\r\n;;;\r\n\r\n;;;\r\n"),
            (Rows{{"a", "b"}, {"1.5", "2"}, {"", ""}, {"3", ""}}));
  EXPECT_EQ(rows_of("a,b\nsep=,2,x,\n"), (Rows{{"a", "b"}, {"sep=", "2", "x"}}));
}

/// Numbers as in German spreadsheets.
TEST(CsvReader, ReadsDecimalCommasBetweenSemicolonsAndTabs) {
  EXPECT_EQ(rows_of("\xEF\xBB\xBFZeit;Kraft [kN]\r\n0,5;1.234,5\r\n-12.000;+3,25e-3\r\n"),
            (Rows{{"Zeit", "Kraft [kN]"}, {"0.5", "1234.5"}, {"-12000", "+3.25e-3"}}));
  // A column whose points are ambiguous; a number below one has no thousands.
  EXPECT_EQ(rows_of("a;b\n1,5;1.250\n2;-0.125\n3;0.5\n"),
            (Rows{{"a", "b"}, {"1.5", "1.250 or 1250"}, {"2", "-0.125"}, {"3", "0.5"}}));
  EXPECT_EQ(rows_of("a\tb\n1,5\t1 234,25\n"), (Rows{{"a", "b"}, {"1.5", "1234.25"}}));
  EXPECT_EQ(rows_of("a;b\n\"1,5\";x,y\n"), (Rows{{"a", "b"}, {"1.5", "x,y"}}));
}

TEST(CsvReader, LeavesNumbersWithPointsAsTheyAre) {
  EXPECT_EQ(rows_of("a;b\n1.500;2.5\n"), (Rows{{"a", "b"}, {"1.500", "2.5"}}));
  EXPECT_EQ(rows_of("a;b\n1.500;2\n0.500;2\n"), (Rows{{"a", "b"}, {"1.500", "2"}, {"0.500", "2"}}));
  EXPECT_EQ(rows_of("a\tb\n1,500\t2.500\n"), (Rows{{"a", "b"}, {"1,500", "2.500"}}));
  EXPECT_EQ(rows_of("a,b\n\"1,5\",1.500\n"), (Rows{{"a", "b"}, {"1,5", "1.500"}}));
  const std::string digits(1000000, '1');
  EXPECT_EQ(rows_of("a;b\n1,5;" + digits + "\n"), (Rows{{"a", "b"}, {"1.5", digits}}));
}

/// Thousands of one country are decimals of another.
TEST(CsvReader, PointsBetweenSemicolonsMustShowWhatTheyAre) {
  EXPECT_EQ(rows_of("a;b\n1.500;2\n"), (Rows{{"a", "b"}, {"1.500 or 1500", "2"}}));
  EXPECT_EQ(rows_of("# 1,5;2.5\na;b\n1.500;2\n"), (Rows{{"a", "b"}, {"1.500 or 1500", "2"}}));
  EXPECT_EQ(rows_of("a;b\n1.500;1.000.000\n"), (Rows{{"a", "b"}, {"1500", "1000000"}}));
  EXPECT_EQ(rows_of("a;b\n\"1\u00a0000,5\";2\n"), (Rows{{"a", "b"}, {"1000.5", "2"}}));
  EXPECT_EQ(rows_of("a;b\n1\u00a0000;15,5\n"), (Rows{{"a", "b"}, {"1000", "15.5"}}));
}

TEST(CsvReader, FieldsStandWhereTheyWereWritten) {
  const std::string text = "# x\na,\"b\nb\", c\n1,2,3";
  CsvReader reader(text);
  ASSERT_TRUE(reader.next());
  const std::size_t first = reader.row_offset();
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(first, 4u);
  EXPECT_EQ(reader.field_offset(first, 1), text.find("\"b\n"));
  EXPECT_EQ(reader.field_offset(first, 2), text.find(" c"));
  EXPECT_EQ(reader.field_offset(first, 3), text.find("\n1"));
  EXPECT_EQ(reader.field_offset(reader.row_offset(), 2), text.size() - 1);
  EXPECT_EQ(reader.field_offset(reader.row_offset(), 3), text.size());
}

TEST(CsvReader, RefusesWhatCannotBeReadInOneWay) {
  EXPECT_THAT(csv_error_of("a,5\" disc\n"), StartsWith("3: got a quote within a field; expected "));
  EXPECT_THAT(csv_error_of("a\n\"b\"c\n"), StartsWith("5: got a quote within a field; expected "));
  EXPECT_THAT(csv_error_of("a\n\"b\nc\n"), StartsWith("2: got a quote that never closes; expected "));
  EXPECT_THAT(csv_error_of(std::string("\xFF\xFE"
                                       "a\0\n\0",
                                       6)),
              HasSubstr("got a text in UTF-16"));
  EXPECT_THAT(csv_error_of("a\n1\r2\r3\n"), StartsWith("2: got a carriage return within a line"));
}

/// A superfluous quote keeps no more than a row in memory.
TEST(CsvReader, RowsAreBounded) {
  std::string text = "a\n\"";
  while (text.size() < (std::size_t{3} << 20U)) text += "1,2,3\n";
  EXPECT_THAT(csv_error_of(text), StartsWith("2: got a row of more than 1024 KiB; expected a shorter"));
}

}  // namespace
}  // namespace prs::input
