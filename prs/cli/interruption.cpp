#include "prs/cli/interruption.h"

#include <sys/time.h>

#include "prs/output/staged_file.h"

namespace prs::cli {
namespace {

constexpr int kStatusOfSignal = 128;  ///< Value that shells add the signal to.

volatile std::sig_atomic_t asked_by = 0;  ///< Received signal, or 0.
Interruption::Patience patience;          ///< Changes only while no signal is handled.

[[noreturn]] void end(int signal, std::string_view text) {
  remove_unfinished();
  write_all(STDERR_FILENO, text);
  ::_exit(kStatusOfSignal + signal);
}

void end(int signal) { end(signal, "prs: interrupted\n"); }

void end_late(int) { end(asked_by, patience.text); }

/// Starts the timer that ends the program; `after` 0: none. A plain system call, allowed in signal handlers.
void call_end_late(std::chrono::milliseconds after) {
  itimerval timer{};
  timer.it_value.tv_sec = after.count() / 1000;
  timer.it_value.tv_usec = after.count() % 1000 * 1000;
  ::setitimer(ITIMER_REAL, &timer, nullptr);
}

void ask_to_stop(int signal) {
  if (asked_by != 0) end(signal);
  asked_by = signal;
  if (patience.time.count() > 0) call_end_late(patience.time);
}

}  // namespace

Interruption::Interruption(Patience given) {
  patience = given;
  struct sigaction ask {};
  sigfillset(&ask.sa_mask);
  ask.sa_handler = end_late;
  ::sigaction(SIGALRM, &ask, &alarm_);
  ask.sa_handler = ask_to_stop;
  ::sigaction(SIGINT, &ask, &interrupt_);
  ::sigaction(SIGTERM, &ask, &terminate_);
}

Interruption::~Interruption() {
  ::sigaction(SIGINT, &interrupt_, nullptr);
  ::sigaction(SIGTERM, &terminate_, nullptr);
  call_end_late(std::chrono::milliseconds(0));
  ::sigaction(SIGALRM, &alarm_, nullptr);
}

bool Interruption::asked() { return asked_by != 0; }

int Interruption::status() { return kStatusOfSignal + asked_by; }

Interruption::Patience patience_for(bool is_kept) {
  return {std::chrono::seconds(5), is_kept
                                       ? "prs: interrupted; what was under way took long and is lost; the same command "
                                         "continues from there\n"
                                       : "prs: interrupted; with --output DIR a run can be continued\n"};
}

void end_on_interrupt() {
  struct sigaction action {};
  action.sa_handler = end;
  sigfillset(&action.sa_mask);
  for (const int signal : {SIGINT, SIGTERM}) ::sigaction(signal, &action, nullptr);
}

void let_writes_fail() {
  for (const int signal : {SIGXFSZ, SIGPIPE}) std::signal(signal, SIG_IGN);
}

}  // namespace prs::cli
