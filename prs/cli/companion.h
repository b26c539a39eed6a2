#pragma once

#include <string>

namespace prs::cli {

/// Becomes another program of this package, found in the folder that PRS_LIBEXEC names or else
/// beside this one or in `../libexec/prs`, with the arguments of `main`: the first two words are
/// its name. Throws std::runtime_error where there is no such program.
[[noreturn]] void become(const std::string& program, int argc, char** argv);

}  // namespace prs::cli
