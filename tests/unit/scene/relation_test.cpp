// Changed scenes are what their relations claim.
#include "scene/relations/relation.h"

#include "base/files.h"
#include "scene/camera_frame.h"
#include "scene/geometry/world_bounds.h"
#include "scene/load/write_scene.h"
#include "scene/relations/geometry.h"
#include "scene/relations/ground.h"
#include "scene/relations/light.h"
#include "scene/relations/motion.h"
#include "scene/relations/surface.h"
#include "unit/scene/related_scenes.h"

#include <filesystem>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

using namespace orbs;
using tests::block_on_ground;

namespace {

Vec3d corner(const scene::Scene& scene, std::size_t instance, std::size_t vertex) {
  const auto& one = scene.instances[instance];
  return transform_point(one.matrix, cast<double>(scene::mesh_of(scene, one).positions[vertex]));
}

double surface_area(const scene::Scene& scene) {
  double area = 0;
  for (const auto& instance : scene.instances) {
    const auto& mesh = scene::mesh_of(scene, instance);
    const auto place = [&](std::uint32_t v) {
      return transform_point(instance.matrix, cast<double>(mesh.positions[v]));
    };
    for (const auto& t : mesh.triangles)
      area += length(cross(place(t[1]) - place(t[0]), place(t[2]) - place(t[0]))) / 2;
  }
  return area;
}

const scene::Scene& scene_in(const std::variant<scene::Scene, std::string>& changed) {
  return std::get<scene::Scene>(changed);
}

}  // namespace

// A renderer gets a file: each changed scene is written, and read again with all checks of the format.
TEST(Relations, MakeScenesThatTheFormatHolds) {
  const ScratchFolder scratch("relations");
  for (const auto& relation : scene::relations()) {
    int written = 0;
    for (const auto& original : {block_on_ground(), tests::terrace(), tests::lamp_above_ground()})
      for (const double magnitude : relation.magnitudes) {
        const auto related = relation.apply(original, magnitude);
        if (std::holds_alternative<std::string>(related)) continue;
        const auto file = scratch.path() / "scene.json";
        scene::write_scene(std::get<0>(related).changed, file);
        EXPECT_NO_THROW(scene::load_scene(file)) << relation.name << " " << magnitude << original.name;
        ++written;
      }
    EXPECT_GE(written, 1) << relation.name;
  }
}

// Of a scene with blends, and of one with solids whose operands have materials of their own.
TEST(Relations, BlendsOfThemselvesStandBehindTheirParts) {
  const ScratchFolder scratch("relations");
  const std::filesystem::path cases = std::filesystem::path(ORBS_SOURCE_DIR) / "data/cases";
  for (const char* name : {"everyday/b6_blend/blend-mirror", "shapes/s4_csg/s4-solids"}) {
    const auto original = scene::load_scene(cases / (std::string(name) + ".json"));
    const auto changed = scene_in(scene::with_blends_of_themselves(original));
    EXPECT_EQ(changed.materials.size(), 2 * original.materials.size());
    scene::write_scene(changed, scratch.path() / "scene.json");
    const auto read = scene::load_scene(scratch.path() / "scene.json");
    const int count = static_cast<int>(original.materials.size());
    for (const auto& instance : original.instances)
      for (const int own : scene::mesh_of(original, instance).triangle_materials)
        EXPECT_TRUE(scene::visible_materials(read).contains(own + count)) << name << " " << own;
    scene::Scene shapes = original;
    shapes.instances.clear();
    for (const int shown : scene::visible_materials(shapes))
      EXPECT_TRUE(scene::visible_materials(read).contains(shown + count)) << name << " " << shown;
  }
}

TEST(Relations, ChangeSomething) {
  const auto original = block_on_ground();
  int applied = 0;
  for (const auto& relation : scene::relations()) {
    const auto related = relation.apply(original, relation.magnitudes.back());
    const auto* scenes = std::get_if<scene::RelatedScenes>(&related);
    if (scenes == nullptr) continue;
    EXPECT_FALSE(scenes->original == scenes->changed) << relation.name;
    ++applied;
  }
  EXPECT_GE(applied, 5);
}

