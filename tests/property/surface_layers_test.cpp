// Layers of surfaces against closed forms.
#include "tracer/integrator/surface_layers.h"

#include "image/layers.h"
#include "unit/tracer/scenes.h"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;

namespace {

image::Image render_layers(const std::string& text, int threads = 0) {
  const std::atomic<bool> never{false};
  const auto scene = scene::load_scene_text("test.json", text, ORBS_SOURCE_DIR);
  const auto world = tracer::make_world(scene);
  const tracer::RenderSettings settings{.samples_per_pixel = 64, .threads = threads};
  auto rendering = tracer::render(world, settings, never, [](const tracer::Progress&) {});
  tracer::add_surface_layers(world, scene, settings, rendering);
  return rendering.image;
}

double at(const image::Image& image, int x, int y, const std::string& channel) {
  const int index = image::channel_index(image, channel);
  EXPECT_GE(index, 0) << channel;
  return static_cast<double>(image.at(x, y, static_cast<std::size_t>(index)));
}

constexpr int kSide = 16;

// A board of 4 x 4 m across the axis, `distance` from a camera of 90 degrees that stands at `eye` and looks
// along -z.
std::string board(double eye, double distance, const std::string& layers, const std::string& camera = "") {
  return fmt::format(
      R"({{"format": "orbs-scene/1", "name": "board", "camera": {{"position": [{0}, 0, {0}],
"look_at": [{0}, 0, {1}], "fov_y": 90, "width": {2}, "height": {2}{3}}},
"materials": [{{"name": "glass", "type": "glass", "ior": 1.5}},
  {{"name": "m", "type": "oren_nayar", "reflectance": [0.5, 0.4, 0.3], "roughness": 0.3}}],
"meshes": [{{"name": "board", "generator": "plane", "half_size": {4}, "material": "m"}}],
"instances": [{{"mesh": "board", "matrix": [{{"translate": [{0}, 0, {1}]}}, {{"rotate_x": 90}}]}}],
"outputs": {{"layers": {5}}}, "integrator": {{"trace_depth": 1}}}})",
      eye, eye - distance, kSide, camera, 2 * distance, layers);
}

}  // namespace

// The corners of a view of 90 degrees are sqrt(3) times as far along the ray.
TEST(SurfaceLayers, DepthIsMeasuredAlongTheAxis) {
  const auto image = render_layers(board(0, 2, R"(["depth"])"));
  for (const auto& [x, y] : {std::pair{0, 0}, {8, 8}, {15, 3}}) {
    EXPECT_NEAR(at(image, x, y, "depth.Z"), 2, 1e-5);
    EXPECT_NEAR(at(image, x, y, "least.depth.Z"), 2, 1e-5);
  }
}

// In world coordinates, also where the tracer works in others: far from the origin, and 1e8 times smaller.
TEST(SurfaceLayers, PositionsAreThoseOfTheScene) {
  for (const auto& [eye, distance] : {std::pair{0.0, 2.0}, {1e6, 2.0}, {0.0, 2e-8}, {0.0, 2e9}}) {
    const auto image = render_layers(board(eye, distance, R"(["position", "depth"])"));
    const double pixel = 2 * distance / kSide;  // on the board
    const double step = std::max(distance * 1e-4, eye * 1e-7);
    // The mean over a pixel of stratified samples is its middle but for a share of the pixel.
    EXPECT_NEAR(at(image, 3, 5, "position.X"), eye + (3.5 - kSide / 2.0) * pixel, 0.02 * pixel + step) << eye;
    EXPECT_NEAR(at(image, 3, 5, "position.Y"), (kSide / 2.0 - 5.5) * pixel, 0.02 * pixel + step) << eye;
    EXPECT_NEAR(at(image, 3, 5, "position.Z"), eye - distance, step) << eye;
    EXPECT_NEAR(at(image, 3, 5, "depth.Z"), distance, step) << eye;
  }
}

