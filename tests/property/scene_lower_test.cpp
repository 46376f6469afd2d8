// Lowering must not change what is drawn: the triangles in world space with their materials are the same at
// every level.
#include "base/random.h"
#include "scene/lower/lower.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;
using namespace orbs::scene;

namespace {

struct Corner {
  Vec3d position;
  Vec3d normal;  // unit
  Vec2d uv;      // as the texture sees it
};

struct WorldTriangle {
  std::array<Corner, 3> corners;
  std::string material;
};

const Capabilities kMaterialsAndLights{"M1", "M2", "M3", "M4", "M5", "M6",
                                       "M7", "M8", "L1", "L2", "L3", "L4"};

Capabilities with_geometry(std::initializer_list<const char*> levels) {
  auto capabilities = kMaterialsAndLights;
  for (const char* level : levels) capabilities.insert(level);
  return capabilities;
}

Vec2d seen_by_texture(const Material& material, Vec2f uv) {
  const auto& use = texture_of(material.model);
  const Mat4 m = use ? use->matrix : Mat4{};
  const auto u = static_cast<double>(uv.x);
  const auto v = static_cast<double>(uv.y);
  return {m(0, 0) * u + m(0, 1) * v + m(0, 3), m(1, 0) * u + m(1, 1) * v + m(1, 3)};
}

// Own and slow, to stand against the code under test. Corners begin with the smallest position, so that a
// triangle compares equal whichever corner it was listed from, but not when its winding has changed; in a
// mirrored instance the winding seen from the vertex normal is the other way round.
std::vector<WorldTriangle> world_triangles(const Scene& scene) {
  std::vector<WorldTriangle> out;
  for (const auto& instance : scene.instances) {
    const auto& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    const auto to_local = inverse(instance.matrix).value();
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const auto& material =
          scene.materials[static_cast<std::size_t>(remapped(instance, mesh.triangle_materials[i]))];
      auto& triangle = out.emplace_back();
      triangle.material = material.name;
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const auto v = mesh.triangles[i][corner];
        triangle.corners[corner] = {transform_point(instance.matrix, cast<double>(mesh.positions[v])),
                                    normalised(transform_normal(to_local, cast<double>(mesh.normals[v]))),
                                    seen_by_texture(material, mesh.uvs[v])};
      }
      if (determinant3(instance.matrix) < 0) std::swap(triangle.corners[1], triangle.corners[2]);
    }
  }
  return out;
}

double distance(const WorldTriangle& a, const WorldTriangle& b, std::size_t turn) {
  double worst = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& p = a.corners[i];
    const auto& q = b.corners[(i + turn) % 3];
    worst = std::max({worst, length(p.position - q.position), length(p.normal - q.normal),
                      std::hypot(p.uv.x - q.uv.x, p.uv.y - q.uv.y)});
  }
  return worst;
}

// Each triangle of one has its own partner in the other, up to the rounding of coordinates of size 10 to
// float.
void expect_same_image(const Scene& before, const Scene& after) {
  constexpr double kRounding = 4e-6;
  const auto expected = world_triangles(before);
  auto found = world_triangles(after);
  ASSERT_EQ(found.size(), expected.size());
  for (const auto& triangle : expected) {
    const auto partner = std::find_if(found.begin(), found.end(), [&](const WorldTriangle& other) {
      if (other.material != triangle.material) return false;
      for (std::size_t turn = 0; turn < 3; ++turn)
        if (distance(triangle, other, turn) < kRounding) return true;
      return false;
    });
    ASSERT_NE(partner, found.end()) << "no partner for a triangle with material " << triangle.material;
    found.erase(partner);
  }
}

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : seed_(seed) {}
  double next(double min, double max) { return min + (max - min) * unit_random(mix(seed_, counter_++)); }
  int below(int count) { return static_cast<int>(next(0, count)); }

 private:
  std::uint64_t seed_;
  std::uint64_t counter_ = 0;
};

Mesh random_mesh(Numbers& numbers, int materials) {
  Mesh mesh;
  constexpr int kVertices = 9;
  const auto number = [&] { return static_cast<float>(numbers.next(-2, 2)); };
  for (int i = 0; i < kVertices; ++i) {
    mesh.positions.push_back({number(), number(), number()});
    mesh.normals.push_back(
        cast<float>(normalised(Vec3d{numbers.next(-1, 1), numbers.next(-1, 1), numbers.next(1, 2)})));
    mesh.tangents.push_back({number(), number(), number()});
    mesh.uvs.push_back({number(), number()});
  }
  for (int i = 0; i < 7; ++i) {
    const auto vertex = [&] { return static_cast<std::uint32_t>(numbers.below(kVertices)); };
    mesh.triangles.push_back({vertex(), vertex(), vertex()});
    mesh.triangle_materials.push_back(numbers.below(materials));
  }
  return mesh;
}

