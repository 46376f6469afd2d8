#include "studies/probe/frames_pass.h"

#include "base/nth.h"
#include "image/image_io.h"
#include "scene/camera_frame.h"
#include "scene/geometry/uv_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace orbs::studies {

namespace {

// Codes of 8 bits. 30 degrees: a lean to the other side is darker by more than half where a surface is seen
// from 45 degrees.
constexpr std::array<int, 3> kToU{191, 128, 238};
constexpr std::array<int, 3> kToV{128, 191, 238};

const std::array<int, 3>& codes(Lean lean) { return lean == Lean::U ? kToU : kToV; }

// 2 c - 1 along u, v and the normal.
Vec3d leaning_normal(Lean lean) {
  const auto& c = codes(lean);
  return Vec3d{2 * c[0] / 255.0 - 1, 2 * c[1] / 255.0 - 1, 2 * c[2] / 255.0 - 1};
}

// The objects all of whose triangles have directions along their coordinates.
std::set<int> objects_with_frames(const scene::Scene& scene) {
  std::map<int, bool> all;
  for (const auto& instance : scene.instances) {
    const scene::Mesh& mesh = mesh_of(scene, instance);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const int object = remapped(instance, mesh.triangle_materials[i]);
      bool& has_frames = all.try_emplace(object, true).first->second;
      has_frames = has_frames && scene::uv_frame(mesh, i).has_value();
    }
  }
  std::set<int> found;
  for (const auto& [object, has_frames] : all)
    if (has_frames) found.insert(object);
  return found;
}

// What the light is multiplied by, where the frame has these directions. Nothing of what lies along the view.
std::optional<double> ratio(
    const VisibleSurface& point, Vec3d to_eye, Vec3d along_u, Vec3d along_v, Lean lean) {
  constexpr double kLeastFacing = 0.1;  // silhouettes are near
  const scene::UvFrame frame{along_u, along_v, cast<double>(point.normal)};
  const Vec3d n = frame.normal;
  const auto t = tangent_across(frame, n);
  const double facing = dot(n, to_eye);
  if (!t || std::abs(facing) < kLeastFacing) return std::nullopt;
  const Vec3d b = cross(n, *t) * (is_mirrored(frame) ? -1.0 : 1.0);
  const Vec3d c = leaning_normal(lean);
  return std::max(0.0, dot(normalised(*t * c.x + b * c.y + n * c.z), to_eye) / facing);
}

// What many renderers leave of the light of a turned normal, so that it does not end at a line (Chiang, Li
// and Burley 2019, "Taming the shadow terminator", eq. 3); the geometric cosine over the two others is g.
double softened(double ratio, Lean lean) {
  const double g = std::min(1.0, 1 / std::max(1e-9, ratio * normalised(leaning_normal(lean)).z));
  return ratio * (-g * g * g + g * g + g);
}

// Where the mirror direction of the view at the turned normal lies below the surface or along it, renderers
// turn the normal back (Cycles, ensure_valid_reflection), and silhouettes are near.
bool reflects_upwards(double turned_cosine, double facing, Lean lean) {
  constexpr double kLeast = 0.15;
  return 2 * turned_cosine * normalised(leaning_normal(lean)).z - facing >= kLeast;
}

// How a frame may be wrong, and what the light is multiplied by then.
using Alternative = std::pair<const char*, double>;

struct Expected {
  double least = 0;
  double most = 0;
  double least_softened = 0;
  std::vector<Alternative> wrong;  // in the middle of the pixel
};

std::optional<Expected> expected_of(const scene::Scene& scene,
                                    std::span<const VisibleSurface> points,
                                    Pixel at,
                                    Lean lean) {
  const auto frame = scene::camera_frame(scene.camera);
  const Vec3d to_eye = -normalised(scene::camera_ray(scene.camera, frame, at.x + 0.5, at.y + 0.5).direction);
  Expected out{1e9, 0, 1e9, {}};
  for (const auto& point : points) {
    const double facing = std::abs(dot(cast<double>(point.normal), to_eye));
    const auto one = ratio(point, to_eye, cast<double>(point.along_u), cast<double>(point.along_v), lean);
    if (!one || !reflects_upwards(*one * facing, facing, lean)) return std::nullopt;
    out.least = std::min(out.least, *one);
    out.most = std::max(out.most, *one);
    out.least_softened = std::min(out.least_softened, softened(*one, lean));
  }
  const auto& middle = points[points.size() / 2];
  const Vec3d u = cast<double>(middle.along_u);
  const Vec3d v = cast<double>(middle.along_v);
  const auto add = [&](const char* what, Vec3d along_u, Vec3d along_v) {
    if (const auto one = ratio(middle, to_eye, along_u, along_v, lean)) out.wrong.emplace_back(what, *one);
  };
  add("u the other way", -u, v);
  add("v the other way", u, -v);
  add("u in the place of v", v, u);
  out.wrong.emplace_back("no lean", 1.0);
  return out;
}

