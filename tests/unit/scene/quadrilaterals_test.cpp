// How the quadrilaterals of subdivision surfaces are cut into triangles.
#include "scene/geometry/subdivision/tessellate_surface.h"
#include "scene/load/load_scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace {

using namespace orbs;

// From the vertex of a corner by that of an edge to that of the face, which follow each other in this order.
bool is_fan(const scene::Mesh& mesh, std::size_t quadrilateral) {
  const auto& [a, b, c] = mesh.triangles[2 * quadrilateral];
  const auto& [d, e, f] = mesh.triangles[2 * quadrilateral + 1];
  return a == d && c == e && a < b && b < c && c > f;
}

double area(const scene::SurfaceMesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const auto at = [&](std::size_t k) { return mesh.places_m[t.at(k)]; };
  return cross(at(1) - at(0), at(2) - at(0)).z / 2;
}

}  // namespace

// All points are corners, so the edges stay straight, and the point in the middle of the face lies at
// (2, -0.2): beyond the edge from (0, 0) to (2, 0), whose middle is then a concave corner.
TEST(Quadrilaterals, AConcaveOneIsCutAtItsConcaveCorner) {
  scene::SubdivisionSurface surface;
  surface.cage = {{{0, 0, 0}, {2, 0, 0}, {5, -2.8, 0}, {1, 2, 0}}, {4}, {0, 1, 2, 3}, {}, {{{0, 1, 2, 3}}}};
  const auto mesh = scene::tessellate(surface);
  const std::vector<Vec3d> outline{{0, 0, 0}, {1, 0, 0}, {2, -0.2, 0}, {0.5, 1, 0}};
  double sum = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_GT(area(mesh, mesh.triangles[i]), 0.05) << i;
    sum += area(mesh, mesh.triangles[i]);
  }
  EXPECT_NEAR(sum, cross(outline[2] - outline[0], outline[3] - outline[1]).z / 2, 1e-12);
}

// References and meshes for renderers without subdivision depend on it.
TEST(Quadrilaterals, ThoseOfAllCasesAreFans) {
  const std::filesystem::path cases = ORBS_SOURCE_DIR "/data/cases/shapes";
  int quadrilaterals = 0;
  for (const char* folder : {"s5_subdivision", "s6_displacement"})
    for (const auto& entry : std::filesystem::directory_iterator(cases / folder)) {
      const auto name = entry.path().filename().string();
      if (entry.path().extension() != ".json" || name == "case.json") continue;
      for (const auto& mesh : scene::load_scene(entry.path()).meshes) {
        if (!mesh.subdivision) continue;
        for (std::size_t i = 0; 2 * i < mesh.triangles.size(); ++i, ++quadrilaterals)
          ASSERT_TRUE(is_fan(mesh, i)) << name << ", mesh '" << mesh.name << "', quadrilateral " << i;
      }
    }
  EXPECT_GT(quadrilaterals, 1000);
}
