// Subdivision surfaces in scene files: how they are read, refused, written and lowered; their limit points
// against those of OpenSubdiv.
#include "base/error.h"
#include "scene/effects/features.h"
#include "scene/load/load_scene.h"
#include "scene/load/write_scene.h"
#include "scene/lower/lower.h"
#include "scene/relations/relation.h"
#include "structure/source_files.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

std::string text_with(const std::string& mesh) {
  return R"({"format": "orbs-scene/1", "name": "s", "camera": {"position": [0, 0, 5], "look_at": [0, 0, 0]},
"materials": [{"name": "m", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}],
"meshes": [{"name": "a", )" +
         mesh + R"(}], "instances": [{"mesh": "a"}]})";
}

scene::Scene scene_with(const std::string& surface) {
  return scene::load_scene_text("scene.json", text_with(R"("material": "m", "subdivision": )" + surface),
                                ".");
}

std::string refusal(const std::string& surface) {
  try {
    scene_with(surface);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}

const char* const kTent = R"json({"points": [-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1, 0, 1, 0],
"faces": [1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4], "face_sizes": [3, 3, 3, 3],
"creases": [{"points": [0, 4, 2], "sharpness": 1.5}], "corners": [{"points": [0, 1]}], "levels": 3,
"displacement": {"expression": "0.02 * sin(20 * x)", "origin": [0.5, 0, 0]}})json";

// A square with something more.
std::string square(const std::string& more, const std::string& faces = "[0, 1, 2, 3]") {
  return R"({"points": [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], "faces": )" + faces + R"(, "levels": 2)" + more +
         "}";
}

std::string levels_of(const scene::Scene& scene) {
  std::string found;
  for (const auto& feature : scene::features_called_for(scene))
    if (feature.requirement.front() == 'S') found += feature.requirement;
  return found;
}

}  // namespace

TEST(SubdivisionScene, IsReadWrittenAndReadAgain) {
  const auto scene = scene_with(kTent);
  const auto& mesh = scene.meshes.front();
  ASSERT_TRUE(mesh.subdivision);
  EXPECT_EQ(mesh.triangles.size(), 12U * 32U);
  EXPECT_EQ(mesh.subdivision->cage.points_m.size(), 5U);
  EXPECT_EQ(mesh.subdivision->cage.creases.front().sharpness, 1.5);
  EXPECT_EQ(mesh.subdivision->cage.corners.front().sharpness, scene::kInfinitelySharp);
  EXPECT_EQ(mesh.subdivision->displacement->origin_m, (Vec3d{0.5, 0, 0}));
  const structure::TestFolder folder("subdivision-scene");
  scene::write_scene(scene, folder.path() / "s.json");
  EXPECT_EQ(scene::load_scene(folder.path() / "s.json"), scene);
}

// Then floats hold no vertices of it: they are stored about an origin, and the cage with them.
TEST(SubdivisionScene, KeepsItsVerticesFarFromZero) {
  std::string far = kTent;
  far.replace(far.find("[-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1, 0, 1, 0]"), 49,
              "[1048575, 0, -1, 1048577, 0, -1, 1048577, 0, 1, 1048575, 0, 1, 1048576, 1, 0]");
  far.replace(far.find("[0.5, 0, 0]"), 11, "[1048576.5, 0, 0]");
  const auto near = scene_with(kTent);
  const auto scene = scene_with(far);
  EXPECT_EQ(scene.meshes, near.meshes);
  EXPECT_EQ(scene.instances.front().matrix, translation({1048576, 0, 0}));
  const structure::TestFolder folder("subdivision-scene");
  scene::write_scene(scene, folder.path() / "s.json");
  EXPECT_EQ(scene::load_scene(folder.path() / "s.json"), scene);
}

TEST(SubdivisionScene, CallsForItsLevels) {
  EXPECT_EQ(levels_of(scene_with(kTent)), "S5S6");
  EXPECT_EQ(levels_of(scene_with(square(""))), "S5");
}

