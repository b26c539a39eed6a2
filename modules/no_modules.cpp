#include <fmt/format.h>

#include "modules/module.h"

/// Modules of a program without shared objects, which has none.
namespace modules {

const Module& load(const Name& name) {
  throw Missing(fmt::format("this needs {}, which is not part of this engine; use the program prs", name.library));
}

}  // namespace modules
