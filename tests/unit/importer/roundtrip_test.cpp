// A scene that our exporter writes comes back as what it was.
#include "adapters/export.h"
#include "adapters/gltf/gltf.h"
#include "registry/features.h"
#include "scene/load/load_scene.h"
#include "tracer/render.h"
#include "tracer/world/build_world.h"
#include "unit/importer/made_gltf.h"

#include <cmath>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
namespace fs = std::filesystem;

scene::Scene prepared(const std::string& name) {
  registry::Renderer renderer;
  renderer.name = "reader";
  renderer.format.name = "gltf";
  renderer.support.declares = registry::parse_features("G5/M8-(7)/L3/A4/B7-(1-6)/C2/D3-(2)/N6-(2,3)");
  const auto scene = scene::load_scene(fs::path(ORBS_SOURCE_DIR) / "data/cases" / (name + ".json"));
  auto ready = adapters::prepare_scene(renderer, scene);
  if (const auto* reason = std::get_if<std::string>(&ready)) ADD_FAILURE() << name << ": " << *reason;
  return std::get<scene::Scene>(ready);
}

constexpr int kSide = 32;
constexpr int kTile = 8;

image::Image rendered(scene::Scene scene) {
  scene.camera.width_px = scene.camera.height_px = kSide;
  const std::atomic<bool> never{false};
  return tracer::render(tracer::make_world(scene), {.samples_per_pixel = 256}, never,
                        [](const tracer::Progress&) {})
      .image;
}

// Equal within five standard errors, and what floats round in the places of vertices: 192 tiles of each scene
// are compared.
void expect_same_tile(const image::Image& a, const image::Image& b, int x0, int y0, std::size_t channel) {
  double difference = 0;
  double variance = 0;
  double sum = 0;
  for (int y = y0; y < y0 + kTile; ++y)
    for (int x = x0; x < x0 + kTile; ++x) {
      difference += double{a.at(x, y, channel)} - b.at(x, y, channel);
      sum += a.at(x, y, channel);
      variance += double{a.at(x, y, channel + 3)} + b.at(x, y, channel + 3);
    }
  EXPECT_LE(std::abs(difference), 5 * std::sqrt(variance) + 1e-4 * sum) << x0 << " " << y0 << " " << channel;
}

class Roundtrip : public testing::TestWithParam<const char*> {};

// What differs is what a light is: a mesh that shines.
TEST_P(Roundtrip, GivesTheSameImage) {
  const auto scene = prepared(GetParam());
  const ScratchFolder scratch("orbs-roundtrip");
  adapters::write_gltf(scene, scratch.path() / "scene.glb");
  make_folder(scratch.path() / "made");
  importer::Report report;
  const auto back =
      importer::import_scene(scratch.path() / "scene.glb", scratch.path() / "made", "back", {}, report);
  for (const auto& remark : report.remarks()) ADD_FAILURE() << text_of(remark);
  EXPECT_TRUE(report.choices().empty());
  EXPECT_EQ(back.trace_depth, scene.trace_depth);
  EXPECT_EQ(back.camera.width_px, scene.camera.width_px);
  const auto was = rendered(scene);
  const auto is = rendered(back);
  for (int y = 0; y < kSide; y += kTile)
    for (int x = 0; x < kSide; x += kTile)
      for (std::size_t c = 0; c < 3; ++c) expect_same_tile(was, is, x, y, c);
}

INSTANTIATE_TEST_SUITE_P(Scenes,
                         Roundtrip,
                         testing::Values("orbs/g5_inst_remaplist/078-remap",
                                         "orbs/m3_mirror/102",
                                         "orbs/m5_texture_matrices/110",
                                         "orbs/m6_emission_texture/124",
                                         "orbs/m8_smooth_glass/113",
                                         "everyday/b7_metallic_roughness/gltf-mix-ball",
                                         "everyday/b7_metallic_roughness_room/gltf-room",
                                         "everyday/c2_orthographic/c2-squares",
                                         "everyday/d1_point/d1-shadow",
                                         "everyday/d3_directional/d3-with-point",
                                         "everyday/n1_normal_map/n1-above",
                                         "everyday/n1_normal_map/n1-below",
                                         "everyday/n4_wrap/n4-turned",
                                         "everyday/n5_filter/n5-nearest",
                                         "everyday/n6_second_coordinates/n6-glow",
                                         "everyday/n6_second_coordinates/n6-normals",
                                         "everyday/n6_second_coordinates/n6-second"));

}  // namespace