// Powers of two are undone without rounding.
TEST(Relations, AMotionAndItsInverseGiveTheSceneBack) {
  const auto original = block_on_ground();
  for (const auto& motion : {translation({1024, -256, 64}), scaling({0.25, 0.25, 0.25}), scaling({-1, 1, 1})})
    EXPECT_TRUE(scene::moved(scene::moved(original, motion), inverse(motion).value()) == original);
}

TEST(Relations, AScaleLeavesRadianceAndScalesLengths) {
  const auto original = block_on_ground();
  const auto changed = scene::moved(original, scaling({8, 8, 8}));
  EXPECT_EQ(changed.lights[0].radiance, original.lights[0].radiance);
  EXPECT_EQ(changed.camera.position_m, original.camera.position_m * 8);
  EXPECT_EQ(changed.camera.up, original.camera.up);
  EXPECT_EQ(changed.spheres[0].radius_m, 1);
  EXPECT_NEAR(surface_area(changed), 64 * surface_area(original), 1e-9 * surface_area(changed));
}

// The camera's right is a pseudovector: seen from the mirrored camera, left and right are exchanged.
TEST(Relations, AMirroredCameraSeesLeftAndRightExchanged) {
  const auto original = block_on_ground();
  const auto mirrored = scene::moved(original, scaling({-1, 1, 1}));
  const auto place_in_image = [](const scene::Scene& scene, Vec3d p) {
    const auto frame = scene::camera_frame(scene.camera);
    const Vec3d d = p - scene.camera.position_m;
    return Vec2d{dot(d, frame.right) / dot(d, frame.forward), dot(d, frame.up) / dot(d, frame.forward)};
  };
  const Vec3d p{0.25, 0.5, 0.125};
  const auto before = place_in_image(original, p);
  const auto after = place_in_image(mirrored, {-p.x, p.y, p.z});
  EXPECT_NEAR(after.x, -before.x, 1e-12);
  EXPECT_NEAR(after.y, before.y, 1e-12);
}

// The window of a shifted lens lies on the camera's right, and a grain turns counter-clockwise.
TEST(Relations, AMirrorTurnsShiftAndGrainAround) {
  const auto mirrored = scene::moved(tests::terrace(), scaling({-1, 1, 1}));
  EXPECT_EQ(mirrored.camera.shift, (Vec2d{-0.125, -0.0625}));
  EXPECT_EQ(std::get<scene::AnisotropicGgx>(mirrored.materials[2].model).rotation_deg, -30);
  const auto turned = scene::moved(tests::terrace(), rotation_y(30));
  EXPECT_EQ(std::get<scene::AnisotropicGgx>(turned.materials[2].model).rotation_deg, 30);
}

TEST(Relations, MovedVerticesLieWhereTheyShould) {
  const auto near = scene::with_moved_vertices(block_on_ground(), {});
  const Vec3d offset{6e6, 4.8e6, 6.4e6};
  const auto far = scene::with_moved_vertices(block_on_ground(), offset);
  for (std::size_t v = 0; v < near.meshes[0].positions.size(); ++v)
    EXPECT_LT(length(corner(far, 0, v) - corner(near, 0, v) - offset), 1e-6) << v;
}

TEST(Relations, SplitTrianglesHaveTheSameAreaAndNoTJunction) {
  const auto original = block_on_ground();
  const auto changed = scene_in(scene::with_triangles_split(original));
  EXPECT_EQ(changed.meshes[1].triangles.size(), 4 * original.meshes[1].triangles.size());
  EXPECT_EQ(changed.meshes[2].triangles.size(), original.meshes[2].triangles.size()) << "it is an emitter";
  EXPECT_NEAR(surface_area(changed), surface_area(original), 1e-6 * surface_area(original));
  // Each face of the cube has an outline of 8 edges, and each other edge belongs to two triangles.
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const auto& t : changed.meshes[1].triangles)
    for (std::size_t i = 0; i < 3; ++i) ++uses[std::minmax(t[i], t[(i + 1) % 3])];
  const auto outline =
      std::count_if(uses.begin(), uses.end(), [](const auto& use) { return use.second == 1; });
  EXPECT_EQ(outline, 6 * 8);
}

