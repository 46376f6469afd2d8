#include "base/error.h"
#include "cli/commands.h"
#include "cli/interrupt.h"
#include "server/serve.h"

#include <algorithm>
#include <array>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace orbs::cli {

namespace {

struct ServeOptions {
  std::vector<std::string> runs;
  std::string address = "127.0.0.1";
  int port = 0;
  bool allow_network = false;
  bool open = false;
};

// Starts the desktop's browser; when there is none the address on the terminal has to do.
void open_in_browser(const std::string& url) {
  std::string program = "xdg-open";
  std::string address = url;
  std::array<char*, 3> argv{program.data(), address.data(), nullptr};
  pid_t child = 0;
  if (::posix_spawnp(&child, "xdg-open", nullptr, nullptr, argv.data(), environ) == 0) return;
  fmt::print(stderr, "there is no xdg-open; open the address in a browser\n");
}

int serve(const ServeOptions& options, const Program& program) {
  if (!server::is_loopback_address(options.address) && !options.allow_network)
    throw InputError(
        fmt::format("{} is not this machine's loopback address: everybody who reaches it could read the "
                    "run; add --allow-network if that is wanted",
                    options.address));
  std::vector<std::filesystem::path> runs(options.runs.begin(), options.runs.end());
  show_runs(runs.empty() ? newest_runs() : runs, program, {options.address, options.port, options.open});
  return 0;
}

}  // namespace

std::vector<std::filesystem::path> newest_runs() {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::current_path()))
    if (entry.path().filename().string().starts_with("outputs-") &&
        std::filesystem::exists(entry.path() / "results.json"))
      found.push_back(entry.path());
  // The names hold the date.
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
    fmt::print(stderr,
               "warning: {} can be reached from other machines: everybody there can read these runs, and "
               "nothing is encrypted\n",
               settings.address);
  server::serve({runs, program.folder / "web", settings.address, settings.port}, catch_interrupts(),
                [&](const std::string& url) {
                  fmt::print("the page is at {}  (Ctrl-C ends it)\n", url);
                  std::fflush(stdout);
                  if (settings.open) open_in_browser(url);
                });
}

void add_serve_command(CLI::App& app, const Program& program, Action& action) {
  auto* command = app.add_subcommand("serve", "Shows runs as a page in the browser, also while they go on");
  const auto options = std::make_shared<ServeOptions>();
  command->add_option("runs", options->runs,
                      "folders of runs (default: all outputs-* here, the newest first)");
  command->add_option("--port", options->port, "port to listen on; 0: any that is free")
      ->check(CLI::Range(0, 65535));
  command->add_option("--address", options->address, "address to listen on");
  command->add_flag("--allow-network", options->allow_network,
                    "needed for an --address that other machines reach");
  command->add_flag("--open", options->open, "open the page in the browser");
  command->footer(
      "The server only reads, and only below the folders of the runs; symbolic links are not followed.");
  command->callback([=, &program, &action] { action = [=, &program] { return serve(*options, program); }; });
}

}  // namespace orbs::cli
