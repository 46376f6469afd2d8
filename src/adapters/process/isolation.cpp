#include "adapters/process/isolation.h"

#include "adapters/process/process.h"
#include "adapters/process/programs.h"
#include "base/error.h"
#include "base/files.h"
#include "base/files_inside.h"
#include "base/text.h"

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <map>
#include <set>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = "bwrap";

// Programs, libraries and their data, on distributions of all kinds.
const std::vector<fs::path>& system_folders() {
  static const std::vector<fs::path> folders{"/usr",   "/bin",    "/sbin",      "/lib",      "/lib32",
                                             "/lib64", "/libx32", "/nix/store", "/gnu/store"};
  return folders;
}

// Parts of /etc that say where libraries, fonts and drivers are, what time it is and who one is; no keys and
// no passwords. /sys/devices/system holds the processors.
constexpr std::initializer_list<const char*> kSystemFiles{
    "/etc/ld.so.cache", "/etc/ld.so.conf", "/etc/ld.so.conf.d", "/etc/alternatives",  "/etc/fonts",
    "/etc/localtime",   "/etc/passwd",     "/etc/group",        "/etc/nsswitch.conf", "/etc/povray",
    "/etc/OpenCL",      "/etc/vulkan",     "/etc/glvnd",        "/sys/devices/system"};

// A program of root's may write here although it has none of root's capabilities: the kernel asks for the
// number of the user alone, and /proc/sys/kernel/core_pattern names a program that it starts outside. Of
// bubblewrap's own guard nothing is left in a user namespace (0.8.0: access(2) says no, so it looks safe).
constexpr std::initializer_list<const char*> kReadOnlyParts{"/proc/sys", "/proc/sysrq-trigger", "/proc/bus",
                                                            "/proc/fs", "/proc/irq"};

// Graphics processors, and where their drivers look for them.
constexpr std::initializer_list<const char*> kDevices{
    "/dev/dri",        "/dev/kfd",       "/dev/nvidia0",    "/dev/nvidia1",          "/dev/nvidia2",
    "/dev/nvidia3",    "/dev/nvidiactl", "/dev/nvidia-uvm", "/dev/nvidia-uvm-tools", "/dev/nvidia-modeset",
    "/dev/nvidia-caps"};
constexpr std::initializer_list<const char*> kDevicePlaces{"/sys/class", "/sys/dev", "/sys/devices",
                                                           "/sys/bus", "/sys/module"};

bool is_in_one_of(const fs::path& path, const std::vector<fs::path>& folders) {
  return std::any_of(folders.begin(), folders.end(),
                     [&](const auto& folder) { return lies_in(path, folder); });
}

fs::path bubblewrap() {
  const auto program = find_program(kProgram);
  if (!program)
    throw InputError(
        "renders cannot be isolated: there is no program 'bwrap'; install bubblewrap, or run without --sandbox");
  return *program;
}

using Words = std::vector<std::string>;

void add(Words& out, std::initializer_list<std::string_view> words) {
  out.insert(out.end(), words.begin(), words.end());
}

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

void add_system(Words& out) {
  for (const auto& folder : system_folders()) {
    std::error_code ignored;
    if (fs::is_symlink(folder, ignored))
      add(out, {"--symlink", fs::read_symlink(folder, ignored).string(), folder.string()});
    else if (is_there(folder))
      add(out, {"--ro-bind", folder.string(), folder.string()});
  }
  for (const char* file : kSystemFiles) add(out, {"--ro-bind-try", file, file});
  add(out, {"--proc", "/proc"});
  for (const char* part : kReadOnlyParts) add(out, {"--ro-bind-try", part, part});
}

// A folder in memory, which holds at most what the limit of memory allows.
void add_memory(Words& out, const fs::path& folder, const Isolation& isolation) {
  if (isolation.memory_bytes) add(out, {"--size", std::to_string(*isolation.memory_bytes)});
  add(out, {"--tmpfs", folder.string()});
}

void add_devices(Words& out, const Isolation& isolation) {
  add(out, {"--dev", "/dev"});
  bool has_devices = false;
  for (const char* file : kDevices) {
    if (!is_there(file)) continue;
    has_devices = true;
    add(out, {"--dev-bind", file, file});
  }
  for (const char* folder : kDevicePlaces)
    if (has_devices) add(out, {"--ro-bind-try", folder, folder});
  add_memory(out, "/dev/shm", isolation);
  add(out, {"--remount-ro", "/dev"});
}

