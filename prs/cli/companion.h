#pragma once

#include <string>

namespace prs::cli {

/// Replaces this process by another program of the package. It is looked for in the folder that
/// PRS_LIBEXEC names, else in the folder of this program or in `../libexec/prs`. It gets the
/// arguments of `main`, whose first two words are its name. Throws std::runtime_error where there
/// is no such program.
[[noreturn]] void become(const std::string& program, int argc, char** argv);

}  // namespace prs::cli
