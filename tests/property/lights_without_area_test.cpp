// Points, spots and parallel light against their closed forms, and the techniques that find them against each
// other.
#include "property/light_images.h"
#include "scene/relations/motion.h"
#include "tracer/choose_light.h"

#include <numbers>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::tests;
using tracer::DirectLight;
using tracer::LightSelection;

constexpr double kPi = std::numbers::pi;

std::string floor_of(const std::string& reflectance) {
  return R"("materials": [{"name": "m", "type": "lambert", "reflectance": )" + reflectance + "}], " +
         meshes({square({0, 0, 0}, {0, 1, 0}, 50, "m")});
}

const std::string kFloor = floor_of("[0.5, 0.5, 0.5]");

std::string lit_floor(Vec3d seen, const std::string& lights, const std::string& floor = kFloor) {
  const View view{.position = text_of(seen + Vec3d{0, 5, 0.001}), .look_at = text_of(seen)};
  return scene_of(view, floor + R"(, "lights": [)" + lights + "]", "1");
}

std::string point(Vec3d at, double intensity, const std::string& more = "") {
  return fmt::format(
      R"({{"type": "point", "intensity": [{0}, {0}, {0}], "matrix": [{{"translate": {1}}}]{2}}})", intensity,
      text_of(at), more);
}

// Turned about z, towards +x.
std::string spot(Vec3d at, double turn_deg, double inner, double outer) {
  return fmt::format(R"({{"type": "spot", "intensity": [1, 1, 1], "inner": {}, "outer": {}, )"
                     R"("matrix": [{{"translate": {}}}, {{"rotate_z": {}}}]}})",
                     inner, outer, text_of(at), turn_deg);
}

std::string parallel(double turn_deg, double irradiance) {
  return fmt::format(
      R"({{"type": "directional", "irradiance": [{0}, {0}, {0}], "matrix": [{{"rotate_z": {1}}}]}})",
      irradiance, turn_deg);
}

double lit_by_point(Vec3d seen, Vec3d light, double intensity) {
  const Vec3d d = light - seen;
  return 0.5 / kPi * intensity * d.y / std::pow(length(d), 3);
}

// Of one ray's radiance, in floats.
void expect_value(const image::Image& image, double expected, const std::string& what) {
  for (const char* channel : {"R", "G", "B"})
    EXPECT_NEAR(mean_of(image, channel), expected, 1e-4 * expected + 1e-7) << what;
}

TEST(Point, LightsByTheInverseSquareAndTheCosine) {
  for (const Vec3d seen : {Vec3d{0, 0, 0}, Vec3d{1, 0, 0.5}, Vec3d{-3, 0, 2}, Vec3d{30, 0, 0}})
    for (const double height : {0.02, 1.0, 4.0})
      expect_value(image_of(lit_floor(seen, point({0.2, height, -0.1}, 7)), 1),
                   lit_by_point(seen, {0.2, height, -0.1}, 7), text_of(seen) + fmt::format(" {}", height));
}

TEST(Point, IsMovedAndNotScaledByItsMatrix) {
  const auto light = R"({"type": "point", "intensity": [2, 2, 2], "matrix": [{"translate": [1, 2, 0]}, )"
                     R"({"rotate_x": 70}, {"scale": [3, 0.1, 2]}, {"translate": [0, 0, 0]}]})";
  expect_value(image_of(lit_floor({0, 0, 0}, light), 1), lit_by_point({0, 0, 0}, {1, 2, 0}, 2), "scaled");
}

TEST(Point, ShinesInItsColour) {
  const auto image = image_of(
      lit_floor({0, 0, 0},
                R"({"type": "point", "intensity": [3, 2, 1], "matrix": [{"translate": [0, 1, 0]}]})"),
      1);
  EXPECT_NEAR(mean_of(image, "R"), 1.5 / kPi, 1e-5);
  EXPECT_NEAR(mean_of(image, "G"), 1.0 / kPi, 1e-5);
  EXPECT_NEAR(mean_of(image, "B"), 0.5 / kPi, 1e-5);
}

TEST(Point, DoesNotLightItsBackThroughTheFloor) {
  expect_value(image_of(lit_floor({0, 0, 0}, point({0, -1, 0}, 5)), 4), 0, "below the floor");
}

