#pragma once

#include "simd/instruction_set.h"

namespace prs {

using simd::InstructionSet, simd::available, simd::batch_size, simd::name;

}  // namespace prs
