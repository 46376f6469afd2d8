#include "peers/povray_render.h"
#include "peers/scenes.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

/// Glass that disperses, on the real POV-Ray: a bright line seen through a wedge lies where Snell's law puts
/// it, for each colour elsewhere.
namespace {

using namespace orbs;
using namespace orbs::peers;

constexpr double kFront_m = 3;  // distances from the camera at the origin, which looks along -Z
constexpr double kLine_m = 8;
const double kTan = std::tan(20 * std::numbers::pi / 180);  // of the wedge's angle

const scene::Dielectric& glass() {
  static const scene::Dielectric kGlass{spectra::Cauchy{1.65, 0.03, 0, 0}, spectra::constant(1), {}, {}};
  return kGlass;
}

// Snell's law in vectors; `normal` against the ray, `ratio` the index before over that behind.
Vec3d refracted(Vec3d direction, Vec3d normal, double ratio) {
  const double cosine = -dot(direction, normal);
  const double beyond = std::sqrt(1 - ratio * ratio * (1 - cosine * cosine));
  return direction * ratio + normal * (ratio * cosine - beyond);
}

// Where a ray from the camera ends on the plane of the line, through the face z = -3 and the one that leans.
double arrival_m(Vec3d direction, double index) {
  const Vec3d front = direction * (kFront_m / -direction.z);
  const Vec3d within = refracted(direction, {0, 0, 1}, 1 / index);
  const Vec3d leaning = normalised(Vec3d{kTan, 0, 1});  // of the plane z = -3 - (x + 1) tan
  const double to_back =
      ((Vec3d{-1, 0, -kFront_m} - front).x * leaning.x + (Vec3d{-1, 0, -kFront_m} - front).z * leaning.z) /
      dot(within, leaning);
  const Vec3d back = front + within * to_back;
  const Vec3d out = refracted(within, leaning, index);
  return back.x + out.x * ((-kLine_m - back.z) / out.z);
}

scene::Mesh wedge() {
  scene::Mesh mesh;
  const double depth = 2 * kTan;
  for (const auto& [from, to] :
       std::vector<std::pair<Vec3d, Vec3d>>{{{-1, -9, -kFront_m}, {1, -9, -kFront_m}},
                                            {{1, -9, -kFront_m}, {1, -9, -kFront_m - depth}},
                                            {{1, -9, -kFront_m - depth}, {-1, -9, -kFront_m}}}) {
    const scene::Mesh face = quad(from, to - from, {0, 18, 0});
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), face.positions.begin(), face.positions.end());
    mesh.normals.insert(mesh.normals.end(), face.normals.begin(), face.normals.end());
    mesh.tangents.insert(mesh.tangents.end(), face.tangents.begin(), face.tangents.end());
    mesh.uvs.insert(mesh.uvs.end(), face.uvs.begin(), face.uvs.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
  }
  return mesh;
}

// The column in which light of this index shows the line at x_m.
double column_of(const scene::Camera& camera, double x_m, double index) {
  double left = 0;
  double right = camera.width_px;
  for (int i = 0; i < 60; ++i) {
    const double middle = (left + right) / 2;
    (arrival_m(pixel_direction(camera, middle, 0.5 * camera.height_px), index) < x_m ? left : right) = middle;
  }
  return left;
}

TEST(Povray, EachColourIsRefractedAsSnellsLawHasIt) {
  auto scene = empty_scene(192, 2, 0.12);
  scene.trace_depth = 6;
  const double x_m = arrival_m({0, 0, -1}, index_at(glass().index, 539.1));
  add_instance(scene, wedge(), add_material(scene, glass()));
  add_instance(scene, quad({x_m - 0.01, -9, -kLine_m}, {0.02, 0, 0}, {0, 18, 0}),
               add_material(scene, scene::Emission{{1, 1, 1}, {}}));
  adapters::PovraySettings settings;
  settings.dispersion_samples = 100;
  const auto image = render_with_povray(scene, "dispersion", settings, {"+A0.0", "+AM1", "+R3", "-J"});
  const auto mean_column = [&](std::size_t channel) {
    double sum = 0;
    double weighted = 0;
    for (int x = 0; x < scene.camera.width_px; ++x) {
      sum += static_cast<double>(image.at(x, 0, channel));
      weighted += static_cast<double>(image.at(x, 0, channel)) * (x + 0.5);
    }
    return weighted / sum;
  };
  // Means of whole hues, each a range of indices: to a tenth of what lies between red and blue.
  const double red = column_of(scene.camera, x_m, index_at(glass().index, 608.6));
  const double blue = column_of(scene.camera, x_m, index_at(glass().index, 453.4));
  const double most = std::abs(red - blue) / 10;
  EXPECT_GT(most, 1);
  EXPECT_NEAR(mean_column(0), red, most);
  EXPECT_NEAR(mean_column(1), column_of(scene.camera, x_m, index_at(glass().index, 539.1)), most);
  EXPECT_NEAR(mean_column(2), blue, most);
}

}  // namespace
