#pragma once

#include <array>

namespace orbs::adapters {

/// The two ends of a pipe that no child inherits except by dup2. Both descriptors are above 3: the child uses
/// 0 to 3.
class Pipe {
 public:
  Pipe();
  ~Pipe();
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  bool is_open() const { return ends_[0] >= 0 && ends_[1] >= 0; }
  int read_end() const { return ends_[0]; }
  int write_end() const { return ends_[1]; }
  void close_read_end();
  void close_write_end();

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// The pipes between us and one supervisor.
struct Pipes {
  Pipe control;  // to the supervisor: it ends the command when this closes
  Pipe output;   // of the command
  Pipe report;   // of the supervisor
};

}  // namespace orbs::adapters
