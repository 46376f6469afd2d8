// OBJ, MTL, PLY and the description beside them, read back.
#include "adapters/obj/obj.h"

#include "adapters/obj/mtl.h"
#include "adapters/obj/world_parts.h"
#include "base/files.h"
#include "json/document.h"
#include "json/object_reader.h"
#include "scene/geometry/generators.h"
#include "scene/geometry/obj.h"
#include "scene/geometry/ply.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
namespace fs = std::filesystem;

// A cube of two materials, once as it is and once mirrored and stretched.
scene::Scene two_cubes() {
  scene::Scene scene;
  scene.name = "two";
  scene.materials = {{"red one", scene::Lambert{{0.5, 0.25, 0}, {}}},
                     {"red_one", scene::Mirror{{0.9, 0.9, 0.9}}}};
  scene.meshes = {scene::make_cube({1})};
  scene.meshes[0].name = "cube";
  scene.meshes[0].triangle_materials.assign(12, 0);
  scene.meshes[0].triangle_materials[11] = 1;
  scene.instances = {{"a", 0, {}, {}}, {"b", 0, translation({5, 0, 0}) * scaling({-1, 2, 3}), {}}};
  return scene;
}

// Triangles whose vertex normals agree with their winding, and the area of all.
struct Seen {
  int outward = 0;
  double area_m2 = 0;
};

void see(const scene::Mesh& mesh, Seen& seen) {
  for (const auto& t : mesh.triangles) {
    const Vec3d a = cast<double>(mesh.positions[t[0]]);
    const Vec3d across =
        cross(cast<double>(mesh.positions[t[1]]) - a, cast<double>(mesh.positions[t[2]]) - a);
    seen.area_m2 += length(across) / 2;
    if (dot(across, cast<double>(mesh.normals[t[0]])) > 0) ++seen.outward;
  }
}

constexpr double kArea_m2 = 24 + 2 * (4 * 6 + 2 * 6 + 2 * 4);  // 2 x 2 x 2 m and 2 x 4 x 6 m

TEST(Obj, MeshesStandInTheWorldAndKeepTheirOutside) {
  const ScratchFolder folder("orbs-obj");
  adapters::write_obj(two_cubes(), folder.path() / "scene.obj");
  const auto read = scene::read_obj(folder.path() / "scene.obj");
  EXPECT_EQ(read.material_names, (std::vector<std::string>{"red_one", "red_one-1"}));
  Seen seen;
  see(read.mesh, seen);
  EXPECT_EQ(seen.outward, 24);
  EXPECT_DOUBLE_EQ(seen.area_m2, kArea_m2);
}

TEST(Ply, HasTheSameMeshesAndTheDescriptionListsThem) {
  const ScratchFolder folder("orbs-ply");
  adapters::write_ply_parts(two_cubes(), folder.path() / "description.json");
  const auto document = json::parse_file(folder.path() / "description.json");
  json::ObjectReader description(document);
  Seen seen;
  for (auto& surface : description.objects("surfaces"))
    see(scene::read_ply(folder.path() / surface.text("file")).mesh, seen);
  EXPECT_EQ(seen.outward, 24);
  EXPECT_DOUBLE_EQ(seen.area_m2, kArea_m2);
}

TEST(Obj, TheDescriptionNamesCameraLampsAndSettings) {
  const ScratchFolder folder("orbs-obj");
  auto scene = two_cubes();
  scene.camera.fov_y_deg = 40;
  scene.trace_depth = scene::kUnlimitedDepth;
  scene.environment.radiance = {1, 2, 3};
  // Turned upside down, it shines up.
  scene.lights = {{"", scene::RectShape{1, 2}, {7, 8, 9}, translation({0, 4, 0}) * rotation_x(180), {}}};
  adapters::write_obj(scene, folder.path() / "scene.obj");
  const auto document = json::parse_file(folder.path() / "description.json");
  json::ObjectReader description(document);
  EXPECT_EQ(description.object("camera").number("fov_y_degrees"), 40);
  EXPECT_EQ(description.text("trace_depth"), "unlimited");
  EXPECT_EQ(description.object("background").vec3("radiance"), (Vec3d{1, 2, 3}));
  auto lamp = description.objects("lamps").at(0);
  EXPECT_EQ(lamp.text("name"), "lamp 0");
  EXPECT_EQ(lamp.number("width_m"), 2);
  EXPECT_EQ(lamp.number("length_m"), 4);
  EXPECT_EQ(lamp.vec3("radiance"), (Vec3d{7, 8, 9}));
  EXPECT_NEAR(lamp.vec3("shines_towards").y, 1, 1e-12);
  const auto corners = lamp.number_rows("corners_m", 3);
  ASSERT_EQ(corners.size(), 4U);
  const auto corner = [&](std::size_t i) { return Vec3d{corners[i][0], corners[i][1], corners[i][2]}; };
  EXPECT_NEAR(cross(corner(1) - corner(0), corner(2) - corner(1)).y, 8, 1e-9)
      << "counter-clockwise from above";
  EXPECT_NEAR(corner(0).y, 4, 1e-12);
}

std::string mtl_of(const scene::MaterialModel& model) {
  auto scene = two_cubes();
  scene.materials[0].model = model;
  scene.textures = {{"t", "checker.png", scene::Wrap::Clamp, scene::Wrap::Clamp}};
  const auto text = adapters::obj::mtl_text(scene, adapters::obj::material_names(scene), "scene");
  const auto begin = text.find("newmtl red_one\n") + std::string("newmtl red_one\n").size();
  return text.substr(begin, text.find("\nnewmtl", begin) - begin);
}

TEST(Mtl, SaysWhatItCanAndCommentsTheRest) {
  EXPECT_EQ(mtl_of(scene::Lambert{{1, 0.5, 0}, scene::TextureUse{0, {}}}),
            "Kd 1 0.5 0\nKs 0 0 0\nillum 1\nmap_Kd -clamp on scene-texture0.png\nKa 0 0 0\n");
  EXPECT_EQ(mtl_of(scene::OrenNayar{{1, 1, 1}, 0.3, {}}),
            "# Oren-Nayar, roughness 0.3: MTL has Lambert's law alone, see description.json\n"
            "Kd 1 1 1\nKs 0 0 0\nillum 1\nKa 0 0 0\n");
  EXPECT_EQ(mtl_of(scene::Glass{{1, 1, 1}, 1.5}),
            "# smooth glass; Ni is inside over outside\nKd 0 0 0\nTf 1 1 1\nNi 1.5\nillum 7\nKa 0 0 0\n");
  EXPECT_EQ(mtl_of(scene::Emission{{2, 4, 8}, {}}),
            "# emits this radiance from both sides and reflects nothing\n"
            "Kd 0 0 0\nKe 2 4 8\nillum 0\nKa 0 0 0\n");
}

TEST(Obj, RefusesWhatNeitherMeshesNorWordsSay) {
  auto scene = two_cubes();
  EXPECT_TRUE(adapters::obj_limits(scene).empty());
  scene.materials[1].model = scene::Polariser{};
  const auto limits = adapters::obj_limits(scene);
  ASSERT_EQ(limits.size(), 1U);
  EXPECT_NE(limits[0].find("material 'red_one'"), std::string::npos) << limits[0];
}

TEST(Obj, NamesAreWordsAndEachOneIsThereOnce) {
  EXPECT_EQ(adapters::obj::plain_names({"a b", "a_b", "", "\n\"x", "a_b-1", "a/b"}),
            (std::vector<std::string>{"a_b", "a_b-1", "2", "__x", "a_b-1-4", "a_b-5"}));
}

}  // namespace
