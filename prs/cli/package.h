#pragma once

#include <filesystem>
#include <string>

namespace prs::cli {

/// Replaces this process by another program of the package. It is looked for in the folder that
/// PRS_LIBEXEC names, else in the folder of this program or in `../libexec/prs`. It gets the
/// arguments of `main`, whose first two words are its name. Throws std::runtime_error where there
/// is no such program.
[[noreturn]] void become(const std::string& program, int argc, char** argv);

/// Folder of data that comes with the program: `lessons` or `validation`. It is looked for in the
/// folder that PRS_SHARE names, else in `../share/prs` beside this program's folder, for programs
/// in `libexec/prs` in `../../share/prs`. A build folder has links there to the sources. Throws
/// std::runtime_error where there is none.
std::filesystem::path data_folder(const std::string& name);

}  // namespace prs::cli
