#include "simd/instruction_set.h"

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "simd/architectures.h"

namespace simd {
namespace {

using enum InstructionSet;

#if defined(__x86_64__)
template <class Arch>
bool processor_has() {
  return xsimd::dispatch<xsimd::arch_list<Arch, Baseline>>(
      [](auto architecture) { return std::is_same_v<decltype(architecture), Arch>; })();
}
#endif

/// Whether this binary and the processor have it, regardless of the environment.
bool is_here(InstructionSet set) {
  switch (set) {
#if defined(__x86_64__)
    case avx2:
      return Architectures::contains<Avx2>() && processor_has<Avx2>();
    case avx512:
      return processor_has<Avx512>();
#else
    case avx2:
    case avx512:
      return false;
#endif
    default:
      return true;
  }
}

}  // namespace

InstructionSet widest_of(std::string_view value) {
  InstructionSet last = baseline;
  std::string expected;
  for (const InstructionSet set : {baseline, avx2, avx512}) {
    if (!is_here(set)) continue;
    if (value == name(set)) return set;
    expected += (expected.empty() ? "" : ", ") + std::string(name(set));
    last = set;
  }
  if (value.empty()) return last;
  throw std::invalid_argument("PRS_INSTRUCTION_SET: got \"" + std::string(value) + "\"; expected one of: " + expected +
                              " (what this program and this processor have)");
}

InstructionSet widest() {
  static const InstructionSet set = [] {
    const char* value = std::getenv("PRS_INSTRUCTION_SET");
    return widest_of(value ? value : "");
  }();
  return set;
}

bool available(InstructionSet set) { return set <= widest() && is_here(set); }

InstructionSet taken(InstructionSet set) {
  if (set == best || set == scalar) return widest();
  if (set == avx512 && available(avx512)) return avx512;
  return set != baseline && available(avx2) ? avx2 : baseline;
}

int batch_size(InstructionSet set) {
  if (set == scalar) return 1;
  switch (taken(set)) {
    case avx512:
      return 8;
    case avx2:
      return 4;
    default:
      return static_cast<int>(sizeof(xsimd::batch<double, Baseline>) / sizeof(double));
  }
}

}  // namespace simd
