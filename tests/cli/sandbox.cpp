#include "cli/sandbox.h"

#include "base/files.h"
#include "image/image_io.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace orbs::cli_tests {

namespace {

// What each mode of the fake renderer is allowed beyond the entry's own time limit.
const std::vector<std::pair<std::string, std::string>> kModes{
    {"good", ""},
    {"dark", ""},
    {"noisy", ""},
    {"noisy-dark", ""},
    {"noisy-nan", ""},
    {"segfault", ""},
    {"abort", ""},
    {"exit3", ""},
    {"exit3-after-image", ""},
    {"hang", R"("wall_seconds": 0.3)"},
    {"ignore-term", R"("wall_seconds": 0.3, "grace_seconds": 0.1)"},
    {"hang-with-child", R"("wall_seconds": 4, "grace_seconds": 0.1)"},
    {"leave-child", ""},
    {"leak", R"("memory_megabytes": 200)"},
    {"leak-to-memfd", R"("memory_megabytes": 200)"},
    {"shared-pages", R"("memory_megabytes": 280)"},
    {"main-thread-ends", R"("wall_seconds": 0.3, "grace_seconds": 0.1)"},
    {"main-thread-ends-leak", R"("memory_megabytes": 200)"},
    {"main-thread-ends-daemon", ""},
    {"burn", R"("cpu_seconds": 0.3)"},
    {"fill-file", R"("output_megabytes": 4)"},
    {"fill-files", R"("output_megabytes": 4)"},
    {"nothing", ""},
    {"garbage", ""},
    {"empty", ""},
    {"half", ""},
    {"elsewhere", ""},
    {"old", ""},
    {"litter", ""},
    {"noisy-litter", ""},
    {"replace-own-folder", ""},
    {"coloured", ""},
    {"other-scene", ""},
    {"other-job", ""},
    {"much", ""},
    {"wrong-size", ""},
    {"wrong-channels", ""},
    {"nan", ""},
    {"infinite", ""},
    {"negative", ""},
    {"interrupt", ""},
    {"complain", ""},
    {"read-input", ""},
    {"environment", ""}};

std::string renderer_entry(const std::string& mode, const std::string& limits) {
  return fmt::format(
      R"x({{"name": "{0}", "executable": "{{build}}/orbs-fake-renderer",{3}
  "declares": "G5/M8", "limits": {{{1}}}, "render_seconds": {{"pattern": "^fake: render_seconds ([0-9.]+)"}},
  "command": ["{{executable}}", "--mode", "{0}", "--output", "{{output}}", "--scene", "{{scene}}", "--width", "{{width}}", "--height", "{{height}}",
              "--grey", "{2}", "--threads", "{{threads}}", "--spp", "{{spp}}", "--seed", "{{seed}}"]}})x",
      mode, limits, mode.ends_with("dark") ? "0.2" : "0.5",
      mode == "good"              ? R"( "version_command": ["{executable}", "--version"],)"
      : mode.starts_with("noisy") ? R"( "seeds": 4,)"
                                  : "");
}

std::string scene_text(const std::string& material) {
  return R"({"format": "orbs-scene/1", "name": "s", "camera": {"position": [0,4,1], "look_at": [0,0,0], "width": 12, "height": 8},
 "materials": [{"name": "m", "type": ")" +
         material + R"(", "reflectance": [0.5,0.5,0.5]}],
 "meshes": [{"name": "p", "generator": "plane", "half_size": 1, "material": "m"}], "instances": [{"mesh": "p"}], "lights": [], "environment": [1,1,1]})";
}

std::string case_text(const std::string& requirement, const std::string& title, const std::string& scenes) {
  return fmt::format(
      R"({{"format": "orbs-case/2", "requirement": "{}", "title": "{}", "tests": "t", "typical_mistake": "m", {}}})",
      requirement, title, scenes);
}

}  // namespace

std::string configuration_with(const std::string& defaults) {
  std::vector<std::string> renderers;
  for (const auto& [mode, limits] : kModes) renderers.push_back(renderer_entry(mode, limits));
  renderers.emplace_back(
      R"({"name": "absent", "executable": "/nowhere/at/all", "declares": "G1", "command": ["{executable}", "{scene}", "{output}"]})");
  return fmt::format(
      R"({{"format": "orbs-configuration/1", "stands_alone": true, "defaults": {{"suite": "t", "fixed_samples": true, "least_side": 1{}{}}}, "limits": {{"wall_seconds": 60}},
"suites": [{{"name": "t", "cases": "cases", "references": "references"}}],
"renderers": [{}]}})",
      defaults.empty() ? "" : ", ", defaults, fmt::join(renderers, ",\n"));
}