TEST(Relations, SplitEmittersCoverWhatTheyReplace) {
  const auto original = block_on_ground();
  const auto changed = scene_in(scene::with_emitters_split(original));
  ASSERT_EQ(changed.lights.size(), 5);
  const auto bounds = scene::world_bounds(original);
  const auto after = scene::world_bounds(changed);
  EXPECT_EQ(bounds->low, after->low);
  EXPECT_EQ(bounds->high, after->high);
  EXPECT_EQ(std::get<scene::RectShape>(changed.lights[0].shape).half_width_m, 0.25);
  EXPECT_EQ(changed.lights[0].radiance, original.lights[0].radiance);
  EXPECT_EQ(changed.meshes[2].triangles.size(), 8);
}

TEST(Relations, EmissionOfEveryKindIsMultiplied) {
  auto original = block_on_ground();
  original.environment.radiance = {1, 2, 3};
  original.environment.spectrum = scene::SpectrumUse{0, 5};
  const auto changed = scene::with_emission_times(original, 4);
  EXPECT_EQ(changed.environment.radiance, (Vec3d{4, 8, 12}));
  EXPECT_EQ(changed.environment.spectrum->scale, 20);
  EXPECT_EQ(changed.lights[1].radiance, (Vec3d{16, 32, 64}));
  EXPECT_EQ(std::get<scene::Emission>(changed.materials[3].model).radiance, (Vec3d{8, 4, 2}));
  EXPECT_EQ(changed.materials[1], original.materials[1]);
}

TEST(Relations, ChannelsRotateThreeTimesToThemselves) {
  auto scene = block_on_ground();
  for (int i = 0; i < 3; ++i) scene = scene_in(scene::with_rotated_channels(scene));
  EXPECT_TRUE(scene == block_on_ground());
  EXPECT_EQ(scene_in(scene::with_rotated_channels(scene)).lights[0].radiance, (Vec3d{8, 4, 8}));
}

// By three rotations of its channels each colour comes back, so one that is left out is not seen there.
TEST(Relations, BothColoursOfAMixRotate) {
  auto scene = tests::terrace();
  scene.environment.map.reset();
  scene.textures.clear();
  scene.materials[1].detail = {};
  const auto changed = scene_in(scene::with_rotated_channels(scene));
  const auto& mix = std::get<scene::GgxLambert>(changed.materials[4].model);
  EXPECT_EQ(mix.colour, (Vec3d{0.5, 0.25, 0.25}));
  EXPECT_EQ(mix.diffuse, (Vec3d{0.375, 0.5, 0.25}));
}

TEST(Relations, LightsWithoutAreaBecomeTwoOfHalfThePower) {
  const auto changed = scene_in(scene::with_emitters_split(tests::terrace()));
  ASSERT_EQ(changed.lights.size(), 6);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(changed.lights[i].radiance, tests::terrace().lights[i / 2].radiance * 0.5) << i;
}

// The sphere that shines by I / (pi r^2) to all sides sends I to each, whatever its radius is.
TEST(Relations, ASphereInThePlaceOfAPointHasItsFlux) {
  const auto changed = scene_in(scene::with_points_as_spheres(tests::lamp_above_ground(), 1e-3));
  const auto& lamp = changed.lights.at(0);
  const double radius = std::get<scene::SphereShape>(lamp.shape).radius_m;
  EXPECT_NEAR(radius, 1e-3 * length(Vec3d{0.5, 0.5, 0}), 1e-12) << "the camera is nearest";
  EXPECT_NEAR(lamp.radiance.x * std::numbers::pi * radius * radius, 2, 1e-12);
}

TEST(Relations, APointStaysWhereASphereWouldBeSeen) {
  auto scene = tests::lamp_above_ground();
  scene.materials[0].model = scene::Mirror{{1, 1, 1}};
  EXPECT_EQ(std::get<std::string>(scene::with_points_as_spheres(scene, 1e-3)),
            "a sphere in the place of its point could be seen in its surfaces");
  scene = tests::lamp_above_ground();
  scene.lights[0].matrix = translation({0.125, 1, 0});
  EXPECT_EQ(std::get<std::string>(scene::with_points_as_spheres(scene, 1e-3)),
            "a sphere in the place of its point could be seen in the image");
}

// Only what is opaque and flat everywhere hides a sheet and may become as large as one likes.
TEST(Relations, AGroundThatLetsRaysPassIsNone) {
  auto scene = block_on_ground();
  scene.materials[0].detail.opacity = 0.5;
  EXPECT_TRUE(std::holds_alternative<std::string>(scene::with_sheet_below_ground(scene, 1e-3)));
}

