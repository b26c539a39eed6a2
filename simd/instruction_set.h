#pragma once

#include <cstddef>
#include <string_view>

namespace simd {

/// Instruction set of a kernel. A request for an unavailable one selects the best available below it.
enum class InstructionSet {
  best,      ///< Widest available batches.
  scalar,    ///< One design at a time, with the multiply-add of the best.
  baseline,  ///< Any processor of the target: batches of 2 on x86-64.
  avx2,      ///< Batches of 4, with multiply-add.
  avx512,    ///< Batches of 8.
};

/// Widest set on which kernels run: the one named by the environment variable PRS_INSTRUCTION_SET or, without it, the
/// widest that this binary and the processor have. The variable is read once. Throws std::invalid_argument if it names
/// no available set.
InstructionSet widest();

/// Set named by a value of PRS_INSTRUCTION_SET; an empty value means the widest that this binary and the processor
/// have. Throws std::invalid_argument if they have no such set.
InstructionSet widest_of(std::string_view value);

/// Whether this binary can run the set on this processor and `widest` allows it.
bool available(InstructionSet set);

/// Set that kernels use when `set` is requested: baseline, avx2 or avx512.
InstructionSet taken(InstructionSet set);

/// Number of designs in one batch.
int batch_size(InstructionSet set);

constexpr std::string_view name(InstructionSet set) {
  constexpr std::string_view kNames[] = {"best", "scalar", "baseline", "avx2", "avx512"};
  return kNames[static_cast<std::size_t>(set)];
}

}  // namespace simd
