#pragma once

#include "server/editor.h"
#include "server/request_gate.h"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

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

struct ServeSettings {
  std::vector<std::filesystem::path> runs;  // and studies, at least one; the page opens with the first
  std::filesystem::path bundle;             // folder of the built page
  std::string address = "127.0.0.1";
  int port = 0;                                  // 0: any free port
  std::chrono::milliseconds head_timeout{5000};  // for a client to send its request
  std::optional<Editor> editor{};                // whoever has the page's whole address may use it
};

/// True for the addresses that only this machine can reach: 127.0.0.0/8 and ::1.
bool is_loopback_address(const std::string& address);

/// Serves the runs until `stop` is set; `ready` gets the address of the page as soon as it answers. Nothing
/// is written but through an editor. InputError if there is an editor and the address is no loopback address,
/// a folder is neither run nor study, the page is not built, or the address cannot be bound.
void serve(const ServeSettings& settings,
           const std::atomic<bool>& stop,
           const std::function<void(const std::string& url)>& ready);

}  // namespace orbs::server
