// Images of polygons that move, by their formula.
#include "analytic/motion.h"

#include "analytic/analytic_image.h"
#include "json/document.h"
#include "property/hashed_numbers.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace orbs;
using registry::FlatPolygon;

namespace {

std::vector<Vec3d> rectangle(double left, double right, double bottom, double top) {
  return {{left, bottom, 0}, {right, bottom, 0}, {right, top, 0}, {left, top, 0}};
}

// Looks along -z from so far that the plane z = 0 is seen from x = -1 to 1, as many pixels wide.
scene::Camera front_camera(int pixels) {
  scene::Camera camera;
  camera.position_m = {0, 0, 1};
  camera.fov_y_deg = 90;
  camera.width_px = camera.height_px = pixels;
  return camera;
}

// The antiderivative of x clamped to [low, high].
double integral_of_clamped(double x, double low, double high) {
  if (x < low) return low * x;
  if (x > high) return high * x - (high * high - low * low) / 2;
  return (x * x + low * low) / 2;
}

// A bar of half width h whose middle moves evenly from c0 to c1 covers a pixel from a to b for this share.
double covered_share(double a, double b, double h, double c0, double c1) {
  const auto part = [&](double x) { return integral_of_clamped(x, c0, c1); };
  return (part(b + h) - part(a + h) - part(b - h) + part(a - h)) / ((b - a) * (c1 - c0));
}

double share_of(const analytic::TimeIntervals& intervals) {
  double sum = 0;
  for (const auto& interval : intervals) sum += interval.to - interval.from;
  return sum;
}

std::string refusal(const std::string& image) {
  try {
    const auto document = json::parse("case.json", image);
    registry::load_analytic(json::ObjectReader(document));
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

std::string formula(const std::string& surface, const std::string& more) {
  return R"({"formula": "direct_light", "law": "l", "source": "s", "surfaces": [{"corners": [[0, 0, 0], [1, 0, 0],
[0, 1, 0]], "radiance": 1)" +
         surface + "}]" + more + "}";
}

}  // namespace

// The box filter of a pixel over a linear ramp.
TEST(AnalyticMotion, ABarThatSlidesCoversTrapezoids) {
  constexpr int kPixels = 16;
  registry::DirectLight image;
  image.shutter = std::array{0.25, 0.75};
  image.environment = 0.5;
  image.surfaces.push_back({FlatPolygon{rectangle(-1.1, -0.8, -2, 2), rectangle(0.9, 1.2, -2, 2)}, 2, {}});
  const auto shown = analytic::analytic_image(image, front_camera(kPixels));
  for (int x = 0; x < kPixels; ++x) {
    const double a = 2.0 * x / kPixels - 1;
    const double share = covered_share(a, a + 2.0 / kPixels, 0.15, -0.45, 0.55);
    for (int y : {0, 7, 15}) EXPECT_NEAR(shown.at(x, y, 1), 0.5 + 1.5 * share, 2e-5) << x;
  }
}

TEST(AnalyticMotion, TimesInsideAreThoseThatAPointIsFoundAt) {
  for (std::uint64_t i = 0; i < 300; ++i) {
    const auto number = [&](std::uint64_t d) { return 2.0 * tests::uniform(i, d) - 1; };
    const FlatPolygon triangle{
        {{-1 + 0.3 * number(0), -1, 0}, {1, -1 + 0.4 * number(1), 0}, {0.3 * number(2), 1, 0}},
        {{number(3) - 1, number(4) - 1, 0},
         {number(5) + 2, number(6) - 1, 0},
         {number(7), 2 + number(8), 0}}};
    const Vec3d point{1.5 * number(9), 1.5 * number(10), 0};
    const auto found = analytic::times_inside(triangle, point, {0.1, 0.9});
    constexpr int kSteps = 2000;
    int inside = 0;
    for (int k = 0; k < kSteps; ++k) {
      const auto corners = analytic::corners_at(triangle, 0.1 + 0.8 * (k + 0.5) / kSteps);
      bool is_inside = true;
      for (std::size_t e = 0; e < 3; ++e)
        is_inside = is_inside && cross(corners[(e + 1) % 3] - corners[e], point - corners[e]).z >= 0;
      inside += is_inside ? 1 : 0;
    }
    EXPECT_NEAR(share_of(found), 0.8 * inside / kSteps, 4 * 0.8 / kSteps) << i;
  }
}

TEST(AnalyticMotion, IntervalsAreAddedAndTakenAway) {
  const analytic::TimeIntervals a{{0, 0.4}, {0.5, 1}};
  const analytic::TimeIntervals b{{0.1, 0.2}, {0.3, 0.6}};
  EXPECT_NEAR(share_of(analytic::common(a, b)), 0.1 + 0.1 + 0.1, 1e-12);
  EXPECT_NEAR(share_of(analytic::without(a, b)), 0.9 - 0.3, 1e-12);
  EXPECT_NEAR(share_of(analytic::without(a, a)), 0, 1e-12);
}

