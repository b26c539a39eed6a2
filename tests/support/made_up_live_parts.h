#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "prs/page/live_parts.h"

namespace test {

/// Writes artificial output of `scripts/web.sh`: an engine of the usual size that computes nothing, and scripts that
/// are their names. Pages accept it if `id` is that of the program.
inline void write_live_parts(const std::filesystem::path& folder, const std::string& id = prs::source_id()) {
  std::filesystem::create_directories(folder);
  for (const char* name : {"worker.js", "start.js", "report.js.gz", "report.hash", "mechanism.js.gz", "mechanism.hash",
                           "workbench.js.gz", "workbench.hash"})
    std::ofstream(folder / name) << name;
  std::ofstream(folder / "engine.wasm.lzma") << std::string(1'350'000, 'e');
  std::ofstream(folder / "source_id") << id;
}

}  // namespace test
