#include "adapters/supervisor_command.h"

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

std::filesystem::path find_supervisor() {
  namespace fs = std::filesystem;
  std::error_code failed;
  const auto beside = fs::read_symlink("/proc/self/exe", failed).parent_path() / "orbs-supervisor";
  const auto test_folders_above = {beside.parent_path().parent_path(),
                                   beside.parent_path().parent_path().parent_path()};
  if (fs::exists(beside, failed)) return beside;
  for (const auto& folder : test_folders_above)
    if (fs::exists(folder / "orbs-supervisor", failed)) return folder / "orbs-supervisor";
  return beside;  // starting it will fail and name it
}

}  // namespace

std::vector<std::string> supervisor_command(const ProcessRequest& request) {
  static const auto supervisor = find_supervisor();
  const auto& limits = request.limits;
  std::vector<std::string> words{supervisor.string()};
  const auto add = [&](const char* option, const std::string& value) {
    words.insert(words.end(), {option, value});
  };
  if (!request.folder.empty()) add("--folder", request.folder.string());
  add("--wall-seconds", fmt::format("{}", limits.wall_seconds));
  if (limits.cpu_seconds) add("--cpu-seconds", fmt::format("{}", *limits.cpu_seconds));
  if (limits.memory_bytes) add("--memory-bytes", fmt::format("{}", *limits.memory_bytes));
  if (limits.output_bytes) add("--output-bytes", fmt::format("{}", *limits.output_bytes));
  add("--grace-seconds", fmt::format("{}", limits.grace_seconds));
  words.emplace_back("--");
  words.insert(words.end(), request.argv.begin(), request.argv.end());
  return words;
}

}  // namespace orbs::adapters