// Three meshes, the last without an instance; instances with every kind of matrix (mirroring too) and with
// remap lists.
Scene random_scene(std::uint64_t seed) {
  constexpr int kMaterials = 5;
  Numbers numbers(seed);
  Scene scene;
  scene.textures.push_back({"t", "/t.png", Wrap::Repeat, Wrap::Repeat});
  for (int i = 0; i < kMaterials; ++i) {
    const Mat4 matrix = i % 2 == 0 ? Mat4{} : translation({0.5, -0.25, 0}) * scaling({2.0 + i, 1.5, 1});
    scene.materials.push_back(
        {std::string(1, static_cast<char>('a' + i)), Lambert{{0.5, 0.5, 0.5}, TextureUse{0, matrix}}});
  }
  for (int i = 0; i < 3; ++i) {
    scene.meshes.push_back(random_mesh(numbers, i == 1 ? 1 : kMaterials));
    scene.meshes.back().name = fmt::format("mesh{}", i);
  }
  for (int i = 0; i < 6; ++i) {
    Instance instance{fmt::format("i{}", i), i % 2, {}, {}};
    const Vec3d offset{numbers.next(-5, 5), numbers.next(-5, 5), numbers.next(-5, 5)};
    const Vec3d scale{numbers.next(0.5, 2) * (i % 3 == 0 ? -1 : 1), numbers.next(0.5, 2),
                      numbers.next(0.5, 2)};
    instance.matrix = translation(offset) * rotation_x(numbers.next(0, 360)) *
                      rotation_y(numbers.next(0, 360)) * scaling(scale);
    if (i >= 2) instance.remap = {{0, numbers.below(kMaterials)}, {3, numbers.below(kMaterials)}};
    scene.instances.push_back(instance);
  }
  return scene;
}

Scene lowered(const Scene& scene, const Capabilities& capabilities) {
  auto result = lower(scene, capabilities);
  EXPECT_TRUE(std::holds_alternative<Scene>(result)) << std::get<std::string>(result);
  return std::get<Scene>(std::move(result));
}

class LoweredGeometry : public testing::TestWithParam<std::uint64_t> {};

}  // namespace

TEST_P(LoweredGeometry, BelowG3IsOneMeshInWorldSpace) {
  const auto scene = random_scene(GetParam());
  for (const auto& capabilities : {with_geometry({"G1"}), with_geometry({"G1", "G2"})}) {
    const auto after = lowered(scene, capabilities);
    ASSERT_EQ(after.meshes.size(), 1U);
    ASSERT_EQ(after.instances.size(), 1U);
    EXPECT_EQ(after.instances[0].matrix, Mat4{});
    EXPECT_TRUE(after.instances[0].remap.empty());
    expect_same_image(scene, after);
  }
}

TEST_P(LoweredGeometry, AtG3HasInstancesWithoutRemapLists) {
  const auto scene = random_scene(GetParam());
  const auto after = lowered(scene, with_geometry({"G1", "G2", "G3"}));
  EXPECT_EQ(after.instances.size(), scene.instances.size());
  for (const auto& instance : after.instances) EXPECT_TRUE(instance.remap.empty());
  EXPECT_EQ(after.meshes[0].triangle_materials,
            scene.meshes[0].triangle_materials);  // the original is still there
  expect_same_image(scene, after);
}

TEST_P(LoweredGeometry, AtG4HasOneMaterialInEachMesh) {
  const auto scene = random_scene(GetParam());
  const auto after = lowered(scene, with_geometry({"G1", "G2", "G3", "G4"}));
  std::set<std::string> names;
  for (const auto& mesh : after.meshes) {
    EXPECT_EQ(std::set<int>(mesh.triangle_materials.begin(), mesh.triangle_materials.end()).size(), 1U)
        << mesh.name;
    EXPECT_TRUE(names.insert(mesh.name).second) << mesh.name << " is the name of two meshes";
  }
  for (const auto& instance : after.instances) EXPECT_TRUE(instance.remap.empty());
  expect_same_image(scene, after);
}

TEST_P(LoweredGeometry, AtG5IsLeftAlone) {
  const auto scene = random_scene(GetParam());
  const auto after = lowered(scene, with_geometry({"G1", "G2", "G3", "G4", "G5"}));
  EXPECT_EQ(after.meshes.size(), scene.meshes.size());
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    EXPECT_EQ(after.instances[i].remap, scene.instances[i].remap);
  expect_same_image(scene, after);
}

TEST_P(LoweredGeometry, WithoutM5HasNoTextureMatrixAtAnyLevel) {
  const auto scene = random_scene(GetParam());
  for (const auto& levels : {std::vector{"G1"}, {"G1", "G3"}, {"G1", "G3", "G4"}, {"G1", "G3", "G4", "G5"}}) {
    auto capabilities = kMaterialsAndLights;
    capabilities.insert(levels.begin(), levels.end());
    capabilities.erase("M5");
    const auto after = lowered(scene, capabilities);
    for (const auto& material : after.materials) EXPECT_EQ(texture_of(material.model)->matrix, Mat4{});
    expect_same_image(scene, after);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, LoweredGeometry, testing::Range<std::uint64_t>(1, 9));
