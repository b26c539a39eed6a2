#pragma once

#include <stdexcept>
#include <string>

namespace modules {

/// Texts of the message for a missing module.
struct Name {
  const char* file;         ///< `prs_pagmo.so`
  const char* library;      ///< `pagmo`, the library of the module.
  const char* package;      ///< `libpagmo-dev`, needed to build the module; it brings the packages needed to load it.
  const char* alternative;  ///< `, or take --threads 1`; empty: no alternative.
};

/// Version and compiler: a module exchanges objects with the program and must agree in both.
inline constexpr const char* kBuild = PRS_VERSION " (compiler " __VERSION__ ")";

/// A part of the program whose library few runs need: a shared object, loaded when a run needs it. Interfaces derive
/// from this, name their module in `kName`, and have functions as members; the shared object exports one as its symbol
/// `prs_module`.
struct Module {
  const char* build = kBuild;  ///< Build of the module, which must be that of the program.
};

/// Error: the module, or a library that it needs, is not installed.
class Missing : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Error: the light build omits this part (PRS_FULL).
class NotBuilt : public Missing {
 public:
  explicit NotBuilt(const std::string& what) : Missing(what + ": not built; scripts/install.sh builds all") {}
};

/// Loads a library. Searches the folder of the program (or of the library that this function is part of), the folder
/// `lib/prs` there and in the two folders above, and the system's library folders. Throws Missing; std::runtime_error
/// if there is a module that does not load.
const Module& load(const Name& name);

/// Loads the module once; throws as `load` does.
template <class Interface>
const Interface& loaded() {
  static const auto& module = static_cast<const Interface&>(load(Interface::kName));
  return module;
}

}  // namespace modules
