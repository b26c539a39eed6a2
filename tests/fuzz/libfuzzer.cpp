#include <algorithm>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iterator>
#include <string_view>

#include "tests/fuzz/targets.h"

// The program of one target, PRS_FUZZ_TARGET, for libFuzzer.
namespace {

const prs::fuzz::Target& target() {
  static const prs::fuzz::Target& found =
      *std::ranges::find(prs::fuzz::kTargets, std::string_view(PRS_FUZZ_TARGET), &prs::fuzz::Target::name);
  return found;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    target().run({reinterpret_cast<const char*>(data), size});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "finding: %s\n", error.what());
    __builtin_trap();
  }
  return 0;
}

/// One mutation in eight is of bytes.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  if (!target().mutate || seed % 8 == 0) return LLVMFuzzerMutate(data, size, most);
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const std::string text = target().mutate(input, most, seed);
  const std::size_t length = std::min(text.size(), most);
  std::memcpy(data, text.data(), length);
  return length;
}
