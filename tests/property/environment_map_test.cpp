// Environment maps: the density of their directions, the image that rays see, and the cases of D5 and D6,
// whose images are known, with the mistakes that they are there to find.
#include "tracer/light/environment_map.h"

#include "property/hashed_numbers.h"
#include "property/judged_case.h"
#include "property/sampling_density.h"
#include "registry/configuration.h"
#include "scene/environment.h"
#include "scene/load/load_scene.h"

#include <functional>
#include <numbers>
#include <vector>

using namespace orbs;
using tracer::EnvironmentMap;

namespace {

constexpr double kPi = std::numbers::pi;

// Dark texels beside bright ones, black rows, one row alone at a pole.
tracer::TexelGrid made_up_sky(int width, int height) {
  tracer::TexelGrid sky{width, height, {}, {}, {}, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto i = static_cast<std::uint64_t>(y * width + x);
      const float scale = y == 2 ? 0.0F : tests::uniform(i, 3) < 0.2F ? 20.0F : 1.0F;
      sky.texels.push_back(Vec3f{tests::uniform(i, 0), tests::uniform(i, 1), tests::uniform(i, 2)} * scale);
    }
  return sky;
}

Vec3f direction_at(const Mat4& matrix, Vec2d uv) {
  return cast<float>(transform_direction(matrix, scene::map_direction(uv)));
}

const Mat4 kTurned = rotation_y(40) * rotation_x(25) * scaling({-1, 1, 1});

registry::Suite everyday() {
  return registry::find_suite(registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json"),
                              "everyday");
}

struct Mistake {
  const char* what;
  std::function<void(scene::Environment&)> change;
};

Mistake turned_by(const char* what, const Mat4& turn) {
  return {what, [turn](scene::Environment& sky) { sky.map->matrix = turn * sky.map->matrix; }};
}

std::vector<Mistake> mistakes_in(const std::string& scene) {
  if (scene == "d5-sun") return {turned_by("a quarter turn", rotation_y(90))};
  if (scene == "d5-turned")
    return {{"the inverse of its matrix",
             [](scene::Environment& sky) { sky.map->matrix = inverse(sky.map->matrix).value(); }}};
  return {turned_by("a quarter turn", rotation_y(90)),
          turned_by("half a turn", rotation_y(180)),
          turned_by("mirrored", scaling({-1, 1, 1})),
          turned_by("upside down", scaling({1, -1, 1})),
          turned_by("z up", rotation_x(90)),
          {"an invisible sky, or a visible one",
           [](scene::Environment& sky) { sky.visible_to_camera = !sky.visible_to_camera; }}};
}

}  // namespace

TEST(EnvironmentMapDensity, IsThatOfItsDirections) {
  for (const auto& [width, height] : {std::pair{8, 5}, std::pair{2, 1}, std::pair{1, 1}, std::pair{64, 32}}) {
    const auto map = make_environment_map(made_up_sky(width, height), kTurned);
    const Mat4 back = inverse(kTurned).value();
    std::vector<Vec2d> places;
    for (std::uint64_t i = 0; i < tests::kTrials; ++i) {
      const auto u = tests::four_uniform(i);
      const Vec3f d = sample_direction(*map, u[0], u[1]);
      EXPECT_NEAR(length(d), 1, 1e-5);
      // v to the height, so that equal areas are equal solid angles.
      const Vec2d uv = scene::map_coordinates(transform_direction(back, cast<double>(d)));
      places.push_back(
          {std::clamp(uv.x, 0.0, 1 - 1e-12), std::clamp(-std::cos(uv.y * kPi), -1.0, 1 - 1e-12)});
    }
    const auto density = [&](Vec2d place) {
      const double v = std::acos(-place.y) / kPi;
      return 2 * kPi * static_cast<double>(pdf_of(*map, direction_at(kTurned, {place.x, v})));
    };
    tests::expect_density(tests::chi_square(places, tests::kTrials, {{0, -1}, {1, 1}}, density),
                          std::to_string(width) + " x " + std::to_string(height));
  }
}

TEST(EnvironmentMapDensity, IsNearlyThatOfTheLight) {
  const auto map = make_environment_map(made_up_sky(64, 32), kTurned);
  double sum = 0;
  double sum_of_squares = 0;
  for (std::uint64_t i = 0; i < tests::kTrials; ++i) {
    const auto u = tests::four_uniform(i);
    const Vec3f d = sample_direction(*map, u[0], u[1]);
    const Vec3f light = radiance_from(*map, d);
    const double weight = (0.2126 * static_cast<double>(light.x) + 0.7152 * static_cast<double>(light.y) +
                           0.0722 * static_cast<double>(light.z)) /
                          static_cast<double>(pdf_of(*map, d));
    sum += weight;
    sum_of_squares += weight * weight;
  }
  const double mean = sum / tests::kTrials;
  EXPECT_NEAR(mean, 4 * kPi * map->mean_luminance, 0.002 * mean);
  // Between rows near a pole the product of two linear functions is not linear.
  EXPECT_LT(std::sqrt(sum_of_squares / tests::kTrials - mean * mean), 0.06 * mean);
}

