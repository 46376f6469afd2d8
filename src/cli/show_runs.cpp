#include "cli/show_runs.h"

#include "base/error.h"
#include "base/terminal.h"
#include "cli/interrupt.h"
#include "server/serve.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <spawn.h>
#include <unistd.h>

namespace orbs::cli {

namespace {

// Starts the desktop's browser. Without one the user opens the address that stands on the terminal.
void open_in_browser(const std::string& url) {
  std::string program = "xdg-open";
  std::string address = url;
  std::array<char*, 3> argv{program.data(), address.data(), nullptr};
  pid_t child = 0;
  if (::posix_spawnp(&child, "xdg-open", nullptr, nullptr, argv.data(), environ) == 0) return;
  print_clean(stderr, "there is no xdg-open; open the address in a browser\n");
}

}  // namespace

std::vector<std::filesystem::path> newest_runs() {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::current_path()))
    if (entry.path().filename().string().starts_with("outputs-") &&
        std::filesystem::exists(entry.path() / "results.json"))
      found.push_back(entry.path());
  // The names hold the date and time.
  std::sort(found.rbegin(), found.rend());
  if (found.empty())
    throw InputError(fmt::format("there is no outputs-* folder of a run in {}; name one",
                                 std::filesystem::current_path().string()));
  return found;
}

void show_runs(const std::vector<std::filesystem::path>& runs,
               const Program& program,
               const ShowSettings& settings) {
  if (!server::is_loopback_address(settings.address))
    print_clean(stderr,
                "warning: other machines can reach {}: everybody there can read these runs, and nothing is "
                "encrypted\n",
                settings.address);
  server::serve({runs, program.folder / "web", settings.address, settings.port}, catch_interrupts(),
                [&](const std::string& url) {
                  print_clean("the page is at {}  (Ctrl-C ends it)\n", url);
                  std::fflush(stdout);
                  if (settings.open) open_in_browser(url);
                });
}

}  // namespace orbs::cli
