#pragma once

#include <span>

#include "prs/input/source.h"
#include "prs/output/staged_file.h"
#include "prs/study/designs.h"

namespace prs {

/// What the rows of a study depend on: one hash of program, file, overrides and what the file
/// refers to, given as SHA-256 of the contents, and behind it these.
std::string study_key(std::string_view version, const input::Source& source,
                      std::span<const std::string> referred = {});

/// What a key has behind its hash.
std::vector<std::string> referred_of(std::string_view key);

/// Header of a journal: enough to write the files of the study without its input.
struct JournalHeader {
  std::string key;  ///< See `study_key`.
  input::Source source;
  std::vector<std::string> responses;
  std::size_t designs = 0;
  Shard shard;
};

/// A block as it stands in a journal: its length, the block and the CRC-32C of both, in the
/// machine's own numbers. What is read back is the block to the last bit.
std::string encode(const RowBlock& block);

/// The designs of an encoded block.
DesignRange designs_of(std::string_view record);

/// The rows of a study in the order in which they were found, in a file that only grows.
///
/// A record is appended by one write, so that a process that dies leaves whole records and at most
/// one torn tail. Reading stops at the first record that is not as it was written; what follows it
/// counts as not computed.
class Journal {
 public:
  struct Record {
    DesignRange designs;
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
  };

  /// Continues the journal of `header.key`, or begins one; a torn tail is cut. `afresh` discards
  /// what the file holds. Throws StudyFolderError where another process writes it or it is of
  /// another key or not a journal, and std::system_error.
  static Journal append_to(const std::filesystem::path& path, const JournalHeader& header, bool afresh = false);

  /// A temporary journal, removed together with the object.
  static Journal temporary(const JournalHeader& header);

  /// A journal as it stands, also while it grows; the header's key is empty where it has not come
  /// that far. Throws StudyFolderError where the file is not a journal, and std::system_error.
  static Journal read(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }
  const JournalHeader& header() const { return header_; }
  const std::vector<Record>& records() const { return records_; }

  /// Whether the journal is of that study.
  bool is_of(const JournalHeader& study) const;

  /// Throws StudyFolderError where it is not.
  void require(const JournalHeader& study) const;

  /// Whether damaged records were found, apart from a torn tail.
  bool is_damaged() const { return damaged_; }

  /// Whether a text is what `encode` gave for designs of this study.
  bool takes(std::string_view record) const;

  /// Appends what `encode` gave. Throws std::system_error where that does not fit on the disk; the
  /// journal is then as it was before.
  void append(std::string_view record);

  /// Rows of a record of this journal. May be called from any thread.
  RowBlock block(const Record& record) const;

  /// Writes appended records through to the disk.
  void sync();

 private:
  Journal() = default;
  /// Reads header and records; false where the file ends before its header does.
  bool load();
  void begin();
  std::string bytes(std::uint64_t offset, std::uint64_t length) const;
  [[noreturn]] void fail(int error) const;

  std::filesystem::path path_;
  FileDescriptor file_;
  JournalHeader header_;
  std::vector<Record> records_;
  std::uint64_t end_ = 0;  ///< End of the last record [bytes].
  bool damaged_ = false;
};

}  // namespace prs
