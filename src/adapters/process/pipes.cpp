#include "adapters/process/pipes.h"

#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace orbs::adapters {

Pipe::Pipe() {
  if (::pipe2(ends_.data(), O_CLOEXEC) != 0) return;
  constexpr int kLowest = 4;
  for (auto& end : ends_) {
    if (end >= kLowest) continue;
    const int low = std::exchange(end, ::fcntl(end, F_DUPFD_CLOEXEC, kLowest));
    ::close(low);
  }
}

Pipe::~Pipe() {
  close_read_end();
  close_write_end();
}

void Pipe::close_read_end() {
  if (ends_[0] >= 0) ::close(std::exchange(ends_[0], -1));
}

void Pipe::close_write_end() {
  if (ends_[1] >= 0) ::close(std::exchange(ends_[1], -1));
}

}  // namespace orbs::adapters
