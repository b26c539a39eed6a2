#pragma once

#include <string_view>

/// Defines `symbol()`: the content of a file, which the assembler copies between two symbols. Its path is relative to
/// the root of the sources.
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
