#include "scene/geometry/generators/box.h"

#include "scene/geometry/mesh.h"

namespace orbs::scene {

namespace {

/// One face of the cube [-1, 1]^3.
struct Face {
  Vec3d normal;
  std::array<Vec3d, 4> corners;
  std::array<Vec2d, 4> uvs;
  std::array<std::array<std::uint32_t, 3>, 2> triangles;  // of corners
};

constexpr std::array<Vec2d, 4> kPlainUv{Vec2d{0, 0}, Vec2d{0, 1}, Vec2d{1, 1}, Vec2d{1, 0}};
constexpr std::array<Vec2d, 4> kMirroredUv{Vec2d{1, 0}, Vec2d{1, 1}, Vec2d{0, 1}, Vec2d{0, 0}};
using FaceTriangles = std::array<std::array<std::uint32_t, 3>, 2>;

constexpr std::array<Face, 6> kFaces{Face{{0, -1, 0},
                                          {{{-1, -1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, -1, -1}}},
                                          kPlainUv,
                                          FaceTriangles{{{0, 2, 1}, {0, 3, 2}}}},
                                     Face{{0, 1, 0},
                                          {{{-1, 1, -1}, {-1, 1, 1}, {1, 1, 1}, {1, 1, -1}}},
                                          kMirroredUv,
                                          FaceTriangles{{{0, 1, 2}, {0, 2, 3}}}},
                                     Face{{0, 0, -1},
                                          {{{-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {1, -1, -1}}},
                                          kPlainUv,
                                          FaceTriangles{{{0, 1, 2}, {0, 2, 3}}}},
                                     Face{{0, 0, 1},
                                          {{{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1}}},
                                          kPlainUv,
                                          FaceTriangles{{{0, 3, 2}, {0, 2, 1}}}},
                                     Face{{-1, 0, 0},
                                          {{{-1, -1, -1}, {-1, -1, 1}, {-1, 1, 1}, {-1, 1, -1}}},
                                          kPlainUv,
                                          FaceTriangles{{{0, 1, 2}, {0, 2, 3}}}},
                                     Face{{1, 0, 0},
                                          {{{1, -1, -1}, {1, -1, 1}, {1, 1, 1}, {1, 1, -1}}},
                                          kPlainUv,
                                          FaceTriangles{{{0, 3, 2}, {0, 2, 1}}}}};
constexpr std::size_t kFaceAtMinusZ = 2;

void add_face(Mesh& mesh, const Face& face, double half_size_m, double normal_sign) {
  const std::uint32_t first = vertex_count(mesh);
  for (std::size_t i = 0; i < 4; ++i)
    add_vertex(mesh, face.corners[i] * half_size_m, face.normal * normal_sign, face.uvs[i]);
  for (const auto& t : face.triangles) mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

}  // namespace

Mesh make_plane(const PlaneParameters& parameters) {
  const double a = parameters.half_size_m;
  Mesh mesh;
  add_vertex(mesh, {-a, 0, -a}, {0, 1, 0}, {0, 0});
  add_vertex(mesh, {a, 0, -a}, {0, 1, 0}, {1, 0});
  add_vertex(mesh, {a, 0, a}, {0, 1, 0}, {1, 1});
  add_vertex(mesh, {-a, 0, a}, {0, 1, 0}, {0, 1});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

Mesh make_cube(const CubeParameters& parameters) {
  Mesh mesh;
  for (const Face& face : kFaces) add_face(mesh, face, parameters.half_size_m, 1);
  return mesh;
}

Mesh make_cube_open(const CubeParameters& parameters) {
  Mesh mesh;
  for (std::size_t i = 0; i < kFaces.size(); ++i)
    if (i != kFaceAtMinusZ) add_face(mesh, kFaces[i], parameters.half_size_m, -1);
  return mesh;
}

}  // namespace orbs::scene
