// The tracer against closed forms. Tolerances are four standard errors by the variance of the image: a false
// alarm in one of 16,000 seeds, and the seeds are fixed.
#include "base/error.h"
#include "unit/tracer/scenes.h"

#include <numbers>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using tests::error_of_mean;
using tests::mean_of_channel;
using tests::render_text;
using tests::scene_text;

constexpr double kPi = std::numbers::pi;

void expect_mean(const tracer::Rendering& rendering, double expected) {
  EXPECT_EQ(rendering.bad_samples.count, 0U);
  for (std::size_t channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(mean_of_channel(rendering.image, channel), expected,
                4 * error_of_mean(rendering.image, channel) + 1e-5 * expected);
}

// A white environment of radiance 1 around one convex object of albedo `rho`: the object shows rho in every
// direction.
std::string furnace_with(const std::string& material) {
  return scene_text(
      "[0, 0, 20]", "[0, 0, 0]", 16, 50,
      R"("environment": [1, 1, 1], "materials": [{"name": "m", )" + material +
          R"(}], "meshes": [{"name": "s", "generator": "sphere", "radius": 1, "segments": 256, "material": "m"}],
                        "instances": [{"mesh": "s"}])");
}

std::string floor_under(const std::string& light, const std::string& look_at) {
  return scene_text("[7, 9, 11]", look_at, 16, 1,
                    R"("materials": [{"name": "m", "type": "lambert", "reflectance": [1, 1, 1]}],
                       "meshes": [{"name": "p", "generator": "plane", "half_size": 50, "material": "m"}],
                       "instances": [{"mesh": "p"}], "lights": [)" +
                        light + "]");
}

}  // namespace

TEST(TracerFurnace, ALambertBallShowsItsAlbedo) {
  expect_mean(render_text(furnace_with(R"("type": "lambert", "reflectance": [0.5, 0.5, 0.5])"),
                          {.samples_per_pixel = 64}),
              0.5);
}

// Lossless and convex: light leaves in another direction, but all directions carry the same radiance.
TEST(TracerFurnace, AMirrorBallOfAlbedoOneIsInvisible) {
  expect_mean(
      render_text(furnace_with(R"("type": "mirror", "reflectance": [1, 1, 1])"), {.samples_per_pixel = 16}),
      1);
}

// Radiance is scaled by 1/eta^2 on the way in and by eta^2 on the way out.
TEST(TracerFurnace, AGlassBallIsInvisible) {
  expect_mean(render_text(furnace_with(R"("type": "glass", "ior": 1.5)"), {.samples_per_pixel = 64}), 1);
}

// Height-correlated single scattering GGX loses a little at alpha 0.1: the directional albedo at normal
// incidence is above 0.99.
TEST(TracerFurnace, ASlightlyRoughGgxBallLosesLittle) {
  const auto rendering = render_text(furnace_with(R"("type": "ggx", "colour": [1, 1, 1], "alpha": 0.1)"),
                                     {.samples_per_pixel = 64});
  EXPECT_GT(mean_of_channel(rendering.image, 0), 0.985);
  EXPECT_LT(mean_of_channel(rendering.image, 0), 1.0 + 4 * error_of_mean(rendering.image, 0));
}

// Closed room, every surface reflects 1/2 and sees emission 1 at depth 0 only through the environment-free
// sum: a room whose walls are lit by an emissive ball of radius 1 at its centre: E at distance d below the
// ball is pi (1/d)^2.
TEST(TracerDirectLight, AnEmissiveMeshBallLightsTheFloorLikeASphere) {
  const auto text = scene_text("[7, 9, 11]", "[0, 0, 0]", 16, 1,
                               R"("materials": [{"name": "m", "type": "lambert", "reflectance": [1, 1, 1]},
                                                {"name": "e", "type": "emission", "radiance": [2, 2, 2]}],
                                  "meshes": [{"name": "p", "generator": "plane", "half_size": 50, "material": "m"},
                                             {"name": "s", "generator": "sphere", "radius": 1, "segments": 512, "material": "e"}],
                                  "instances": [{"mesh": "p"}, {"mesh": "s", "matrix": [{"translate": [0, 2, 0]}]}])");
  const auto rendering = render_text(text, {.samples_per_pixel = 256});
  // L = rho E / pi = 2 (1/2)^2. The inscribed mesh with 512 segments is smaller by less than 1e-4; the pixels
  // span 14 mm, over which E changes by less than 1e-4.
  EXPECT_NEAR(mean_of_channel(rendering.image, 0), 0.5, 4 * error_of_mean(rendering.image, 0) + 1e-4);
}

