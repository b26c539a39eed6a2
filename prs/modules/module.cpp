#include "prs/modules/module.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>

#include <filesystem>
#include <string_view>

namespace prs {
namespace {

/// Of the program, or of the library that this code is part of.
std::filesystem::path own_folder() {
  Dl_info info;
  void* found = nullptr;
  if (dladdr1(reinterpret_cast<const void*>(&load_module), &info, &found, RTLD_DL_LINKMAP) == 0)
    return {};
  const char* path = static_cast<const link_map*>(found)->l_name;  // Of a program: empty.
  std::error_code none;
  return std::filesystem::canonical(*path == '\0' ? "/proc/self/exe" : path, none).parent_path();
}

/// The last candidate is left to the system.
void* open_module(const char* file) {
  const std::filesystem::path own = own_folder();
  for (const char* folder : {"", "../lib/prs", "../../lib/prs"})
    if (const auto path = own / folder / file; std::filesystem::exists(path))
      return dlopen(path.c_str(), RTLD_NOW);
  return dlopen(file, RTLD_NOW);
}

}  // namespace

const Module& load_module(const ModuleName& name) {
  void* const handle = open_module(name.file);
  const void* const symbol = handle != nullptr ? dlsym(handle, "prs_module") : nullptr;
  if (symbol == nullptr) {
    const std::string_view error = dlerror();
    if (error.starts_with(name.file))
      throw MissingModule(fmt::format(
          "this needs {0}, and {1} is not beside the program; install {2} and build prs again{3}",
          name.library, name.file, name.package, name.alternative));
    throw MissingModule(
        fmt::format("this needs {}, and {} does not load: {}; install what it asks for{}",
                    name.library, name.file, error, name.alternative));
  }
  const auto& loaded = *static_cast<const Module*>(symbol);
  if (std::string_view(loaded.version) != kVersion)
    throw MissingModule(fmt::format("{} is of prs {}; this program is {}: install both together",
                                    name.file, loaded.version, kVersion));
  return loaded;
}

}  // namespace prs
