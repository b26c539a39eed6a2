#include <gtest/gtest.h>

#include "prs/input/document.h"
#include "prs/input/reader.h"
#include "support/count.h"
#include "support/cpu_time.h"
#include "support/sanitized.h"

namespace prs::input {
namespace {

std::string text_of(const std::string& part, std::size_t bytes) {
  std::string text;
  while (text.size() < bytes) text += part;
  return text;
}

/// A megabyte; a fifth under sanitizers.
std::size_t bytes() { return static_cast<std::size_t>(test::samples(1 << 20, 1 << 20)); }

/// Processor time of reading a text [s], and the error.
std::pair<double, std::string> reading(const std::string& text) {
  std::string error;
  const double time = test::cpu_seconds([&] {
    try {
      const Source source{"case.yaml", text, {}};
      ErrorList errors(source);
      read_document(source, errors);
      errors.throw_if_any();
    } catch (const InputError& e) {
      error = e.what();
    }
  });
  return {time, error};
}

double time_of_plain_text() {
  const auto [time, error] = reading(text_of("- 12.345 mm\n", bytes()));
  EXPECT_EQ(error, "");
  return time;
}

/// No text takes more than a few times as long as a plain one of its size: a time that grows with the square of the
/// size would be 100,000 times as long.
TEST(DocumentTime, AMegabyteOfAnythingIsRefusedAboutAsQuicklyAsPlainTextIsRead) {
  SKIP_UNDER_SANITIZERS();
  const double plain = time_of_plain_text();
  for (const char* part : {"[",     "]",    "{",   "}",   "- ",   "a: ",  "a: 1\n", "a:\n ",    "{? ",  "? ",
                           "&a ",   "*a ",  "!a ", "\"",  "'",    "\"\\", "|\n",    ">\n",      "%a\n", "---\n",
                           "...\n", ",",    ":",   "#",   "\n",   "\r",   "\t",     "a,",       "[a,",  "{a,",
                           "[[],",  "- - ", "-\n", "?\n", "<<: ", "a\n",  "k",      "\xC3\xA9", "\xFF", "@"}) {
    std::string error;
    const std::string text = text_of(part, bytes()).substr(0, bytes());
    const double taken = test::cpu_seconds([&] {
      try {
        read_case_text(text, "case.yaml", {}, Command::check);
      } catch (const InputError& e) {
        error = e.what();
      }
    });
    EXPECT_LT(taken, 20.0 * plain) << part;
    EXPECT_EQ(error.rfind("case.yaml:", 0), 0U) << part << error;
    EXPECT_NE(error.find(": error: "), std::string::npos) << part << error;
  }
}

TEST(DocumentTime, ManyDuplicateKeysAreRefusedAboutAsQuicklyAsPlainTextIsRead) {
  const double plain = time_of_plain_text();
  const auto [taken, error] = reading(text_of("a: 1\n", bytes() / 7 * 3));
  EXPECT_NE(error.find("duplicate key"), std::string::npos);
  EXPECT_LT(taken, 20.0 * plain);
}

}  // namespace
}  // namespace prs::input
