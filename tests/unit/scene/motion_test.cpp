// Motion within a frame in scene files: read, written, lowered, refused.
#include "scene/motion.h"

#include "adapters/export.h"
#include "adapters/povray/povray.h"
#include "base/error.h"
#include "base/files.h"
#include "run/plan/scenes.h"
#include "scene/effects/effects.h"
#include "scene/effects/features.h"
#include "scene/geometry/world_bounds.h"
#include "scene/load/load_scene.h"
#include "scene/load/write_scene.h"
#include "scene/lower/lower.h"
#include "scene/relations/motion.h"
#include "scene/relations/relation.h"
#include "structure/source_files.h"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;

namespace {

constexpr const char* kSheet =
    R"({{"name": "sheet", "positions": [0, 0, 0, 1, 0, 0, 0, 1, 0], "normals": [0, 0, 1, 0, 0, 1, 0, 0, 1],
        "triangles": [0, 1, 2], "material": "m"{}}})";
constexpr const char* kEnd =
    R"(, "end": {"positions": [0, 0, 2, 3, 0, 0, 0, 1, 0], "normals": [1, 0, 1, 0, 0, 1, 0, 0, 1]})";
constexpr const char* kSlides = R"(, "end_matrix": [{"translate": [4, 0, 0]}])";
constexpr const char* kOpen = R"(, "shutter": [0, 1])";

struct Parts {
  std::string camera = kOpen;
  std::string mesh = "";
  std::string instance = "";
  std::string more = "";
};

scene::Scene read(const Parts& parts, const std::filesystem::path& folder = ".") {
  return scene::load_scene_text(
      "scene.json",
      fmt::format(R"({{"format": "orbs-scene/1", "name": "s",
"camera": {{"position": [0, 0, 9], "look_at": [0, 0, 0]{}}},
"materials": [{{"name": "m", "type": "lambert", "reflectance": [0.5, 0.4, 0.3]}}],
"meshes": [{}],
"instances": [{{"mesh": "sheet", "matrix": [{{"translate": [0, 2, 0]}}]{}}}]{}}})",
                  parts.camera, fmt::format(fmt::runtime(kSheet), parts.mesh), parts.instance, parts.more),
      folder);
}

void expect_refusal(const Parts& parts, const std::string& part, const std::filesystem::path& folder = ".") {
  try {
    read(parts, folder);
    ADD_FAILURE() << "no error where expected: " << part;
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
  }
}

std::string levels_of_motion(const scene::Scene& scene) {
  std::string levels;
  for (const auto& feature : scene::features_called_for(scene))
    if (feature.requirement.front() == 'T') levels += feature.requirement;
  return levels;
}

bool calls_for_motion(const scene::Scene& scene) {
  return scene::calls_for(scene::effects(scene), scene::Effect::Motion);
}

constexpr const char* kCameraSlides =
    R"(, "shutter": [0, 1], "end": {"position": [2, 0, 9], "look_at": [4, 0, 0]})";

scene::Scene both() { return read({.mesh = kEnd, .instance = kSlides}); }

}  // namespace

TEST(SceneMotion, IsReadWithBothEndsOfTheFrame) {
  const auto scene = read({.camera = R"(, "shutter": [0.25, 0.75])", .mesh = kEnd, .instance = kSlides});
  EXPECT_EQ(scene.camera.shutter, (scene::Shutter{0.25, 0.75}));
  EXPECT_EQ(scene.instances[0].matrix, translation({0, 2, 0}));
  EXPECT_EQ(scene.instances[0].end_matrix, translation({4, 0, 0}));
  ASSERT_TRUE(scene.meshes[0].end);
  EXPECT_EQ(scene.meshes[0].end->positions[1], (Vec3f{3, 0, 0}));
  EXPECT_EQ(scene.meshes[0].end->normals[0], (Vec3f{1, 0, 1}));
}

TEST(SceneMotion, IsWhatItWasAfterWritingAndReading) {
  const structure::TestFolder folder("motion");
  for (const auto& scene : {both(), read({.mesh = kEnd}), read({.camera = kCameraSlides}),
                            read({.camera = R"(, "shutter": [0.1, 0.7])", .instance = kSlides}), read({})}) {
    scene::write_scene(scene, folder.path() / "scene.json");
    EXPECT_EQ(scene::load_scene(folder.path() / "scene.json"), scene);
  }
}

