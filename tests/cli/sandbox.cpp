#include "cli/sandbox.h"

#include "adapters/process.h"
#include "adapters/programs.h"
#include "base/files.h"
#include "image/image_io.h"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace orbs::cli_tests {

namespace {

// What each mode of the fake renderer is allowed beyond the entry's own time limit.
const std::vector<std::pair<std::string, std::string>> kModes{
    {"good", ""},
    {"dark", ""},
    {"segfault", ""},
    {"abort", ""},
    {"exit3", ""},
    {"exit3-after-picture", ""},
    {"hang", R"("wall_seconds": 0.3)"},
    {"ignore-term", R"("wall_seconds": 0.3, "grace_seconds": 0.1)"},
    {"hang-with-child", R"("wall_seconds": 0.3, "grace_seconds": 0.1)"},
    {"leave-child", ""},
    {"leak", R"("memory_megabytes": 200)"},
    {"burn", R"("cpu_seconds": 0.3)"},
    {"fill-file", R"("output_megabytes": 4)"},
    {"fill-files", R"("output_megabytes": 4)"},
    {"nothing", ""},
    {"garbage", ""},
    {"empty", ""},
    {"half", ""},
    {"elsewhere", ""},
    {"old", ""},
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
      mode, limits, mode == "dark" ? "0.2" : "0.5",
      mode == "good" ? R"( "version_command": ["{executable}", "--version"],)" : "");
}

std::string scene_text(const std::string& material) {
  return R"({"format": "orbs-scene/1", "name": "s", "camera": {"position": [0,4,1], "look_at": [0,0,0], "width": 12, "height": 8},
 "materials": [{"name": "m", "type": ")" +
         material + R"(", "reflectance": [0.5,0.5,0.5]}],
 "meshes": [{"name": "p", "generator": "plane", "half_size": 1, "material": "m"}], "instances": [{"mesh": "p"}], "lights": [], "environment": [1,1,1]})";
}

std::string case_text(const std::string& requirement, const std::string& title, const std::string& scenes) {
  return fmt::format(
      R"({{"format": "orbs-case/1", "requirement": "{}", "title": "{}", "tests": "t", "typical_mistake": "m", {}}})",
      requirement, title, scenes);
}

}  // namespace

std::string configuration_with(const std::string& defaults) {
  std::vector<std::string> renderers;
  for (const auto& [mode, limits] : kModes) renderers.push_back(renderer_entry(mode, limits));
  renderers.emplace_back(
      R"({"name": "absent", "executable": "/nowhere/at/all", "declares": "G1", "command": ["{executable}", "{scene}", "{output}"]})");
  return fmt::format(
      R"({{"format": "orbs-configuration/1", "defaults": {{"suite": "t"{}{}}}, "limits": {{"wall_seconds": 60}},
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

Answer answer_of(adapters::ProcessRequest request) {
  request.environment = adapters::child_environment({"ASAN_OPTIONS", "UBSAN_OPTIONS"});
  const auto result = adapters::run_process(request);
  if (!result.start_error.empty()) return {-1, result.start_error};
  return {result.signal == 0 ? result.exit_code : -result.signal, result.output};
}

std::vector<std::string> orbs_with(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{ORBS_BINARY_DIR "/orbs"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

}  // namespace

Answer Sandbox::orbs(const std::vector<std::string>& arguments) const {
  adapters::ProcessRequest request;
  request.argv = orbs_with(arguments);
  request.folder = folder_;
  return answer_of(std::move(request));
}

Answer Sandbox::orbs_with_small_files(const std::vector<std::string>& arguments,
                                      std::size_t most_bytes) const {
  adapters::ProcessRequest request;
  request.argv = {"/usr/bin/prlimit", fmt::format("--fsize={}", most_bytes)};
  for (const auto& word : orbs_with(arguments)) request.argv.push_back(word);
  request.folder = folder_;
  return answer_of(std::move(request));
}

Answer Sandbox::shell(const std::string& line) const {
  adapters::ProcessRequest request;
  request.argv = {"/bin/sh", "-c", line};
  request.folder = folder_;
  return answer_of(std::move(request));
}

}  // namespace orbs::cli_tests
