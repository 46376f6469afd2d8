#include "adapters/process/isolation.h"

#include "adapters/process/process.h"
#include "adapters/process/programs.h"
#include "base/error.h"
#include "base/text.h"

#include <system_error>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

constexpr const char* kProgram = "bwrap";

std::filesystem::path bubblewrap() {
  const auto program = find_program(kProgram);
  if (!program)
    throw InputError(
        "renders cannot be isolated: there is no program 'bwrap'; install bubblewrap, or run without --sandbox");
  return *program;
}

}  // namespace

// The order counts: what comes later is mounted over what came before.
std::vector<std::string> isolated(const std::vector<std::string>& argv, const Isolation& isolation) {
  std::vector<std::string> out{bubblewrap().string(),
                               "--die-with-parent",
                               "--unshare-net",
                               "--ro-bind",
                               "/",
                               "/",
                               "--dev-bind",
                               "/dev",
                               "/dev",
                               "--tmpfs",
                               "/tmp"};
  const auto add = [&](const char* option, const std::filesystem::path& path, bool twice) {
    std::error_code failed;
    const auto real = std::filesystem::canonical(path, failed);
    if (failed) return;
    out.insert(out.end(), {option, real.string()});
    if (twice) out.push_back(real.string());
  };
  for (const auto& path : isolation.readable)
    if (std::filesystem::weakly_canonical(path).string().starts_with("/tmp/")) add("--ro-bind", path, true);
  for (const auto& path : isolation.hidden) add("--tmpfs", path, false);
  add("--bind", isolation.folder, true);
  const auto folder = std::filesystem::weakly_canonical(isolation.folder);
  out.insert(out.end(), {"--chdir", folder.string(), "--"});
  out.insert(out.end(), argv.begin(), argv.end());
  return out;
}

std::string why_not_isolated() {
  try {
    constexpr double kEnough_seconds = 10;
    ProcessRequest request;
    request.argv = isolated({"/bin/true"}, {std::filesystem::temp_directory_path(), {}, {}});
    request.environment = child_environment({});
    request.limits.wall_seconds = kEnough_seconds;
    const auto result = run_process(request);
    if (result.exit_code == 0 && result.signal == 0) return "";
    return fmt::format("renders cannot be isolated: bwrap says: {}", trim(result.output));
  } catch (const InputError& e) {
    return e.what();
  }
}

}  // namespace orbs::adapters
