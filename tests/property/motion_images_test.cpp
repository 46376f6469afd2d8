// Motion in the tracer: rays against brute force, images against means of scenes at rest.
#include "property/hashed_numbers.h"
#include "property/light_images.h"
#include "scene/motion.h"
#include "tracer/accel/double_triangles.h"
#include "tracer/world/surface.h"

#include <algorithm>
#include <array>
#include <limits>

using namespace orbs;

namespace {

struct RenderOptions {
  int samples = 16;
  int threads = 0;
  std::uint64_t seed = 1;
  tracer::WorldSettings world{};
};

image::Image render_scene(const scene::Scene& scene, const RenderOptions& options) {
  const std::atomic<bool> never{false};
  const auto rendering =
      tracer::render(tracer::make_world(scene, options.world),
                     {.samples_per_pixel = options.samples, .seed = options.seed, .threads = options.threads},
                     never, [](const tracer::Progress&) {});
  EXPECT_EQ(rendering.bad_samples.count, 0U);
  return rendering.image;
}

scene::Scene read(const std::string& text) {
  return scene::load_scene_text("test.json", text, ORBS_SOURCE_DIR);
}

constexpr const char* kMaterials = R"("materials": [
    {"name": "grey", "type": "lambert", "reflectance": [0.6, 0.5, 0.4]},
    {"name": "mirror", "type": "mirror", "reflectance": [0.9, 0.9, 0.9]},
    {"name": "glass", "type": "glass", "ior": 1.5},
    {"name": "glow", "type": "emission", "radiance": [3, 2, 1]}],)";

// A block that turns and slides, a smooth octahedron that becomes slim and one that glows as it moves and
// changes its shape, a mirror at rest, on a ground under a lamp.
std::string busy_scene(const std::string& integrator = R"({"trace_depth": 4})",
                       const std::string& shutter = "[0.1, 0.9]",
                       const std::string& more = "",
                       const std::string& camera = "") {
  const std::string octahedron =
      R"("positions": [0.4, 0, 0, -0.4, 0, 0, 0, 0.4, 0, 0, -0.4, 0, 0, 0, 0.4, 0, 0, -0.4],
    "normals": [1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1],
    "triangles": [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5],
    "end": {"positions": [0.2, 0, 0, -0.2, 0, 0, 0, 0.9, 0, 0, -0.3, 0, 0, 0.1, 0.3, 0, 0, -0.3],
            "normals": [1, 1, 0, -1, 0.5, 0, 0, 1, 0.3, 0, -1, 0, 0, 0, 1, 0.2, 0, -1]})";
  return R"({"format": "orbs-scene/1", "name": "busy", "camera": {"position": [0.5, 2, 4], "look_at": [0, 0.4, 0],
    "fov_y": 45, "width": 24, "height": 24, "shutter": )" +
         shutter + camera + R"(}, "integrator": )" + integrator + ", " + kMaterials + R"(
    "meshes": [{"name": "ground", "generator": "plane", "half_size": 4, "material": "grey"},
               {"name": "block", "generator": "cube", "half_size": 0.3, "material": "grey"},
               {"name": "wall", "generator": "plane", "half_size": 1, "material": "mirror"},
               {"name": "slim", "material": "grey", )" +
         octahedron + R"(}, {"name": "coal", "material": "glow", )" + octahedron + R"(}],
    "instances": [{"mesh": "ground"},
      {"mesh": "block", "matrix": [{"translate": [-1, 0.5, 0.3]}],
       "end_matrix": [{"translate": [0.2, 0.4, 0.6]}, {"rotate_y": 70}, {"scale": [1, 0.6, 1.2]}]},
      {"mesh": "block", "matrix": [{"translate": [1.4, 0.3, 0.3]}, {"rotate_y": 20}]},
      {"mesh": "wall", "matrix": [{"translate": [0, 1, -1]}, {"rotate_x": 90}]},
      {"mesh": "slim", "matrix": [{"translate": [0.8, 0.5, 0.5]}, {"scale": [1, 1.3, 0.8]}]},
      {"mesh": "coal", "matrix": [{"translate": [-0.5, 1.3, -0.3]}, {"scale": 0.4}],
       "end_matrix": [{"translate": [0.5, 1.4, 0.2]}, {"rotate_x": 50}, {"scale": 0.5}]}],
    "lights": [{"type": "rect", "half_width": 0.5, "half_length": 0.5, "radiance": [8, 8, 8],
                "matrix": [{"translate": [0.5, 3, 0.5]}]}])" +
         more + "}";
}

