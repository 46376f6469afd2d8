#include "cli/show_runs.h"

#include "base/error.h"
#include "base/terminal.h"
#include "cli/interrupt.h"
#include "results/study_kinds.h"
#include "server/serve.h"

#include <algorithm>
#include <array>
#include <functional>

#include <fmt/format.h>
#include <spawn.h>
#include <unistd.h>

namespace orbs::cli {

namespace {

namespace fs = std::filesystem;

// Starts the desktop's browser. Without one the user opens the address that stands on the terminal.
void open_in_browser(const std::string& url) {
  std::string program = "xdg-open";
  std::string address = url;
  std::array<char*, 3> argv{program.data(), address.data(), nullptr};
  pid_t child = 0;
  if (::posix_spawnp(&child, "xdg-open", nullptr, nullptr, argv.data(), environ) == 0) return;
  print_clean(stderr, "there is no xdg-open; open the address in a browser\n");
}

bool holds_run(const fs::path& folder) {
  std::error_code ignored;  // a folder of somebody else, a link that leads to itself
  return fs::exists(folder / "results.json", ignored);
}

// The folders of the working folder that hold a result, the newest first.
std::vector<fs::path> newest_folders(const std::function<bool(const fs::path&)>& holds_result) {
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(fs::current_path()))
    if (holds_result(entry.path())) found.push_back(entry.path());
  // The names hold the date and time after the first hyphen.
  const auto time_of = [](const fs::path& folder) {
    const auto name = folder.filename().string();
    return name.substr(name.find('-'));
  };
  std::sort(found.begin(), found.end(),
            [&](const fs::path& a, const fs::path& b) { return time_of(a) > time_of(b); });
  if (found.empty())
    throw InputError(
        fmt::format("there is no outputs-* folder of a run in {}; name one", fs::current_path().string()));
  return found;
}

}  // namespace

std::vector<fs::path> newest_runs() {
  return newest_folders([](const fs::path& folder) {
    return folder.filename().string().starts_with("outputs-") && holds_run(folder);
  });
}

std::vector<fs::path> newest_runs_and_studies() {
  return newest_folders([](const fs::path& folder) {
    const auto name = folder.filename().string();
    const bool is_named = name.starts_with("outputs-");
    if (is_named && holds_run(folder)) return true;
    const auto* const kind = results::study_kind_in(folder);
    return kind != nullptr && (is_named || name.starts_with(fmt::format("{}-", kind->name)));
  });
}

void show_runs(const std::vector<std::filesystem::path>& runs,
               const Program& program,
               const ShowSettings& settings) {
  if (!server::is_loopback_address(settings.address))
    print_clean(stderr,
                "warning: other machines can reach {}: everybody there can read these runs, and nothing is "
                "encrypted\n",
                settings.address);
  server::ServeSettings served{runs, program.folder / "web", settings.address, settings.port};
  served.editor = settings.editor;
  server::serve(served, catch_interrupts(), [&](const std::string& url) {
    print_clean("the page is at {}  (Ctrl-C ends it)\n", url);
    std::fflush(stdout);
    if (settings.open) open_in_browser(url);
  });
}

}  // namespace orbs::cli
