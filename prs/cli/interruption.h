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

/// A file that may not grow further (SIGXFSZ) and a reader that is gone (SIGPIPE) become errors of
/// whoever writes, as a full disk is, not the end of the program.
void let_writes_fail();

}  // namespace prs::cli
