#include "adapters/native_scene.h"

#include "base/error.h"
#include "base/files.h"
#include "registry/renderer_variants.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace orbs::adapters {

namespace {

namespace fs = std::filesystem;

// Paths relative to the folder of the scene, sorted: a hash must not depend on the order of a directory.
std::vector<fs::path> files_beside(const fs::path& native) {
  const auto folder = native.parent_path();
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const auto type = entry.symlink_status().type();
    if (type == fs::file_type::directory) continue;
    if (type != fs::file_type::regular)
      throw InputError(
          fmt::format("{}: is a link or a special file, but hand-written scenes take their whole folder with "
                      "them; copy what it stands for",
                      entry.path().string()));
    files.push_back(entry.path().lexically_relative(folder));
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

fs::path native_scene_file(const registry::Renderer& renderer,
                           const fs::path& neutral_file,
                           const std::string& scene_name) {
  if (renderer.format.native_scenes.empty()) return {};
  return neutral_file.parent_path() / registry::entry_of(renderer) /
         fmt::format("{}.{}", scene_name, renderer.format.native_scenes);
}

fs::path native_scene(const registry::Renderer& renderer,
                      const fs::path& neutral_file,
                      const std::string& scene_name) {
  auto file = native_scene_file(renderer, neutral_file, scene_name);
  std::error_code ignored;
  return fs::exists(file, ignored) ? file : fs::path{};
}

std::uint64_t native_scene_hash(const fs::path& native) {
  auto hash = content_hash(native.filename().string());
  for (const auto& file : files_beside(native))
    hash = content_hash(read_file(native.parent_path() / file), content_hash(file.string(), hash));
  return hash;
}

void copy_native_scene(const fs::path& native, const fs::path& folder) {
  constexpr std::array<std::string_view, 3> kOurs{"result.exr", "log.txt", "job.json"};
  for (const auto& file : files_beside(native)) {
    if (std::find(kOurs.begin(), kOurs.end(), file.string()) != kOurs.end())
      throw InputError(fmt::format("{}: a render writes a file of that name; rename it",
                                   (native.parent_path() / file).string()));
    make_folder((folder / file).parent_path());
    write_file(folder / file, read_file(native.parent_path() / file));
  }
}

}  // namespace orbs::adapters
