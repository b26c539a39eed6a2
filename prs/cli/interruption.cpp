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

void end(int signal) { end(signal, interruption_text.load()); }

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

/// Sets the handler of a signal, except of SIGHUP that is ignored, as under nohup. Returns the former one.
struct sigaction handle(int signal, void (*handler)(int)) {
  struct sigaction action {
  }, former{};
  sigfillset(&action.sa_mask);
  action.sa_handler = handler;
  ::sigaction(signal, nullptr, &former);
  if (signal != SIGHUP || former.sa_handler != SIG_IGN) ::sigaction(signal, &action, nullptr);
  return former;
}

}  // namespace

Interruption::Interruption(Patience given) {
  patience = given;
  alarm_ = handle(SIGALRM, end_late);
  interrupt_ = handle(SIGINT, ask_to_stop);
  terminate_ = handle(SIGTERM, ask_to_stop);
  hang_up_ = handle(SIGHUP, ask_to_stop);
}

Interruption::~Interruption() {
  ::sigaction(SIGINT, &interrupt_, nullptr);
  ::sigaction(SIGTERM, &terminate_, nullptr);
  ::sigaction(SIGHUP, &hang_up_, nullptr);
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
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) handle(signal, end);
}

void let_writes_fail() {
  for (const int signal : {SIGXFSZ, SIGPIPE}) std::signal(signal, SIG_IGN);
}

}  // namespace prs::cli
