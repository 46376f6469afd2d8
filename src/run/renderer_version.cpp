#include "run/renderer_version.h"

#include "adapters/process/isolation.h"
#include "adapters/process/process.h"
#include "adapters/process/programs.h"
#include "base/files.h"
#include "base/pattern.h"
#include "base/text.h"
#include "registry/placeholders.h"
#include "run/isolate.h"

#include <fmt/format.h>

namespace orbs::run {

namespace {

std::string how_it_ended(const adapters::ProcessResult& process) {
  if (!process.start_error.empty()) return fmt::format("cannot be started: {}", process.start_error);
  return fmt::format("ended with exit code {}", process.exit_code);
}

std::string how_it_was_cut_off(const adapters::ProcessResult& process, const VersionRequest& request) {
  if (process.cause == supervisor::Cause::WallTime)
    return fmt::format("did not end within {} s", request.second_seconds);
  return process.signal != 0 ? fmt::format("was killed by {}", adapters::signal_name(process.signal))
                             : "was ended before it answered";
}

// "" where the line says no version.
std::string version_in(const std::string& line, const std::string& pattern) {
  if (pattern.empty()) return line;
  const auto groups = Pattern(pattern).last_match(line);
  return groups.empty() ? "" : groups.front();
}

adapters::ProcessResult answer_of(adapters::ProcessRequest command,
                                  const std::string& renderer,
                                  const std::string& program,
                                  const VersionRequest& request) {
  command.limits.wall_seconds = request.first_seconds;
  auto process = adapters::run_process(command);
  if (process.cause != supervisor::Cause::WallTime) return process;
  if (request.say)
    request.say(fmt::format("{}: '{}' did not say its version within {} s; waiting for up to {} s", renderer,
                            program, request.first_seconds, request.second_seconds));
  command.limits.wall_seconds = request.second_seconds;
  return adapters::run_process(command);
}

}  // namespace

std::string renderer_version(const ChosenRenderer& renderer,
                             const Plan& plan,
                             const VersionRequest& request) {
  if (renderer.entry.command.version_command.empty()) return "";
  adapters::ProcessRequest command;
  command.argv = registry::fill_placeholders(renderer.entry.command.version_command,
                                             {{"executable", renderer.executable.string()},
                                              {"root", plan.root.string()},
                                              {"build", plan.build.string()}});
  const auto program = adapters::find_program(command.argv[0]);
  if (!program) return fmt::format("unknown: there is no program '{}'", command.argv[0]);
  command.argv[0] = program->string();
  command.environment = adapters::child_environment(renderer.entry.command.environment);
  // Its own folder, as in a render: what it writes there is no part of anything.
  const ScratchFolder scratch("orbs-version");
  if (plan.settings.sandbox) {
    command.argv =
        adapters::isolated(command.argv, isolation_of_version(plan, renderer, command.argv, scratch.path()));
    command.folder = scratch.path();
    command.has_own_keyring = true;
  }
  const auto process = answer_of(command, renderer.entry.name, program->string(), request);
  if (process.cause != supervisor::Cause::Nothing || process.signal != 0) {
    if (request.say)
      request.say(fmt::format("{}: its version is not known: '{}' {}", renderer.entry.name, program->string(),
                              how_it_was_cut_off(process, request)));
    return "";
  }
  // Some programs have no such command and say their version in a complaint: then the pattern recognises it.
  const auto& pattern = renderer.entry.command.version_pattern;
  const bool has_failed = process.exit_code != 0 || !process.start_error.empty();
  for (const auto& line : split(has_failed && pattern.empty() ? "" : process.output, '\n'))
    if (const auto version = version_in(std::string(trim(line)), pattern); !version.empty())
      return clean_text(version);
  if (has_failed) return fmt::format("unknown: '{}' {}", program->string(), how_it_ended(process));
  return pattern.empty()
             ? "unknown: its version command prints nothing"
             : fmt::format("unknown: its version command prints no line that matches '{}'", pattern);
}

bool is_other_version(const std::string& one, const std::string& other) {
  const auto is_known = [](const std::string& version) {
    return !version.empty() && !version.starts_with("unknown: ");
  };
  return is_known(one) && is_known(other) && one != other;
}

}  // namespace orbs::run
