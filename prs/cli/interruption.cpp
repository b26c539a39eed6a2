#include "prs/cli/interruption.h"

#include <unistd.h>

#include <csignal>
#include <string_view>

#include "prs/file_descriptor.h"
#include "prs/output/unfinished.h"

namespace prs::cli {
namespace {

constexpr int kStatusOfSignal = 128;  ///< Shells add the signal to it.

volatile std::sig_atomic_t asked_by = 0;  ///< The signal, or 0.

void end(int signal) {
  constexpr std::string_view kText = "prs: interrupted\n";
  remove_unfinished();
  write_all(STDERR_FILENO, kText);
  ::_exit(kStatusOfSignal + signal);
}

void ask_to_stop(int signal) {
  if (asked_by != 0) end(signal);
  asked_by = signal;
}

}  // namespace

/// How the signals were answered.
struct Interruption::Before {
  struct sigaction interrupt {};
  struct sigaction terminate {};
};

Interruption::Interruption() : before_(std::make_unique<Before>()) {
  struct sigaction ask {};
  ask.sa_handler = ask_to_stop;
  sigfillset(&ask.sa_mask);
  ::sigaction(SIGINT, &ask, &before_->interrupt);
  ::sigaction(SIGTERM, &ask, &before_->terminate);
}

Interruption::~Interruption() {
  ::sigaction(SIGINT, &before_->interrupt, nullptr);
  ::sigaction(SIGTERM, &before_->terminate, nullptr);
}

bool Interruption::asked() { return asked_by != 0; }

int Interruption::status() { return kStatusOfSignal + asked_by; }

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
