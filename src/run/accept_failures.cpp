#include "run/accept_failures.h"

#include "base/error.h"
#include "base/files.h"
#include "results/record_json.h"
#include "run/expected.h"
#include "run/summary.h"

#include <fmt/format.h>

namespace orbs::run {

std::size_t accept_failures(const registry::Configuration& configuration,
                            const std::string& reason,
                            results::RunRecord& run) {
  const auto accepted = accepted_failures(run, reason);
  if (accepted.empty()) return 0;
  // Through a symbolic link, which is to stay one.
  const auto file = std::filesystem::canonical(configuration.file);
  // It may have been edited while the run went on.
  const auto text = read_file(file);
  const auto read =
      with_note(fmt::format("accepting failures; {} is as it was", configuration.file.string()), [&] {
        const auto present = registry::parse_configuration(configuration.file, text);
        const auto changed = registry::with_expected(text, present.expected, accepted);
        auto parsed = registry::parse_configuration(configuration.file, changed);
        write_file(file, changed);
        return parsed;
      });
  mark_expected(read.expected, run);
  summarise(run);
  write_file(std::filesystem::path(run.folder) / "results.json", results::run_json(run));
  return accepted.size();
}

}  // namespace orbs::run
