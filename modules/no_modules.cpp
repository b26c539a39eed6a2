#include <fmt/format.h>

#include "modules/module.h"

/// Replaces modules in a program without shared objects: all are missing.
namespace modules {

const Module& load(const Name& name) {
  throw Missing(fmt::format("this needs {}, which is not part of this engine; use the program prs", name.library));
}

}  // namespace modules
