#include <fmt/format.h>

#include <string_view>

#include "modules/module.h"

/// The module that is part of a program without shared objects, and its file's name elsewhere.
extern "C" const modules::Module* prs_built_in_module(std::string_view& file);

namespace modules {

const Module& load(const Name& name) {
  std::string_view file;
  const Module* const built_in = prs_built_in_module(file);
  if (file == name.file) return *built_in;
  throw Missing(fmt::format("this needs {}, which is not part of this engine; use the program prs", name.library));
}

}  // namespace modules
