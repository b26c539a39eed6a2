#pragma once

#include <cstddef>
#include <cstdint>

/// SHA-256 (FIPS 180-4) with the names of Nettle, which is not built for WebAssembly.
inline constexpr std::size_t SHA256_DIGEST_SIZE = 32;

struct sha256_ctx {
  std::uint32_t state[8];
  std::uint64_t bytes;
  std::uint8_t block[64];
};

void sha256_init(sha256_ctx* context);
void sha256_update(sha256_ctx* context, std::size_t length, const std::uint8_t* data);
void sha256_digest(sha256_ctx* context, std::size_t length, std::uint8_t* digest);
