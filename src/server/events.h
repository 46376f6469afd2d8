#pragma once

#include "server/http.h"
#include "server/served.h"

#include <atomic>

namespace orbs::server {

/// The clients that follow the progress of runs, which all runs share.
struct EventClients {
  std::atomic<int> count = 0;
  const std::atomic<bool>* stop = nullptr;  // ends all answers when it becomes true; may be null
};

/// Progress of a run as server-sent events (HTML standard, section 9.2) until it ends; 204 when it has ended,
/// which tells browsers not to ask again. `clients` and `run` must outlive the answer.
void send_events(EventClients& clients, ServedRun& run, Response& response);

}  // namespace orbs::server
