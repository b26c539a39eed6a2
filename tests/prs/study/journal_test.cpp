#include "prs/study/journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <bit>
#include <boost/crc.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "prs/sha256.h"
#include "support/small_files.h"
#include "synthetic_study.h"
#include "tests/support/temporary_directory.h"

namespace prs {
namespace {

namespace fs = std::filesystem;
using test::content_of;
using test::folder_error_of;
using test::same_rows;
using test::synthetic_header;
using test::synthetic_rows;
using testing::HasSubstr;

constexpr std::size_t kJournalDesigns = 1000;
constexpr std::size_t kRows = 30;

void write(const fs::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

/// A journal of three blocks, not in their order; returns where each ends.
std::vector<std::uint64_t> write_journal(const fs::path& path) {
  Journal journal = Journal::append_to(path, synthetic_header(kJournalDesigns));
  std::vector<std::uint64_t> ends;
  for (const std::size_t first : {100, 0, 200}) {
    journal.append(encode(synthetic_rows(first, kRows)));
    ends.push_back(fs::file_size(path));
  }
  return ends;
}

TEST(Journal, GivesBackEveryBit) {
  const test::TemporaryDirectory temporary;
  const fs::path path = temporary.path() / "study.journal";
  RowBlock block{5, 2, {}, {{1, {"refused", std::string("a\0\n\xff,", 5)}}}};
  for (const std::uint64_t bits :
       {0x7ff8000000000abcULL, 0xfff0000000000000ULL, 1ULL, 0x8000000000000000ULL, 0x3ff0000000000001ULL, 0ULL})
    block.responses.push_back(std::bit_cast<double>(bits));
  {
    Journal journal = Journal::append_to(path, synthetic_header(kJournalDesigns));
    journal.append(encode(block));
    EXPECT_EQ(encode(journal.block(journal.records()[0])), encode(block));
  }
  const Journal journal = Journal::read(path);
  ASSERT_EQ(journal.records().size(), 1u);
  EXPECT_EQ(journal.records()[0].designs, (DesignRange{5, 2}));
  const RowBlock read = journal.block(journal.records()[0]);
  for (std::size_t k = 0; k < block.responses.size(); ++k)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read.responses[k]), std::bit_cast<std::uint64_t>(block.responses[k]));
  ASSERT_EQ(read.failures.size(), 1u);
  EXPECT_EQ(read.failures[0].row, 1u);
  EXPECT_EQ(read.failures[0].status.reason, block.failures[0].status.reason);
}

TEST(Journal, TakesWhatWasEncodedForItsStudy) {
  const Journal journal = Journal::temporary(synthetic_header(kJournalDesigns));
  const std::string record = encode(synthetic_rows(100, kRows));
  EXPECT_TRUE(journal.takes(record));
  for (std::size_t size = 0; size < record.size(); ++size) EXPECT_FALSE(journal.takes(record.substr(0, size))) << size;
  EXPECT_FALSE(journal.takes(record + '\0'));
  EXPECT_FALSE(journal.takes(encode(synthetic_rows(kJournalDesigns, kRows))));
}

TEST(Journal, HeaderTellsAllThatTheFilesOfTheStudyNeed) {
  const test::TemporaryDirectory temporary;
  const fs::path path = temporary.path() / "study.journal";
  JournalHeader header = synthetic_header(kJournalDesigns, {2, 8});
  header.source.text = std::string("not UTF-8: \xff\xfe \0 end", 18);
  Journal::append_to(path, header);
  const JournalHeader read = Journal::read(path).header();
  EXPECT_EQ(read.key, header.key);
  EXPECT_EQ(read.source.name, header.source.name);
  EXPECT_EQ(read.source.text, header.source.text);
  EXPECT_EQ(read.source.overrides, header.source.overrides);
  EXPECT_EQ(read.responses, header.responses);
  EXPECT_EQ(read.designs, header.designs);
  EXPECT_EQ(read.shard, header.shard);
}

TEST(Journal, TailTornAtAnyByteCostsTheLastBlockOnly) {
  const test::TemporaryDirectory temporary;
  const fs::path path = temporary.path() / "study.journal";
  const std::vector<std::uint64_t> ends = write_journal(path);
  const std::string whole = content_of(path);
  for (std::uint64_t size = ends[1]; size < ends[2]; ++size) {
    write(path, whole.substr(0, size));
    const Journal torn = Journal::read(path);
    ASSERT_EQ(torn.records().size(), 2u) << size;
    ASSERT_FALSE(torn.is_damaged());
    Journal journal = Journal::append_to(path, synthetic_header(kJournalDesigns));
    ASSERT_EQ(fs::file_size(path), ends[1]);
    journal.append(encode(synthetic_rows(200, kRows)));
    ASSERT_EQ(content_of(path), whole) << size;
  }
}

TEST(Journal, HeaderTornAtAnyByteBeginsAnew) {
  const test::TemporaryDirectory temporary;
  const fs::path path = temporary.path() / "study.journal";
  Journal::append_to(path, synthetic_header(kJournalDesigns));
  const std::string whole = content_of(path);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    write(path, whole.substr(0, size));
    ASSERT_EQ(Journal::read(path).header().key, "");
    Journal::append_to(path, synthetic_header(kJournalDesigns));
    ASSERT_EQ(content_of(path), whole) << size;
  }
}

