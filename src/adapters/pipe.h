#pragma once

#include <array>

namespace orbs::adapters {

/// The two ends of a pipe that no child inherits but by dup2. Descriptors 0 to 3 are left to the child, so
/// both ends are above.
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

}  // namespace orbs::adapters