// A shadow that passes in a tenth of the time is not missed.
TEST(AnalyticMotion, IntegralsSeeShortDips) {
  const auto dip = [](double t) { return std::min(1.0, std::fabs(t - 0.3141) / 0.05); };
  EXPECT_NEAR(analytic::integral(dip, {0, 1}), 1 - 0.05, 1e-5);
}

// The shadow of a polygon that comes back to where it was is that of one at rest.
TEST(AnalyticMotion, WithoutAWayIsRest) {
  registry::DirectLight image;
  image.has_shadows = true;
  image.surfaces = {{FlatPolygon{{{-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9}}}, 0, 0.5},
                    {FlatPolygon{{{-0.5, 1, 0.5}, {0.5, 1, 0.5}, {0.5, 1, -0.5}, {-0.5, 1, -0.5}}}, 0, {}}};
  image.sources.push_back(
      {FlatPolygon{{{-.3, 3, -.3}, {.3, 3, -.3}, {.3, 3, .3}, {-.3, 3, .3}}}, 60, {}, {}, {}});
  auto camera = front_camera(3);
  camera.fov_y_deg = 28;
  camera.position_m = {0, 0.9, 3};  // sees the shadow and not the card, whose edges would take long
  const auto at_rest = analytic::analytic_image(image, camera);
  auto& card = std::get<FlatPolygon>(image.surfaces[1].shape);
  card.end_corners = card.corners;
  image.shutter = std::array{0.0, 1.0};
  const auto moving = analytic::analytic_image(image, camera);
  for (std::size_t i = 0; i < at_rest.pixels.size(); ++i)
    EXPECT_NEAR(moving.pixels[i], at_rest.pixels[i], 1e-5F) << i;
}

// A lamp that moves gives the mean of the light that it gives where it is at each time.
TEST(AnalyticMotion, LightOfASourceThatMovesIsTheMeanOfInstants) {
  registry::DirectLight image;
  image.surfaces.push_back({FlatPolygon{{{-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9}}}, 0, 0.5});
  const FlatPolygon lamp{{{-1, 1, -1}, {0, 1, -1}, {0, 1, 0}, {-1, 1, 0}},
                         {{0, 1, -1}, {2, 1, -1}, {2, 1, 1}, {0, 1, 1}}};
  image.sources.push_back({lamp, 3, {}, {}, {}});
  image.shutter = std::array{0.25, 0.75};
  auto camera = front_camera(4);
  camera.position_m = {0, 0.9, 3};
  camera.fov_y_deg = 28;
  const auto moving = analytic::analytic_image(image, camera);
  constexpr int kTimes = 64;
  std::vector<double> sums(moving.pixels.size());
  image.shutter.reset();
  for (int i = 0; i < kTimes; ++i) {
    image.sources[0].shape = FlatPolygon{analytic::corners_at(lamp, 0.25 + 0.5 * (i + 0.5) / kTimes)};
    const auto now = analytic::analytic_image(image, camera);
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += static_cast<double>(now.pixels[k]) / kTimes;
  }
  for (std::size_t k = 0; k < sums.size(); ++k)
    EXPECT_NEAR(static_cast<double>(moving.pixels[k]), sums[k], 1e-4 * sums[k]) << k;
}

TEST(AnalyticMotion, RefusalsSayWhatHasAClosedForm) {
  const auto expect = [](const std::string& surface, const std::string& more, const std::string& part) {
    const auto text = refusal(formula(surface, more));
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  const std::string open = R"(, "shutter": [0, 1])";
  const auto to = [](const char* corners) { return fmt::format(R"(, "end_corners": [{}])", corners); };
  expect(to("[1, 0, 0], [2, 0, 0], [1, 1, 0]"), open, "no error");
  expect(to("[1, 0, 1], [2, 0, 1], [1, 1, 1]"), open, "must lie in the plane of 'corners'");
  expect(to("[1, 0, 0], [1, 1, 0], [2, 0, 0]"), open, "must run the same way round");
  expect(to("[1, 0, 0], [2, 0, 0], [2, 1, 0], [1, 1, 0]"), open, "must be as many as 'corners', 3");
  expect(to("[1, 0, 0], [2, 0, 0], [1, 1, 0]"), "", "/shutter: is needed where something has 'end_corners'");
  expect("", open, "/shutter: has no effect");
  expect(to("[1, 0, 0], [2, 0, 0], [1, 1, 0]"), R"(, "shutter": [1, 1])", "must open before it closes");
}
