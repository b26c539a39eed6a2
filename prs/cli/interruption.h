#pragma once

#include <memory>

namespace prs::cli {

/// While it lives, the first Ctrl-C or SIGTERM only asks the program to stop; the next one kills
/// it.
class Interruption {
 public:
  Interruption();
  ~Interruption();

  static bool asked();

 private:
  struct Before;
  std::unique_ptr<Before> before_;
};

/// A file that may not grow further becomes an error like a full disk, not the end of the program.
void let_large_files_fail();

}  // namespace prs::cli