// What the environment calls the home folder, unless programs of the system lie there.
void add_home(Words& out, const Isolation& isolation) {
  const char* text = std::getenv("HOME");
  if (text == nullptr || *text != '/') return;
  const auto home = fs::path(text).lexically_normal();
  auto taken = system_folders();
  taken.insert(taken.end(), {"/proc", "/dev", "/sys", "/etc"});
  if (home.has_relative_path() && home != "/tmp" && !is_in_one_of(home, taken))
    add_memory(out, home, isolation);
}

// The places of a command line in the making: what is seen through `shown`, but for what lies in `hidden`.
struct Places {
  Words& out;
  std::vector<fs::path> shown = system_folders();
  std::vector<fs::path> hidden{};

  bool sees(const fs::path& path) const { return is_in_one_of(path, shown) && !is_in_one_of(path, hidden); }
};

void show(Places& places, const char* option, const fs::path& real, const fs::path& place) {
  add(places.out, {option, real.string(), place.string()});
  places.shown.push_back(place);
}

// Shows the paths where their symbolic links lead, and where they are named: unless that lies in a folder
// that is shown, whose links then lead to the same.
void show_all(Places& places, const std::vector<fs::path>& paths) {
  std::set<fs::path> real;  // sorted: folders before what lies in them
  std::map<fs::path, fs::path> named;
  for (const auto& path : paths) {
    std::error_code failed;
    const auto target = fs::canonical(path, failed);
    if (failed) continue;
    real.insert(target);
    named.emplace(fs::absolute(path).lexically_normal(), target);
  }
  for (const auto& path : real)
    if (!places.sees(path)) show(places, "--ro-bind", path, path);
  for (const auto& [place, path] : named)
    if (!is_in_one_of(place, places.shown)) show(places, "--ro-bind", path, place);
}

// Nothing of what is not seen anyway.
void hide_all(Places& places, const std::vector<fs::path>& paths) {
  for (const auto& path : paths) {
    std::error_code failed;
    const auto real = fs::canonical(path, failed);
    if (failed || !places.sees(real)) continue;
    if (fs::is_directory(real, failed))
      add(places.out, {"--tmpfs", real.string()});
    else
      add(places.out, {"--ro-bind", "/dev/null", real.string()});
    places.hidden.push_back(real);
  }
}

// In a user namespace of its own a program could mount folders in memory that no limit counts, and reach more
// of the kernel. Of bubblewrap before 0.8.0, and of one with root's rights, there is no way to forbid them.
bool can_forbid_namespaces() {
  static const bool can = [] {
    constexpr double kEnough_seconds = 10;
    ProcessRequest request;
    request.argv = {bubblewrap().string(),
                    "--unshare-user",
                    "--disable-userns",
                    "--ro-bind",
                    "/",
                    "/",
                    "--proc",
                    "/proc",
                    "/bin/true"};
    request.environment = child_environment({});
    request.limits.wall_seconds = kEnough_seconds;
    const auto result = run_process(request);
    return result.start_error.empty() && result.exit_code == 0 && result.signal == 0;
  }();
  return can;
}

}  // namespace

bool is_of_system(const fs::path& path) {
  return is_in_one_of(path, system_folders()) && !is_in_one_of(path, {"/usr/local", "/usr/src"});
}

// The order counts: what comes later is mounted over what came before.
std::vector<std::string> isolated(const std::vector<std::string>& argv, const Isolation& isolation) {
  Words out{bubblewrap().string(), "--die-with-parent", "--unshare-pid", "--unshare-ipc",
            "--unshare-uts",       "--unshare-net",     "--cap-drop",    "ALL"};
  if (can_forbid_namespaces())
    add(out, {"--unshare-user", "--disable-userns"});
  else
    add(out, {"--unshare-user-try"});
  add_system(out);
  add_devices(out, isolation);
  add_memory(out, "/tmp", isolation);
  add_home(out, isolation);
  Places places{out};
  show_all(places, isolation.readable);
  hide_all(places, isolation.hidden);
  show_all(places, isolation.inputs);
  const auto named = fs::absolute(isolation.folder).lexically_normal();
  const auto folder = fs::weakly_canonical(named);
  show(places, "--bind", folder, folder);
  if (!is_in_one_of(named, places.shown)) show(places, "--bind", folder, named);
  for (const auto& hidden : places.hidden)
    if (std::error_code ignored; fs::is_directory(hidden, ignored))
      add(out, {"--remount-ro", hidden.string()});
  add(out, {"--remount-ro", "/", "--chdir", named.string(), "--setenv", "TMPDIR", "/tmp", "--"});
  out.insert(out.end(), argv.begin(), argv.end());
  return out;
}

std::string why_not_isolated() {
  try {
    constexpr double kEnough_seconds = 10;
    const ScratchFolder folder("orbs-sandbox");
    ProcessRequest request;
    request.argv = isolated({"/bin/true"}, {folder.path(), {}, {}, {}, {}});
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
