#pragma once

#include <cfloat>

namespace fe {

/// A number of 113 binary digits (IEEE 754 binary128), by the compiler's own arithmetic: `long double` of ARM and
/// WebAssembly, a separate type on x86, whose `long double` is shorter.
#if LDBL_MANT_DIG == 113
using Quad = long double;
#else
__extension__ using Quad = __float128;
#endif

}  // namespace fe