TEST(SurfaceLayers, ALatitudeLongitudeImageHasTheWayToTheCamera) {
  const auto image = render_layers(
      R"({"format": "orbs-scene/1", "name": "s", "camera": {"position": [1, 2, 3], "look_at": [1, 2, 0],
"projection": "latitude_longitude", "width": 16, "height": 8},
"materials": [{"name": "m", "type": "mirror", "reflectance": [0.9, 0.8, 0.7]}],
"shapes": [{"type": "sphere", "centre": [1, 2, 3], "radius": 5, "material": "m"}],
"outputs": {"layers": ["depth", "albedo", "normal"]}, "integrator": {"trace_depth": 1}})");
  for (const auto& [x, y] : {std::pair{0, 0}, {8, 4}, {15, 7}}) {
    EXPECT_NEAR(at(image, x, y, "depth.Z"), 5, 1e-5);
    EXPECT_NEAR(at(image, x, y, "albedo.G"), 0.8, 1e-6);
  }
  // Inwards, as the camera stands inside: at the middle of the image, from -z towards +z.
  EXPECT_NEAR(at(image, 8, 4, "normal.Z"), 1, 0.2);
}

// Seen from behind as well, and mirrored.
TEST(SurfaceLayers, NormalsAreTurnedToTheViewer) {
  for (const char* turn :
       {R"({"rotate_x": 90})", R"({"rotate_x": -90})", R"({"rotate_x": 90}, {"scale": [-1, 1, 1]})",
        R"({"rotate_x": 90}, {"scale": [1, -1, 1]})"}) {
    auto text = board(0, 2, R"(["normal"])");
    const std::string plain = R"({"rotate_x": 90})";
    text.replace(text.find(plain), plain.size(), turn);
    const auto image = render_layers(text);
    EXPECT_NEAR(at(image, 5, 9, "normal.Z"), 1, 1e-6) << turn;
    EXPECT_NEAR(at(image, 5, 9, "normal.X"), 0, 1e-6) << turn;
  }
}

// The half plane x < 0 covers the left half of the image, and 0.5 of a column whose middle is at x = 0.
TEST(SurfaceLayers, CoverageIsTheShareOfThePixel) {
  const std::string half =
      R"({"format": "orbs-scene/1", "name": "s", "camera": {"position": [0, 0, 1], "look_at": [0, 0, 0],
"projection": "orthographic", "view_height": 15, "width": 15, "height": 15},
"materials": [{"name": "m", "type": "lambert", "reflectance": [0.5, 0.4, 0.3]}],
"meshes": [{"name": "board", "generator": "plane", "half_size": 20, "material": "m"}],
"instances": [{"mesh": "board", "matrix": [{"translate": [-20, 0, 0]}, {"rotate_x": 90}]}],
"outputs": {"layers": ["coverage", "depth", "object"]}, "integrator": {"trace_depth": 1}})";
  const auto image = render_layers(half);
  EXPECT_EQ(at(image, 6, 3, "coverage.A"), 1);
  EXPECT_NEAR(at(image, 7, 3, "coverage.A"), 0.5, 0.02);
  EXPECT_EQ(at(image, 8, 3, "coverage.A"), 0);
  EXPECT_NEAR(at(image, 7, 3, "depth.Z"), 1, 1e-5);  // of the half that shows something
  EXPECT_EQ(at(image, 8, 3, "depth.Z"), 0);
  EXPECT_EQ(at(image, 6, 3, "object.id"), 1);
  EXPECT_EQ(at(image, 8, 3, "object.id"), 0);
}

// u along x, v along z of a plane; 0.5 in its middle.
TEST(SurfaceLayers, TextureCoordinatesAreThoseOfTheMesh) {
  const auto image = render_layers(board(0, 2, R"(["uv", "albedo"])"));
  // A board of 8 m: a pixel is 4 / 16 m.
  EXPECT_NEAR(at(image, 3, 5, "uv.U"), 0.5 + (3.5 - 8) * 0.25 / 8, 1e-3);
  EXPECT_NEAR(at(image, 3, 5, "uv.V"), 0.5 + (5.5 - 8) * 0.25 / 8, 1e-3);
  EXPECT_NEAR(at(image, 3, 5, "albedo.R"), 0.5, 1e-6);
}

