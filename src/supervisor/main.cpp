// orbs-supervisor: runs one command under limits and reports how it ended. It ends the command when it can
// read a byte from its standard input, or the end of it. orbs starts one for every render. It is a process of
// its own because only a parent without other children can keep track of all processes that a renderer
// starts, and so that renderers end when orbs itself is killed.
#include "base/text.h"
#include "supervisor/supervise.h"

#include <csignal>
#include <cstdio>
#include <string>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <unistd.h>

namespace {

using orbs::supervisor::Command;

// Sets the member that the option names; false for an unknown option and for a value that is no number.
bool set_option(const std::string& name, const std::string& value, Command& command) {
  if (name == "--folder") return !(command.folder = value).empty();
  const auto number = orbs::to_number(value);
  if (!number || !(*number >= 0)) return false;
  auto& limits = command.limits;
  if (name == "--wall-seconds") return limits.wall_seconds = *number, true;
  if (name == "--grace-seconds") return limits.grace_seconds = *number, true;
  if (name == "--cpu-seconds") return limits.cpu_seconds = *number, true;
  if (name == "--memory-bytes") return limits.memory_bytes = static_cast<std::size_t>(*number), true;
  if (name == "--own-keyring") return command.has_own_keyring = *number > 0, true;
  if (name == "--output-bytes") return limits.output_bytes = static_cast<std::size_t>(*number), true;
  return false;
}

bool parse(const std::vector<std::string>& words, Command& command) {
  std::size_t at = 0;
  for (; at + 1 < words.size() && words[at] != "--"; at += 2)
    if (!set_option(words[at], words[at + 1], command)) return false;
  if (at >= words.size() || words[at] != "--") return false;
  command.argv.assign(words.begin() + static_cast<std::ptrdiff_t>(at) + 1, words.end());
  return !command.argv.empty();
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int kReport = 3;  // descriptor
  Command command;
  if (!parse({argv + 1, argv + argc}, command)) {
    fmt::print(stderr,
               "orbs-supervisor [--folder F] [--wall-seconds S] [--cpu-seconds S] [--memory-bytes N] "
               "[--output-bytes N] [--own-keyring 1] [--grace-seconds S] -- program arguments...\n"
               "Ends the command when its standard input ends; reports to descriptor 3.\n");
    return 2;
  }
  ::fcntl(kReport, F_SETFD, FD_CLOEXEC);
  ::prctl(PR_SET_PDEATHSIG, SIGCONT);  // should we be stopped when orbs is killed
  const auto text = orbs::supervisor::report_text(orbs::supervisor::supervise(command, STDIN_FILENO));
  return ::write(kReport, text.data(), text.size()) == static_cast<ssize_t>(text.size()) ? 0 : 1;
}
