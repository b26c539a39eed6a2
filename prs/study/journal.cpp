#include "prs/study/journal.h"

#include <sys/file.h>
#include <sys/stat.h>

#include <boost/crc.hpp>
#include <system_error>

#include "prs/bytes.h"
#include "prs/output/files.h"
#include "prs/sha256.h"

namespace prs {
namespace {

namespace fs = std::filesystem;

/// First word of a journal file. It also shows the byte order and, by its last digit, the format.
constexpr std::uint64_t kMagic = 0x3241'4e4a'2d53'5250;  // "PRS-JNA2" on a little-endian machine
constexpr std::uint64_t kLongestHeader = 1u << 26;

constexpr std::size_t kWord = sizeof(std::uint64_t);
/// Length, first design, rows, responses; checksum.
constexpr std::uint64_t kShortestRecord = 5 * kWord;

std::uint64_t crc32c(std::string_view bytes) {
  boost::crc_optimal<32, 0x1EDC'6F41, 0xFFFF'FFFF, 0xFFFF'FFFF, true, true> crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

std::uint64_t integer_at(std::string_view bytes, std::size_t offset) { return Cursor(bytes.substr(offset)).number(); }

/// A sealed text: its length, the text and the checksum of both.
std::string sealed(std::string text) {
  std::string bytes;
  bytes.reserve(text.size() + 2 * kWord);
  put(bytes, text.size() + 2 * kWord);
  bytes += text;
  put(bytes, crc32c(bytes));
  return bytes;
}

bool is_whole(std::string_view bytes) {
  return bytes.size() >= 2 * kWord && integer_at(bytes, 0) == bytes.size() &&
         integer_at(bytes, bytes.size() - kWord) == crc32c(bytes.substr(0, bytes.size() - kWord));
}

std::string_view content(std::string_view sealed_bytes) {
  return sealed_bytes.substr(kWord, sealed_bytes.size() - 2 * kWord);
}

/// Decoded block; absent if the bytes are no block of a study with these numbers of responses and designs.
std::optional<RowBlock> decode(std::string_view bytes, const JournalHeader& header) {
  Cursor cursor(content(bytes));
  RowBlock block;
  block.first = cursor.number();
  block.rows = cursor.number();
  const std::uint64_t responses = cursor.number();
  if (!cursor.good() || responses != header.responses.size() || block.rows == 0 || block.first >= header.designs ||
      block.rows > header.designs - block.first)
    return std::nullopt;
  if (responses > 0 && block.rows > bytes.size() / sizeof(double) / responses) return std::nullopt;
  const std::string_view numbers = cursor.text(block.rows * responses * sizeof(double));
  if (!cursor.good()) return std::nullopt;
  block.responses.resize(block.rows * responses);
  if (!numbers.empty()) std::memcpy(block.responses.data(), numbers.data(), numbers.size());
  while (cursor.good() && !cursor.at_end()) {
    RowBlock::Failure& failure = block.failures.emplace_back();
    failure.row = cursor.number();
    failure.status.name = cursor.text();
    failure.status.reason = cursor.text();
    if (failure.row >= block.rows) return std::nullopt;
  }
  return cursor.good() ? std::optional(std::move(block)) : std::nullopt;
}

std::string encode(const JournalHeader& header) {
  const auto& [key, source, responses, designs, shard] = header;
  std::string text, bytes;
  for (const std::string& part : {key, source.name, source.text}) put(text, part);
  put(text, source.overrides);
  put(text, responses);
  for (const std::uint64_t number : {designs, shard.index, shard.count}) put(text, number);
  put(bytes, kMagic);
  return bytes + sealed(std::move(text));
}

/// Decoded header; absent if the bytes are not those of `encode` for a header.
std::optional<JournalHeader> decode_header(std::string_view bytes) {
  Cursor cursor(content(bytes));
  const JournalHeader header{cursor.text(),
                             {cursor.text(), cursor.text(), cursor.texts()},
                             cursor.texts(),
                             cursor.number(),
                             {cursor.number(), cursor.number()}};
  const Shard& shard = header.shard;
  const bool sound = cursor.at_end() && shard.index < shard.count && shard.count <= kMostShards;
  return sound ? std::optional(header) : std::nullopt;
}

[[noreturn]] void refuse_foreign(const fs::path& path) {
  throw StudyFolderError(
      fmt::format("{}: error: this is no journal of a study, or it is damaged or of another kind of machine; "
                  "remove it, give another folder with --output, or --restart to discard it",
                  path.string()));
}

FileDescriptor open_temporary() {
  std::string pattern = (temporary_folder() / "prs-study-XXXXXX").string();
  FileDescriptor file(::mkostemp(pattern.data(), O_APPEND | O_CLOEXEC));
  if (!file.is_open())
    throw std::system_error(errno, std::generic_category(), fmt::format("cannot write '{}'", pattern));
  ::unlink(pattern.c_str());
  return file;
}

}  // namespace

std::string study_key(std::string_view version, const input::Source& source, std::span<const std::string> referred) {
  std::string bytes;
  put(bytes, version);
  put(bytes, source.text);
  put(bytes, source.overrides);
  for (const std::string& digest : referred) put(bytes, digest);
  std::string key = sha256(bytes);
  for (const std::string& digest : referred) key += digest;
  return key;
}

std::vector<std::string> referred_of(std::string_view key) {
  constexpr std::size_t kDigest = 64;
  std::vector<std::string> digests;
  for (std::size_t at = kDigest; at < key.size(); at += kDigest) digests.emplace_back(key.substr(at, kDigest));
  return digests;
}

std::string encode(const RowBlock& block) {
  std::string bytes;
  bytes.reserve(3 * kWord + block.responses.size() * sizeof(double));
  put(bytes, block.first);
  put(bytes, block.rows);
  put(bytes, block.rows == 0 ? 0 : block.responses.size() / block.rows);
  bytes.append(reinterpret_cast<const char*>(block.responses.data()), block.responses.size() * sizeof(double));
  for (const RowBlock::Failure& failure : block.failures) {
    put(bytes, failure.row);
    put(bytes, failure.status.name);
    put(bytes, failure.status.reason);
  }
  return sealed(std::move(bytes));
}

DesignRange designs_of(std::string_view record) { return {integer_at(record, kWord), integer_at(record, 2 * kWord)}; }

Journal Journal::append_to(const fs::path& path, const JournalHeader& header, bool afresh) {
  Journal journal;
  journal.path_ = path;
  journal.file_ = open_study_file(path, O_RDWR | O_CREAT | O_APPEND);
  if (!lock_file(journal.file_, LOCK_EX, path))
    throw StudyFolderError(
        fmt::format("{}: error: another process is writing this journal; wait for it, or give another folder "
                    "with --output",
                    path.string()));
  if (afresh || !journal.load()) {
    journal.header_ = header;
    journal.begin();
  }
  journal.require(header);
  if (::ftruncate(journal.file_.get(), static_cast<off_t>(journal.end_)) != 0) journal.fail(errno);
  return journal;
}

Journal Journal::temporary(const JournalHeader& header) {
  Journal journal;
  journal.path_ = temporary_folder();
  journal.file_ = open_temporary();
  journal.header_ = header;
  journal.begin();
  return journal;
}

Journal Journal::read(const fs::path& path) {
  Journal journal;
  journal.path_ = path;
  journal.file_ = open_study_file(path, O_RDONLY);
  journal.load();
  return journal;
}

bool Journal::is_of(const JournalHeader& study) const {
  return header_.key == study.key && header_.designs == study.designs && header_.responses == study.responses;
}

void Journal::require(const JournalHeader& study) const {
  if (is_of(study)) return;
  throw StudyFolderError(
      fmt::format("{}: error: it holds the journal {} of another study: the file, an override or the program "
                  "changed since; give another folder with --output, or --restart to discard what was computed",
                  path_.parent_path().string(), path_.filename().string()));
}

bool Journal::takes(std::string_view record) const { return is_whole(record) && decode(record, header_); }

void Journal::append(std::string_view record) {
  if (const int error = write_all(file_, record); error != 0) {
    // An incomplete record that cannot be cut off now is cut off when the journal is read.
    if (::ftruncate(file_.get(), static_cast<off_t>(end_)) != 0) fail(errno);
    fail(error);
  }
  records_.push_back({designs_of(record), end_, record.size()});
  end_ += record.size();
}

RowBlock Journal::block(const Record& record) const {
  const std::string raw = bytes(record.offset, record.length);
  std::optional<RowBlock> block = is_whole(raw) ? decode(raw, header_) : std::nullopt;
  if (!block)
    throw std::runtime_error(fmt::format("'{}' changed while it was read; run the same command again", path_.string()));
  return *std::move(block);
}

void Journal::sync() {
  if (::fdatasync(file_.get()) != 0) fail(errno);
}

bool Journal::load() {
  struct stat status {};
  if (::fstat(file_.get(), &status) != 0) fail(errno);
  const auto size = static_cast<std::uint64_t>(status.st_size);
  const std::string start = bytes(0, std::min<std::uint64_t>(size, 2 * kWord));
  std::string magic;
  put(magic, kMagic);
  if (start.substr(0, kWord) != magic.substr(0, start.size())) refuse_foreign(path_);
  if (start.size() < 2 * kWord) return false;
  const std::uint64_t length = integer_at(start, kWord);
  if (length > kLongestHeader) refuse_foreign(path_);
  if (length > size - kWord) return false;
  const std::string head = bytes(kWord, length);
  if (!is_whole(head)) refuse_foreign(path_);
  std::optional<JournalHeader> header = decode_header(head);
  if (!header) refuse_foreign(path_);
  header_ = *std::move(header);

  end_ = kWord + length;
  while (size - end_ >= kShortestRecord) {
    const std::uint64_t next = integer_at(bytes(end_, kWord), 0);
    if (next > size - end_) break;
    const std::string record = next < kShortestRecord ? std::string() : bytes(end_, next);
    damaged_ = !is_whole(record) || !decode(record, header_);
    if (damaged_) break;
    records_.push_back({designs_of(record), end_, next});
    end_ += next;
  }
  return true;
}

void Journal::begin() {
  const std::string head = encode(header_);
  if (::ftruncate(file_.get(), 0) != 0) fail(errno);
  if (const int error = write_all(file_, head); error != 0) fail(error);
  end_ = head.size();
}

std::string Journal::bytes(std::uint64_t offset, std::uint64_t length) const {
  std::string read(length, '\0');
  std::size_t done = 0;
  while (done < length) {
    const ssize_t got = ::pread(file_.get(), read.data() + done, length - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(errno);
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  read.resize(done);
  return read;
}

void Journal::fail(int error) const {
  throw std::system_error(error, std::generic_category(), fmt::format("cannot write '{}'", path_.string()));
}

}  // namespace prs
