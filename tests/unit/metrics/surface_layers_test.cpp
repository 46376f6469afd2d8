// Layers of surfaces: what single pixels, means of blocks and numbers of things may be, and may not.
#include "metrics/surface_layers.h"

#include "image/colour.h"
#include "metrics/image_pair.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

using namespace orbs;

namespace {

constexpr int kSide = 32;

using Fill = std::function<float(int x, int y)>;

// Grey, with the channels of layers by place.
image::Image with_layers(const std::vector<std::pair<std::string, Fill>>& layers) {
  std::vector<std::string> channels{"R", "G", "B"};
  for (const auto& [name, fill] : layers) channels.push_back(name);
  auto image = image::make_image(kSide, kSide, channels);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) = 0.5F;
      for (std::size_t i = 0; i < layers.size(); ++i) image.at(x, y, 3 + i) = layers[i].second(x, y);
    }
  return image;
}

// The depth of a plane that runs away to the right: 1 m + 0.1 m a pixel, at a place within the pixel.
image::Image ramp(float place) {
  return with_layers({{"depth.Z", [=](int x, int) { return 1 + 0.1F * (static_cast<float>(x) + place); }}});
}

// The same as a reference, which knows what each pixel shows.
image::Image ramp_reference() {
  const auto at = [](float place) {
    return [=](int x, int) { return 1 + 0.1F * (static_cast<float>(x) + place); };
  };
  return with_layers({{"depth.Z", at(0.5F)}, {"least.depth.Z", at(0)}, {"most.depth.Z", at(1)}});
}

metrics::MetricResult pixels_off(const image::Image& result, const image::Image& reference) {
  return metrics::compute_layer_pixels(metrics::make_image_pair(result, reference));
}

metrics::MetricResult error(const image::Image& result, const image::Image& reference) {
  return metrics::compute_layer_error(metrics::make_image_pair(result, reference));
}

// Two things side by side.
image::Image two_things(float left, float right, float edge) {
  return with_layers({{"object.id", [=](int x, int) { return x < 15 ? left : x > 15 ? right : edge; }}});
}

}  // namespace

TEST(SurfaceLayers, AnImageWithoutLayersHasNothingToCompare) {
  const auto plain = with_layers({});
  EXPECT_EQ(pixels_off(ramp(0.5F), plain).absence, metrics::Absence::NothingInReference);
  EXPECT_FALSE(pixels_off(ramp(0.5F), plain).value);
}

TEST(SurfaceLayers, ALayerThatIsMissingIsNamed) {
  const auto missing = pixels_off(with_layers({}), ramp_reference());
  EXPECT_EQ(missing.absence, metrics::Absence::MissingInResult);
  EXPECT_EQ(missing.what, "depth");
  EXPECT_EQ(error(with_layers({}), ramp_reference()).absence, metrics::Absence::MissingInResult);
}

TEST(SurfaceLayers, TheMeanOfAPixelIsRight) {
  EXPECT_EQ(pixels_off(ramp(0.5F), ramp_reference()).value, 0);
  EXPECT_NEAR(*error(ramp(0.5F), ramp_reference()).value, 0, 1e-9);
}

// As of a renderer that writes the first sample.
TEST(SurfaceLayers, AnyOneSampleOfAPixelIsRight) {
  const auto sampled = with_layers({{"depth.Z", [](int x, int y) {
                                       const auto place = static_cast<float>((7 * x + 11 * y) % 16) / 16;
                                       return 1 + 0.1F * (static_cast<float>(x) + place);
                                     }}});
  EXPECT_EQ(pixels_off(sampled, ramp_reference()).value, 0);
  EXPECT_EQ(*error(sampled, ramp_reference()).value, 0);
}

TEST(SurfaceLayers, HalfAPixelOfShiftIsAnErrorOfTheMeans) {
  const auto shifted = error(ramp(1), ramp_reference());
  EXPECT_GT(*shifted.value, 0.002);
  EXPECT_NE(shifted.what.find("depth.Z"), std::string::npos);
}

// 5 % along the ray, as far from the axis as in the corners of a lens of 36 degrees.
TEST(SurfaceLayers, DepthAlongTheRayIsBeyondWhatThePixelShows) {
  const auto along_rays = with_layers({{"depth.Z", [](int x, int y) {
                                          const double u = (x - 15.5) / 50;
                                          const double v = (y - 15.5) / 50;
                                          return static_cast<float>(2 * std::sqrt(1 + u * u + v * v));
                                        }}});
  const auto flat = with_layers({{"depth.Z", [](int, int) { return 2.0F; }}});
  EXPECT_GT(*pixels_off(along_rays, flat).value, 500);
  EXPECT_GT(*error(along_rays, flat).value, 0.01);
}