TEST(SceneMotion, CallsForItsLevelsAndItsEffect) {
  EXPECT_EQ(levels_of_motion(both()), "T1T2");
  EXPECT_EQ(levels_of_motion(read({.instance = kSlides})), "T1");
  EXPECT_EQ(levels_of_motion(read({.mesh = kEnd})), "T2");
  EXPECT_EQ(levels_of_motion(read({.camera = kCameraSlides})), "T3");
  EXPECT_TRUE(calls_for_motion(read({.mesh = kEnd})));
  EXPECT_TRUE(calls_for_motion(read({.camera = kCameraSlides})));
  EXPECT_EQ(levels_of_motion(read({})), "");
  EXPECT_FALSE(calls_for_motion(read({})));
}

// What cannot be seen is no part of the scene that a renderer gets.
TEST(SceneMotion, ThatLeadsNowhereIsRest) {
  const auto at_rest = read({.camera = ""});
  EXPECT_EQ(read({.instance = R"(, "end_matrix": [{"translate": [0, 2, 0]}])"}), at_rest);
  EXPECT_EQ(read({.mesh = R"(, "end": {"positions": [0, 0, 0, 1, 0, 0, 0, 1, 0],
                                       "normals": [0, 0, 1, 0, 0, 1, 0, 0, 1]})"}),
            at_rest);
  EXPECT_EQ(read({.camera = "", .mesh = kEnd, .instance = kSlides}), at_rest) << "without a shutter";
  EXPECT_EQ(read({.camera = R"(, "end": {"position": [2, 0, 9]})"}), at_rest) << "without a shutter";
  EXPECT_EQ(read({.camera = R"(, "shutter": [0, 1], "end": {"position": [0, 0, 9], "up": [0, 1, 0]})"}),
            at_rest);
}

// A shutter that opens and closes at one time, in lengths of the frame.
TEST(SceneMotion, OfAnInstantIsTheSceneAtThatTime) {
  const auto instant = read({.camera = R"(, "shutter": [0.25, 0.25])", .mesh = kEnd, .instance = kSlides});
  EXPECT_EQ(instant, scene::at_time(both(), 0.25));
  EXPECT_EQ(instant.instances[0].matrix, translation({1, 1.5, 0}));
  EXPECT_EQ(instant.meshes[0].positions[0], (Vec3f{0, 0, 0.5F}));
  EXPECT_EQ(instant.meshes[0].positions[1], (Vec3f{1.5F, 0, 0}));
  EXPECT_EQ(instant.meshes[0].normals[0], (Vec3f{0.25F, 0, 1}));
  EXPECT_EQ(levels_of_motion(instant), "");
}

TEST(SceneMotion, OfTheCameraIsLinearInItsVectors) {
  const auto scene =
      read({.camera = R"(, "shutter": [0, 1], "end": {"position": [2, 0, 9], "up": [1, 1, 0]})"});
  ASSERT_TRUE(scene.camera.end);
  EXPECT_EQ(scene.camera.end->look_at_m, (Vec3d{0, 0, 0})) << "what is left out stays";
  const auto now = scene::at_time(scene, 0.25);
  EXPECT_EQ(now.camera.position_m, (Vec3d{0.5, 0, 9}));
  EXPECT_EQ(now.camera.up, (Vec3d{0.25, 1, 0}));
  EXPECT_FALSE(now.camera.end);
  EXPECT_EQ(read({.camera = R"(, "shutter": [0.25, 0.25], "end": {"position": [2, 0, 9], "up": [1, 1, 0]})"}),
            now);
}

TEST(SceneMotion, EndsOfFilesAreReadWithTheTrianglesOfTheStart) {
  const structure::TestFolder folder("motion");
  const auto obj = [&](const char* name, const char* corners) {
    write_file(folder.path() / name, fmt::format("v 0 0 0\nv 2 0 0\nv 0 5 0\nvn 0 0 1\nf {}\n", corners));
  };
  obj("end.obj", "1//1 2//1 3//1");
  obj("turned.obj", "2//1 3//1 1//1");
  const auto scene = read({.mesh = R"(, "end": {"file": "end.obj"})"}, folder.path());
  EXPECT_EQ(scene.meshes[0].end->positions[2], (Vec3f{0, 5, 0}));
  write_file(folder.path() / "more.obj",
             "v 0 0 0\nv 2 0 0\nv 0 5 0\nv 1 1 1\nvn 0 0 1\nf 1//1 2//1 3//1\nf 1//1 2//1 4//1\n");
  expect_refusal({.mesh = R"(, "end": {"file": "more.obj"})"}, "must have the triangles of the start",
                 folder.path());
}

