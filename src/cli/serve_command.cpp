#include "base/error.h"
#include "cli/program.h"
#include "cli/show_runs.h"
#include "server/serve.h"

#include <fmt/format.h>

namespace orbs::cli {

namespace {

struct ServeOptions {
  std::vector<std::string> runs;
  std::string address = "127.0.0.1";
  int port = 0;
  bool allow_network = false;
  bool open = false;
};

int serve(const ServeOptions& options, const Program& program) {
  if (!server::is_loopback_address(options.address) && !options.allow_network)
    throw InputError(
        fmt::format("{} is not this machine's loopback address: everybody who reaches it could read the "
                    "run; add --allow-network if that is wanted",
                    options.address));
  std::vector<std::filesystem::path> runs(options.runs.begin(), options.runs.end());
  show_runs(runs.empty() ? newest_runs_and_studies() : runs, program,
            {options.address, options.port, options.open});
  return 0;
}

}  // namespace

void add_serve_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto options = std::make_shared<ServeOptions>();
  command
      .add_option("runs", options->runs,
                  "Folders of runs and studies (default: all of the working folder, the newest first)")
      .not_empty("a folder");
  command.add_option("--port", options->port, "Port to listen on; 0: any free port").range(0, 65535);
  command.add_option("--address", options->address,
                     "Address to listen on (default: 127.0.0.1, this machine only)");
  command.add_flag("--allow-network", options->allow_network,
                   "Permit an --address that other machines can reach");
  command.add_flag("--open", options->open, "Open the page in the browser");
  command.footer(
      "The server only reads files, only below the folders of the runs, and follows no symbolic links.");
  command.callback([=, &program, &action] { action = [=, &program] { return serve(*options, program); }; });
}

}  // namespace orbs::cli
