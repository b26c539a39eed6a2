#pragma once

#include <cstddef>
#include <string_view>

namespace simd {

/// What a kernel runs on. Asking for one that is not available takes the best below it that is.
enum class InstructionSet {
  best,      ///< Widest batches that are available.
  scalar,    ///< One design at a time, with the multiply-add of the best.
  baseline,  ///< Every processor of the target: batches of 2 on x86-64.
  avx2,      ///< Batches of 4, with multiply-add.
  avx512,    ///< Batches of 8.
};

/// Widest set that kernels run on: the one that PRS_INSTRUCTION_SET of the environment names or, without it, the
/// widest that this binary and the processor have. The variable is read once. Throws std::invalid_argument where it
/// names no set that they have.
InstructionSet widest();

/// Set that a value of PRS_INSTRUCTION_SET names; an empty value stands for the widest that this binary and the
/// processor have. Throws std::invalid_argument where they have no such set.
InstructionSet widest_of(std::string_view value);

/// Whether this binary on this processor can run it and `widest` allows it.
bool available(InstructionSet set);

/// Set that kernels run on where `set` is asked for: baseline, avx2 or avx512.
InstructionSet taken(InstructionSet set);

/// Designs side by side in one batch.
int batch_size(InstructionSet set);

constexpr std::string_view name(InstructionSet set) {
  constexpr std::string_view kNames[] = {"best", "scalar", "baseline", "avx2", "avx512"};
  return kNames[static_cast<std::size_t>(set)];
}

}  // namespace simd