TEST(TracerDirectLight, ASphereLightBelowItsCentreIsPiLTimesRadiusOverDistanceSquared) {
  const auto rendering = render_text(floor_under(R"({"type": "sphere", "radius": 0.5, "radiance": [1, 1, 1],
                                                     "matrix": [{"translate": [0, 2, 0]}]})",
                                                 "[0, 0, 0]"),
                                     {.samples_per_pixel = 256});
  EXPECT_NEAR(mean_of_channel(rendering.image, 0), 0.0625, 0.00005);
}

// An ellipsoid, made from a sphere light by a non-uniform matrix, seen from below along its long axis.
// Stretching along y towards the floor preserves its horizontal section but brings its surface nearer; the
// exact form factor of a spheroid with semi-axes (a, c, a) at height h is a^2 / (h^2 - c^2 + a^2) for a
// receiver that faces its centre.
TEST(TracerDirectLight, AStretchedSphereLightIsASpheroid) {
  const auto rendering = render_text(floor_under(R"({"type": "sphere", "radius": 0.5, "radiance": [1, 1, 1],
                                                     "matrix": [{"translate": [0, 2, 0]}, {"scale": [1, 2, 1]}]})",
                                                 "[0, 0, 0]"),
                                     {.samples_per_pixel = 256});
  EXPECT_NEAR(mean_of_channel(rendering.image, 0), 0.25 / (4 - 1 + 0.25), 0.0007);
}

// Unit square of radiance 1 at height 1, point below its centre: F = 0.23945647 (sum of four corner
// rectangles).
TEST(TracerDirectLight, ARectangleMatchesItsFormFactor) {
  const auto rendering = render_text(
      floor_under(R"({"type": "rect", "half_width": 0.5, "half_length": 0.5, "radiance": [1, 1, 1],
                                                     "matrix": [{"translate": [0, 1, 0]}]})",
                  "[0, 0, 0]"),
      {.samples_per_pixel = 256});
  EXPECT_NEAR(mean_of_channel(rendering.image, 0), 0.23945647, 0.0002);
}

// The same rectangle through a matrix that scales it: size follows, radiance does not (ORB.S REQ_L3).
TEST(TracerDirectLight, ScalingALightChangesItsSizeAndNotItsRadiance) {
  const auto direct =
      render_text(floor_under(R"({"type": "rect", "half_width": 0.5, "half_length": 1, "radiance": [3, 3, 3],
                                                  "matrix": [{"translate": [0, 1, 0]}]})",
                              "[0, 0, 0]"),
                  {.samples_per_pixel = 64});
  const auto scaled =
      render_text(floor_under(R"({"type": "rect", "half_width": 1, "half_length": 1, "radiance": [3, 3, 3],
                                                  "matrix": [{"translate": [0, 1, 0]}, {"scale": [0.5, 7, 1]}]})",
                              "[0, 0, 0]"),
                  {.samples_per_pixel = 64});
  EXPECT_EQ(direct.image.pixels, scaled.image.pixels);
}

// Coaxial parallel disk, r = h = 1: F = 1/2.
TEST(TracerDirectLight, ADiskMatchesItsFormFactor) {
  const auto rendering = render_text(floor_under(R"({"type": "disk", "radius": 1, "radiance": [1, 1, 1],
                                                     "matrix": [{"translate": [0, 1, 0]}]})",
                                                 "[0, 0, 0]"),
                                     {.samples_per_pixel = 256});
  EXPECT_NEAR(mean_of_channel(rendering.image, 0), 0.5, 0.0005);
}

