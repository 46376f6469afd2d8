#include "adapters/job.h"

#include "adapters/export.h"
#include "adapters/transports.h"
#include "base/error.h"
#include "base/files.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace orbs::adapters {

int scaled_spp(int spp, double renderer_scale, double run_scale) {
  constexpr int kMost = 1 << 30;
  const double samples = spp * renderer_scale * run_scale;
  if (!(samples <= kMost))
    throw InputError(
        fmt::format("{} spp times the factors {} and {} are {} samples; at most {} can be asked for", spp,
                    renderer_scale, run_scale, samples, kMost));
  return static_cast<int>(std::max(1L, std::lround(samples)));
}

namespace {

std::int64_t strided_seed(const registry::Renderer& renderer, int seed) {
  constexpr std::int64_t kMost = std::numeric_limits<std::uint32_t>::max();
  const auto strided = std::int64_t{seed} * renderer.sampling.seed_stride;
  if (strided > kMost)
    throw InputError(fmt::format(
        "{}: seed {} times its seed_stride {} is {}; at most {} is a seed of most renderers: choose a "
        "smaller seed",
        entry_name(renderer), seed, renderer.sampling.seed_stride, strided, kMost));
  return strided;
}

std::vector<std::string> words_of_command(const registry::Renderer& renderer,
                                          const std::vector<std::string>& of_scene) {
  auto words = renderer.command.words;
  auto place = std::find(words.begin(), words.end(), "{arguments}");
  if (place != words.end()) place = words.erase(place);
  place = words.insert(place, renderer.command.arguments.begin(), renderer.command.arguments.end());
  words.insert(place + static_cast<std::ptrdiff_t>(renderer.command.arguments.size()), of_scene.begin(),
               of_scene.end());
  return words;
}

// A word with {plugin} becomes one word for each plug-in. Their paths may hold braces, which are none.
std::vector<std::string> filled_words(const std::vector<std::string>& words,
                                      const std::vector<std::filesystem::path>& plugins,
                                      registry::Placeholders values) {
  std::vector<std::string> out;
  for (const auto& word : words) {
    if (!registry::uses_placeholder(word, "plugin")) {
      out.push_back(registry::fill_placeholders(word, values));
      continue;
    }
    for (const auto& plugin : plugins) {
      values["plugin"] = plugin.string();
      out.push_back(registry::fill_placeholders(word, values));
    }
  }
  return out;
}

std::vector<std::filesystem::path> resolved(const std::vector<std::string>& names,
                                            const std::filesystem::path& root,
                                            const std::filesystem::path& build) {
  std::vector<std::filesystem::path> paths;
  for (const auto& name : names)
    paths.push_back(resolve_path(
        root, registry::fill_placeholders(name, {{"root", root.string()}, {"build", build.string()}})));
  return paths;
}

}  // namespace

std::vector<std::filesystem::path> plugin_files(const registry::Renderer& renderer,
                                                const std::filesystem::path& root,
                                                const std::filesystem::path& build) {
  return resolved(renderer.command.plugins, root, build);
}

std::vector<std::filesystem::path> readable_places(const registry::Renderer& renderer,
                                                   const std::filesystem::path& root,
                                                   const std::filesystem::path& build) {
  return resolved(renderer.command.readable, root, build);
}

Job make_job(const registry::Renderer& renderer,
             const scene::Scene& scene,
             const JobSettings& settings,
             const std::filesystem::path& folder) {
  Job job;
  job.folder = folder;
  job.scene_file =
      folder / (settings.scene_file.empty() ? scene_file_name(renderer.format.name) : settings.scene_file);
  job.image = folder / settings.image_file;
  job.width_px = scene.camera.width_px;
  job.height_px = scene.camera.height_px;
  job.spp = settings.spp;
  job.seed = strided_seed(renderer, settings.seed);
  if (settings.scene_file.empty()) job.channels = image_channels(renderer.format.name, scene);
  registry::Placeholders values{{"executable", settings.executable.string()},
                                {"scene", job.scene_file.string()},
                                {"output", job.image.string()},
                                {"folder", folder.string()},
                                {"spp", std::to_string(settings.spp)},
                                {"seed", std::to_string(job.seed)},
                                {"threads", std::to_string(settings.threads)},
                                {"width", std::to_string(job.width_px)},
                                {"height", std::to_string(job.height_px)},
                                {"trace_depth", std::to_string(scene.trace_depth)},
                                {"transport", transport_word(renderer, scene)},
                                {"root", settings.root.string()},
                                {"build", settings.build.string()}};
  // Those of all formats, because a renderer with hand-written scenes names no exporter.
  for (const auto& exporter : exporters())
    if (exporter.placeholders != nullptr) values.merge(exporter.placeholders(settings.spp));
  job.argv = filled_words(words_of_command(renderer, settings.arguments),
                          plugin_files(renderer, settings.root, settings.build), std::move(values));
  return job;
}

}  // namespace orbs::adapters