TEST(Journal, AnyFlippedBitIsFoundAndWhatStandsBeforeItIsKept) {
  const test::TemporaryDirectory temporary;
  const fs::path path = temporary.path() / "study.journal";
  const std::vector<std::uint64_t> ends = write_journal(path);
  const std::string whole = content_of(path);
  const std::size_t first_record = fs::file_size(path) - 3 * (ends[2] - ends[1]);
  for (std::size_t k = 0; k < whole.size(); k += 1 + k / 100) {
    std::string flipped = whole;
    flipped[k] = static_cast<char>(flipped[k] ^ (1 << k % 8));
    write(path, flipped);
    std::size_t intact = 0;
    while (intact < 3 && ends[intact] <= k) ++intact;
    try {
      const Journal journal = Journal::read(path);
      ASSERT_EQ(journal.records().size(), intact) << k;
      for (std::size_t r = 0; r < intact; ++r)
        ASSERT_TRUE(
            same_rows(journal.block(journal.records()[r]), synthetic_rows(journal.records()[r].designs.first, kRows)));
    } catch (const StudyFolderError&) {
      ASSERT_LT(k, first_record + 100);  // Records have no error message of their own.
    }
  }
}

TEST(Journal, DamageWithinIsTold) {
  const test::TemporaryDirectory temporary;
  const fs::path path = temporary.path() / "study.journal";
  const std::vector<std::uint64_t> ends = write_journal(path);
  std::string bytes = content_of(path);
  bytes[ends[0] + 100] = static_cast<char>(bytes[ends[0] + 100] ^ 1);
  write(path, bytes);
  EXPECT_TRUE(Journal::read(path).is_damaged());
  Journal::append_to(path, synthetic_header(kJournalDesigns));
  EXPECT_EQ(fs::file_size(path), ends[0]);
}

TEST(Journal, WhatIsNoJournalIsRefused) {
  const test::TemporaryDirectory temporary;
  const fs::path path = temporary.path() / "study.journal";
  write(path, "design,status\n0,converged\n");
  for (const std::string& error : {folder_error_of([&] { Journal::read(path); }), folder_error_of([&] {
                                     Journal::append_to(path, synthetic_header(kJournalDesigns));
                                   })}) {
    EXPECT_THAT(error, HasSubstr(path.string() + ": error: "));
    EXPECT_THAT(error, HasSubstr("--restart"));
  }
  EXPECT_EQ(content_of(path), "design,status\n0,converged\n");
  Journal::append_to(path, synthetic_header(kJournalDesigns), true);
  EXPECT_EQ(Journal::read(path).header().designs, kJournalDesigns);
}