TEST(TracerDirectLight, LightsAreBlackFromBehind) {
  const auto rendering =
      render_text(floor_under(R"({"type": "rect", "half_width": 1, "half_length": 1, "radiance": [1, 1, 1],
                                                     "matrix": [{"translate": [0, 1, 0]}, {"rotate_x": 180}]})",
                              "[0, 1, 0]"),
                  {.samples_per_pixel = 4});
  EXPECT_EQ(mean_of_channel(rendering.image, 0), 1);  // the camera is above and sees the bright side
  const auto below =
      render_text(floor_under(R"({"type": "rect", "half_width": 1, "half_length": 1, "radiance": [1, 1, 1],
                                                 "matrix": [{"translate": [0, 1, 0]}]})",
                              "[0, 1, 0]"),
                  {.samples_per_pixel = 4});
  EXPECT_EQ(mean_of_channel(below.image, 0), 0);
}

// A closed box of albedo 1/2 with a light, seen from its middle: every image of depth d is a partial sum, and
// the layers by path class add up to the image.
TEST(TracerPaths, LayersAddUpToTheImage) {
  const auto text =
      scene_text("[0, 0, 0]", "[0, -1, 1]", 16, 4,
                 R"("materials": [{"name": "m", "type": "lambert", "reflectance": [0.5, 0.6, 0.7]},
                                                {"name": "s", "type": "mirror", "reflectance": [0.9, 0.9, 0.9]}],
                                  "meshes": [{"name": "c", "generator": "cube", "half_size": 2,
                                              "triangle_materials": [{"material": "m", "count": 8}, {"material": "s", "count": 4}]}],
                                  "instances": [{"mesh": "c"}],
                                  "lights": [{"type": "rect", "half_width": 0.5, "half_length": 0.5, "radiance": [9, 9, 9],
                                              "matrix": [{"translate": [0, 1.9, 0]}]}])",
                 "60");
  const auto rendering = render_text(text, {.samples_per_pixel = 16, .split_paths = true});
  const auto& image = rendering.image;
  ASSERT_GT(image.channel_count(), 6U);
  ASSERT_GE(image::channel_index(image, "path.EDL.R"), 0);
  ASSERT_GE(image::channel_index(image, "path.EDSL.R"), 0);
  ASSERT_GE(image::channel_index(image, "path.other.R"), 0);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      double sum = 0;
      for (std::size_t c = 6; c < image.channel_count(); c += 3) sum += image.at(x, y, c);
      EXPECT_NEAR(sum, image.at(x, y, 0), 1e-5 * sum + 1e-7);
    }
}

namespace {

const std::string kBusyScene = scene_text("[0, 3, 14]",
                                          "[0, 0, 0]",
                                          48,
                                          6,
                                          R"("environment": [0.1, 0.2, 0.3],
   "materials": [{"name": "m", "type": "lambert", "reflectance": [0.5, 0.6, 0.7]}, {"name": "g", "type": "ggx", "colour": [0.8, 0.8, 0.8], "alpha": 0.2},
                 {"name": "t", "type": "glass", "ior": 1.5}, {"name": "e", "type": "emission", "radiance": [1, 2, 3]}],
   "meshes": [{"name": "p", "generator": "plane", "half_size": 5, "material": "g"},
              {"name": "s", "generator": "sphere", "radius": 0.1, "segments": 32, "material": "m"}],
   "instances": [{"mesh": "p"}, {"mesh": "s", "matrix": [{"translate": [0, 0.1, 0]}]},
                 {"mesh": "s", "matrix": [{"translate": [0.1, 0.1, 0.2]}, {"scale": [1, 0.5, 1]}], "remap": ["m", "t"]},
                 {"mesh": "s", "matrix": [{"translate": [-0.1, 0.1, 0.2]}, {"scale": 0.5}], "remap": ["m", "e"]}],
   "lights": [{"type": "rect", "half_width": 1, "half_length": 1, "radiance": [4, 4, 4], "matrix": [{"translate": [0, 3, 0]}]},
              {"type": "sphere", "radius": 0.3, "radiance": [4, 2, 4], "matrix": [{"translate": [1, 2, 1]}]}])",
                                          "1");

}  // namespace

TEST(TracerDeterminism, TheImageDoesNotDependOnTheNumberOfThreads) {
  const auto one =
      render_text(kBusyScene, {.samples_per_pixel = 20, .seed = 7, .threads = 1, .split_paths = true});
  const auto three =
      render_text(kBusyScene, {.samples_per_pixel = 20, .seed = 7, .threads = 3, .split_paths = true});
  EXPECT_EQ(one.image.pixels, three.image.pixels);
  const auto other = render_text(kBusyScene, {.samples_per_pixel = 20, .seed = 8, .threads = 3});
  EXPECT_NE(one.image.pixels, other.image.pixels);
}

