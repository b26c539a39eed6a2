#include "prs/svg/png.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string_view>
#ifndef __EMSCRIPTEN__
#include <zlib.h>

#include "prs/indices.h"
#endif

namespace prs {
namespace {

void put32(std::string& bytes, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>((value >> shift) & 0xff);
}

/// CRC-32 of the PNG specification, annex D.
std::uint32_t checksum(std::string_view bytes) {
  std::uint32_t crc = 0xffffffff;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc;
}

void put_chunk(std::string& file, std::string_view type, std::string_view data) {
  put32(file, static_cast<std::uint32_t>(data.size()));
  const std::string whole = std::string(type).append(data);
  file += whole;
  put32(file, checksum(whole));
}

#ifdef __EMSCRIPTEN__
/// A zlib stream (RFC 1950) of uncompressed bytes: the engine of pages has no zlib.
std::string deflated(std::string_view bytes) {
  constexpr std::size_t kMost = 65535;
  std::string stream = "\x78\x01";
  std::uint32_t a = 1, b = 0;
  for (const char c : bytes) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  for (std::size_t at = 0; at < bytes.size(); at += kMost) {
    const std::size_t size = std::min(kMost, bytes.size() - at);
    stream += static_cast<char>(at + size == bytes.size());
    for (const std::size_t part : {size, ~size})
      for (const int shift : {0, 8}) stream += static_cast<char>((part >> shift) & 0xff);
    stream += bytes.substr(at, size);
  }
  put32(stream, b << 16 | a);
  return stream;
}
#else
std::string deflated(std::string_view bytes) {
  uLongf size = ::compressBound(bytes.size());
  std::string stream(size, '\0');
  ::compress2(reinterpret_cast<Bytef*>(stream.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
              bytes.size(), Z_BEST_SPEED);
  stream.resize(size);
  return stream;
}
#endif

/// Base64 of RFC 4648.
std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t three = 0;
    for (const auto k : up_to(3))
      three = three << 8 | (at + k < bytes.size() ? static_cast<unsigned char>(bytes[at + k]) : 0u);
    for (const auto k : up_to(4)) text += at + k > bytes.size() ? '=' : kDigits[(three >> (18 - 6 * k)) & 63];
  }
  return text;
}

}  // namespace

std::string png(const Image& image) {
  std::string header, palette(3, '\xff'), rows;
  put32(header, static_cast<std::uint32_t>(image.width));
  put32(header, static_cast<std::uint32_t>(image.height));
  header.append("\x08\x03\0\0\0", 5);  // One byte per pixel, a palette, defaults for the rest.
  for (const std::string& colour : image.colours)
    for (const std::size_t channel : {1u, 3u, 5u}) {
      int level = 0;
      std::from_chars(&colour[channel], &colour[channel] + 2, level, 16);
      palette += static_cast<char>(level);
    }
  for (const auto row : up_to(image.height)) {
    rows += '\0';  // No filter.
    rows.append(image.pixels, row * image.width, image.width);
  }
  std::string file = "\x89PNG\r\n\x1a\n";
  put_chunk(file, "IHDR", header);
  put_chunk(file, "PLTE", palette);
  put_chunk(file, "tRNS", std::string_view("\0", 1));
  put_chunk(file, "IDAT", deflated(rows));
  put_chunk(file, "IEND", {});
  return file;
}

std::string png_address(const Image& image) { return "data:image/png;base64," + base64(png(image)); }

}  // namespace prs
