#include "importer/vertices.h"

#include "scene/load/entry.h"

#include <cmath>
#include <numeric>

namespace orbs::importer {

namespace {

std::string attribute_place(const std::string& attribute, const std::string& where) {
  return fmt::format("{} of {}", attribute, where);
}

Vec3d vector_at(const Numbers& numbers, std::size_t index) {
  const double* v = numbers.element(index);
  return {v[0], v[1], v[2]};
}

// An attribute of as many elements as there are vertices.
std::optional<Numbers> attribute(const Source& source,
                                 const std::map<std::string, int>& attributes,
                                 const std::string& name,
                                 std::size_t width,
                                 std::size_t count,
                                 const std::string& where) {
  const auto found = attributes.find(name);
  if (found == attributes.end()) return std::nullopt;
  auto numbers = read_numbers(source, found->second, width, attribute_place(name, where));
  if (numbers.count != count)
    refuse(source, fmt::format("{} has {} elements, and there are {} positions; each needs one",
                               attribute_place(name, where), numbers.count, count));
  return numbers;
}

void check_places(const Source& source, const std::vector<Vec3d>& positions, const std::string& where) {
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (!is_finite(positions[i]) || largest_magnitude(positions[i]) > scene::kFarthest_m)
      refuse(source,
             fmt::format("POSITION of {}: vertex {} is at ({}, {}, {}); expected metres within {:g}", where,
                         i, positions[i].x, positions[i].y, positions[i].z, scene::kFarthest_m));
}

// Adds so much of each target as the pose says.
void morph(const Source& source,
           const tinygltf::Primitive& primitive,
           const std::vector<double>& weights,
           const std::string& where,
           Vertices& vertices) {
  for (std::size_t t = 0; t < std::min(weights.size(), primitive.targets.size()); ++t) {
    if (weights[t] == 0) continue;
    const auto place = fmt::format("morph target {} of {}", t, where);
    const auto add = [&](const char* name, std::vector<Vec3d>& to) {
      const auto change = attribute(source, primitive.targets[t], name, 3, to.size(), place);
      for (std::size_t i = 0; change && i < to.size(); ++i) to[i] += vector_at(*change, i) * weights[t];
    };
    add("POSITION", vertices.positions);
    if (!vertices.normals.empty()) add("NORMAL", vertices.normals);
  }
}

Mat4 blended(const Source& source,
             const std::vector<Mat4>& joints,
             const double* numbers,
             const double* weights,
             const std::string& where) {
  Mat4 sum;
  sum.m.fill(0);
  double total = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    if (weights[k] == 0) continue;
    if (!(numbers[k] >= 0 && numbers[k] < static_cast<double>(joints.size())))
      refuse(source,
             fmt::format("JOINTS_0 of {} names joint {}; its skin has {}", where, numbers[k], joints.size()));
    const Mat4& joint = joints[static_cast<std::size_t>(numbers[k])];
    for (std::size_t i = 0; i < 16; ++i) sum.m[i] += weights[k] * joint.m[i];
    total += weights[k];
  }
  if (total == 0) return {};
  for (double& entry : sum.m) entry /= total;
  return sum;
}

void skin(const Source& source,
          const tinygltf::Primitive& primitive,
          const std::vector<Mat4>& joints,
          const std::string& where,
          Vertices& vertices) {
  const auto count = vertices.positions.size();
  const auto numbers = attribute(source, primitive.attributes, "JOINTS_0", 4, count, where);
  const auto weights = attribute(source, primitive.attributes, "WEIGHTS_0", 4, count, where);
  if (!numbers || !weights)
    refuse(source, where + " has a skin, but its vertices have no JOINTS_0 and WEIGHTS_0");
  for (std::size_t i = 0; i < count; ++i) {
    const Mat4 matrix = blended(source, joints, numbers->element(i), weights->element(i), where);
    vertices.positions[i] = transform_point(matrix, vertices.positions[i]);
    vertices.tangents[i] = transform_direction(matrix, vertices.tangents[i]);
    if (vertices.normals.empty()) continue;
    const auto back = inverse(matrix);
    vertices.normals[i] = back ? transform_normal(*back, vertices.normals[i])
                               : transform_direction(matrix, vertices.normals[i]);
  }
}

// v is 0 in the bottom row. All zero if the primitive has no such set.
std::vector<Vec2f> read_uvs(const Source& source,
                            const tinygltf::Primitive& primitive,
                            int set,
                            std::size_t count,
                            const std::string& where) {
  std::vector<Vec2f> uvs(count);
  const auto name = fmt::format("TEXCOORD_{}", set);
  const auto numbers = attribute(source, primitive.attributes, name, 2, count, where);
  if (!numbers) return uvs;
  for (std::size_t i = 0; i < count; ++i) {
    const double* uv = numbers->element(i);
    if (!std::isfinite(uv[0]) || !std::isfinite(uv[1]))
      refuse(source, fmt::format("{}: vertex {} has ({}, {}); expected finite numbers",
                                 attribute_place(name, where), i, uv[0], uv[1]));
    uvs[i] = {static_cast<float>(uv[0]), static_cast<float>(1 - uv[1])};
  }
  return uvs;
}

}  // namespace

