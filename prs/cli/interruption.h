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

/// A file at its size limit (SIGXFSZ) and a closed pipe (SIGPIPE) become write errors, like a full
/// disk, and do not end the program.
void let_writes_fail();

}  // namespace prs::cli