TEST(Relations, AGroundGrowsToItsRatio) {
  const auto changed = scene_in(scene::with_large_ground(block_on_ground(), 1000));
  const auto ground = scene::world_bounds(changed, changed.instances[0]);
  auto others = changed;
  others.instances.erase(others.instances.begin());
  EXPECT_NEAR(ground.high.x, 1000 * scene::radius_of(*scene::world_bounds(others)), 1e-6 * ground.high.x);
  EXPECT_EQ(ground.high.y, 0);
  EXPECT_EQ(changed.trace_depth, 1);
}

TEST(Relations, ASceneWithoutAGroundSaysSo) {
  auto scene = block_on_ground();
  scene.instances.erase(scene.instances.begin());
  EXPECT_EQ(std::get<std::string>(scene::with_large_ground(scene, 1000)),
            "no level, opaque instance without texture lies below all else and below the camera");
}

// At 100 radii the sky between the edge and the horizon is half a pixel of 32 high.
TEST(Relations, AGroundBelowAShiningSkyHasAnEdge) {
  auto scene = block_on_ground();
  scene.environment.radiance = {0, 0, 1};
  EXPECT_EQ(std::get<std::string>(scene::with_large_ground(scene, 1000)).substr(0, 22),
            "its environment shines");
}

TEST(Relations, AFarCameraSeesWhatItLooksAtInTheSameSize) {
  const auto near = block_on_ground();
  const auto far = scene_in(scene::with_far_camera(near, 1000));
  const auto height = [](const scene::Scene& scene) {
    return length(scene.camera.look_at_m - scene.camera.position_m) *
           scene::camera_frame(scene.camera).half_height;
  };
  EXPECT_NEAR(height(far), height(near), 1e-9);
  EXPECT_EQ(std::get<std::string>(scene::with_far_camera(near, 1e7)),
            "its pixels would be finer than 1e-06 rad");
}

// Vertices that a file gives in double keep their distances far from zero.
TEST(FarVertices, AreReadInDouble) {
  const auto scene = scene::load_scene_text("far.json", R"({"format": "orbs-scene/1", "name": "far",
    "camera": {"position": [1e7, 0, 5], "look_at": [1e7, 0, 0]},
    "materials": [{"name": "m", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}],
    "meshes": [{"name": "far", "positions": [10000000.1, 0, 0, 10000000.35, 0, 0, 10000000.1, 0.25, 0],
                "normals": [0, 0, 1, 0, 0, 1, 0, 0, 1], "triangles": [0, 1, 2], "material": "m"},
               {"name": "near", "positions": [0.1, 0, 0, 0.35, 0, 0, 0.1, 0.25, 0],
                "normals": [0, 0, 1, 0, 0, 1, 0, 0, 1], "triangles": [0, 1, 2], "material": "m"}],
    "instances": [{"mesh": "far", "matrix": [{"scale": 2}]}, {"mesh": "near"}]})",
                                            "/");
  EXPECT_NEAR(corner(scene, 0, 0).x, 20000000.2, 1e-7);
  EXPECT_NEAR(corner(scene, 0, 1).x - corner(scene, 0, 0).x, 0.5, 1e-7);
  EXPECT_EQ(scene.instances[1].matrix, Mat4{}) << "what lies near zero stays as it is";
  EXPECT_EQ(scene.meshes[1].positions[1].x, 0.35F);
}

TEST(FarVertices, OfAMeshOfPartsAreReadInDouble) {
  const auto scene = scene::load_scene_text("far.json", R"({"format": "orbs-scene/1", "name": "far",
    "camera": {"position": [1e7, 0, 5], "look_at": [1e7, 0, 0]},
    "materials": [{"name": "m", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}],
    "meshes": [{"name": "far", "parts": [{"generator": "plane", "half_size": 0.25, "material": "m",
                                          "matrix": [{"translate": [10000000.1, 0, 0]}]}]}],
    "instances": [{"mesh": "far"}]})",
                                            "/");
  const auto bounds = scene::world_bounds(scene, scene.instances[0]);
  EXPECT_NEAR(bounds.high.x - bounds.low.x, 0.5, 1e-7);
  EXPECT_NEAR(bounds.low.x, 10000000.1 - 0.25, 1e-7);
}