// The camera looks straight at it, and so does a mirror behind it.
TEST(Point, IsSeenByNobody) {
  const View view{.fov_deg = 1};
  const auto mirror = R"("materials": [{"name": "m", "type": "mirror", "reflectance": [1, 1, 1]}], )" +
                      meshes({square({0, 0, -1}, {0, 0, 1}, 5, "m")});
  for (const auto& light : {point({0, 0, 0}, 5), spot({0, 0, 0}, 90, 10, 20), parallel(90, 5)})
    expect_value(image_of(scene_of(view, mirror + R"(, "lights": [)" + light + "]"), 16), 0, light);
}

// cos a - cos b of 15 and 30 degrees; the table of smoothsteps is in docs/reference/scene-format.md.
TEST(Spot, FallsByASmoothstepOfTheCosine) {
  const std::vector<std::pair<double, double>> table{
      {0, 1}, {14.9, 1}, {20, 0.82935}, {22.5, 0.61769}, {25, 0.35665}, {28, 0.07636}, {30.1, 0}};
  for (const auto& [angle, share] : table) {
    const Vec3d seen{std::tan(angle * kPi / 180), 0, 0};
    // At 28 degrees the image's width of 0.01 degrees is 0.6 % of the value, of which 64 samples leave some
    // percent; the table is rounded by 7e-5 of it.
    const auto image = image_of(lit_floor(seen, spot({0, 1, 0}, 0, 15, 30)), 64);
    const double expected = share * lit_by_point(seen, {0, 1, 0}, 1);
    EXPECT_NEAR(mean_of(image, "G"), expected, 2e-4 * expected + 1e-6) << angle;
  }
}

TEST(Spot, ShinesAlongItsAxisWithAHardEdgeAtEqualAngles) {
  for (const double off : {-20.5, -19.5, 0.0, 19.5, 20.5}) {
    const double angle = (35 + off) * kPi / 180;
    const Vec3d seen{std::tan(angle), 0, 0};
    const double expected = std::abs(off) < 20 ? lit_by_point(seen, {0, 1, 0}, 1) : 0;
    EXPECT_NEAR(mean_of(image_of(lit_floor(seen, spot({0, 1, 0}, 35, 20, 20)), 1), "G"), expected,
                1e-4 * expected + 1e-7)
        << off;
  }
}

// The smoothstep's mean is a half.
TEST(Spot, HasTheFluxOfItsFormula) {
  const double inner = scene::cos_of_degrees(15);
  const double outer = scene::cos_of_degrees(30);
  constexpr int kSteps = 100000;
  double flux = 0;
  for (int i = 0; i < kSteps; ++i)
    flux += 2 * kPi * 2 / kSteps * scene::share_of_intensity(inner, outer, -1 + 2 * (i + 0.5) / kSteps);
  EXPECT_NEAR(flux, 2 * kPi * ((1 - inner) + (inner - outer) / 2), 1e-5);
  EXPECT_NEAR(flux, 0.527941, 1e-5);
}

TEST(Directional, LightsByTheCosineEverywhere) {
  for (const double turn : {0.0, 30.0, -60.0, 89.0})
    for (const Vec3d seen : {Vec3d{0, 0, 0}, Vec3d{20, 0, -30}})
      expect_value(image_of(lit_floor(seen, parallel(turn, 3)), 1),
                   0.5 / kPi * 3 * std::cos(turn * kPi / 180), fmt::format("{}", turn));
  expect_value(image_of(lit_floor({0, 0, 0}, parallel(120, 3)), 1), 0, "from below");
}

TEST(IesPoint, IsTheIntensityTimesTheShareOfTheTable) {
  const std::string profile =
      R"(, "ies": {"file": ")" ORBS_SOURCE_DIR R"(/data/cases/known/l4_ies/cosine_squared.ies"})";
  for (const auto& [angle, share] : std::vector<std::pair<double, double>>{
           {0, 1}, {10, 0.96984631}, {25, (0.883022222 + 0.75) / 2}, {60, 0.25}}) {
    const Vec3d seen{std::tan(angle * kPi / 180), 0, 0};
    expect_value(image_of(lit_floor(seen, point({0, 1, 0}, 4, profile)), 1),
                 share * lit_by_point(seen, {0, 1, 0}, 4), fmt::format("{}", angle));
  }
}