TEST(SurfaceLayers, OnePixelOffIsFoundWithItsPlace) {
  auto wrong = ramp(0.5F);
  wrong.at(20, 9, 3) = 5;
  const auto found = pixels_off(wrong, ramp_reference());
  EXPECT_EQ(found.value, 1);
  ASSERT_TRUE(found.where);
  EXPECT_EQ(found.where->x0, 20);
  EXPECT_EQ(found.where->y0, 9);
  EXPECT_GT(found.map.at(20, 9, 0), 0.3F);
  wrong.at(20, 9, 3) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(pixels_off(wrong, ramp_reference()).value, 1);
  EXPECT_TRUE(std::isinf(*error(wrong, ramp_reference()).value));
}

// Renderers differ in what they make of what is beside a surface.
TEST(SurfaceLayers, WhereASurfaceCoversAPartOnlyTheCoverageIsJudged) {
  const Fill covered = [](int x, int) { return x < 15 ? 1.0F : x == 15 ? 0.4F : 0.0F; };
  const auto reference =
      with_layers({{"coverage.A", covered}, {"depth.Z", [](int x, int) { return x < 16 ? 2.0F : 0.0F; }}});
  const Fill far = [](int x, int) { return x < 15 ? 2.0F : 1e10F; };
  EXPECT_EQ(pixels_off(with_layers({{"coverage.A", covered}, {"depth.Z", far}}), reference).value, 0);
  const Fill half = [](int x, int) { return x < 15 ? 0.5F : 0.0F; };
  EXPECT_EQ(pixels_off(with_layers({{"coverage.A", half}, {"depth.Z", far}}), reference).value, 14 * kSide);
  EXPECT_GT(*error(with_layers({{"coverage.A", half}, {"depth.Z", far}}), reference).value, 0.2);
}

TEST(SurfaceLayers, ACoverageThatTheSceneDoesNotAskForIsNotCompared) {
  auto reference = with_layers(
      {{"coverage.A", [](int, int) { return 0.5F; }}, {"depth.Z", [](int, int) { return 2.0F; }}});
  const auto result = with_layers({{"depth.Z", [](int, int) { return 2.0F; }}});
  EXPECT_EQ(pixels_off(result, reference).absence, metrics::Absence::MissingInResult);
  reference.attributes["orbs.layers"] = "depth normal";
  EXPECT_EQ(pixels_off(result, reference).value, 0);
}

TEST(SurfaceLayers, ThingsMayHaveOtherNumbers) {
  const auto reference = two_things(1, 2, 1);
  EXPECT_EQ(pixels_off(two_things(1, 2, 1), reference).value, 0);
  EXPECT_EQ(pixels_off(two_things(40, 7, 40), reference).value, 0);
  EXPECT_EQ(pixels_off(two_things(2, 1, 1), reference).value, 0);  // the other side of the edge
}

TEST(SurfaceLayers, ANumberThatIsAveragedAtAnEdgeStandsForAThirdThing) {
  const auto averaged = pixels_off(two_things(1, 2, 1.5F), two_things(1, 2, 1));
  EXPECT_EQ(averaged.value, kSide);
  EXPECT_NE(averaged.what.find("object.id is 1.5"), std::string::npos) << averaged.what;
}

TEST(SurfaceLayers, TwoThingsWithOneNumberAreFound) {
  const auto same = pixels_off(two_things(3, 3, 3), two_things(1, 2, 1));
  EXPECT_GT(*same.value, 10 * kSide);
  EXPECT_NE(same.what.find("also the number of another thing"), std::string::npos) << same.what;
}

TEST(SurfaceLayers, OneThingWithTwoNumbersIsFound) {
  const auto split = with_layers({{"object.id", [](int, int y) { return y < 8 ? 5.0F : 6.0F; }}});
  EXPECT_EQ(pixels_off(split, two_things(1, 1, 1)).value, 8 * kSide);
}

TEST(SurfaceLayers, MaskedPixelsDoNotCount) {
  auto wrong = ramp(0.5F);
  wrong.at(20, 9, 3) = 5;
  const auto pair = metrics::make_image_pair(wrong, ramp_reference(), {{{20, 9, 21, 10}}, {}});
  EXPECT_EQ(metrics::compute_layer_pixels(pair).value, 0);
}