TEST(SubdivisionScene, WithoutItsLevelsIsTriangles) {
  const auto scene = scene_with(kTent);
  const auto lowered = [&](scene::Capabilities capabilities) {
    capabilities.insert({"G1", "G2", "G3", "G4", "G5", "M1"});
    return std::get<scene::Scene>(scene::lower(scene, capabilities)).meshes.front();
  };
  EXPECT_EQ(lowered({"S5", "S6"}), scene.meshes.front());
  EXPECT_FALSE(lowered({}).subdivision);
  EXPECT_FALSE(lowered({"S5"}).subdivision);
  EXPECT_EQ(lowered({}).positions, scene.meshes.front().positions);
}

// A relation that changes triangles must not leave a cage from which a renderer would make the old ones.
TEST(SubdivisionScene, RelationsKeepTheSurfaceOrDropIt) {
  const auto scene = scene_with(kTent);
  int kept = 0;
  for (const auto& relation : scene::relations()) {
    const auto related = relation.apply(scene, relation.magnitudes.front());
    const auto* scenes = std::get_if<scene::RelatedScenes>(&related);
    if (scenes == nullptr) continue;
    for (const auto& mesh : scenes->changed.meshes) {
      if (!mesh.subdivision) continue;
      EXPECT_EQ(mesh.positions, scene.meshes.front().positions) << relation.name;
      EXPECT_EQ(mesh.triangles, scene.meshes.front().triangles) << relation.name;
      ++kept;
    }
  }
  EXPECT_GT(kept, 4);
}

TEST(SubdivisionScene, RefusesWhatIsNoManifold) {
  expect_part(refusal(square("", "[0, 1, 2]")), "holds 3 indices, no multiple of 4");
  expect_part(refusal(square("", "[0, 1, 2, 4]")), "face 0 has point 4, there are 4 points");
  expect_part(refusal(square("", "[0, 1, 2, 1]")), "face 0 has point 1 twice");
  expect_part(refusal(square("", "[0, 1, 2, 2.5]")), "/faces/3: must be a whole number, is 2.5");
  expect_part(refusal(square(R"(, "face_sizes": [3])")), "the faces take 3 points, 4 are given");
  expect_part(refusal(square(R"(, "face_sizes": [2, 2])")), "face 0 has 2 points");
  expect_part(refusal(square(R"(, "face_sizes": [3])", "[0, 1, 2]")), "point 3 belongs to no face");
  expect_part(refusal(square(R"(, "face_sizes": [3, 3])", "[0, 1, 2, 0, 1, 3]")),
              "faces 0 and 1 both run from point 0 to point 1");
  expect_part(
      refusal(
          R"({"points": [0, 0, 0, 1, 0, 0, 1, 1, 0, -1, 0, 0, -1, -1, 0], "faces": [0, 1, 2, 0, 3, 4], "face_sizes": [3, 3], "levels": 1})"),
      "point 0 joins faces that share no edge there");
}

TEST(SubdivisionScene, RefusesCreasesThatAreNone) {
  expect_part(refusal(square(R"(, "creases": [{"points": [0, 2]}])")),
              "a crease runs from point 0 to point 2, between which there is no edge");
  expect_part(refusal(square(R"(, "creases": [{"points": [0]}])")), "must be at least 2, there are 1");
  expect_part(refusal(square(R"(, "corners": [{"points": [9]}])")), "a corner is point 9, there are 4");
  expect_part(refusal(square(R"(, "corners": [{"points": [0], "sharpness": 2.5}])")),
              "a sharpness is 2.5, must not exceed levels, 2");
}

