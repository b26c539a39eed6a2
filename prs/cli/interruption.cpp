#include "prs/cli/interruption.h"

#include <csignal>

namespace prs::cli {
namespace {

volatile std::sig_atomic_t asked_to_stop = 0;

}  // namespace

/// How the signals were answered.
struct Interruption::Before {
  struct sigaction interrupt {};
  struct sigaction terminate {};
};

Interruption::Interruption() : before_(std::make_unique<Before>()) {
  struct sigaction ask {};
  ask.sa_handler = [](int) { asked_to_stop = 1; };
  ask.sa_flags = static_cast<int>(SA_RESETHAND);
  ::sigaction(SIGINT, &ask, &before_->interrupt);
  ::sigaction(SIGTERM, &ask, &before_->terminate);
}

Interruption::~Interruption() {
  ::sigaction(SIGINT, &before_->interrupt, nullptr);
  ::sigaction(SIGTERM, &before_->terminate, nullptr);
}

bool Interruption::asked() { return asked_to_stop != 0; }

void let_writes_fail() {
  for (const int signal : {SIGXFSZ, SIGPIPE}) std::signal(signal, SIG_IGN);
}

}  // namespace prs::cli