// Splitting by class only sorts contributions.
TEST(TracerDeterminism, SplittingPathsDoesNotChangeTheImage) {
  const auto plain = render_text(kBusyScene, {.samples_per_pixel = 8});
  const auto split = render_text(kBusyScene, {.samples_per_pixel = 8, .split_paths = true});
  for (int y = 0; y < plain.image.height; ++y)
    for (int x = 0; x < plain.image.width; ++x)
      for (std::size_t c = 0; c < 6; ++c) ASSERT_EQ(plain.image.at(x, y, c), split.image.at(x, y, c));
}

// Var(a - b) = Var(a) + Var(b): over many pixels the squared differences of two seeds must average to the
// stated variances.
TEST(TracerVariance, IsTheVarianceOfTheMean) {
  const auto a = render_text(kBusyScene, {.samples_per_pixel = 64, .seed = 1});
  const auto b = render_text(kBusyScene, {.samples_per_pixel = 64, .seed = 2});
  double ratio = 0;
  double count = 0;
  for (int y = 0; y < a.image.height; ++y)
    for (int x = 0; x < a.image.width; ++x) {
      const double stated = a.image.at(x, y, 3) + b.image.at(x, y, 3);
      if (stated == 0) continue;
      const double difference = a.image.at(x, y, 0) - b.image.at(x, y, 0);
      ratio += difference * difference;
      count += stated;
    }
  EXPECT_NEAR(ratio / count, 1, 0.15);
}

TEST(TracerInstances, CopiesAndInstancesShowTheSameImage) {
  const auto scene = scene::load_scene_text("test.json", kBusyScene, ".");
  const std::atomic<bool> never{false};
  const auto silent = [](const tracer::Progress&) {};
  const auto copied = tracer::render(tracer::make_world(scene), {.samples_per_pixel = 64}, never, silent);
  const auto instanced = tracer::render(tracer::make_world(scene, {.most_copied_triangles = 0}),
                                        {.samples_per_pixel = 64}, never, silent);
  const double noise = std::hypot(error_of_mean(copied.image, 0), error_of_mean(instanced.image, 0));
  EXPECT_NEAR(mean_of_channel(copied.image, 0), mean_of_channel(instanced.image, 0), 4 * noise);
}

// Vertex normals are mapped before they are interpolated: a matrix that stretches turns them against each
// other.
TEST(TracerInstances, AStretchedMeshIsShadedAsItsCopyInPlace) {
  const auto scene = scene::load_scene_text(
      "test.json",
      scene_text("[0, 0, 6]", "[0, 0, 0]", 32, 1,
                 R"("materials": [{"name": "m", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}],
                    "meshes": [{"name": "s", "generator": "sphere", "radius": 1, "segments": 8, "material": "m"}],
                    "instances": [{"mesh": "s", "matrix": [{"translate": [-1.2, 0, 0]}, {"scale": [0.3, 1, 1]}]},
                                  {"mesh": "s", "matrix": [{"translate": [1.2, 0, 0]}, {"scale": [0.3, 1, 1]}]}],
                    "lights": [{"type": "sphere", "radius": 0.1, "radiance": [300, 300, 300],
                                "matrix": [{"translate": [0, 3, 4]}]}])",
                 "40"),
      ".");
  const std::atomic<bool> never{false};
  const auto silent = [](const tracer::Progress&) {};
  const tracer::RenderSettings settings{.samples_per_pixel = 16};
  const auto copied = tracer::render(tracer::make_world(scene), settings, never, silent).image;
  const auto instanced =
      tracer::render(tracer::make_world(scene, {.most_copied_triangles = 0}), settings, never, silent).image;
  double difference = 0;
  for (int y = 0; y < copied.height; ++y)
    for (int x = 0; x < copied.width; ++x)
      difference += std::fabs(double{copied.at(x, y, 0)} - double{instanced.at(x, y, 0)});
  const double pixels = double{1} * copied.width * copied.height;
  EXPECT_LT(difference / pixels, 1e-4 * mean_of_channel(copied, 0));
}

