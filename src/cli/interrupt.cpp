#include "cli/interrupt.h"

#include <csignal>

#include <unistd.h>

namespace orbs::cli {

namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void note_interrupt(int signal) {
  if (interrupted.exchange(true)) ::_exit(128 + signal);
}

}  // namespace

const std::atomic<bool>& catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = note_interrupt;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaction(signal, &action, nullptr);
  // A limit of the shell on file sizes then is an error like a full disk, and no sudden death.
  std::signal(SIGXFSZ, SIG_IGN);
  return interrupted;
}

void wind_up() { interrupted = true; }

}  // namespace orbs::cli
