#include "unit/adapters/process_shell.h"

#include <fstream>
#include <thread>

#include <fmt/format.h>

namespace orbs::process_tests {

adapters::ProcessRequest shell(const std::string& script) {
  adapters::ProcessRequest request;
  request.argv = {"/bin/sh", "-c", script};
  request.environment = {"PATH=/usr/bin:/bin"};
  request.limits.wall_seconds = 60;
  request.limits.grace_seconds = 0.1;
  return request;
}

bool is_running(const std::string& id) {
  for (int look = 0; look < 100000; ++look) {
    std::ifstream stat(fmt::format("/proc/{}/stat", std::stoi(id)));
    std::string text;
    if (!std::getline(stat, text)) return false;
    const char state = text[text.rfind(')') + 2];
    if (state == 'Z' || state == 'X') return false;
    std::this_thread::yield();
  }
  return true;
}

}  // namespace orbs::process_tests