Vertices read_vertices(const Source& source,
                       const tinygltf::Primitive& primitive,
                       const Pose& pose,
                       const UvSets& sets,
                       const std::string& where) {
  Vertices vertices;
  const auto positions =
      read_numbers(source, primitive.attributes.at("POSITION"), 3, attribute_place("POSITION", where));
  for (std::size_t i = 0; i < positions.count; ++i) vertices.positions.push_back(vector_at(positions, i));
  const auto normals = attribute(source, primitive.attributes, "NORMAL", 3, positions.count, where);
  for (std::size_t i = 0; normals && i < positions.count; ++i)
    vertices.normals.push_back(vector_at(*normals, i));
  vertices.tangents.resize(positions.count);
  const auto tangents = attribute(source, primitive.attributes, "TANGENT", 4, positions.count, where);
  for (std::size_t i = 0; tangents && i < positions.count; ++i)
    if (const Vec3d tangent = vector_at(*tangents, i); is_finite(tangent)) vertices.tangents[i] = tangent;
  vertices.tangent_sides.resize(positions.count, 1);
  for (std::size_t i = 0; tangents && i < positions.count; ++i)
    vertices.tangent_sides[i] = tangents->element(i)[3] < 0 ? -1 : 1;
  vertices.uvs = read_uvs(source, primitive, sets.colour, positions.count, where);
  vertices.map_uvs =
      sets.map == sets.colour ? vertices.uvs : read_uvs(source, primitive, sets.map, positions.count, where);
  if (sets.second) vertices.second_uvs = read_uvs(source, primitive, *sets.second, positions.count, where);
  morph(source, primitive, pose.weights, where, vertices);
  if (!pose.joints.empty()) skin(source, primitive, pose.joints, where, vertices);
  check_places(source, vertices.positions, where);
  return vertices;
}

std::vector<std::array<std::uint32_t, 3>> read_triangles(const Source& source,
                                                         const tinygltf::Primitive& primitive,
                                                         std::size_t vertices,
                                                         const std::string& where) {
  std::vector<std::uint32_t> corners(primitive.indices < 0 ? vertices : 0);
  std::iota(corners.begin(), corners.end(), 0U);
  if (primitive.indices >= 0)
    corners = read_indices(source, primitive.indices, vertices, "the indices of " + where);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const bool is_list = primitive.mode == TINYGLTF_MODE_TRIANGLES;
  if (is_list && corners.size() % 3 != 0)
    refuse(source, fmt::format("{} has {} corners of triangles: no multiple of 3", where, corners.size()));
  for (std::size_t i = 2; i < corners.size(); i += is_list ? 3 : 1) {
    if (primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN)
      triangles.push_back({corners[i - 1], corners[i], corners[0]});
    else if (is_list || i % 2 == 0)
      triangles.push_back({corners[i - 2], corners[i - 1], corners[i]});
    else  // every other triangle of a strip runs the other way round (3.7.2.1)
      triangles.push_back({corners[i - 2], corners[i], corners[i - 1]});
  }
  return triangles;
}

}  // namespace orbs::importer
