#include <fmt/format.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cstring>
#include <optional>
#include <system_error>

#include "prs/input/study_reader.h"
#include "prs/study/designs.h"
#include "prs/study/response.h"
#include "prs/study/study_files.h"
#include "prs/study/study_result.h"
#include "prs/study/study_run.h"
#include "tests/fuzz/documents.h"
#include "tests/fuzz/files.h"
#include "tests/fuzz/mutators.h"
#include "tests/fuzz/targets.h"

namespace prs::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kWord = 8;

/// Checks a journal record by record: its designs must be possible for one study.
void expect_sound(const Journal& journal) {
  for (const Journal::Record& record : journal.records()) {
    const RowBlock block = journal.block(record);
    expect(block.first == record.designs.first && block.rows == record.designs.count,
           "a record of other designs than it says");
    expect(block.rows > 0 && block.first < journal.header().designs &&
               block.rows <= journal.header().designs - block.first,
           "a record beyond the study");
    expect(block.responses.size() == block.rows * journal.header().responses.size(), "a record with too few numbers");
    expect(journal.takes(encode(block)), "a record that is not taken again");
  }
}

/// Checks that a continued journal begins with the records read from it.
void expect_continued(const fs::path& path) {
  const Journal read = Journal::read(path);
  if (read.header().key.empty()) return;
  const JournalHeader header = read.header();
  const auto kept = read.records().size();
  {
    const Journal continued = Journal::append_to(path, header);
    expect(continued.records().size() == kept, "a continued journal holds other records");
  }
  const Journal again = Journal::read(path);
  expect(!again.is_damaged() && again.records().size() == kept, "a continued journal is not what it was");
}

/// The rows of all journals together: each design once, in order.
void expect_in_order(const StoredRows& rows, std::size_t designs) {
  std::size_t next = 0;
  for (std::size_t k = 0; k < rows.block_count(); ++k) {
    const RowBlock block = rows.block(k);
    expect(block.first == next, "designs out of order");
    for (const RowBlock::Failure& failure : block.failures)
      expect(failure.row < block.rows, "a failure beyond its block");
    next += block.rows;
  }
  expect(next == designs, "designs are missing");
}

/// Continues as `prs study merge` does.
void expect_deliverable(const StoredRows& rows) {
  const JournalHeader& header = rows.journals().front().header();
  if (header.source.text.size() > 2'000) return;
  const input::Source source = input::source_of_text("case.yaml", header.source.text, {});
  const input::StudyInput in = input::read_study_input(source);
  Study study = in.study;
  const std::vector<std::string> known = study.responses.empty() ? default_responses(study.command) : study.responses;
  const bool agree =
      header.designs == design_count(study) &&
      (study.responses.empty()
           ? std::ranges::all_of(header.responses,
                                 [&](const std::string& path) { return std::ranges::find(known, path) != known.end(); })
           : header.responses == known);
  if (!agree || study.plan == Plan::derivatives) return;
  study.responses = header.responses;
  StudyResult result{study, {}, 0, 0, 0, {}};
  StudyAnalysis analysis(study);
  const DocumentInfo info{"1", "1", "", {}, "study", "case.yaml", {}};
  const fs::path out = scratch_folder() / "out";
  fs::create_directories(out);
  write_rows(rows, study, &out, 1, [&](const RowBlock& block, std::span<const double> inputs) {
    add(result, block);
    analysis.add(block, inputs);
  });
  result.summary = analysis.summary();
  expect_stored_study(result, info);
}

std::uint64_t checksum(std::string_view bytes) {
  boost::crc_optimal<32, 0x1EDC6F41, 0xFFFFFFFF, 0xFFFFFFFF, true, true> crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

void set_number(std::string& bytes, std::size_t at, std::uint64_t number) {
  if (at + kWord <= bytes.size()) std::memcpy(bytes.data() + at, &number, kWord);
}

/// Sets correct checksums: header and records follow the magic word.
void seal(std::string& bytes) {
  for (std::size_t at = kWord; at + 2 * kWord <= bytes.size();) {
    std::uint64_t length = Cursor(std::string_view(bytes).substr(at)).number();
    length = std::clamp<std::uint64_t>(length, 2 * kWord, bytes.size() - at);
    set_number(bytes, at, length);
    set_number(bytes, at + length - kWord, checksum(std::string_view(bytes).substr(at, length - kWord)));
    at += length;
  }
}

/// Offset after the magic word and the header.
std::size_t first_record(std::string_view bytes) {
  if (bytes.size() < 2 * kWord) return 0;
  return kWord + std::min<std::uint64_t>(Cursor(bytes.substr(kWord)).number(), bytes.size());
}

}  // namespace

bool journals(std::string_view input) {
  if (input.size() > kLongest) return false;
  const fs::path folder = scratch_folder() / "study";
  fs::remove_all(folder);
  fs::create_directory(folder);
  const std::vector<std::string> files = pieces(input, 3);
  for (std::size_t k = 0; k < files.size(); ++k) {
    const fs::path path = journal_path(folder, {k, 3});
    write_bytes(path, files[k]);
    try {
      expect_sound(Journal::read(path));
      expect_continued(path);
    } catch (const StudyFolderError&) {
    }
    write_bytes(path, files[k]);
  }
  try {
    const StoredRows rows = gather_rows({folder});
    expect_in_order(rows, rows.journals().front().header().designs);
    expect_deliverable(rows);
    return true;
  } catch (const StudyFolderError&) {
  } catch (const input::InputError&) {  // The study that a header holds may be wrong.
  }
  return false;
}

std::string mutated_journals(std::string_view input, std::size_t most, std::uint32_t seed) {
  Random random(seed);
  const auto below = [&](std::size_t count) { return fuzz::below(count, random); };
  std::vector<std::string> files = pieces(input, 3);
  if (files.empty()) return std::string(input);
  // Often only words of records change, so that most journals stay of one study.
  const bool of_records = below(2) == 0;
  for (std::size_t left = 1 + below(3); left > 0; --left) {
    std::string& bytes = files[below(files.size())];
    const std::size_t first = of_records ? first_record(bytes) : 0;
    if (first >= bytes.size()) continue;
    const std::size_t at = first + below(bytes.size() - first), word = at / kWord * kWord;
    constexpr std::uint64_t kOdd[] = {0, 1, 2, 7, 8, 40, 255, 1u << 26, 1ull << 32, 1ull << 61, ~0ull};
    switch (below(of_records ? 3 : 7)) {
      case 0:
        bytes[at] = static_cast<char>(below(256));
        break;
      case 1:
        set_number(bytes, word, kOdd[below(std::size(kOdd))]);
        break;
      case 2:
        set_number(bytes, word, Cursor(std::string_view(bytes).substr(word)).number() + below(5) - 2);
        break;
      case 3:
        bytes.resize(at);
        break;
      case 4:
        bytes.insert(at, bytes.substr(at, 1 + below(64)));
        break;
      case 5:
        bytes.erase(at, 1 + below(16));
        break;
      default:
        files[below(files.size())] = bytes;
        break;
    }
  }
  if (below(8) != 0)
    for (std::string& bytes : files) seal(bytes);
  const std::string text = joined(files);
  return text.size() <= most ? text : std::string(input);
}

}  // namespace prs::fuzz
