#include "supervisor/proc_file.h"

#include <array>

#include <fcntl.h>
#include <unistd.h>

namespace orbs::supervisor {

// Streams cost three times as much, and there are many files.
std::string read_proc_file(const std::string& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return {};
  std::string text;
  std::array<char, 16384> buffer{};
  for (;;) {
    const auto count = ::read(descriptor, buffer.data(), buffer.size());
    if (count <= 0) break;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  ::close(descriptor);
  return text;
}

}  // namespace orbs::supervisor
