#include "base/error.h"
#include "base/terminal.h"
#include "cli/options.h"
#include "cli/page_editor.h"
#include "cli/program.h"
#include "cli/show_runs.h"
#include "registry/configuration_files.h"
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
  bool edit = false;
};

// What the page writes to is read before anything is served: its mistakes are told here.
server::Editor editor_of(const std::string& configuration, const Program& program) {
  const auto read = read_configuration(configuration, program);
  registry::own_text(read.own_file);
  print_clean(stderr,
              "whoever has the whole address below can make failures known in {}; keep it to yourself\n",
              read.own_file.string());
  return page_editor(read);
}

int serve(const ServeOptions& options, const std::string& configuration, const Program& program) {
  if (!server::is_loopback_address(options.address) && options.edit)
    throw InputError(
        fmt::format("{} is not this machine's loopback address, which is the only one that --edit allows",
                    options.address));
  if (!server::is_loopback_address(options.address) && !options.allow_network)
    throw InputError(
        fmt::format("{} is not this machine's loopback address: everybody who reaches it could read the "
                    "run; add --allow-network if that is wanted",
                    options.address));
  std::vector<std::filesystem::path> runs(options.runs.begin(), options.runs.end());
  ShowSettings settings{options.address, options.port, options.open};
  if (runs.empty()) runs = newest_runs_and_studies();
  if (options.edit) settings.editor = editor_of(configuration, program);
  show_runs(runs, program, settings);
  return 0;
}

}  // namespace

void add_serve_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
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
  // The words of a command are no secret: every user of the machine sees those that start the browser.
  command
      .add_flag("--edit", options->edit,
                "Let the page write known failures into the configuration; only the whole address that is "
                "printed can")
      .excludes(command.option("--allow-network"))
      .excludes(command.option("--open"));
  command.footer(
      "The server only reads files, only below the folders of the runs, and follows no symbolic links. With "
      "--edit it also writes to one file, that of the configuration.");
  command.callback([=, &program, &action] {
    action = [=, &program] { return serve(*options, *configuration, program); };
  });
}

}  // namespace orbs::cli