std::string word(std::uint64_t number) { return std::string(reinterpret_cast<const char*>(&number), sizeof number); }

std::string text_of(const std::string& text) { return word(text.size()) + text; }

/// A whole journal that begins with these bytes in place of a header.
std::string journal_of(const std::string& header) {
  const std::string sealed = word(header.size() + 16) + header;
  boost::crc_optimal<32, 0x1EDC6F41, 0xFFFFFFFF, 0xFFFFFFFF, true, true> crc;
  crc.process_bytes(sealed.data(), sealed.size());
  return "PRS-JNA2" + sealed + word(crc.checksum());
}

TEST(Journal, HeadersThatNoStudyWritesAreRefused) {
  const test::TemporaryDirectory temporary;
  const fs::path path = temporary.path() / "study.journal";
  const std::string texts = text_of("k") + text_of("case.yaml") + text_of("");
  const std::string lists = word(1) + text_of("a") + word(1) + text_of("r");
  const auto header_of = [&](std::uint64_t index, std::uint64_t count) {
    return texts + lists + word(5) + word(index) + word(count);
  };
  const std::string good = header_of(1, 8);
  write(path, journal_of(good));
  EXPECT_EQ(Journal::read(path).header().shard, (Shard{1, 8}));

  constexpr auto kHuge = std::uint64_t{1} << 40;
  std::vector<std::string> bad{header_of(kHuge, 2 * kHuge),
                               header_of(8, 8),
                               header_of(0, 0),
                               good + "x",
                               good + word(1),
                               texts + word(~std::uint64_t{0}),
                               word(~std::uint64_t{0}),
                               texts + word(1) + word(kHuge) + lists};
  for (std::size_t length = 0; length < good.size(); ++length) bad.push_back(good.substr(0, length));
  for (const std::string& header : bad) {
    write(path, journal_of(header));
    EXPECT_THAT(folder_error_of([&] { Journal::read(path); }), HasSubstr("no journal of a study"));
  }
}

TEST(Journal, RecordsThatClaimMoreThanTheyHoldAreDamage) {
  const Journal journal = Journal::temporary(synthetic_header(std::uint64_t{1} << 62));
  RowBlock block = synthetic_rows(0, 4);
  EXPECT_TRUE(journal.takes(encode(block)));
  // Rows times responses times eight exceed the record's value by one turn of 64 bits.
  RowBlock wrapped = synthetic_rows(0, 1);
  wrapped.rows = (std::uint64_t{1} << 61) + 1;
  wrapped.responses.resize(kRows);
  EXPECT_FALSE(journal.takes(encode(wrapped)));
}

TEST(Journal, LinksPipesAndFoldersAreRefusedAndLeftAlone) {
  const test::TemporaryDirectory temporary;
  const fs::path other = temporary.path() / "other", path = temporary.path() / "study.journal";
  const auto refused = [&](const char* what) {
    for (const std::string& error :
         {folder_error_of([&] { Journal::read(path); }),
          folder_error_of([&] { Journal::append_to(path, synthetic_header(kJournalDesigns)); }),
          folder_error_of([&] { Journal::append_to(path, synthetic_header(kJournalDesigns), true); })})
      EXPECT_THAT(error, HasSubstr(path.string() + ": error: got " + what));
    fs::remove(path);
  };
  write_journal(other);
  const std::string before = content_of(other);
  fs::create_symlink(other, path);
  refused("a symbolic link");
  EXPECT_EQ(content_of(other), before);
  fs::create_symlink(temporary.path() / "new", path);
  refused("a symbolic link");
  EXPECT_FALSE(fs::exists(temporary.path() / "new"));
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  refused("a pipe");
  fs::create_directory(path);
  refused("a folder");
}

