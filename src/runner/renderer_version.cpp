#include "runner/renderer_version.h"

#include "adapters/process/process.h"
#include "adapters/process/programs.h"
#include "base/text.h"
#include "registry/placeholders.h"

#include <fmt/format.h>

namespace orbs::runner {

std::string renderer_version(const ChosenRenderer& renderer, const Plan& plan) {
  constexpr double kLimit_seconds = 30;
  if (renderer.entry.version_command.empty()) return "";
  adapters::ProcessRequest request;
  request.argv = registry::fill_placeholders(renderer.entry.version_command,
                                             {{"executable", renderer.executable.string()},
                                              {"root", plan.root.string()},
                                              {"build", plan.build.string()}});
  const auto program = adapters::find_program(request.argv[0]);
  if (!program) return fmt::format("unknown: there is no program '{}'", request.argv[0]);
  request.argv[0] = program->string();
  request.environment = adapters::child_environment(renderer.entry.environment);
  request.limits.wall_seconds = kLimit_seconds;
  const auto process = adapters::run_process(request);
  if (process.cause == supervisor::Cause::WallTime)
    return fmt::format("unknown: '{}' did not end within {} s", request.argv[0], kLimit_seconds);
  for (const auto& line : split(process.output, '\n'))
    if (const auto text = trim(line); !text.empty() && text.starts_with(renderer.entry.version_prefix))
      return clean_text(text);
  return renderer.entry.version_prefix.empty()
             ? "unknown: its version command prints nothing"
             : fmt::format("unknown: its version command prints no line that starts '{}'",
                           renderer.entry.version_prefix);
}

}  // namespace orbs::runner