// Of the means of the two images over tiles of 8 x 8 pixels: the largest difference, relative to those of
// `a`.
double largest_tile_difference(const image::Image& a, const image::Image& b) {
  constexpr int kTile = 8;
  double largest = 0;
  for (int y = 0; y < a.height; y += kTile)
    for (int x = 0; x < a.width; x += kTile)
      for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0;
        double size = 0;
        for (int j = 0; j < kTile; ++j)
          for (int i = 0; i < kTile; ++i) {
            sum += static_cast<double>(a.at(x + i, y + j, c)) - static_cast<double>(b.at(x + i, y + j, c));
            size += static_cast<double>(a.at(x + i, y + j, c));
          }
        largest = std::max(largest, std::abs(sum) / size);
      }
  return largest;
}

// The mean of the scenes at rest in the middles of equal parts of the time that the shutter is open.
image::Image mean_of_instants(const scene::Scene& scene, int count, RenderOptions options) {
  image::Image mean;
  for (int i = 0; i < count; ++i) {
    const auto& [open, close] = scene.camera.shutter;
    options.seed = static_cast<std::uint64_t>(100 + i);
    const auto one = render_scene(scene::at_time(scene, open + (close - open) * (i + 0.5) / count), options);
    if (i == 0) mean = one;
    if (i > 0)
      for (std::size_t k = 0; k < mean.pixels.size(); ++k) mean.pixels[k] += one.pixels[k];
  }
  for (float& value : mean.pixels) value /= static_cast<float>(count);
  return mean;
}

// Embree's hit of every ray must be the nearest triangle of the scene at rest at the time of the ray.
struct NearestTriangle {
  double distance = std::numeric_limits<double>::infinity();
  std::uint32_t object = tracer::kNoHit;
  std::uint32_t primitive = 0;
  Vec3d geometric_normal;
  Vec3d shading_normal;
};

NearestTriangle nearest_triangle(const scene::Scene& scene, const tracer::Ray& ray) {
  const auto now = scene::at_time(scene, static_cast<double>(ray.time));
  NearestTriangle nearest;
  for (std::size_t i = 0; i < now.instances.size(); ++i) {
    const auto& mesh = mesh_of(now, now.instances[i]);
    const Mat4& matrix = now.instances[i].matrix;
    const Mat4 back = inverse(matrix).value();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      tracer::DoubleTriangle triangle;
      std::array<Vec3d, 3> normals;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto vertex = mesh.triangles[t][k];
        triangle.corners[k] = transform_point(matrix, cast<double>(mesh.positions[vertex]));
        normals[k] = normalised(transform_normal(back, cast<double>(mesh.normals[vertex])));
      }
      const auto hit = tracer::intersect(triangle, cast<double>(ray.origin), cast<double>(ray.direction), 0,
                                         nearest.distance);
      if (!hit) continue;
      const auto& [a, b, c] = triangle.corners;
      nearest = {hit->distance, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(t),
                 normalised(cross(b - a, c - a)),
                 normalised(normals[0] * (1 - hit->uv[0] - hit->uv[1]) + normals[1] * hit->uv[0] +
                            normals[2] * hit->uv[1])};
    }
  }
  return nearest;
}

void expect_hits_of_brute_force(const scene::Scene& scene, tracer::Intersection intersection) {
  const auto world = tracer::make_world(scene, {.intersection = intersection});
  std::vector<tracer::Ray> rays;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const auto number = [&](std::uint64_t d) { return 2 * tests::uniform(i, d) - 1; };
    const Vec3f origin{4 * number(0), 2 + 1.9F * number(1), 4 * number(2)};
    const Vec3f target{1.5F * number(3), 0.6F + 0.8F * number(4), 1.2F * number(5)};
    rays.push_back({.origin = origin,
                    .direction = normalised(target - origin),
                    .time = i % 16 == 0   ? 1
                            : i % 16 == 1 ? 0
                                          : tests::uniform(i, 6)});
  }
  std::vector<tracer::Hit> hits(rays.size());
  std::vector<std::uint8_t> blocked(rays.size());
  world.accel->intersect(rays, hits);
  world.accel->occluded(rays, blocked);
  int moving = 0;
  int edges = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto expected = nearest_triangle(scene, rays[i]);
    // The lamp is no mesh; at an edge rounding may decide between two triangles.
    if (hits[i].object < world.objects.size() &&
        world.objects[hits[i].object].kind == tracer::ObjectKind::Light)
      continue;
    const bool is_same = hits[i].object == expected.object &&
                         (expected.object == tracer::kNoHit || hits[i].primitive == expected.primitive);
    if (!is_same) {
      ++edges;
      continue;
    }
    EXPECT_EQ(blocked[i] != 0, expected.object != tracer::kNoHit);
    if (expected.object == tracer::kNoHit) continue;
    EXPECT_NEAR(hits[i].distance, expected.distance, 1e-4) << i;
    if (world.objects[hits[i].object].kind != tracer::ObjectKind::MovingMesh) continue;
    ++moving;
    const auto point = tracer::surface_point(world, rays[i], hits[i]);
    const Vec3d place = cast<double>(rays[i].origin) + cast<double>(rays[i].direction) * expected.distance;
    EXPECT_LT(std::abs(dot(cast<double>(point.position) - place, expected.geometric_normal)),
              static_cast<double>(point.position_error))
        << i;
    EXPECT_LT(largest_magnitude(cast<double>(point.position) - place), 1e-4) << i;
    EXPECT_GT(std::abs(dot(cast<double>(point.geometric_normal), expected.geometric_normal)), 1 - 1e-5) << i;
    EXPECT_LT(largest_magnitude(cast<double>(point.shading_normal) - expected.shading_normal), 2e-4) << i;
  }
  EXPECT_GT(moving, 500);
  EXPECT_LT(edges, 4);
}

}  // namespace

