#include "simd/instruction_set.h"

#include <type_traits>

#include "simd/architectures.h"

namespace simd {
namespace {

template <class Arch>
bool processor_has() {
  return xsimd::dispatch<xsimd::arch_list<Arch, Baseline>>(
      [](auto best) { return std::is_same_v<decltype(best), Arch>; })();
}

}  // namespace

bool available(InstructionSet set) {
  switch (set) {
#if defined(__x86_64__)
    case InstructionSet::avx2:
      return Architectures::contains<Avx2>() && processor_has<Avx2>();
    case InstructionSet::avx512:
      return processor_has<Avx512>();
#else
    case InstructionSet::avx2:
    case InstructionSet::avx512:
      return false;
#endif
    default:
      return true;
  }
}

int batch_size(InstructionSet set) {
  if (set == InstructionSet::scalar) return 1;
  int size = static_cast<int>(sizeof(xsimd::batch<double, Baseline>) / sizeof(double));
#if defined(__x86_64__)
  const bool best = set == InstructionSet::best || set == InstructionSet::avx512;
  if ((best || set == InstructionSet::avx2) && available(InstructionSet::avx2)) size = 4;
  if (best && available(InstructionSet::avx512)) size = 8;
#endif
  return size;
}

}  // namespace simd
