#include <nettle/sha2.h>

#include <algorithm>
#include <bit>

namespace {

// The first 32 bits of the fractional parts of the cube roots of the first 64 primes.
constexpr std::uint32_t kRounds[64] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

void take_block(sha256_ctx& c) {
  std::uint32_t w[64];
  for (int k = 0; k < 16; ++k)
    w[k] = std::uint32_t{c.block[4 * k]} << 24 | std::uint32_t{c.block[4 * k + 1]} << 16 |
           std::uint32_t{c.block[4 * k + 2]} << 8 | std::uint32_t{c.block[4 * k + 3]};
  for (int k = 16; k < 64; ++k) {
    const std::uint32_t a = w[k - 15], b = w[k - 2];
    w[k] = w[k - 16] + w[k - 7] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ a >> 3) +
           (std::rotr(b, 17) ^ std::rotr(b, 19) ^ b >> 10);
  }
  std::uint32_t s[8];
  std::copy(c.state, c.state + 8, s);
  for (int k = 0; k < 64; ++k) {
    const std::uint32_t a = s[0], e = s[4];
    const std::uint32_t t =
        s[7] + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + ((e & s[5]) ^ (~e & s[6])) + kRounds[k] + w[k];
    const std::uint32_t u =
        (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & s[1]) ^ (a & s[2]) ^ (s[1] & s[2]));
    std::copy_backward(s, s + 7, s + 8);
    s[4] += t;
    s[0] = t + u;
  }
  for (int k = 0; k < 8; ++k) c.state[k] += s[k];
}

}  // namespace

void sha256_init(sha256_ctx* context) {
  *context = {{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19}, 0, {}};
}

void sha256_update(sha256_ctx* context, std::size_t length, const std::uint8_t* data) {
  for (std::size_t k = 0; k < length; ++k) {
    context->block[context->bytes++ % 64] = data[k];
    if (context->bytes % 64 == 0) take_block(*context);
  }
}

void sha256_digest(sha256_ctx* context, std::size_t length, std::uint8_t* digest) {
  const std::uint64_t bits = 8 * context->bytes;
  const std::uint8_t end = 0x80, zero = 0;
  sha256_update(context, 1, &end);
  while (context->bytes % 64 != 56) sha256_update(context, 1, &zero);
  for (int k = 7; k >= 0; --k) {
    const auto byte = static_cast<std::uint8_t>(bits >> 8 * k);
    sha256_update(context, 1, &byte);
  }
  for (std::size_t k = 0; k < length; ++k)
    digest[k] = static_cast<std::uint8_t>(context->state[k / 4] >> (24 - 8 * (k % 4)));
  sha256_init(context);
}
