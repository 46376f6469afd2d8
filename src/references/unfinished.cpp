#include "references/unfinished.h"

#include "base/error.h"
#include "base/files.h"
#include "image/image_io.h"
#include "judge/provenance.h"
#include "run/plan/load_scenes.h"
#include "scene/load/load_scene.h"

#include <fmt/format.h>

namespace orbs::references {

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