TEST(SurfaceLayers, NumbersTellInstancesMeshesAndMaterials) {
  const auto image = render_layers(
      R"({"format": "orbs-scene/1", "name": "s", "camera": {"position": [0, 0, 1], "look_at": [0, 0, 0],
"projection": "orthographic", "view_height": 4, "width": 4, "height": 4},
"materials": [{"name": "a", "type": "lambert", "reflectance": [0.5, 0.4, 0.3]},
              {"name": "b", "type": "lambert", "reflectance": [0.5, 0.4, 0.3]}],
"meshes": [{"name": "board", "generator": "plane", "half_size": 0.5, "material": "a"}],
"instances": [{"mesh": "board", "matrix": [{"translate": [-1.5, 1.5, 0]}, {"rotate_x": 90}]},
              {"mesh": "board", "matrix": [{"translate": [-0.5, 1.5, 0]}, {"rotate_x": 90}], "remap": ["a", "b"]}],
"shapes": [{"type": "sphere", "centre": [0.5, 1.5, 0], "radius": 0.5, "material": "b"}],
"lights": [{"type": "rect", "half_width": 0.5, "half_length": 0.5, "radiance": [1, 1, 1],
            "matrix": [{"translate": [1.5, 1.5, 0]}, {"rotate_x": -90}]}],
"outputs": {"layers": ["instance", "object", "material"]}, "integrator": {"trace_depth": 1}})");
  const auto row = [&](const std::string& channel) {
    std::vector<double> numbers;
    for (int x = 0; x < 4; ++x) numbers.push_back(at(image, x, 0, channel));
    return numbers;
  };
  EXPECT_EQ(row("instance.id"), (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(row("object.id"), (std::vector<double>{1, 1, 2, 3}));
  EXPECT_EQ(row("material.id"), (std::vector<double>{1, 2, 2, 3}));
  EXPECT_EQ(at(image, 0, 3, "instance.id"), 0);
}

TEST(SurfaceLayers, AreTheSameForAnyNumberOfThreadsAndLeaveTheColourAsItIs) {
  const auto text = board(0, 2, R"(["position", "normal", "instance"])",
                          R"(, "aperture_radius": 0.2, "focus_distance": 1)");
  const auto one = render_layers(text, 1);
  EXPECT_EQ(one.pixels, render_layers(text, 2).pixels);
  auto plain = text;
  const std::string layers = R"("layers": ["position", "normal", "instance"])";
  plain.replace(plain.find(layers), layers.size(), "");
  EXPECT_TRUE(image::has_same_colours(one, render_layers(plain, 1)));
}

// A blend of two colours by 0.25.
TEST(SurfaceLayers, TheAlbedoOfABlendIsTheWeightedMean) {
  auto text = board(0, 2, R"(["albedo"])");
  const std::string materials = R"("materials": [)";
  text.replace(text.find(materials), materials.size(),
               R"("materials": [{"name": "one", "type": "lambert", "reflectance": [0.8, 0.4, 0]},
  {"name": "two", "type": "mirror", "reflectance": [0, 0.4, 0.8]},
  {"name": "both", "type": "blend", "first": "one", "second": "two", "weight": 0.25},)");
  const std::string shown = R"("material": "m")";
  text.replace(text.find(shown), shown.size(), R"("material": "both")");
  const auto image = render_layers(text);
  EXPECT_NEAR(at(image, 5, 5, "albedo.R"), 0.6, 1e-6);
  EXPECT_NEAR(at(image, 5, 5, "albedo.G"), 0.4, 1e-6);
  EXPECT_NEAR(at(image, 5, 5, "albedo.B"), 0.2, 1e-6);
}