// Each technique finds all of them, or leaves them to another.
TEST(LightsWithoutArea, AreTheSameByEveryTechniqueAndChoice) {
  const std::string lamp =
      R"({"type": "rect", "half_width": 0.4, "half_length": 0.4, "radiance": [6, 6, 6], "matrix": [{"translate": [1, 2, 0]}]})";
  const auto text = lit_floor({0, 0, 0}, point({-1, 1, 0}, 3) + "," + spot({0.5, 1, 0.2}, -20, 30, 50) + "," +
                                             parallel(25, 2) + "," + lamp);
  const double without_lamp = lit_by_point({}, {-1, 1, 0}, 3) +
                              mean_of(image_of(lit_floor({}, spot({0.5, 1, 0.2}, -20, 30, 50)), 1), "G") +
                              0.5 / kPi * 2 * std::cos(25 * kPi / 180);
  const double expected = without_lamp + mean_of(image_of(lit_floor({}, lamp), 16384), "G");
  for (const auto direct : {DirectLight::Mis, DirectLight::Light, DirectLight::Bsdf})
    for (const auto selection : {LightSelection::Power, LightSelection::Bvh}) {
      const auto image = image_of(text, 4096, {.direct_light = direct, .light_selection = selection});
      EXPECT_NEAR(mean_of(image, "G"), expected, 4 * error_of_mean(image, 1) + 1e-3 * expected)
          << static_cast<int>(direct) << " " << static_cast<int>(selection);
    }
}

TEST(LightsWithoutArea, GiveTheSameImageOfAScaledWorld) {
  const auto text = lit_floor(
      {0.3, 0, 0}, point({-1, 1, 0}, 3) + "," + spot({0.5, 1, 0.2}, -20, 30, 50) + "," + parallel(25, 2));
  const auto scene = scene::load_scene_text("test.json", text, ORBS_SOURCE_DIR);
  const auto mean = [](const scene::Scene& one) {
    const std::atomic<bool> never{false};
    return mean_of(tracer::render(tracer::make_world(one, {}), {.samples_per_pixel = 1024}, never,
                                  [](const tracer::Progress&) {})
                       .image,
                   "G");
  };
  const double whole = mean(scene);
  for (const double factor : {1e-6, 0x1p-3, 1e5})
    EXPECT_NEAR(mean(moved(scene, scaling({factor, factor, factor}))), whole, 2e-3 * whole) << factor;
}

TEST(LightsWithoutArea, ShineBySpectraAsByColours) {
  const std::string spectral =
      R"("spectra": [{"name": "white", "illuminant": "D65"}], )" + kFloor +
      R"(, "lights": [{"type": "point", "intensity": {"spectrum": "white"}, "matrix": [{"translate": [0, 1, 0]}]}])";
  const View view{.position = "[0, 5, 0.001]"};
  const auto rgb = image_of(scene_of(view, spectral, "1"), 1);
  const auto waves =
      image_of(scene_of(view, spectral, "1"), 4096, {.transport = scene::LightTransport::Spectral});
  for (const char* channel : {"R", "G", "B"})
    EXPECT_NEAR(mean_of(waves, channel), mean_of(rgb, channel), 0.01 * mean_of(rgb, channel)) << channel;
}

// A glass ball over a floor of which the camera sees the part below the ball.
std::string below_glass(const std::string& lights) {
  const View view{.position = "[3, 1.2, 0.2]", .look_at = "[0.02, 0, 0]", .fov_deg = 3};
  return scene_of(
      view,
      R"("materials": [{"name": "m", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}, )"
      R"({"name": "glass", "type": "glass", "ior": 1.5}], )" +
          meshes({square({0, 0, 0}, {0, 1, 0}, 3, "m")}) +
          R"(, "shapes": [{"type": "sphere", "centre": [0, 1, 0], "radius": 0.5, "material": "glass"}])" +
          R"(, "lights": [)" + lights + "]",
      "4");
}

void expect_same_means(const image::Image& a, const image::Image& b, const std::string& what) {
  const double error = std::hypot(error_of_mean(a, 1), error_of_mean(b, 1));
  EXPECT_LT(error, 0.02 * mean_of(a, "G")) << what << ": too noisy to tell";
  EXPECT_NEAR(mean_of(a, "G"), mean_of(b, "G"), 4 * error + 2e-3 * mean_of(b, "G")) << what;
}

