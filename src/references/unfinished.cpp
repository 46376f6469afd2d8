#include "references/unfinished.h"

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "image/image_io.h"
#include "image/layers.h"
#include "judge/provenance.h"
#include "run/plan/scenes.h"
#include "scene/load/load_scene.h"

#include <algorithm>

#include <fmt/format.h>

namespace orbs::references {

void add_pass(PassSum& sum, const image::Image& image, const Pass& pass) {
  if (sum.passes.empty()) {
    sum.width = image.width;
    sum.height = image.height;
    sum.attributes = image.attributes;
  } else if (image.width != sum.width || image.height != sum.height) {
    throw InputError(fmt::format("a pass of {} x {} px cannot be added to one of {} x {} px", image.width,
                                 image.height, sum.width, sum.height));
  }
  const std::size_t count = image.channel_count();
  for (std::size_t c = 0; c < count; ++c) {
    // Layers of surfaces are those of the first pass: numbers of things have no mean.
    const bool is_layer = image::is_layer_channel(image.channels[c]);
    if (is_layer && !sum.passes.empty()) continue;
    auto& values = sum.channels[image.channels[c]];
    values.resize(image.pixel_count());
    const double weight = is_layer                                ? 1
                          : image::is_variance(image.channels[c]) ? static_cast<double>(pass.spp) * pass.spp
                                                                  : pass.spp;
    for (std::size_t pixel = 0; pixel < values.size(); ++pixel)
      values[pixel] += weight * static_cast<double>(image.pixels[pixel * count + c]);
  }
  sum.passes.push_back(pass);
  sum.spp += pass.spp;
  const auto bad = image.attributes.find("orbs.bad_samples");
  if (bad != image.attributes.end()) sum.bad_samples += to_integer(bad->second).value_or(0);
}

image::Image mean_image(const PassSum& sum) {
  std::vector<std::string> names{"R", "G", "B", "variance.R", "variance.G", "variance.B"};
  std::erase_if(names, [&](const auto& name) { return !sum.channels.contains(name); });
  for (const auto& [name, values] : sum.channels)
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  auto image = image::make_image(sum.width, sum.height, names);
  image.attributes = sum.attributes;
  for (std::size_t c = 0; c < names.size(); ++c) {
    const auto& values = sum.channels.at(names[c]);
    const double weight = image::is_layer_channel(names[c]) ? 1
                          : image::is_variance(names[c])    ? static_cast<double>(sum.spp) * sum.spp
                                                            : sum.spp;
    for (std::size_t pixel = 0; pixel < values.size(); ++pixel)
      image.pixels[pixel * names.size() + c] = static_cast<float>(values[pixel] / weight);
  }
  return image;
}

UnfinishedReference unfinished_reference(const std::filesystem::path& target,
                                         const std::filesystem::path& scene,
                                         const std::string& camera,
                                         const std::filesystem::path& tracer,
                                         bool split_paths) {
  UnfinishedReference unfinished;
  unfinished.folder = target.parent_path() / ".unfinished" / target.stem();
  const auto of_scene = run::scene_content_hash(scene::load_scene(scene, {}, camera), scene);
  unfinished.made_from =
      hash_text(content_hash(split_paths ? "layers" : "", content_hash(read_file(tracer), of_scene)));
  make_folder(unfinished.folder.parent_path());
  // Names of scenes never begin with a point.
  const auto lock_file = unfinished.folder.parent_path() / fmt::format(".{}.lock", target.stem().string());
  unfinished.lock = std::make_unique<FileLock>(lock_file, [&](const std::string& process) {
    return fmt::format(
        "{}: another call, of process {}, renders this reference; wait for its end, or stop it",
        target.string(), process);
  });
  // Only now: the call that held the lock before has removed the folder.
  make_folder(unfinished.folder);
  return unfinished;
}

std::filesystem::path file_of(const UnfinishedReference& unfinished, const Pass& pass) {
  return unfinished.folder / fmt::format("{}-{}-{}.exr", unfinished.made_from, pass.seed, pass.spp);
}

std::optional<image::Image> kept_pass(const UnfinishedReference& unfinished, const Pass& pass) {
  const auto file = file_of(unfinished, pass);
  if (!std::filesystem::exists(file)) return std::nullopt;
  try {
    auto image = image::read_image(file);
    if (judge::provenance_of(image)["spp"] != std::to_string(pass.spp)) return std::nullopt;
    return image;
  } catch (const InputError&) {
    return std::nullopt;  // torn
  }
}

void remove_passes(UnfinishedReference unfinished) {
  std::error_code ignored;
  std::filesystem::remove_all(unfinished.folder, ignored);
  unfinished.lock.reset();
  std::filesystem::remove(unfinished.folder.parent_path(), ignored);  // unless it has those of another
}

}  // namespace orbs::references
