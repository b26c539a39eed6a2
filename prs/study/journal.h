#pragma once

#include <span>

#include "prs/input/source.h"
#include "prs/output/staged_file.h"
#include "prs/study/designs.h"

namespace prs {

/// Key of the rows of a study: one hash of program, file, overrides and the files referred to, given as SHA-256 of the
/// contents, followed by these.
std::string study_key(std::string_view version, const input::Source& source,
                      std::span<const std::string> referred = {});

/// Part of a key after its hash.
std::vector<std::string> referred_of(std::string_view key);

/// Header of a journal: enough to write the files of the study without its input.
struct JournalHeader {
  std::string key;  ///< See `study_key`.
  input::Source source;
  std::vector<std::string> responses;
  std::size_t designs = 0;
  Shard shard;
};

/// A block in the format of a journal: its length, the block and the CRC-32C of both, in the machine's own numbers.
/// Reading gives the same block bit by bit.
std::string encode(const RowBlock& block);

/// The designs of an encoded block.
DesignRange designs_of(std::string_view record);

/// Rows of a study in the order in which they were found, in a file that only grows.
///
/// A record is appended by one write, so that a process that dies leaves complete records and at most one incomplete
/// tail. Reading stops at the first damaged record; later ones count as not computed.
class Journal {
 public:
  struct Record {
    DesignRange designs;
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
  };

  /// Continues the journal of `header.key`, or begins one; an incomplete tail is cut. `afresh` discards the contents of
  /// the file. Throws StudyFolderError if another process writes it or it is of another key or not a journal, and
  /// std::system_error.
  static Journal append_to(const std::filesystem::path& path, const JournalHeader& header, bool afresh = false);

  /// A temporary journal, removed together with the object.
  static Journal temporary(const JournalHeader& header);

  /// A journal in its current state, also while it grows; the header's key is empty if the header is incomplete. Throws
  /// StudyFolderError if the file is not a journal, and std::system_error.
  static Journal read(const std::filesystem::path& path);

  const std::filesystem::path& path() const { return path_; }
  const JournalHeader& header() const { return header_; }
  const std::vector<Record>& records() const { return records_; }

  /// Whether the journal belongs to that study.
  bool is_of(const JournalHeader& study) const;

  /// Throws StudyFolderError if it does not.
  void require(const JournalHeader& study) const;

  /// Whether damaged records were found, other than an incomplete tail.
  bool is_damaged() const { return damaged_; }

  /// Whether a text is the result of `encode` for designs of this study.
  bool takes(std::string_view record) const;

  /// Appends a result of `encode`. Throws std::system_error if it does not fit on the disk; the journal is then
  /// unchanged.
  void append(std::string_view record);

  /// Rows of a record of this journal. May be called from any thread.
  RowBlock block(const Record& record) const;

  /// Flushes appended records to the disk.
  void sync();

 private:
  Journal() = default;
  /// Reads header and records; false if the file ends before its header does.
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
