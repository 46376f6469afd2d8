#include "base/terminal.h"
#include "cli/program.h"
#include "command_line/manual.h"

namespace orbs::cli {

void add_manual_command(const command_line::Command& command, const Program& program, Action& action) {
  command.callback([=, &program, &action] {
    action = [=, &program] {
      print_raw(stdout, command_line::manual_page(command.parent(), "orbs", "benchmark of renderers",
                                                  program.version));
      return 0;
    };
  });
}

}  // namespace orbs::cli
