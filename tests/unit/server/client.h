#pragma once

#include "base/files.h"
#include "server/serve.h"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>

namespace orbs::server_tests {

/// The server over one run with a stand-in for the bundle, on a free port, for as long as this lives.
class RunningServer {
 public:
  explicit RunningServer(const std::filesystem::path& run,
                         std::chrono::milliseconds request_timeout = server::ServeSettings{}.request_timeout,
                         std::optional<server::Editor> editor = {});
  ~RunningServer();
  RunningServer(const RunningServer&) = delete;
  RunningServer& operator=(const RunningServer&) = delete;

  int port() const { return port_; }
  /// What lets a request edit; "" without an editor.
  const std::string& token() const { return token_; }
  /// All that the server sends back on a connection that sends `bytes`, until it closes.
  std::string talk(const std::string& bytes) const;
  /// talk with a GET of this target.
  std::string get(const std::string& target) const;

 private:
  std::atomic<bool> stop_ = false;
  std::atomic<int> port_ = 0;
  std::string token_;  // written before the port
  ScratchFolder bundle_{"orbs-bundle"};
  std::thread thread_;
};

/// 200 of "HTTP/1.1 200 OK..."; 0 for no answer.
int status_of(const std::string& answer);

/// What follows the empty line.
std::string body_of(const std::string& answer);

/// A connected socket; the caller closes it.
int connect_to(int port);

/// All that comes back on this socket after `bytes` are sent, until the server closes it.
std::string answer_to(int sock, const std::string& bytes);

}  // namespace orbs::server_tests