TEST(Motion, RaysMeetWhatIsThereAtTheirTime) {
  const auto scene = read(busy_scene());
  expect_hits_of_brute_force(scene, tracer::Intersection::Single);
  expect_hits_of_brute_force(scene, tracer::Intersection::Double);
}

// With lights, mirrors, interreflection, emitters that move and every integrator that takes motion. Noise
// leaves tiles within 2 %.
TEST(Motion, ImagesAreMeansOfInstants) {
  for (const char* integrator :
       {R"({"trace_depth": 4})", R"({"type": "ambient_occlusion", "distance": 1})"}) {
    const auto scene = read(busy_scene(integrator));
    const auto moving = render_scene(scene, {.samples = 2048});
    const auto mean = mean_of_instants(scene, 32, {.samples = 64});
    EXPECT_LT(largest_tile_difference(moving, mean), 0.02) << integrator;
    // What two seeds of half the samples differ by is below 0.01.
    EXPECT_GT(largest_tile_difference(moving, render_scene(scene::at_time(scene, 0.1), {.samples = 512})),
              0.03);
  }
}

// One that turns, rolls and comes nearer, alone and with all else; and one from so far that its rays are made
// in double precision. It looks down: above the horizon tiles would be black but for a sliver of ground.
// Edges sweep over many pixels, so there are many instants.
TEST(Motion, ImagesOfAMovingCameraAreMeansOfInstants) {
  const std::string turns =
      R"(, "end": {"position": [0.9, 2.4, 3.2], "look_at": [-0.3, 0.2, 0], "up": [0.4, 1, 0]})";
  auto scene = read(busy_scene(R"({"trace_depth": 2})", "[0.2, 0.9]", "", turns));
  ASSERT_TRUE(scene.camera.end);
  const auto expect_mean = [](const scene::Scene& moving) {
    const auto image = render_scene(moving, {.samples = 4096});
    EXPECT_LT(largest_tile_difference(image, mean_of_instants(moving, 256, {.samples = 16})), 0.02);
    EXPECT_GT(largest_tile_difference(image, render_scene(scene::at_time(moving, 0.2), {.samples = 512})),
              0.03);
  };
  expect_mean(scene);
  for (auto& instance : scene.instances) instance.end_matrix.reset();
  for (auto& mesh : scene.meshes) mesh.end.reset();
  expect_mean(scene);
  const auto far = [](Vec3d& position) { position = position * 50; };
  far(scene.camera.position_m);
  far(scene.camera.end->position_m);
  scene.camera.fov_y_deg = 1;
  expect_mean(scene);
}

TEST(Motion, TransportsSeeOneTimeOnAPath) {
  const auto scene = read(
      busy_scene(R"({"trace_depth": 2})", "[0, 1]",
                 R"(, "environment": {"spectrum": "a"}, "spectra": [{"name": "a", "illuminant": "A"}])"));
  const auto moving = render_scene(scene, {.samples = 2048});
  EXPECT_LT(largest_tile_difference(moving, mean_of_instants(scene, 32, {.samples = 64})), 0.02);
}

