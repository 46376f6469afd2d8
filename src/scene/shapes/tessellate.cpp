#include "scene/shapes/tessellate.h"

#include "scene/geometry/generators.h"
#include "scene/geometry/mesh.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include <fmt/format.h>

namespace orbs::scene {

namespace {

constexpr int kBands = kShapeSegments / 2;

double turn_rad(int part) { return 2 * std::numbers::pi * part / kShapeSegments; }

// A circle of a surface that turns about y, with the normal in the plane of the axis.
struct Ring {
  double y = 0;
  double radius = 0;
  double normal_out = 0;
  double normal_up = 1;
  double v = 0;
};

// Surfaces between rings, from above to below.
void add_rings(Mesh& mesh, const std::vector<Ring>& rings) {
  const auto first = vertex_count(mesh);
  for (const Ring& ring : rings)
    for (int j = 0; j <= kShapeSegments; ++j) {
      const double phi = turn_rad(j % kShapeSegments);  // the seam's two columns coincide to the bit
      const Vec3d out{std::sin(phi), 0, std::cos(phi)};
      add_vertex(mesh, out * ring.radius + Vec3d{0, ring.y, 0},
                 normalised(out * ring.normal_out + Vec3d{0, ring.normal_up, 0}),
                 {double(j) / kShapeSegments, ring.v});
    }
  add_grid_triangles(mesh, first, static_cast<int>(rings.size()) - 1, kShapeSegments);
}

void add_cap(Mesh& mesh, double y, double radius, bool is_top) {
  if (radius <= 0) return;
  const double up = is_top ? 1 : -1;
  const Ring centre{y, 0, 0, up, 0};
  const Ring rim{y, radius, 0, up, 1};
  add_rings(mesh, is_top ? std::vector{centre, rim} : std::vector{rim, centre});
}

double radius_at(const RevolvedQuadric& q, double y) {
  return std::sqrt(std::max(0.0, q.a + y * (q.b + y * q.c)));
}

// The side between the heights, from the top; the gradient of x^2 + z^2 - a - b y - c y^2 is its normal.
void add_side(Mesh& mesh, const RevolvedQuadric& q, const std::vector<double>& heights) {
  std::vector<Ring> rings;
  for (const double y : heights) {
    const double radius = radius_at(q, y);
    Ring ring{y, radius, radius, -(q.b / 2 + q.c * y), (y - q.y_low) / (q.y_high - q.y_low)};
    // At an apex the gradient is zero or along the axis; a cone's side has the normal of all its heights.
    if (radius == 0 && q.c > 0) ring = {y, 0, 1, q.b > 0 ? -std::sqrt(q.c) : std::sqrt(q.c), ring.v};
    rings.push_back(ring);
  }
  add_rings(mesh, rings);
}

std::vector<double> even_heights(const RevolvedQuadric& q, int bands) {
  std::vector<double> heights;
  for (int i = 0; i <= bands; ++i) heights.push_back(q.y_high + (q.y_low - q.y_high) * i / bands);
  return heights;
}

Mesh revolve(const RevolvedQuadric& q, const std::vector<double>& heights) {
  Mesh mesh;
  if (q.has_caps) add_cap(mesh, q.y_high, radius_at(q, q.y_high), true);
  add_side(mesh, q, heights);
  if (q.has_caps) add_cap(mesh, q.y_low, radius_at(q, q.y_low), false);
  return mesh;
}

// Sines of multiples of pi are some 1e-16 and not 0, of which small powers are far from 0.
double signed_power(double x, double exponent) {
  const double magnitude = std::abs(x) < 1e-12 ? 0 : std::abs(x);
  return std::copysign(std::pow(magnitude, exponent), x);
}

struct Tessellation {
  std::optional<Mesh> operator()(const SphereForm& f) const {
    Mesh mesh = make_sphere({f.radius_m, kShapeSegments});
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const std::size_t band = i / (kShapeSegments + 1);
      mesh.uvs[i].y = 1 - static_cast<float>(band) / kBands;
      mesh.positions[i] = cast<float>(cast<double>(mesh.positions[i]) + f.centre_m);
    }
    return mesh;
  }
  std::optional<Mesh> operator()(const CylinderForm& f) const {
    const auto q = revolved(f);
    return revolve(q, even_heights(q, 1));
  }
  std::optional<Mesh> operator()(const ConeForm& f) const {
    const auto q = revolved(f);
    return revolve(q, even_heights(q, 1));
  }
  std::optional<Mesh> operator()(const DiskForm& f) const {
    Mesh mesh;
    add_cap(mesh, 0, f.radius_m, true);
    return mesh;
  }
  std::optional<Mesh> operator()(const ParaboloidForm& f) const {
    std::vector<double> heights;  // of even radii
    for (int i = kBands; i >= 0; --i) heights.push_back(f.height_m * i * i / (kBands * kBands));
    return revolve(revolved(f), heights);
  }
  std::optional<Mesh> operator()(const HyperboloidForm& f) const {
    const auto q = revolved(f);
    return revolve(q, even_heights(q, kBands));
  }
  std::optional<Mesh> operator()(const BoxForm& f) const;
  std::optional<Mesh> operator()(const TorusForm& f) const;
  std::optional<Mesh> operator()(const SuperellipsoidForm& f) const;
  std::optional<Mesh> operator()(const HalfSpaceForm&) const { return std::nullopt; }
  std::optional<Mesh> operator()(const ImplicitForm&) const { return std::nullopt; }
  std::optional<Mesh> operator()(const PluginForm&) const { return std::nullopt; }
  std::optional<Mesh> operator()(const CsgForm&) const { return std::nullopt; }
};

// Texture coordinates run with the two other axes in their order: those of the faces of x with z and y.
std::optional<Mesh> Tessellation::operator()(const BoxForm& f) const {
  constexpr std::array kNormals{Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}};
  constexpr std::array kRows{Vec3d{0, 1, 0}, Vec3d{0, 0, 1}, Vec3d{1, 0, 0}};
  Mesh mesh;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const auto first = vertex_count(mesh);
      const Vec3d normal = kNormals[axis] * side;
      const Vec3d along = kRows[axis];
      const Vec3d across = cross(normal, along);
      for (const double i : {-1.0, 1.0})
        for (const double j : {-1.0, 1.0}) {
          const Vec3d p = normal + along * i + across * j;
          const double u = axis == 0 ? p.z : p.x;
          const double v = axis == 1 ? p.z : p.y;
          add_vertex(mesh, p * f.half_sizes_m, normal, {(u + 1) / 2, (v + 1) / 2});
        }
      add_grid_triangles(mesh, first, 1, 1);
    }
  return mesh;
}