TEST(Journal, OfAnotherStudyIsRefused) {
  const test::TemporaryDirectory temporary;
  const fs::path path = temporary.path() / "study.journal";
  write_journal(path);
  const std::string before = content_of(path);
  JournalHeader other_key = synthetic_header(kJournalDesigns);
  other_key.key = "other";
  JournalHeader other_responses = synthetic_header(kJournalDesigns);
  other_responses.responses.pop_back();
  for (const JournalHeader& header : {other_key, other_responses, synthetic_header(kJournalDesigns + 1)}) {
    const std::string error = folder_error_of([&] { Journal::append_to(path, header); });
    EXPECT_THAT(error, HasSubstr(temporary.path().string() + ": error: "));
    EXPECT_THAT(error, HasSubstr("--output"));
    EXPECT_THAT(error, HasSubstr("--restart"));
  }
  EXPECT_EQ(content_of(path), before);
}

TEST(Journal, HasOneWriter) {
  const test::TemporaryDirectory temporary;
  const fs::path path = temporary.path() / "study.journal";
  const Journal journal = Journal::append_to(path, synthetic_header(kJournalDesigns));
  EXPECT_THAT(folder_error_of([&] { Journal::append_to(path, synthetic_header(kJournalDesigns)); }),
              HasSubstr("another process"));
}

TEST(Journal, OnAFullDiskIsAsBefore) {
  const test::TemporaryDirectory temporary;
  const fs::path path = temporary.path() / "study.journal";
  const std::vector<std::uint64_t> ends = write_journal(path);
  const std::string whole = content_of(path);
  fs::resize_file(path, ends[1]);
  Journal journal = Journal::append_to(path, synthetic_header(kJournalDesigns));
  for (const std::uint64_t room : {0ul, 1ul, 500ul}) {
    const test::SmallFilesOnly full_disk(ends[1] + room);
    try {
      journal.append(encode(synthetic_rows(200, kRows)));
      FAIL() << "written all the same";
    } catch (const std::system_error& error) {
      EXPECT_EQ(error.code(), std::errc::file_too_large);
      EXPECT_THAT(error.what(), HasSubstr(path.string()));
    }
    EXPECT_EQ(fs::file_size(path), ends[1]);
  }
  journal.append(encode(synthetic_rows(200, kRows)));
  EXPECT_EQ(content_of(path), whole);
}

TEST(Journal, TemporaryLeavesNoFile) {
  const test::TemporaryDirectory temporary;
  const char* before = std::getenv("TMPDIR");
  const std::string restored = before ? before : "";
  ::setenv("TMPDIR", temporary.path().c_str(), 1);
  Journal journal = Journal::temporary(synthetic_header(kJournalDesigns));
  before ? ::setenv("TMPDIR", restored.c_str(), 1) : ::unsetenv("TMPDIR");
  journal.append(encode(synthetic_rows(0, 10)));
  EXPECT_TRUE(same_rows(journal.block(journal.records()[0]), synthetic_rows(0, 10)));
  EXPECT_TRUE(fs::is_empty(temporary.path()));
}

TEST(StudyKey, DependsOnAllThatTheRowsDependOn) {
  const input::Source source{"a.yaml", "text", {"a=1", "b=2"}};
  const std::string key = study_key("1", source);
  EXPECT_EQ(study_key("1", {"elsewhere/a.yaml", "text", {"a=1", "b=2"}}), key);
  EXPECT_NE(study_key("2", source), key);
  EXPECT_NE(study_key("1", {"a.yaml", "texta", {"=1", "b=2"}}), key);
  EXPECT_NE(study_key("1", {"a.yaml", "text", {"a=1b=2"}}), key);
  const std::vector<std::string> history{"1 kN\n"};
  EXPECT_NE(study_key("1", source, history), key);
  const std::vector<std::string> digests{sha256("1 kN\n"), sha256("2 kN\n")};
  EXPECT_EQ(referred_of(study_key("1", source, digests)), digests);
  EXPECT_TRUE(referred_of(key).empty());
}

}  // namespace
}  // namespace prs