TEST(Motion, ImagesDoNotDependOnThreadsOrTheTestOfTriangles) {
  const auto scene = read(busy_scene());
  const auto one = render_scene(scene, {.samples = 8, .threads = 1});
  EXPECT_EQ(one.pixels, render_scene(scene, {.samples = 8, .threads = 3}).pixels);
  const auto with_double =
      render_scene(scene, {.samples = 8, .world = {.intersection = tracer::Intersection::Double}});
  EXPECT_LT(largest_tile_difference(one, with_double), 0.01);
}

// The time is a set of random numbers of its own: what rests looks, sample by sample, as if nothing moved.
// The mover is locked in a box.
TEST(Motion, WhatRestsKeepsItsSamples) {
  const auto text = [](const char* end) {
    return R"({"format": "orbs-scene/1", "name": "s", "camera": {"position": [0.5, 2, 4], "look_at": [0, 0.4, 0],
    "fov_y": 45, "width": 24, "height": 24, "shutter": [0, 1]}, "integrator": {"trace_depth": 4},)" +
           std::string(kMaterials) + R"(
    "meshes": [{"name": "ground", "generator": "plane", "half_size": 4, "material": "grey"},
               {"name": "block", "generator": "cube", "half_size": 0.5, "material": "grey"},
               {"name": "sheet", "generator": "plane", "half_size": 0.1, "material": "grey"}],
    "instances": [{"mesh": "ground"}, {"mesh": "block", "matrix": [{"translate": [0, 0.7, 0]}]},
                  {"mesh": "sheet", "matrix": [{"translate": [0, 0.6, 0]}])" +
           std::string(end) + R"(}],
    "lights": [{"type": "rect", "half_width": 0.5, "half_length": 0.5, "radiance": [8, 8, 8],
                "matrix": [{"translate": [0.5, 3, 0.5]}]}]})";
  };
  const auto at_rest = read(text(""));
  const auto moving = read(text(R"(, "end_matrix": [{"translate": [0, 0.8, 0]}])"));
  ASSERT_TRUE(scene::has_motion(moving));
  EXPECT_EQ(render_scene(moving, {.samples = 16}).pixels, render_scene(at_rest, {.samples = 16}).pixels);
}

// The same matrix and the same vertices twice, given to the tracer as motion. Light sampling knows no
// emitters and mirrors that move, so both images do without.
TEST(Motion, WithoutAWayLooksLikeRest) {
  const auto at_rest = scene::at_time(read(busy_scene(R"({"trace_depth": 4})", "[0, 1]")), 0.5);
  auto twice = at_rest;
  twice.camera.shutter = {0, 1};
  for (auto& instance : twice.instances) instance.end_matrix = instance.matrix;
  for (auto& mesh : twice.meshes) mesh.end = scene::MeshEnd{mesh.positions, mesh.normals};
  RenderOptions options{.samples = 64};
  options.world.direct_light = tracer::DirectLight::Bsdf;
  options.world.mirrored_light = false;
  options.world.light_paths = false;
  EXPECT_LT(largest_tile_difference(render_scene(twice, options), render_scene(at_rest, options)), 0.002);
}

// A convex body of albedo 0.5 in an even sky of 1 shows 0.5: a ray that met its own surface would be dark.
TEST(Motion, SurfacesDoNotShadowThemselves) {
  for (const char* place : {"0, 0, 0", "300, -200, 700"})
    for (const char* end :
         {R"({"rotate_y": 80}, {"scale": [1, 1.2, 0.9]})", R"({"translate": [0.3, 0.2, -0.1]})"}) {
      const Vec3d centre = std::string(place) == "0, 0, 0" ? Vec3d{} : Vec3d{300, -200, 700};
      const tests::View view{.position = tests::text_of(centre + Vec3d{0.3, 0.4, 5}),
                             .look_at = tests::text_of(centre + Vec3d{0.05, 0.04, 0}),
                             .fov_deg = 2};
      auto text = tests::scene_of(view, fmt::format(R"("environment": [1, 1, 1], "materials": [
        {{"name": "m", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}}],
        "meshes": [{{"name": "cube", "generator": "cube", "half_size": 1, "material": "m"}}],
        "instances": [{{"mesh": "cube", "matrix": [{{"translate": [{0}]}}],
                       "end_matrix": [{{"translate": [{0}]}}, {1}]}}])",
                                                    place, end));
      const auto scene = read(text.replace(text.find(R"("width")"), 0, R"("shutter": [0, 1], )"));
      ASSERT_TRUE(scene::has_motion(scene));
      EXPECT_NEAR(tests::mean_of(render_scene(scene, {.samples = 256}), "R"), 0.5, 1e-5) << place << end;
    }
}
