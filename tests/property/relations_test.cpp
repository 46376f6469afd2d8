// The built-in tracer follows every relation, as far as tests have time: each at its first and, for sweeps,
// at a hard magnitude.
#include "studies/effects/paired_difference.h"
#include "studies/stability/images.h"
#include "tracer/render.h"
#include "tracer/world/build_world.h"
#include "unit/scene/related_scenes.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;

std::vector<image::Image> images_of(const scene::Scene& scene) {
  const std::atomic<bool> never{false};
  const auto world = tracer::make_world(scene);
  std::vector<image::Image> images;
  for (const std::uint64_t seed : {1, 2})
    images.push_back(image::select_rgb(
        tracer::render(world, {.samples_per_pixel = 16, .seed = seed}, never, [](const tracer::Progress&) {})
            .image,
        ""));
  return images;
}

void expect_followed(const scene::Relation& relation, double magnitude) {
  const auto related = relation.apply(tests::block_on_ground(), magnitude);
  ASSERT_TRUE(std::holds_alternative<scene::RelatedScenes>(related)) << relation.name;
  const auto& scenes = std::get<scene::RelatedScenes>(related);
  auto changed = images_of(scenes.changed);
  for (auto& image : changed) image = studies::original_of(image, scenes.image);
  const auto found = studies::paired_difference(images_of(scenes.original), changed);
  EXPECT_TRUE(found.is_equal || !relation.is_exact) << relation.name << " " << magnitude;
  const auto is_off = [](const studies::RelativeDifference& one, double bound) {
    return one.confidence >= studies::kSure && std::abs(one.value) > bound;
  };
  EXPECT_FALSE(is_off(found.mean, 1e-3)) << relation.name << " " << magnitude << ": " << found.mean.value;
  EXPECT_FALSE(is_off(found.largest, 2e-2)) << relation.name << " " << magnitude << ": "
                                            << found.largest.value << " at " << found.x << ", " << found.y;
}

double hard_magnitude(const scene::Relation& relation) {
  if (relation.name == "translate_matrix") return 1e9;
  if (relation.name == "translate_vertices") return 1e7;
  if (relation.name == "scale_up") return 1e8;
  if (relation.name == "scale_down") return 1e-8;
  return relation.magnitudes.front();
}

}  // namespace

TEST(Relations, AreFollowedByTheTracer) {
  for (const auto& relation : scene::relations()) expect_followed(relation, relation.magnitudes.front());
}

TEST(Relations, AreFollowedByTheTracerOverManyDecades) {
  for (const auto& relation : scene::relations())
    if (hard_magnitude(relation) != relation.magnitudes.front())
      expect_followed(relation, hard_magnitude(relation));
}
