#include "tracer_cli/faulty_program.h"

#include "image/reduced_precision.h"
#include "plugins/flush_to_zero.h"
#include "tracer/numeric_fault.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace orbs::tracer_cli {

namespace {

using tracer::has_fault;
using tracer::NumericFault;

Vec3d corner(const scene::Mesh& mesh, std::size_t triangle, std::size_t i) {
  return cast<double>(mesh.positions[mesh.triangles[triangle][i]]);
}

// Twice the area.
double area_of(const scene::Mesh& mesh, std::size_t triangle) {
  const Vec3d p = corner(mesh, triangle, 0);
  return length(cross(corner(mesh, triangle, 1) - p, corner(mesh, triangle, 2) - p));
}

// Each triangle gets corners of its own, which are moved towards its middle.
void crack(scene::Mesh& mesh) {
  constexpr double kUncovered = 1e-5;
  scene::Mesh cracked = mesh;
  cracked.positions.clear();
  cracked.normals.clear();
  cracked.uvs.clear();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Vec3d middle = (corner(mesh, t, 0) + corner(mesh, t, 1) + corner(mesh, t, 2)) / 3;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto vertex = mesh.triangles[t][i];
      const Vec3d at = corner(mesh, t, i);
      cracked.triangles[t][i] = static_cast<std::uint32_t>(cracked.positions.size());
      cracked.positions.push_back(cast<float>(at + (middle - at) * kUncovered));
      cracked.normals.push_back(mesh.normals[vertex]);
      if (!mesh.uvs.empty()) cracked.uvs.push_back(mesh.uvs[vertex]);
    }
  }
  mesh = std::move(cracked);
}

void drop_thin_triangles(scene::Mesh& mesh) {
  constexpr double kLeastShare = 1e-5;
  scene::Mesh kept = mesh;
  kept.triangles.clear();
  kept.triangle_materials.clear();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
      longest = std::max(longest, length(corner(mesh, t, i) - corner(mesh, t, (i + 1) % 3)));
    if (area_of(mesh, t) < kLeastShare * longest * longest) continue;
    kept.triangles.push_back(mesh.triangles[t]);
    kept.triangle_materials.push_back(mesh.triangle_materials[t]);
  }
  // A mesh of needles alone is left out as a whole; a scene must not be empty of triangles.
  if (!kept.triangles.empty())
    mesh = std::move(kept);
  else
    for (auto& position : mesh.positions) position = mesh.positions.front();
}

void turn_normals(scene::Mesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (area_of(mesh, t) == 0)
      for (const auto vertex : mesh.triangles[t]) mesh.normals[vertex] = {0, 0, 1};
}

}  // namespace

std::vector<std::string> numeric_fault_names() {
  std::vector<std::string> names;
  for (const auto& one : tracer::kNumericFaults) names.emplace_back(one.name);
  return names;
}

void begin_numeric_fault(const std::string& name) {
  for (const auto& one : tracer::kNumericFaults)
    if (one.name == name) tracer::active_fault = one.fault;
  // Threads take over the flags of the one that starts them.
  if (has_fault(NumericFault::DenormalsFlushed)) tests::flush_small_numbers();
}

scene::Scene as_kept(scene::Scene scene) {
  for (auto& mesh : scene.meshes) {
    if (has_fault(NumericFault::CrackedEdges)) crack(mesh);
    if (has_fault(NumericFault::ThinTrianglesDropped)) drop_thin_triangles(mesh);
    if (has_fault(NumericFault::EmptyTrianglesTurnNormals)) turn_normals(mesh);
  }
  return scene;
}

image::Image as_written(image::Image image) {
  if (has_fault(NumericFault::HalfFloats))
    for (auto& value : image.pixels) value = image::float_of_half(image::half_bits(value));
  return image;
}

}  // namespace orbs::tracer_cli
