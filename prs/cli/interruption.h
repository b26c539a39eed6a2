#pragma once

#include <chrono>
#include <csignal>

namespace prs::cli {

/// While it lives, the first Ctrl-C or SIGTERM only asks the program to stop; the next one ends it.
class Interruption {
 public:
  /// How long the program may take to stop, and what it says when it is ended then.
  struct Patience {
    std::chrono::milliseconds time{0};  ///< 0: for ever.
    const char* text = "";
  };

  Interruption() : Interruption(Patience{}) {}
  explicit Interruption(Patience patience);
  ~Interruption();

  static bool asked();

  /// Exit status of a program that stopped because it was asked: 130 after Ctrl-C.
  static int status();

 private:
  struct sigaction interrupt_ {
  }, terminate_{}, alarm_{};  ///< How the signals were answered.
};

/// For runs that keep what is computed: time for a design, and not for a long one. `is_kept` says
/// whether they have a folder for it.
Interruption::Patience patience_for(bool is_kept);

/// Thrown where a program that was asked to stop has left everything in order.
struct Interrupted {};

/// Ctrl-C and SIGTERM end the program with status 130 and 143, as a shell reports it, and leave
/// nothing unfinished.
void end_on_interrupt();

/// A file at its size limit (SIGXFSZ) and a closed pipe (SIGPIPE) become write errors, like a full
/// disk, and do not end the program.
void let_writes_fail();

}  // namespace prs::cli
