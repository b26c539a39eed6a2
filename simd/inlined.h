#pragma once

/// Marks functions and lambdas of kernels: a kernel is compiled for several instruction sets, and a function that is
/// not inlined would be linked for one of them alone.
#define PRS_INLINED __attribute__((always_inline))
