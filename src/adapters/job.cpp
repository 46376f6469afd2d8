#include "adapters/job.h"

#include "adapters/export.h"
#include "adapters/transports.h"
#include "base/error.h"
#include "base/files.h"
#include "scene/effects/switches.h"

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

// All images but the last are rendered in vain: more of them are hardly meant.
void check_image_count(const registry::Renderer& renderer, std::int64_t images) {
  constexpr int kMost = 100;
  if (images > kMost)
    throw InputError(fmt::format(
        "{}: seed {} is the last of as many images that its command renders (image_sequence), and at most {} "
        "can be asked for: choose a smaller seed",
        entry_name(renderer), images, kMost));
}

// The words of the sequence in the place of {images}, once for each image.
std::vector<std::string> with_images(const registry::Renderer& renderer, std::int64_t images) {
  auto words = renderer.command.words;
  const auto& of_image = renderer.command.sequence.words;
  if (of_image.empty()) return words;
  check_image_count(renderer, images);
  auto place = std::find(words.begin(), words.end(), "{images}");
  if (place == words.end()) return words;
  place = words.erase(place);
  for (std::int64_t i = 0; i < images; ++i)
    place = words.insert(place, of_image.begin(), of_image.end()) + std::ssize(of_image);
  return words;
}

// Where the last of so many images is.
std::filesystem::path last_image(const registry::Renderer& renderer,
                                 const std::filesystem::path& output,
                                 std::int64_t images) {
  const auto& sequence = renderer.command.sequence;
  if (sequence.words.empty() || images == 1) return output;
  return output.parent_path() / (output.stem().string() + sequence.suffix + output.extension().string());
}

std::vector<std::string> words_of_command(const registry::Renderer& renderer,
                                          const std::vector<std::string>& of_scene,
                                          std::int64_t images) {
  auto words = with_images(renderer, images);
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
  const auto output = folder / settings.image_file;
  job.width_px = scene.camera.width_px;
  job.height_px = scene.camera.height_px;
  job.spp = settings.spp;
  job.seed = strided_seed(renderer, settings.seed);
  job.image = last_image(renderer, output, job.seed);
  job.fails_on = renderer.command.fails_on;
  job.channel_names = renderer.image_names.channels;
  if (settings.scene_file.empty()) job.channels = image_channels(renderer.format.name, scene);
  registry::Placeholders values{{"executable", settings.executable.string()},
                                {"scene", job.scene_file.string()},
                                {"output", output.string()},
                                {"folder", folder.string()},
                                {"spp", std::to_string(settings.spp)},
                                {"seed", std::to_string(job.seed)},
                                {"threads", std::to_string(settings.threads)},
                                {"width", std::to_string(job.width_px)},
                                {"height", std::to_string(job.height_px)},
                                {"trace_depth", std::to_string(scene.trace_depth)},
                                {"transport", transport_word(renderer, scene)},
                                {"effects", scene::switch_words(scene)},
                                {"bounces", std::to_string(scene::bounces_that_matter(scene))},
                                {"root", settings.root.string()},
                                {"build", settings.build.string()}};
  // Those of all formats, because a renderer with hand-written scenes names no exporter.
  for (const auto& exporter : exporters())
    if (exporter.placeholders != nullptr)
      values.merge(exporter.placeholders(scene, renderer.format.settings, settings.spp));
  job.argv = filled_words(words_of_command(renderer, settings.arguments, job.seed),
                          plugin_files(renderer, settings.root, settings.build), std::move(values));
  return job;
}

}  // namespace orbs::adapters
