// The built-in tracer follows every relation, as far as tests have time: each at its first and, for sweeps,
// at a hard magnitude.
#include "studies/effects/paired_difference.h"
#include "studies/stability/images.h"
#include "tracer/render.h"
#include "tracer/world/build_world.h"
#include "unit/scene/related_scenes.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using namespace orbs;

using Fault = std::optional<scene::RenderFault>;

std::vector<image::Image> images_of(const scene::Scene& scene, Fault fault) {
  const std::atomic<bool> never{false};
  tracer::WorldSettings settings{.fault = fault};
  if (fault == scene::RenderFault::NoMisWeight) {  // as orbs-tracer --fault makes it
    settings.direct_light = tracer::DirectLight::Unweighted;
    settings.light_paths = false;
    settings.mirrored_light = false;
  }
  const auto world = tracer::make_world(fault ? scene::with_fault(scene, *fault) : scene, settings);
  std::vector<image::Image> images;
  for (const std::uint64_t seed : {1, 2})
    images.push_back(image::select_rgb(
        tracer::render(world, {.samples_per_pixel = 16, .seed = seed}, never, [](const tracer::Progress&) {})
            .image,
        ""));
  return images;
}

bool is_off(const studies::RelativeDifference& one, double bound) {
  return one.confidence >= studies::kSure && std::abs(one.value) > bound;
}

// What is wrong with how a tracer with this fault follows the relation; "" if it follows.
std::string breach(const scene::RelatedScenes& scenes, bool is_exact, Fault fault = {}) {
  auto changed = images_of(scenes.changed, fault);
  for (auto& image : changed) image = studies::original_of(image, scenes.image);
  const auto found = studies::paired_difference(images_of(scenes.original, fault), changed);
  if (is_exact && !found.is_equal) return "it must be followed to the bit";
  if (is_off(found.mean, 1e-3)) return fmt::format("the mean is off by {}", found.mean.value);
  if (is_off(found.largest, 2e-2))
    return fmt::format("the block at {}, {} is off by {}", found.x, found.y, found.largest.value);
  return "";
}

// In each of the scenes that the relation changes, and at least in one.
void expect_followed(const scene::Relation& relation, double magnitude) {
  int applied = 0;
  for (const auto& scene : {tests::block_on_ground(), tests::terrace(), tests::lamp_above_ground()}) {
    const auto related = relation.apply(scene, magnitude);
    const auto* scenes = std::get_if<scene::RelatedScenes>(&related);
    if (scenes == nullptr) continue;
    EXPECT_EQ(breach(*scenes, relation.is_exact), "")
        << relation.name << " " << magnitude << " in " << scene.name;
    ++applied;
  }
  EXPECT_GE(applied, 1) << relation.name << " " << magnitude;
}

scene::Relation relation_named(std::string_view name) {
  const auto& all = scene::relations();
  return *std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
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

// A relation that no fault breaks says nothing.
TEST(Relations, AreBrokenByFaultsOfRenderers) {
  struct Breaking {
    scene::RenderFault fault;
    std::string_view relation;
    scene::Scene scene;
    double magnitude = 1;
  };
  using enum scene::RenderFault;
  for (const auto& [fault, name, scene, magnitude] :
       {Breaking{OpacityInverted, "clear_box", tests::terrace()},
        {SpotFullAngles, "points_as_spots", tests::terrace()},
        {EnvironmentQuarterTurn, "rotate", tests::terrace()},
        {FramesWithoutSign, "mirror", tests::terrace()},
        {FramesWithSignOfMesh, "mirror", tests::terrace()},
        {EnvironmentMirrored, "rotate", tests::terrace()},
        // So large that enough paths find it to be counted twice.
        {NoMisWeight, "points_as_spheres", tests::lamp_above_ground(), 0.5}}) {
    const auto relation = relation_named(name);
    const auto related = relation.apply(scene, magnitude);
    ASSERT_TRUE(std::holds_alternative<scene::RelatedScenes>(related)) << std::get<1>(related);
    const auto& scenes = std::get<scene::RelatedScenes>(related);
    EXPECT_EQ(breach(scenes, relation.is_exact), "") << name;
    EXPECT_NE(breach(scenes, relation.is_exact, fault), "") << name << " " << scene::name_of(fault);
  }
}
