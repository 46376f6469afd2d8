// orbs-supervisor: runs one command under limits and reports how it ended. Its standard input is the string
// that it hangs on: a byte there, or the end of it, and the command ends. Started by orbs for every render; a
// process of its own, because only a parent without other children can hold together what a renderer starts,
// and so that renderers end when orbs itself is killed.
#include "base/text.h"
#include "supervisor/guard.h"

#include <cstdio>
#include <string>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace {

using orbs::supervisor::Order;

// Sets what `name` names; false for an unknown name or a value that is none.
bool take_option(const std::string& name, const std::string& value, Order& order) {
  if (name == "--folder") return !(order.folder = value).empty();
  const auto number = orbs::to_number(value);
  if (!number || !(*number >= 0)) return false;
  auto& limits = order.limits;
  if (name == "--wall-seconds") return limits.wall_seconds = *number, true;
  if (name == "--grace-seconds") return limits.grace_seconds = *number, true;
  if (name == "--cpu-seconds") return limits.cpu_seconds = *number, true;
  if (name == "--memory-bytes") return limits.memory_bytes = static_cast<std::size_t>(*number), true;
  if (name == "--output-bytes") return limits.output_bytes = static_cast<std::size_t>(*number), true;
  return false;
}

bool parse(const std::vector<std::string>& words, Order& order) {
  std::size_t at = 0;
  for (; at + 1 < words.size() && words[at] != "--"; at += 2)
    if (!take_option(words[at], words[at + 1], order)) return false;
  if (at >= words.size() || words[at] != "--") return false;
  order.argv.assign(words.begin() + static_cast<std::ptrdiff_t>(at) + 1, words.end());
  return !order.argv.empty();
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int kReport = 3;  // descriptor
  Order order;
  if (!parse({argv + 1, argv + argc}, order)) {
    fmt::print(stderr,
               "orbs-supervisor [--folder F] [--wall-seconds S] [--cpu-seconds S] [--memory-bytes N] "
               "[--output-bytes N] [--grace-seconds S] -- program arguments...\n"
               "Ends the command when its standard input ends; reports to descriptor 3.\n");
    return 2;
  }
  ::fcntl(kReport, F_SETFD, FD_CLOEXEC);
  const auto text = orbs::supervisor::report_text(orbs::supervisor::guard(order, STDIN_FILENO));
  return ::write(kReport, text.data(), text.size()) == static_cast<ssize_t>(text.size()) ? 0 : 1;
}
