#pragma once

#include "server/request_gate.h"

#include <atomic>
#include <chrono>

#include <httplib.h>

namespace orbs::server {

struct ConnectionLimits {
  std::chrono::milliseconds head_timeout{5000};    // from the connection to the empty line of the request
  std::chrono::milliseconds write_timeout{10000};  // while the client takes no byte
  std::size_t threads = 256;                       // connections served at the same time; others wait
  int backlog = 512;                               // connections that may wait
};

/// httplib's server behind the gate: each connection carries one request, whose head must arrive in time, fit
/// the size limit and pass the gate before httplib sees it. (httplib's own timeouts restart with every byte:
/// a client that sends one byte a second would hold a thread for hours.)
class GatedServer : public httplib::Server {
 public:
  GatedServer(GateSettings gate, ConnectionLimits limits);

  /// Binds and listens; port 0 takes a free one. Returns the port. InputError with the reason if that
  /// fails.
  int open(const std::string& address, int port);

 private:
  bool process_and_close_socket(socket_t sock) override;
  void answer(socket_t sock);

  GateSettings gate_;
  ConnectionLimits limits_;
};

}  // namespace orbs::server
