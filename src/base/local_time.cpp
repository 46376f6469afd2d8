#include "base/local_time.h"

#include <array>
#include <ctime>

namespace orbs {

std::string local_time_now(const char* format) {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  ::localtime_r(&now, &local);
  std::array<char, 64> text{};
  std::strftime(text.data(), text.size(), format, &local);
  return text.data();
}

}  // namespace orbs