TEST(SubdivisionScene, RefusesWhatHasNoFiniteSurface) {
  expect_part(refusal(square(R"json(, "displacement": {"expression": "1 / (x - x)"})json")),
              "the displacement '1 / (x - x)' is ");
  expect_part(refusal(square(R"json(, "displacement": {"expression": "sqrt(-1 - x)"})json")),
              "it must be finite");
  expect_part(refusal(square(R"json(, "displacement": {"expression": "1e100 * (1 + x)"})json")),
              "farther out than");
  expect_part(refusal(square(R"(, "displacement": {"expression": "x +* y"})")),
              "/displacement/expression: column 4");
  expect_part(
      refusal(R"({"points": [0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0], "faces": [0, 1, 2, 3], "levels": 1})"),
      "the surface has no normal at (");
  expect_part(
      refusal(R"({"points": [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], "faces": [0, 1, 2, 3], "levels": 11})"),
      "/levels: ");
  const std::string many =
      R"({"points": [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0, 3, 0, 0, 3, 1, 0], )"
      R"("faces": [0, 1, 2, 3, 1, 4, 5, 2, 4, 6, 7, 5], "levels": 10})";
  expect_part(refusal(many), "make 6291456 triangles, more than 4194304: take fewer levels");
}

TEST(SubdivisionScene, IsAMeshOfItsOwnAndOfOneMaterial) {
  const auto refused = [](const std::string& mesh) {
    try {
      scene::load_scene_text("scene.json", text_with(mesh), ".");
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string("no error");
  };
  expect_part(refused(R"("parts": [{"material": "m", "subdivision": )" + square("") + "}]"),
              "cannot be a part");
  expect_part(refused(R"("subdivision": )" + square("")), "key 'material' is missing");
}

namespace {

// The largest distance of a vertex of `mesh` from the nearest of `other`.
double distance(const scene::Mesh& mesh, const scene::Mesh& other) {
  auto sorted = other.positions;
  std::sort(sorted.begin(), sorted.end(), [](Vec3f a, Vec3f b) { return a.x < b.x; });
  constexpr float kReach = 1e-4F;
  double largest = 0;
  for (const Vec3f p : mesh.positions) {
    auto near = std::lower_bound(sorted.begin(), sorted.end(), p.x - kReach,
                                 [](Vec3f a, float x) { return a.x < x; });
    double nearest = 1;
    for (; near != sorted.end() && near->x < p.x + kReach; ++near)
      nearest = std::min(nearest, length(cast<double>(*near) - cast<double>(p)));
    largest = std::max(largest, nearest);
  }
  return largest;
}

void expect_near_theirs(const std::string& name, const std::map<std::string, double>& tolerance_m) {
  const auto folder = std::filesystem::path(ORBS_SOURCE_DIR) / "data/cases/shapes";
  const auto ours = scene::load_scene(folder / (name + ".json"));
  const auto theirs = scene::load_scene(folder / (name + "-mesh.json"));
  std::size_t compared = 0;
  for (std::size_t i = 0; i < ours.meshes.size(); ++i) {
    if (!ours.meshes[i].subdivision) continue;
    EXPECT_LT(distance(theirs.meshes[i], ours.meshes[i]), tolerance_m.at(ours.meshes[i].name)) << name;
    ++compared;
  }
  EXPECT_EQ(compared, tolerance_m.size());
}

}  // namespace

// OpenSubdiv computes in floats. Where the seed's crease ends it probably takes the mask of smooth points,
// which is 1.6e-5 off there; displaced points have normals of triangles in their reference.
TEST(SubdivisionScene, LimitPointsAreThoseOfOpenSubdiv) {
  const std::map<std::string, double> limits{{"jack", 1e-6}, {"drum", 1e-6}, {"leaf", 1e-6}, {"seed", 2e-5}};
  expect_near_theirs("s5_subdivision/s5-creases", limits);
  expect_near_theirs("s5_subdivision/s5-outlines", limits);
  expect_near_theirs("s6_displacement/s6-displacement",
                     {{"bumps", 2e-5}, {"screw", 1e-4}, {"ripples", 1e-6}});
}
