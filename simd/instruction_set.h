#pragma once

#include <cstddef>
#include <string_view>

namespace simd {

/// What a kernel runs on. Asking for one that this binary or the processor lacks takes the best
/// below it that both have.
enum class InstructionSet {
  best,      ///< Widest batches that the processor has.
  scalar,    ///< One design at a time, with the processor's multiply-add.
  baseline,  ///< Every processor of the target: batches of 2 on x86-64.
  avx2,      ///< Batches of 4, with multiply-add.
  avx512,    ///< Batches of 8.
};

/// Whether this binary on this processor can run it.
bool available(InstructionSet set);

/// Designs side by side in one batch.
int batch_size(InstructionSet set);

constexpr std::string_view name(InstructionSet set) {
  constexpr std::string_view kNames[] = {"best", "scalar", "baseline", "avx2", "avx512"};
  return kNames[static_cast<std::size_t>(set)];
}

}  // namespace simd
