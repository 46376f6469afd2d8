#pragma once

#include "server/request_gate.h"
#include "server/socket.h"
#include "server/workers.h"

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <poll.h>

namespace orbs::server {

struct ConnectionLimits {
  std::chrono::milliseconds request_timeout{5000};  // from the connection to the last byte of the request
  std::chrono::milliseconds write_timeout{10000};   // while the client takes no byte
  std::size_t threads = 256;                        // answers that are sent at the same time
  // A process may usually have 1024 files open: one for each client that is received, for each that is
  // answered, and for the file that it gets.
  std::size_t most_received = 320;  // clients whose request is not whole yet, or that are about to leave
  std::size_t most_answered = 320;  // clients whose request is whole
  int backlog = 512;                // clients that wait to be received
};

/// One thread receives all clients: it reads their requests as the bytes come, so that a client that sends
/// half a request holds no worker and nobody else. Each connection carries one request, which must be whole
/// in time, fit the limits and pass the gate before a worker sees it.
class Reception {
 public:
  Reception(Descriptor listener, GateSettings gate, ConnectionLimits limits);

  /// Receives clients until `stop` is set. `answer` gets each whose request is whole, and its socket must be
  /// given back.
  void run(const std::atomic<bool>& stop, const std::function<void(Visitor)>& answer);

  /// Closes the connection when the client has seen the end of its answer. From any thread.
  void give_back(Descriptor sock);

 private:
  using Clock = std::chrono::steady_clock;
  struct Client {
    Descriptor sock;
    Clock::time_point deadline;
    std::string bytes{};                 // of the head; then of the body
    std::optional<Admitted> admitted{};  // when the head has come
    bool is_leaving = false;             // has its answer
    std::size_t unread = 0;              // bytes that it has sent since
  };

  std::vector<pollfd> watched() const;
  void take_back();
  void accept_clients();
  void make_room();
  bool receive(Client& client, const std::function<void(Visitor)>& answer);
  bool advance(Client& client, const std::function<void(Visitor)>& answer);
  bool send_away(Client& client, const Refusal& refusal);
  bool is_in_time(Client& client);
  void leave(Client& client);

  Descriptor listener_;
  GateSettings gate_;
  ConnectionLimits limits_;
  Descriptor bell_;              // rung when a socket is given back
  std::vector<Client> clients_;  // in the order in which they came
  std::size_t answered_ = 0;     // whose request is whole
  bool is_out_of_files_ = false;
  std::mutex mutex_;
  std::vector<Descriptor> given_back_;
};

}  // namespace orbs::server