// A lamp so small or so far that its size blurs nothing here, of the same intensity or irradiance.
TEST(LightsWithoutArea, MakeTheCausticsOfSmallOrDistantLamps) {
  constexpr int kSamples = 4096;
  const Vec3d at{0.2, 4, 0};
  const auto lamp = image_of(
      below_glass(fmt::format(
          R"({{"type": "sphere", "radius": 0.01, "radiance": [{0}, {0}, {0}], "matrix": [{{"translate": {1}}}]}})",
          5 / (kPi * 1e-4), text_of(at))),
      kSamples);
  EXPECT_GT(mean_of(lamp, "G"), 3 * 0.5 / kPi * 5 / 16) << "brighter than without glass";
  expect_same_means(image_of(below_glass(point(at, 5)), kSamples), lamp, "point");
  const std::string wide =
      R"({"type": "spot", "intensity": [5, 5, 5], "inner": 30, "outer": 40, "matrix": [{"translate": [0.2, 4, 0]}]})";
  expect_same_means(image_of(below_glass(wide), kSamples), lamp, "spot");
  // At the ball its irradiance is 1e-3 above that at the floor.
  const auto distant =
      R"({"type": "disk", "radius": 2, "radiance": [1e6, 1e6, 1e6], "matrix": [{"translate": [0, 2000, 0]}]})";
  expect_same_means(image_of(below_glass(parallel(0, kPi)), kSamples),
                    image_of(below_glass(distant), kSamples), "directional");
}

// No camera path meets a point, so the light paths that do are kept without a trial.
TEST(LightsWithoutArea, KeepTheirLightPaths) {
  auto world =
      tracer::make_world(scene::load_scene_text("test.json", below_glass(point({0, 4, 0}, 5)), ""), {});
  tracer::choose_light(world, {.samples_per_pixel = 16});
  EXPECT_FALSE(world.caustic_casters.empty());
}

std::string beside_mirror(const View& view, const std::string& light) {
  return scene_of(
      view,
      R"("materials": [{"name": "m", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}, )"
      R"({"name": "mirror", "type": "mirror", "reflectance": [0.8, 0.8, 0.8]}], )" +
          meshes({square({0, 0, 0}, {0, 1, 0}, 5, "m"), square({2, 2, 0}, {-1, 0, 0}, 2, "mirror")}) +
          R"(, "lights": [)" + light + "]",
      "2");
}

// The mirror's image of the point lights the floor as a second one.
TEST(LightsWithoutArea, ShineByFlatMirrors) {
  const View view{.position = "[0, 5, 0.001]"};
  expect_value(image_of(beside_mirror(view, point({-1, 1, 0}, 3)), 16),
               lit_by_point({}, {-1, 1, 0}, 3) + 0.8 * lit_by_point({}, {5, 1, 0}, 3), "point");
  expect_value(image_of(beside_mirror(view, parallel(60, 3)), 16), 1.8 * 0.5 / kPi * 3 * 0.5, "directional");
}

// Light paths bring what sampling by way of the mirror brings, where there is none.
TEST(LightsWithoutArea, ShineByFlatMirrorsAlongLightPaths) {
  const View view{.position = "[0, 5, 0.001]", .fov_deg = 40};
  for (const auto& light : {point({-1, 1, 0}, 3), parallel(60, 3)}) {
    const auto by_mirrors = image_of(beside_mirror(view, light), 256);
    const auto by_light_paths = image_of(beside_mirror(view, light), 1024, {.mirrored_light = false});
    expect_same_means(by_light_paths, by_mirrors, light);
    const auto neither =
        image_of(beside_mirror(view, light), 64, {.light_paths = false, .mirrored_light = false});
    // The mirror brings 2.95 % of the point's light that is seen, by the inverse squares of both distances.
    EXPECT_LT(mean_of(neither, "G"), 0.98 * mean_of(by_mirrors, "G")) << light;
  }
}

TEST(LightsWithoutArea, LightAnIrradianceCacheAsTheyLightPaths) {
  const View view{.position = "[0, 0, 0.9]", .look_at = "[0, -0.2, -1]", .fov_deg = 60};
  const auto room = [&](const std::string& integrator) {
    auto text =
        scene_of(view,
                 R"("materials": [{"name": "m", "type": "lambert", "reflectance": [0.6, 0.6, 0.6]}], )" +
                     meshes({square({0, -1, 0}, {0, 1, 0}, 1, "m"), square({0, 1, 0}, {0, -1, 0}, 1, "m"),
                             square({0, 0, -1}, {0, 0, 1}, 1, "m"), square({-1, 0, 0}, {1, 0, 0}, 1, "m"),
                             square({1, 0, 0}, {-1, 0, 0}, 1, "m"), square({0, 0, 1}, {0, 0, -1}, 1, "m")}) +
                     R"(, "lights": [)" + point({0.3, 0.4, 0.1}, 1) + "]",
                 "3" + integrator);
    return text;
  };
  const auto paths = image_of(room(""), 256);
  const auto cache = image_of(room(R"(, "type": "irradiance_cache")"), 64);
  EXPECT_NEAR(mean_of(cache, "G"), mean_of(paths, "G"), 0.01 * mean_of(paths, "G"));
}

}  // namespace
