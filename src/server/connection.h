#pragma once

#include "server/request_gate.h"

#include <atomic>
#include <chrono>

#include <httplib.h>

namespace orbs::server {

struct ConnectionLimits {
  std::chrono::milliseconds head_time{5000};     // from the connection to the empty line of the request
  std::chrono::milliseconds write_stall{10000};  // without a byte taken by the client
  std::size_t threads = 256;                     // connections that are served at a time; others wait in line
  int backlog = 512;                             // of the line
};

/// httplib's server behind the gate: each connection carries one request, whose head must arrive in time,
/// within the size and as the gate allows before httplib sees it. (httplib's own time-outs start anew with
/// every byte, so that a client that sends one byte a second would hold a thread for hours.)
class GatedServer : public httplib::Server {
 public:
  GatedServer(GateSettings gate, ConnectionLimits limits);

  /// Binds and listens; port 0 takes a free one. Returns the port. InputError with the reason when that
  /// fails.
  int open(const std::string& address, int port);

 private:
  bool process_and_close_socket(socket_t sock) override;
  void answer(socket_t sock);

  GateSettings gate_;
  ConnectionLimits limits_;
};

}  // namespace orbs::server