// Places of a mesh that lies far out are relative to an origin, which both ends share.
TEST(SceneMotion, BothEndsOfAFarMeshHaveOneOrigin) {
  const auto scene = scene::load_scene_text("scene.json", R"({"format": "orbs-scene/1", "name": "s",
"camera": {"position": [0, 0, 9], "look_at": [0, 0, 0], "shutter": [0, 1]},
"materials": [{"name": "m", "type": "lambert", "reflectance": [0.5, 0.4, 0.3]}],
"meshes": [{"name": "sheet", "positions": [1e7, 0, 0, 10000001, 0, 0, 1e7, 1, 0],
            "normals": [0, 0, 1, 0, 0, 1, 0, 0, 1], "triangles": [0, 1, 2], "material": "m",
            "end": {"positions": [10000000.25, 0, 0, 10000001.25, 0, 0, 10000000.25, 1, 0],
                    "normals": [0, 0, 1, 0, 0, 1, 0, 0, 1]}}],
"instances": [{"mesh": "sheet", "end_matrix": [{"translate": [0, 0, 1]}]}]})",
                                            ".");
  const auto& mesh = scene.meshes[0];
  ASSERT_TRUE(mesh.end);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(mesh.end->positions[i] - mesh.positions[i], (Vec3f{0.25F, 0, 0})) << i;
  const auto& instance = scene.instances[0];
  EXPECT_EQ(transform_point(*instance.end_matrix, {}) - transform_point(instance.matrix, {}),
            (Vec3d{0, 0, 1}));
}

TEST(SceneMotion, CopiesOfAGridMoveTogether) {
  const auto scene = read({.instance = R"(, "end_matrix": [{"translate": [0, 3, 0]}],
    "scatter": {"columns": 2, "rows": 1, "spacing": 2})"});
  ASSERT_EQ(scene.instances.size(), 2U);
  for (const auto& copy : scene.instances) EXPECT_EQ(*copy.end_matrix, translation({0, 1, 0}) * copy.matrix);
}

TEST(SceneMotion, RefusalsSayWhereAndWhatToDo) {
  expect_refusal({.camera = R"(, "shutter": [0.5, 0.25])"}, "/camera/shutter: must open before it closes");
  expect_refusal({.camera = R"(, "shutter": [0, 1.5])"}, "/camera/shutter/1");
  expect_refusal({.camera = R"(, "shutter": [0])"}, "/camera/shutter");
  const auto end = [](const char* keys) {
    return fmt::format(R"(, "shutter": [0, 1], "end": {{{}}})", keys);
  };
  expect_refusal({.camera = end(R"("look_at": [0, 0, 9])")},
                 "/camera/end: look_at must differ from position");
  expect_refusal({.camera = end(R"("look_at": [0, 0, 18])")}, "/camera/end: the camera meets the point");
  expect_refusal({.camera = end(R"("up": [0, -1, 0])")}, "/camera/end: 'up' is no direction at some time");
  expect_refusal({.camera = end(R"("up": [0, 0, 1])")}, "as it is at 1 of the frame");
  // The view turns over the top, along 'up' at one time alone.
  expect_refusal({.camera = end(R"("position": [0, 3, 0], "look_at": [0, 13, 6])")},
                 "/camera/end: up must not be parallel to the view direction, as it is at 0.6 of the frame");
  expect_refusal({.instance = R"(, "end_matrix": [{"rotate_y": 180}])"},
                 "/instances/0/end_matrix: the matrices between start and end, which are linear in time, are "
                 "singular on the way to 0.5 of the frame: turn by less than 180 degrees");
  expect_refusal({.instance = R"(, "end_matrix": [{"scale": [-1, 1, 1]}])"}, "are singular on the way to 1");
  expect_refusal({.instance = R"(, "end_matrix": [{"scale": [0, 1, 1]}])"}, "/instances/0/end_matrix");
  expect_refusal({.mesh = R"(, "end": {"positions": [0, 0, 0], "normals": [0, 0, 1]})"},
                 "there are 3 vertices at the start of the frame, 1 positions and 1 normals at its end");
  expect_refusal({.mesh = R"(, "end": {"positions": [0, 0, 0, 1, 0, 0, 0, 1, 0],
                                       "normals": [0, 0, 1, 0, 0, -1, 0, 0, 1]})"},
                 "/meshes/0/end: normal 1 is the opposite of that of the start");
  expect_refusal({.mesh = R"(, "end": {"positions": [0, 0, 0, 1, 0, 0, 0, 1, 0],
                                       "normals": [0, 0, 1, 0, 0, 0, 0, 0, 1]})"},
                 "normal 1 must be finite and not zero");
  expect_refusal({.mesh = R"(, "end": {"positions": [0, 0, 0]})"}, "key 'normals' is missing");
  expect_refusal({.more = R"(, "lights": [{"type": "disk", "radius": 1, "radiance": [1, 1, 1],
                                           "end_matrix": [{"scale": 2}]}])"},
                 "/lights/0/end_matrix: lights cannot move within a frame");
  expect_refusal(
      {.more = R"(, "shapes": [{"type": "sphere", "centre": [0, 0, 0], "radius": 1, "material": "m",
                                           "end_matrix": [{"scale": 2}]}])"},
      "/shapes/0/end_matrix: shapes by their formula cannot move within a frame");
  expect_refusal({.instance = kSlides, .more = R"(, "integrator": {"type": "irradiance_cache"})"},
                 "/integrator: an irradiance cache is made at one time");
}

