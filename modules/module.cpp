#include "modules/module.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace modules {
namespace {

/// Path of the program, or of the library that this code is part of.
std::filesystem::path own_folder() {
  Dl_info info;
  void* found = nullptr;
  if (dladdr1(reinterpret_cast<const void*>(&load), &info, &found, RTLD_DL_LINKMAP) == 0) return {};
  const char* path = static_cast<const link_map*>(found)->l_name;  // Empty for a program.
  std::error_code none;
  return std::filesystem::canonical(*path == '\0' ? "/proc/self/exe" : path, none).parent_path();
}

void* open(const char* file) {
  const std::filesystem::path own = own_folder();
  std::error_code none;
  if (!own.empty())  // Without it the folders below the working directory would be searched.
    for (const char* folder : {"", "lib/prs", "../lib/prs", "../../lib/prs"})
      if (const auto path = (own / folder / file).lexically_normal(); std::filesystem::exists(path, none))
        return dlopen(path.c_str(), RTLD_NOW);
  return dlopen(file, RTLD_NOW);
}

}  // namespace

const Module& load(const Name& name) {
  void* const handle = open(name.file);
  const void* const symbol = handle != nullptr ? dlsym(handle, "prs_module") : nullptr;
  if (symbol == nullptr) {
    const std::string error = dlerror();
    if (error.starts_with(name.file))
      throw Missing(
          fmt::format("this needs {0}, and {1} is not next to the program; install {2} and build prs again{3}",
                      name.library, name.file, name.package, name.alternative));
    // Message of the loader if the system lacks a library of the module.
    if (const auto end = error.find(": cannot open shared object file: No such file"); end != error.npos)
      throw Missing(
          fmt::format("this needs {0}, and {1} is not installed; install {0}, on Debian by `apt "
                      "install {2}`{3}",
                      name.library, error.substr(0, end), name.package, name.alternative));
    throw std::runtime_error(
        fmt::format("this needs {0}, and {1} does not load: {2}; give the program more memory or open files, or "
                    "install {0} and build prs again{3}",
                    name.library, name.file, error, name.alternative));
  }
  const auto& loaded = *static_cast<const Module*>(symbol);
  if (std::string_view(loaded.build) != kBuild)
    throw std::runtime_error(fmt::format("{} is of prs {}, and this is prs {}; install both from one build", name.file,
                                         loaded.build, kBuild));
  return loaded;
}

}  // namespace modules
