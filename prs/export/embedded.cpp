#include "prs/export/embedded.h"

// The content of FILE between two symbols. Paths come from the build.
#define PRS_EMBED(symbol, file)                        \
  asm(".pushsection .rodata\n"                         \
      ".globl prs_embedded_" #symbol                   \
      "\n"                                             \
      "prs_embedded_" #symbol                          \
      ":\n"                                            \
      ".incbin \"" file                                \
      "\"\n"                                           \
      ".globl prs_embedded_" #symbol                   \
      "_end\n"                                         \
      "prs_embedded_" #symbol                          \
      "_end:\n"                                        \
      ".byte 0\n"                                      \
      ".popsection\n");                                \
  extern "C" const char prs_embedded_##symbol[];       \
  extern "C" const char prs_embedded_##symbol##_end[]; \
  static std::string_view symbol() { return {prs_embedded_##symbol, prs_embedded_##symbol##_end}; }

PRS_EMBED(curves_h, PRS_UNIT_SOURCES "/curves.h")
PRS_EMBED(curves_c, PRS_UNIT_SOURCES "/curves.c")
PRS_EMBED(fmi2_h, PRS_UNIT_SOURCES "/fmi2.h")
PRS_EMBED(unit_c, PRS_UNIT_SOURCES "/unit.c")
PRS_EMBED(licence, PRS_LICENCE)
PRS_EMBED(library, PRS_UNIT_LIBRARY)

namespace prs {

EmbeddedUnit embedded_unit() {
#if defined(__x86_64__) && defined(__linux__)
  constexpr std::string_view kPlatform = "linux64";
#else
  constexpr std::string_view kPlatform;
#endif
  return {curves_h(), curves_c(), fmi2_h(), unit_c(), licence(), library(), kPlatform};
}

}  // namespace prs
