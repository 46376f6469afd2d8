#include "base/terminal.h"
#include "cli/interrupt.h"
#include "cli/options.h"
#include "cli/program.h"
#include "cli/run/run_options.h"
#include "references/references.h"
#include "references/store.h"
#include "results/image_hashes.h"

#include <cstdio>

#include <fmt/format.h>

namespace orbs::cli {

void add_reference_command(const command_line::Command& command, const Program& program, Action& action) {
  const auto configuration = add_configuration_option(command);
  const auto settings = std::make_shared<references::ReferenceSettings>();
  const auto run = std::make_shared<RunOptions>();
  add_settings(command, *run, kTargetSettings);
  command
      .add_option("--spp", settings->spp, "Samples per pixel (default: until its noise leaves verdicts room)")
      .range(1, references::kMostReferenceSpp);
  command.add_option("--seed", settings->seed, "Seed; it must differ from the seeds of runs")
      .zero_or_more()
      .shows_default();
  command.add_option("--threads", settings->threads, "Threads; 0: all cores").range(0, 1024);
  command.add_option(
      "--accept", settings->reason,
      "Reason for replacing references that exist. It is kept in the provenance record and, together with "
      "the record of the replaced reference, in <scene>.history.json");
  const auto note_hashes = std::make_shared<bool>(false);
  command.add_flag("--note-hashes", *note_hashes,
                   "Render nothing: note the pixel hashes of references that have none in image-hashes.json");
  command.callback([=, &program, &action] {
    action = [=, &program] {
      const auto read = read_configuration(*configuration, program);
      registry::RunSettings selection;
      selection.suite = read.defaults.suite;
      selection = run_settings(command, *run, selection);
      if (*note_hashes) {
        const auto folder = registry::find_suite(read, selection.suite).references;
        print_clean("{}: {} hashes noted\n", (folder / results::kImageHashesFile).string(),
                    references::note_image_hashes(folder));
        return 0;
      }
      const auto& stop = catch_interrupts();
      // A file or a pipe would else get its first line after minutes.
      const auto say = [](const std::string& line) {
        print_clean("{}\n", line);
        std::fflush(stdout);
      };
      return references::render_references(read, selection, *settings,
                                           {program.folder / "orbs-tracer", &stop, say});
    };
  });
}

}  // namespace orbs::cli
