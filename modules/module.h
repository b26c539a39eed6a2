#pragma once

#include <stdexcept>
#include <string>

namespace modules {

/// What the message says where a module is missing.
struct Name {
  const char* file;         ///< `prs_netcdf.so`
  const char* library;      ///< `netCDF`, which the module brings.
  const char* package;      ///< `libnetcdf-dev`, which building it takes; brings what loading takes.
  const char* alternative;  ///< `, or take --threads 1`; empty: none.
};

/// Version and compiler: a module exchanges objects with the program and must agree in both.
inline constexpr const char* kBuild = PRS_VERSION " (compiler " __VERSION__ ")";

/// A part of the program whose library few runs need: a shared object, loaded when a run asks for
/// it. Interfaces derive from this, name their module in `kName`, and have functions as members;
/// the shared object has one as its symbol `prs_module`.
struct Module {
  const char* build = kBuild;  ///< What the module was built with: that of the program.
};

/// The module is not there, or does not load.
class Missing : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Something that a light build leaves out (PRS_FULL).
class NotBuilt : public Missing {
 public:
  explicit NotBuilt(const std::string& what) : Missing(what + ": not built; scripts/install.sh builds all") {}
};

/// Searches the folder of the program (or of the library that this function is part of), the folder
/// `lib/prs` there and in the two folders above, and the system's library folders.
const Module& load(const Name& name);

/// Loads it once. Throws Missing.
template <class Interface>
const Interface& loaded() {
  static const auto& module = static_cast<const Interface&>(load(Interface::kName));
  return module;
}

}  // namespace modules
