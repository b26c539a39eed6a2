#pragma once

#include <atomic>
#include <chrono>
#include <csignal>

namespace prs::cli {

/// Message of a program that a signal ends.
inline std::atomic<const char*> interruption_text = "prs: interrupted\n";

/// Message while a journal keeps the results.
inline constexpr const char* kContinues = "prs: interrupted; the same command continues from there\n";

/// While the object lives, the first Ctrl-C, SIGTERM or SIGHUP only requests a stop; the next one ends the program.
class Interruption {
 public:
  /// Time that the program may take to stop, and the message if it is then ended.
  struct Patience {
    std::chrono::milliseconds time{0};  ///< 0: unlimited.
    const char* text = "";
  };

  Interruption() : Interruption(Patience{}) {}
  explicit Interruption(Patience patience);
  ~Interruption();

  static bool asked();

  /// Exit status of a program that stopped on request: 130 after Ctrl-C.
  static int status();

 private:
  struct sigaction interrupt_ {
  }, terminate_{}, hang_up_{}, alarm_{};  ///< Former handlers of the signals.
};

/// Patience of runs that keep their results: enough for a design, but not for a long one. `is_kept`: whether they have
/// a folder for results.
Interruption::Patience patience_for(bool is_kept);

/// Exception of a program that was asked to stop and has left everything in order.
struct Interrupted {};

/// Makes Ctrl-C, SIGTERM and SIGHUP end the program with status 130, 143 and 129, as a shell reports it, leaving
/// nothing unfinished. SIGHUP stays ignored under nohup.
void end_on_interrupt();

/// Turns a file at its size limit (SIGXFSZ) and a closed pipe (SIGPIPE) into write errors, like a full disk, which do
/// not end the program.
void let_writes_fail();

}  // namespace prs::cli
