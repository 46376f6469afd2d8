#include "base/files.h"
#include "fuzz/feed.h"
#include "scene/camera_frame.h"
#include "scene/load/load_scene.h"
#include "scene/load/write_scene.h"

namespace orbs::fuzz {

namespace {

// Small enough that a scene at the limit is read in milliseconds.
constexpr scene::SceneBudget kBudget{.triangles = 5000, .instances = 500};

void check_numbers(const scene::Scene& scene) {
  const auto frame = scene::camera_frame(scene.camera);
  require(is_finite(frame.forward) && is_finite(frame.right) && is_finite(frame.up),
          "the camera has a frame");
  for (const auto& instance : scene.instances)
    require(inverse(instance.matrix).has_value(), "an instance can be moved back");
  for (const auto& mesh : scene.meshes)
    for (const int material : mesh.triangle_materials)
      require(material >= 0 && material < static_cast<int>(scene.materials.size()),
              "a triangle's material exists");
}

void check_round_trip(const scene::Scene& scene) {
  static const ScratchFolder folder("orbs-feed-scene");
  const auto file = folder.path() / "scene.json";
  scene::write_scene(scene, file);
  try {
    require(scene::load_scene(file) == scene, "a scene reads back as it was written");
  } catch (const InputError& e) {
    require(false, std::string("a scene that was written can be read: ") + e.what());
  }
}

}  // namespace

std::string feed_scene(std::string_view bytes) {
  scene::Scene scene;
  auto complaint = complaint_of("scene.json", [&] {
    scene = scene::load_scene_text("scene.json", std::string(bytes), ORBS_SOURCE_DIR "/data/common", kBudget);
  });
  if (!complaint.empty()) return complaint;
  check_numbers(scene);
  check_round_trip(scene);
  return "";
}

}  // namespace orbs::fuzz
