#include "prs/export/zip.h"

#include <boost/crc.hpp>

namespace prs {
namespace {

// Records of PKWARE's APPNOTE 6.3.10, sections 4.3.7, 4.3.12 and 4.3.16.
constexpr std::uint32_t kLocalHeader = 0x04034b50, kCentralHeader = 0x02014b50, kEndRecord = 0x06054b50;
constexpr std::uint16_t kVersion20 = 20, kMadeOnUnix = 3 << 8;
constexpr std::uint16_t kFirstDay = (1 << 5) | 1;  ///< 1980-01-01, as MS-DOS counts.
constexpr std::uint32_t kPlainFile = std::uint32_t{0100644} << 16;

void put16(std::string& bytes, std::uint64_t value) {
  bytes += static_cast<char>(value & 0xff);
  bytes += static_cast<char>((value >> 8) & 0xff);
}

void put32(std::string& bytes, std::uint64_t value) {
  put16(bytes, value & 0xffff);
  put16(bytes, value >> 16);
}

/// Fields of both headers of a file after their versions.
std::string description_of(const OutputFile& file) {
  boost::crc_32_type crc;
  crc.process_bytes(file.content.data(), file.content.size());
  std::string bytes;
  put16(bytes, 0);  // Flags.
  put16(bytes, 0);  // Stored.
  put16(bytes, 0);  // Midnight.
  put16(bytes, kFirstDay);
  put32(bytes, crc.checksum());
  put32(bytes, file.content.size());
  put32(bytes, file.content.size());
  put16(bytes, file.name.size());
  put16(bytes, 0);  // No extra field.
  return bytes;
}

}  // namespace

std::string zip(const std::vector<OutputFile>& files) {
  std::string archive, directory;
  for (const OutputFile& file : files) {
    const std::string description = description_of(file);
    const std::size_t offset = archive.size();
    put32(archive, kLocalHeader);
    put16(archive, kVersion20);
    archive.append(description).append(file.name).append(file.content);

    put32(directory, kCentralHeader);
    put16(directory, kMadeOnUnix | kVersion20);
    put16(directory, kVersion20);
    directory += description;
    put16(directory, 0);  // No comment.
    put16(directory, 0);  // First disk.
    put16(directory, 0);  // Binary.
    put32(directory, kPlainFile);
    put32(directory, offset);
    directory += file.name;
  }
  const std::size_t start = archive.size();
  archive += directory;
  put32(archive, kEndRecord);
  put16(archive, 0);  // This disk.
  put16(archive, 0);  // Disk of the directory.
  put16(archive, files.size());
  put16(archive, files.size());
  put32(archive, directory.size());
  put32(archive, start);
  put16(archive, 0);  // No comment.
  return archive;
}

}  // namespace prs