std::optional<Mesh> Tessellation::operator()(const TorusForm& f) const {
  Mesh mesh;
  for (int i = 0; i <= kShapeSegments; ++i)
    for (int j = 0; j <= kShapeSegments; ++j) {
      const double ring = turn_rad(i % kShapeSegments);
      const double tube = turn_rad(j % kShapeSegments);
      const Vec3d out{std::sin(ring), 0, std::cos(ring)};
      const Vec3d normal = out * std::cos(tube) + Vec3d{0, std::sin(tube), 0};
      add_vertex(mesh, out * f.major_radius_m + normal * f.minor_radius_m, normal,
                 {double(i) / kShapeSegments, double(j) / kShapeSegments});
    }
  add_grid_triangles(mesh, 0, kShapeSegments, kShapeSegments);
  return mesh;
}

std::optional<Mesh> Tessellation::operator()(const SuperellipsoidForm& f) const {
  Mesh mesh;
  for (int i = 0; i <= kBands; ++i)
    for (int j = 0; j <= kShapeSegments; ++j) {
      const double polar = turn_rad(i);
      const double phi = turn_rad(j % kShapeSegments);
      const double out = std::sin(polar);
      const auto place = [&](double e, double n) {
        return Vec3d{signed_power(out, n) * signed_power(std::sin(phi), e), signed_power(std::cos(polar), n),
                     signed_power(out, n) * signed_power(std::cos(phi), e)};
      };
      const Vec3d p = place(f.east_west, f.north_south);
      const Vec3d normal = normalised(place(2 - f.east_west, 2 - f.north_south));
      const double around = std::atan2(p.x, p.z) / (2 * std::numbers::pi);
      const double u = j == kShapeSegments ? 1 : around - std::floor(around);
      add_vertex(mesh, p, normal, {u, 0.5 + std::asin(p.y / length(p)) / std::numbers::pi});
    }
  add_grid_triangles(mesh, 0, kBands, kShapeSegments);
  return mesh;
}

}  // namespace

std::optional<Mesh> tessellated(const ShapeForm& form) { return std::visit(Tessellation{}, form); }

void tessellate_shapes(Scene& scene, const char* level) {
  std::vector<Shape> kept;
  for (Shape& shape : scene.shapes) {
    auto mesh = level_of(shape.form) == std::string_view(level) ? tessellated(shape.form) : std::nullopt;
    if (!mesh) {
      kept.push_back(std::move(shape));
      continue;
    }
    mesh->name = fmt::format("shape {} as triangles", scene.meshes.size());
    mesh->triangle_materials.assign(mesh->triangles.size(), shape.material);
    scene.instances.push_back({shape.name, static_cast<int>(scene.meshes.size()), shape.matrix, {}});
    scene.meshes.push_back(std::move(*mesh));
  }
  scene.shapes = std::move(kept);
}

}  // namespace orbs::scene