Sandbox::Sandbox() {
  static int count = 0;
  folder_ = fs::temp_directory_path() / fmt::format("orbs-cli-{}-{}", ::getpid(), count++);
  fs::create_directories(folder_ / "references");
  write("configuration.json", configuration_with(""));
  write("cases/m1_grey/grey.json", scene_text("lambert"));
  write("cases/m3_mirror/mirror.json", scene_text("mirror"));
  write(
      "cases/m1_grey/case.json",
      case_text(
          "M1", "Grey",
          R"("scenes": [{"name": "grey", "file": "grey.json", "spp": 8}, {"name": "v1.5", "file": "grey.json", "spp": 8}])"));
  write(
      "cases/m3_mirror/case.json",
      case_text(
          "M3", "Mirror & co",
          R"("scenes": [{"name": "mirror", "file": "mirror.json", "spp": 8}, {"name": "grey", "file": "../m1_grey/grey.json", "spp": 8}],
  "differences": [{"name": "rest", "of": "mirror", "minus": "grey"}])"));
  auto grey = image::make_image(12, 8, {"R", "G", "B"});
  std::fill(grey.pixels.begin(), grey.pixels.end(), 0.5F);
  for (const char* scene : {"grey", "v1.5", "mirror"})
    image::write_exr(grey, folder_ / "references" / (std::string(scene) + ".exr"));
}

Sandbox::~Sandbox() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void Sandbox::write(const std::string& file, const std::string& text) const {
  fs::create_directories((folder_ / file).parent_path());
  std::ofstream(folder_ / file, std::ios::binary) << text;
}

void Sandbox::add_to_good(const std::string& members) const {
  auto text = read("configuration.json");
  const std::string limits = R"("limits": {})";  // the first entry is that of "good"
  write("configuration.json", text.insert(text.find(limits) + limits.size(), members));
}

std::string Sandbox::read(const std::string& file) const { return read_file(folder_ / file); }

std::vector<std::string> Sandbox::runs() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder_))
    if (const auto name = entry.path().filename().string(); name.starts_with("outputs-"))
      names.push_back(name);
  std::sort(names.begin(), names.end());
  return names;
}

namespace {

std::string all_of(int file) {
  std::string text;
  std::array<char, 4096> part{};
  for (;;) {
    const auto count = ::read(file, part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(part.data(), static_cast<std::size_t>(count));
  }
}

// Not by run_process, which ends what is left of its children, closes their input and passes on little of the
// environment: what is tested here would then be done by the test.
Answer answer_of(std::vector<std::string> words, const fs::path& folder) {
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  std::array<int, 2> output{-1, -1};
  if (::pipe2(output.data(), O_CLOEXEC) != 0) return {-1, std::strerror(errno)};
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, output[1], STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, output[1], STDERR_FILENO);
  ::posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  pid_t child = 0;
  const int error = ::posix_spawn(&child, argv.front(), &actions, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(output[1]);
  Answer answer{-1, error == 0 ? all_of(output[0]) : std::strerror(error)};
  ::close(output[0]);
  int status = 0;
  if (error == 0 && ::waitpid(child, &status, 0) == child)
    answer.status = WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
  return answer;
}

std::vector<std::string> orbs_with(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{ORBS_BINARY_DIR "/orbs"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

}  // namespace

Answer Sandbox::orbs(const std::vector<std::string>& arguments) const {
  return answer_of(orbs_with(arguments), folder_);
}

Answer Sandbox::orbs_with_small_files(const std::vector<std::string>& arguments,
                                      std::size_t most_bytes) const {
  std::vector<std::string> words{"/usr/bin/prlimit", fmt::format("--fsize={}", most_bytes)};
  for (const auto& word : orbs_with(arguments)) words.push_back(word);
  return answer_of(std::move(words), folder_);
}

Answer Sandbox::shell(const std::string& line) const { return answer_of({"/bin/sh", "-c", line}, folder_); }

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

void replace_in(const Sandbox& sandbox,
                const std::string& file,
                const std::string& old,
                const std::string& with) {
  auto text = sandbox.read(file);
  ASSERT_NE(text.find(old), std::string::npos) << file;
  sandbox.write(file, text.replace(text.find(old), old.size(), with));
}

}  // namespace orbs::cli_tests