bool are_near(double a, double b) { return std::abs(a - b) <= 0.05 + 0.1 * std::max(a, b); }

bool is_right(const Expected& expected, double seen) {
  return (seen >= expected.least_softened && seen <= expected.most) ||
         are_near(seen, expected.least_softened) || are_near(seen, expected.most);
}

std::string shown_instead(const Expected& expected, double seen) {
  for (const auto& [what, value] : expected.wrong)
    if (are_near(seen, value)) return fmt::format("{}: {:.2f} times the light", what, seen);
  return fmt::format("{:.2f} times the light", seen);
}

}  // namespace

void write_leaning_map(Lean lean, const std::filesystem::path& file) {
  auto image = image::make_image(2, 2, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<float>(codes(lean).at(i % 3)) / 255;
  image::write_png(image, file);
}

std::optional<scene::Scene> make_frames_pass(const ProbeScene& probe,
                                             const std::vector<VisibleSurface>& surfaces,
                                             const std::filesystem::path& map) {
  const auto framed = objects_with_frames(probe.scene);
  std::vector<double> depths_m;
  for (const auto& point : surfaces)
    if (framed.contains(point.object)) depths_m.push_back(point.depth_m);
  if (depths_m.empty()) return std::nullopt;
  const auto median = depths_m.begin() + std::ssize(depths_m) / 2;
  std::nth_element(depths_m.begin(), median, depths_m.end());
  scene::Scene out = probe.scene;
  if (!map.empty()) {
    out.textures = {{"leaning", map}};
    out.textures[0].encoding = scene::Encoding::Linear;
  }
  for (std::size_t i = 0; i < out.materials.size(); ++i) {
    out.materials[i].model = scene::Lambert{{1, 1, 1}, {}};
    if (!map.empty() && framed.contains(static_cast<int>(i)))
      out.materials[i].detail.normal_map = scene::NormalMap{{0, {}}, 1};
  }
  const double intensity = std::numbers::pi * *median * *median;  // about 1 in the image
  out.lights = {{"eye",
                 scene::PointShape{},
                 {intensity, intensity, intensity},
                 translation(out.camera.position_m),
                 {}}};
  return out;
}

ProbeFindings compare_frames(const ProbeScene& probe,
                             const std::vector<VisibleSurface>& surfaces,
                             const image::Image& plain,
                             const image::Image& leaning,
                             Lean lean) {
  constexpr float kLeastLight = 0.01F;
  const auto framed = objects_with_frames(probe.scene);
  std::vector<Suspect> suspects;
  ProbeFindings findings;
  const auto channel = static_cast<std::size_t>(image::channel_index(plain, "G"));
  const auto other = static_cast<std::size_t>(image::channel_index(leaning, "G"));
  const std::size_t each = surfaces.size() / plain.pixel_count();
  for (int y = 0; y < plain.height; ++y)
    for (int x = 0; x < plain.width; ++x) {
      const auto pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(plain.width) + static_cast<std::size_t>(x);
      const auto points = std::span(surfaces).subspan(pixel * each, each);
      const auto object = only_object(points);
      if (!object || !framed.contains(*object) || plain.at(x, y, channel) < kLeastLight) continue;
      const auto expected = expected_of(probe.scene, points, {x, y}, lean);
      if (!expected || expected->most - expected->least > 0.1) continue;
      const auto mirrored = expected->wrong.at(lean == Lean::U ? 0 : 1).second;
      if (is_right(*expected, mirrored)) continue;
      ++findings.compared;
      const double seen = static_cast<double>(leaning.at(x, y, other)) / plain.at(x, y, channel);
      if (!is_right(*expected, seen)) suspects.push_back({*object, {x, y}, shown_instead(*expected, seen)});
    }
  findings.mismatches = mismatches_of(probe, std::move(suspects));
  return findings;
}

}  // namespace orbs::studies