TEST(SceneMotion, SubdivisionSurfacesRest) {
  try {
    scene::load_scene_text("scene.json", R"({"format": "orbs-scene/1", "name": "s",
"camera": {"position": [0, 0, 9], "look_at": [0, 0, 0]},
"materials": [{"name": "m", "type": "lambert", "reflectance": [0.5, 0.4, 0.3]}],
"meshes": [{"name": "a", "material": "m", "end": {"file": "a.ply"},
            "subdivision": {"points": [0, 0, 0, 1, 0, 0, 0, 1, 0], "faces": [0, 1, 2], "face_sizes": [3], "levels": 1}}]})",
                           ".");
    ADD_FAILURE();
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("/meshes/0/end: does not go with \"subdivision\""),
              std::string::npos)
        << e.what();
  }
}

// A renderer without a level of motion would show an instant, so nothing is lowered.
TEST(SceneMotion, IsNotLowered) {
  const auto reason = [](const scene::Scene& scene, scene::Capabilities levels) {
    levels.insert({"G1", "G2", "M1"});
    const auto lowered = scene::lower(scene, levels);
    const auto* why = std::get_if<std::string>(&lowered);
    return why == nullptr ? "" : *why;
  };
  EXPECT_EQ(reason(read({.instance = kSlides}), {"G3", "G4", "G5"}),
            "instance 'sheet' moves, which needs T1");
  EXPECT_EQ(reason(read({.mesh = kEnd}), {"G3", "G4", "G5", "T1"}),
            "mesh 'sheet' changes its shape, which needs T2");
  EXPECT_EQ(reason(both(), {"G3", "G4", "G5", "T1", "T2"}), "");
  EXPECT_EQ(reason(both(), {"T1", "T2"}),
            "something moves, and one mesh in world space cannot, which needs G3");
  EXPECT_EQ(reason(read({.camera = "", .mesh = kEnd, .instance = kSlides}), {}), "");
  EXPECT_EQ(reason(read({.camera = kCameraSlides}), {"G3", "G4", "G5"}), "the camera moves, which needs T3");
  EXPECT_EQ(reason(read({.camera = kCameraSlides}), {"T3"}), "") << "one mesh in world space can rest";
}

// Lowering that takes meshes apart keeps their ends.
TEST(SceneMotion, StaysWithTheVerticesOfEachMaterial) {
  auto scene = read({.mesh = kEnd});
  auto& mesh = scene.meshes[0];
  scene.materials.push_back({"n", scene::Lambert{}});
  for (const Vec3f p : {Vec3f{7, 7, 7}, Vec3f{8, 7, 7}, Vec3f{7, 8, 7}}) {
    mesh.positions.push_back(p);
    mesh.normals.push_back({0, 0, 1});
    mesh.tangents.push_back({});
    mesh.uvs.push_back({});
    mesh.end->positions.push_back(p + Vec3f{0, 0, 1});
    mesh.end->normals.push_back({0, 0, 1});
  }
  mesh.triangles.push_back({3, 4, 5});
  mesh.triangle_materials = {0, 1};
  const auto lowered = std::get<scene::Scene>(scene::lower(scene, {"G1", "G2", "G3", "G4", "M1", "T2"}));
  ASSERT_EQ(lowered.meshes.size(), 2U);
  EXPECT_EQ(lowered.meshes[0].end->positions[1], (Vec3f{3, 0, 0}));
  EXPECT_EQ(lowered.meshes[1].end->positions[1], (Vec3f{8, 7, 8}));
  EXPECT_EQ(lowered.meshes[1].end->positions.size(), 3U);
}