TEST(TracerStop, KeepsThePassesThatWereFinished) {
  const std::atomic<bool> at_once{true};
  const auto world = tracer::make_world(scene::load_scene_text("test.json", kBusyScene, "."));
  const auto rendering =
      tracer::render(world, {.samples_per_pixel = 64}, at_once, [](const tracer::Progress&) {});
  EXPECT_EQ(rendering.samples_per_pixel, 8);  // one piece of eight
  EXPECT_GT(mean_of_channel(rendering.image, 0), 0);
}

// Each search that does not end takes 10 ms, so a formula of which most rays find no end would render for
// hours.
TEST(TracerShapes, WhoseSearchDoesNotEndAreRefused) {
  const std::string text = scene_text(
      "[0, 0, 20]", "[0, 0, 0]", 16, 1,
      R"=("environment": [1, 1, 1], "materials": [{"name": "m", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}], "shapes": [
                    {"type": "implicit", "name": "pole", "expression": "x / (sin(x)^2 + cos(x)^2 - 1)",
                     "low": [-1, -1, -1], "high": [1, 1, 1], "material": "m"}])=");
  const auto world = tracer::make_world(scene::load_scene_text("test.json", text, ORBS_SOURCE_DIR));
  world.solids.front().counts->unfinished = tracer::kMostUnfinished + 1;  // as after ten seconds of its rays
  const std::atomic<bool> never{false};
  try {
    tracer::render(world, {.samples_per_pixel = 4}, never, [](const tracer::Progress&) {});
    FAIL() << "it was rendered";
  } catch (const InputError& e) {
    EXPECT_NE(
        std::string(e.what()).find("shape 'pole': the search for its surface did not end on more than 500"),
        std::string::npos)
        << e.what();
  }
}

TEST(TracerEmission, DirectlyVisibleEmissionIsExact) {
  const auto text =
      scene_text("[0, 0, 5]", "[0, 0, 0]", 8, 3,
                 R"("materials": [{"name": "e", "type": "emission", "radiance": [0.5, 0.25, 3]}],
                                  "meshes": [{"name": "s", "generator": "sphere", "radius": 1, "segments": 64, "material": "e"}],
                                  "instances": [{"mesh": "s"}])");
  const auto image = render_text(text, {.samples_per_pixel = 5}).image;
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      EXPECT_EQ(image.at(x, y, 0), 0.5F);
      EXPECT_EQ(image.at(x, y, 1), 0.25F);
      EXPECT_EQ(image.at(x, y, 2), 3.0F);
    }
}

// Two parallel mirrors would reflect forever; N scattering events and no more.
TEST(TracerDepth, CountsSurfaceScatterings) {
  for (const int depth : {1, 2, 3, 5}) {
    // Closed cube, albedo 1/2, lit from within by emission seen by the environment: a room open nowhere, one
    // wall emissive.
    const auto text = scene_text(
        "[0, 0, 0]", "[0, 0, 1]", 4, depth,
        R"("environment": [1, 1, 1], "materials": [{"name": "m", "type": "mirror", "reflectance": [0.5, 0.5, 0.5]}],
                                    "meshes": [{"name": "w", "generator": "plane", "half_size": 100, "material": "m"}],
                                    "instances": [{"mesh": "w", "matrix": [{"translate": [0, 0, 1]}, {"rotate_x": 90}]},
                                                  {"mesh": "w", "matrix": [{"translate": [0, 0, -1]}, {"rotate_x": 90}]}])");
    const auto image = render_text(text, {.samples_per_pixel = 4}).image;
    EXPECT_EQ(mean_of_channel(image, 0), 0) << "between the mirrors nothing is lit at depth " << depth;
  }
  const auto open = scene_text(
      "[0, 0, 0]", "[0, 0, 1]", 4, 1,
      R"("environment": [1, 1, 1], "materials": [{"name": "m", "type": "mirror", "reflectance": [0.5, 0.5, 0.5]}],
                                  "meshes": [{"name": "w", "generator": "plane", "half_size": 100, "material": "m"}],
                                  "instances": [{"mesh": "w", "matrix": [{"translate": [0, 0, 1]}, {"rotate_x": 90}]}])");
  EXPECT_NEAR(mean_of_channel(render_text(open, {.samples_per_pixel = 4}).image, 0), 0.5, 1e-6);
}