namespace {

// Normals of a cylinder that lies aslant, or what `mistake` makes of them.
using Normal = std::array<double, 3>;

image::Image normals(const std::function<Normal(Normal)>& mistake) {
  const auto part = [=](std::size_t i) {
    return [=](int x, int y) {
      const double a = (x - 16) / 12.0;
      const double b = (y - 16) / 20.0;
      const double size = std::sqrt(1 + a * a + b * b);
      return static_cast<float>(mistake({a / size, b / size, 1 / size}).at(i));
    };
  };
  return with_layers({{"normal.X", part(0)}, {"normal.Y", part(1)}, {"normal.Z", part(2)}});
}

Normal right(Normal n) { return n; }

std::string fault_of(const image::Image& result, const image::Image& reference) {
  return pixels_off(result, reference).what;
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

}  // namespace

TEST(LayerFaults, MistakesOfNormalsAreNamed) {
  const auto reference = normals(right);
  const auto absolute = [](Normal n) { return Normal{std::fabs(n[0]), std::fabs(n[1]), n[2]}; };
  expect_part(fault_of(normals(absolute), reference), "'normal' is without signs");
  const auto encoded = [](Normal n) { return Normal{0.5 * n[0] + 0.5, 0.5 * n[1] + 0.5, 0.5 * n[2] + 0.5}; };
  expect_part(fault_of(normals(encoded), reference), "halved and moved into [0, 1]");
  const auto outwards = [](Normal n) { return n[0] > 0 ? Normal{-n[0], -n[1], -n[2]} : n; };
  expect_part(fault_of(normals(outwards), reference), "'normal' is not turned to the viewer everywhere");
  const double c = std::cos(0.5);
  const double s = std::sin(0.5);
  const auto turned = [=](Normal n) { return Normal{c * n[0] + s * n[2], n[1], c * n[2] - s * n[0]}; };
  expect_part(fault_of(normals(turned), reference),
              "in another space, as that of the camera, turned by 28.6 degrees");
}

TEST(LayerFaults, MistakesOfDepthAreNamed) {
  const auto plane = [](int x, int) { return 3 + 0.1F * static_cast<float>(x); };
  const auto reference = with_layers({{"depth.Z", plane}});
  const auto along_rays =
      with_layers({{"depth.Z", [=](int x, int y) {
                      const double u = (x - 15.5) / 30;
                      const double v = (y - 15.5) / 30;
                      return plane(x, y) * static_cast<float>(std::sqrt(1 + u * u + v * v));
                    }}});
  expect_part(fault_of(along_rays, reference), "'depth' is along the ray and not along the axis");
  const auto in_cm = with_layers({{"depth.Z", [=](int x, int y) { return 100 * plane(x, y); }}});
  expect_part(fault_of(in_cm, reference), "100 times what it should be");
}

TEST(LayerFaults, MistakesOfTextureCoordinatesAndAlbedosAreNamed) {
  const auto u = [](int x, int) { return 0.02F * static_cast<float>(x); };
  const auto v = [](int, int y) { return 0.03F * static_cast<float>(y); };
  const auto from_top = [](int, int y) { return 1 - 0.03F * static_cast<float>(y); };
  const auto uv = with_layers({{"uv.U", u}, {"uv.V", v}});
  expect_part(fault_of(with_layers({{"uv.U", u}, {"uv.V", from_top}}), uv),
              "counted from the other end in v");
  expect_part(fault_of(with_layers({{"uv.U", v}, {"uv.V", u}}), uv), "swapped in u and v");
  const auto encoded = [=](int x, int y) { return image::srgb_encode(u(x, y)); };
  const auto albedo = with_layers({{"albedo.R", u}, {"albedo.G", u}, {"albedo.B", u}});
  expect_part(
      fault_of(with_layers({{"albedo.R", encoded}, {"albedo.G", encoded}, {"albedo.B", encoded}}), albedo),
      "'albedo' is encoded as sRGB");
}

TEST(LayerFaults, AnotherErrorHasNoName) {
  auto wrong = ramp(0.5F);
  for (int y = 0; y < kSide; ++y) wrong.at(9, y, 3) = 7;
  EXPECT_EQ(fault_of(wrong, ramp_reference()).find("the layer"), std::string::npos);
}