// Every format but ours is of scenes at rest; each exporter says so of the object that moves.
TEST(SceneMotion, IsRefusedByTheExporters) {
  auto scene = both();
  scene.camera.end = scene::CameraEnd{{2, 0, 9}, {2, 0, 0}};
  for (const auto& exporter : adapters::exporters()) {
    if (exporter.format == std::string(registry::kNeutralFormat)) continue;
    const auto reasons = exporter.limits(scene, {});
    for (const char* object :
         {"instance 'sheet' moves", "mesh 'sheet' changes its shape", "the camera moves"})
      EXPECT_TRUE(std::any_of(reasons.begin(), reasons.end(),
                              [&](const std::string& reason) { return reason.starts_with(object); }))
          << exporter.format << ": " << object;
  }
  EXPECT_EQ(adapters::povray_limits(scene).front(),
            "instance 'sheet' moves: POV-Ray shows an instant, it has no motion blur");
}

TEST(SceneMotion, LeftOutIsTheSceneAsTheShutterOpens) {
  auto scene = read({.camera = R"(, "shutter": [0.25, 0.75])", .mesh = kEnd, .instance = kSlides});
  EXPECT_TRUE(scene::leave_out(scene::Effect::Motion, scene));
  EXPECT_EQ(scene, scene::at_time(both(), 0.25));
}

TEST(SceneMotion, BoundsAreThoseOfTheWholeFrame) {
  const auto scene = both();
  for (const auto& bounds : {*scene::world_bounds(scene), *scene::rough_bounds(scene)})
    for (const double time : {0.0, 0.3, 0.5, 1.0}) {
      const auto now = *scene::world_bounds(scene::at_time(scene, time));
      EXPECT_GE(now.low.x, bounds.low.x);
      EXPECT_GE(now.low.y, bounds.low.y);
      EXPECT_LE(now.high.x, bounds.high.x + 1e-9);
      EXPECT_LE(now.high.z, bounds.high.z + 1e-9);
    }
}

// Relations change both ends of the frame, or say why they cannot.
TEST(SceneMotion, OfRelatedScenesIsThatOfTheOriginal) {
  const auto scene = both();
  for (const auto& relation : scene::relations()) {
    const auto related = relation.apply(scene, relation.magnitudes.front());
    const auto* scenes = std::get_if<scene::RelatedScenes>(&related);
    if (scenes == nullptr) continue;
    EXPECT_TRUE(scenes->changed.instances[0].end_matrix || scenes->changed.instances.size() > 1)
        << relation.name;
    for (const auto& mesh : scenes->changed.meshes) {
      if (!mesh.end) continue;
      EXPECT_EQ(mesh.end->positions.size(), mesh.positions.size()) << relation.name;
      EXPECT_EQ(mesh.end->normals.size(), mesh.normals.size()) << relation.name;
    }
    EXPECT_EQ(levels_of_motion(scenes->changed), "T1T2") << relation.name;
  }
  const auto doubled = scene::moved(read({.camera = kCameraSlides, .instance = kSlides}), scaling({2, 2, 2}));
  EXPECT_EQ(*doubled.camera.end, (scene::CameraEnd{{4, 0, 18}, {8, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(*doubled.instances[0].end_matrix, scaling({2, 2, 2}) * translation({4, 0, 0}));
}

// A reference of another motion is none of this one; scenes at rest keep theirs.
TEST(SceneMotion, OfAFileChangesTheHashOfTheScene) {
  const structure::TestFolder folder("motion");
  const auto file = folder.path() / "scene.json";
  write_file(file, "{}");
  auto scene = read({.mesh = kEnd});
  const auto hash = run::scene_content_hash(scene, file);
  scene.meshes[0].end->positions[0].x += 1;
  EXPECT_NE(run::scene_content_hash(scene, file), hash);
}