TEST(EnvironmentMapRadiance, IsThatOfTexelsAndBetweenThem) {
  const auto sky = made_up_sky(8, 5);
  const auto map = make_environment_map(sky, kTurned);
  const auto seen = [&](double u, double v) { return radiance_from(*map, direction_at(kTurned, {u, v})); };
  const auto texel = [&](std::size_t x, std::size_t y) { return sky.texels[y * 8 + x]; };
  const auto expect_near = [](Vec3f a, Vec3f b) { EXPECT_LT(length(a - b), 1e-4F) << a.x << " for " << b.x; };
  for (std::size_t y = 0; y < 5; ++y)
    for (std::size_t x = 0; x < 8; ++x)
      expect_near(seen((static_cast<double>(x) + 0.5) / 8, (static_cast<double>(y) + 0.5) / 5), texel(x, y));
  expect_near(seen(1, 0.3), (texel(7, 1) + texel(0, 1)) * 0.5F);  // across the seam
  expect_near(seen(2. / 8, 0.4), (texel(1, 1) + texel(2, 1) + texel(1, 2) + texel(2, 2)) * 0.25F);
  expect_near(seen(3.5 / 8, 0.02), texel(3, 0));  // near a pole nothing comes from beyond it
  expect_near(seen(3.5 / 8, 0.98), texel(3, 4));
}

// Of rows that are even: else the density at a pole would be another from each side.
TEST(EnvironmentMapDensity, HasALimitAtThePoles) {
  auto sky = made_up_sky(8, 5);
  for (std::size_t i = 0; i < sky.texels.size(); ++i) sky.texels[i] = sky.texels[i / 8 * 8];
  const auto map = make_environment_map(sky, Mat4{});
  for (const float y : {-1.0F, 1.0F}) {
    const float at_pole = pdf_of(*map, {0, y, 0});
    const float beside = pdf_of(*map, {0, y, -1e-4F});
    EXPECT_GT(at_pole, 0);
    EXPECT_NEAR(at_pole, beside, 0.01F * beside);
  }
}

TEST(EnvironmentCases, KnownImagesAreShownAndMistakesFail) {
  const auto suite = everyday();
  int seen = 0;
  for (const auto& one_case : registry::load_cases(suite)) {
    if (one_case.requirement != "D5" && one_case.requirement != "D6") continue;
    for (const auto& one : one_case.scenes) {
      if (!one.analytic) continue;
      ++seen;
      const auto scene = scene::load_scene(one.file, {}, one.camera);
      tests::expect_verdict(tests::judged(one_case, one.name, scene, suite.references, registry::FullSize),
                            results::Verdict::Pass, "");
      for (const auto& [what, change] : mistakes_in(one.name)) {
        auto wrong = scene;
        change(wrong.environment);
        tests::expect_verdict(tests::judged(one_case, one.name, wrong, suite.references),
                              results::Verdict::Fail, std::string(" ") + what);
      }
    }
  }
  EXPECT_EQ(seen, 4);
}

// With a lamp beside the sky, so that there is a choice.
TEST(EnvironmentCases, ThreeEstimatorsAgree) {
  auto scene =
      scene::load_scene(ORBS_SOURCE_DIR "/data/cases/everyday/d5_environment_map/d5-court.json", {}, "");
  scene.lights.push_back(
      {"lamp", scene::RectShape{0.5, 0.5}, {2, 2, 2}, translation({0, 1.9, 0}), {}, {}, {}});
  std::vector<double> means;
  const std::atomic<bool> never{false};
  for (const auto direct_light :
       {tracer::DirectLight::Mis, tracer::DirectLight::Light, tracer::DirectLight::Bsdf}) {
    const auto image = tracer::render(tracer::make_world(scene, {.direct_light = direct_light}),
                                      {.samples_per_pixel = 256}, never, [](const tracer::Progress&) {})
                           .image;
    double sum = 0;
    for (std::size_t i = 0; i < image.pixel_count(); ++i)
      sum += static_cast<double>(image.pixels[i * image.channels.size()]);
    means.push_back(sum / static_cast<double>(image.pixel_count()));
  }
  // The standard error of BSDF sampling alone is 0.1 %; that of the others a tenth of it.
  EXPECT_NEAR(means[1], means[0], 0.0005 * means[0]);
  EXPECT_NEAR(means[2], means[0], 0.005 * means[0]);
}
