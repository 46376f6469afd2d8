#pragma once

#include "server/http.h"
#include "server/socket.h"

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace orbs::server {

/// A client whose request is whole.
struct Visitor {
  Descriptor sock;
  Request request;
};

/// Threads that answer visitors. Another one is started while all are busy, up to `most`; further visitors
/// wait.
class Workers {
 public:
  Workers(std::size_t most, std::function<void(Visitor)> answer);
  /// Sends those away that wait, and waits for the answers that have begun.
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  void add(Visitor visitor);

 private:
  void work();

  std::size_t most_;
  std::function<void(Visitor)> answer_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Visitor> waiting_;
  std::size_t idle_ = 0;
  bool is_ending_ = false;
  std::vector<std::jthread> threads_;
};

}  // namespace orbs::server
