#include "adapters/interrupt.h"

#include <array>
#include <csignal>

#include <unistd.h>

namespace orbs::adapters {

namespace {

// A signal handler can use nothing but lock-free atomics: a fixed table, and groups beyond its size are not
// killed.
std::array<std::atomic<pid_t>, 1024> groups;
std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<pid_t>::is_always_lock_free);

void note_interrupt(int signal) {
  if (!interrupted.exchange(true)) return;
  for (const auto& group : groups)
    if (const pid_t id = group.load(); id > 0) ::kill(-id, SIGKILL);
  ::_exit(128 + signal);
}

}  // namespace

const std::atomic<bool>& catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = note_interrupt;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaction(signal, &action, nullptr);
  return interrupted;
}

GroupAtRisk::GroupAtRisk(pid_t group) {
  for (slot_ = 0; slot_ < groups.size(); ++slot_) {
    pid_t free = 0;
    if (groups.at(slot_).compare_exchange_strong(free, group)) return;
  }
}

GroupAtRisk::~GroupAtRisk() {
  if (slot_ < groups.size()) groups.at(slot_) = 0;
}

}  // namespace orbs::adapters
