// A transport that carries more than the scene calls for renders the same image.
#include "base/error.h"
#include "property/light_images.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using namespace orbs::tests;
using scene::LightTransport;

struct MaterialCase {
  std::string name;
  std::string model;
};

// Grey, because the product of two colours differs between three channels and a spectrum.
const std::vector<MaterialCase> kMaterials{
    {"Lambert", R"("type": "lambert", "reflectance": [0.6, 0.6, 0.6])"},
    {"OrenNayar", R"("type": "oren_nayar", "reflectance": [0.6, 0.6, 0.6], "roughness": 0.4)"},
    {"Mirror", R"("type": "mirror", "reflectance": [0.8, 0.8, 0.8])"},
    {"Glass", R"("type": "glass", "ior": 1.5)"},
    {"Ggx", R"("type": "ggx", "colour": [0.8, 0.8, 0.8], "alpha": 0.2)"},
    {"RoughGlass", R"("type": "rough_glass", "ior": 1.5, "alpha": 0.3)"},
    {"Conductor", R"("type": "conductor", "index": {"n": 0.2, "k": 3.4})"},
    {"RoughConductor", R"("type": "conductor", "index": {"n": 0.2, "k": 3.4}, "alpha": 0.3)"},
    {"Dielectric", R"("type": "dielectric", "index": 1.5)"},
    {"RoughDielectric", R"("type": "dielectric", "index": 1.5, "alpha": 0.3, "distribution": "beckmann")"}};

constexpr std::array kRicher{LightTransport::Spectral, LightTransport::Polarised, LightTransport::Bispectral,
                             LightTransport::PolarisedBispectral};

// A pane of the material above a depolarising floor: between two hits of the pane, light always hits the
// floor, so that polarisation makes no difference.
std::string sheet_over_floor(const std::string& material) {
  return scene_of(
      {.position = "[0, 2.5, 4]", .look_at = "[0, 0.5, 0]", .fov_deg = 40, .width = 24, .height = 24},
      R"("environment": [0.3, 0.3, 0.3], "materials": [{"name": "m", )" + material +
          R"(}, {"name": "floor", "type": "lambert", "reflectance": [0.7, 0.7, 0.7]}], )" +
          meshes({square({0, 0.6, 0}, {0, 1, 0}, 1, "m"), square({0, 0, 0}, {0, 1, 0}, 20, "floor")}) +
          R"(, "lights": [{"type": "rect", "half_width": 1, "half_length": 1, "radiance": [4, 4, 4], "matrix": [{"translate": [0.5, 3, 0]}]}])",
      "6");
}

void expect_same_means(const image::Image& a, const image::Image& b, const std::string& what) {
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double error = std::hypot(error_of_mean(a, channel), error_of_mean(b, channel));
    EXPECT_NEAR(mean_of_channel(a, channel), mean_of_channel(b, channel), 4 * error + 1e-5)
        << what << " channel " << channel;
    EXPECT_LT(error, 0.015 * mean_of_channel(b, channel)) << what;
  }
}

class RicherTransport : public testing::TestWithParam<MaterialCase> {};

}  // namespace

TEST_P(RicherTransport, ShowsTheSameImage) {
  const auto text = sheet_over_floor(GetParam().model);
  const auto plain = image_of(text, 64);
  for (const auto transport : kRicher)
    expect_same_means(image_of(text, 64, {.transport = transport}, 2), plain,
                      std::string(scene::transport_name(transport)));
}

INSTANTIATE_TEST_SUITE_P(Materials, RicherTransport, testing::ValuesIn(kMaterials), [](const auto& material) {
  return material.param.name;
});

// One reflection multiplies a colour with white light only, which spectra of colours reproduce.
TEST(RicherTransports, KeepTheColoursOfWhatWhiteLightShows) {
  const auto text = scene_of({.fov_deg = 1},
                             R"("environment": [1, 1, 1],
         "materials": [{"name": "m", "type": "lambert", "reflectance": [0.9, 0.3, 0.05]}],
         "shapes": [{"type": "sphere", "centre": [0, 0, 0], "radius": 1, "material": "m"}])",
                             "1");
  const auto plain = image_of(text, 64);
  for (const auto transport : kRicher) {
    const auto image = image_of(text, 256, {.transport = transport});
    for (std::size_t channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(mean_of_channel(image, channel), mean_of_channel(plain, channel),
                  4 * error_of_mean(image, channel) + 1e-5)
          << scene::transport_name(transport) << " channel " << channel;
  }
}

// Where light is scattered by two polarising surfaces in succession the transports differ, by a known amount
// (PolarisedLight.AGlassSlabTransmitsEachPolarisationByItself).

namespace {

// Everything that polarises, disperses or fluoresces, as far as the transport supports it.
std::string busy_scene(LightTransport transport) {
  std::string materials =
      R"({"name": "floor", "type": "lambert", "reflectance": [0.7, 0.6, 0.5]}, {"name": "a", "type": "ggx", "colour": [0.8, 0.8, 0.8], "alpha": 0.2})";
  if (transport == LightTransport::Rgb)
    materials +=
        R"(, {"name": "b", "type": "dielectric", "index": 1.5, "alpha": 0.1}, {"name": "c", "type": "glass", "ior": 1.3})";
  else
    materials +=
        R"(, {"name": "b", "type": "dielectric", "index": {"cauchy": [1.5, 0.005]}}, {"name": "c", "type": "conductor", "index": {"file": "data/common/spectra/metals/copper.csv"}, "alpha": 0.2, "film": {"index": 1.4, "height_nm": 300}})";
  const bool fluoresces =
      transport == LightTransport::Bispectral || transport == LightTransport::PolarisedBispectral;
  materials +=
      fluoresces
          ? R"(, {"name": "d", "type": "fluorescent", "reflectance": [0.2, 0.2, 0.2], "reradiation": {"first_nm": 300, "width_nm": 200, "bins": 2, "shares": [[0, 0], [0.7, 0]]}})"
          : R"(, {"name": "d", "type": "oren_nayar", "reflectance": [0.2, 0.5, 0.2], "roughness": 1})";
  if (transport == LightTransport::Polarised || transport == LightTransport::PolarisedBispectral)
    materials += R"(, {"name": "filter", "type": "polariser", "axis": [1, 0, 0]})";
  else
    materials += R"(, {"name": "filter", "type": "glass", "ior": 1.2})";
  std::string shapes;
  for (int i = 0; i < 4; ++i)
    shapes +=
        fmt::format(R"({}{{"type": "sphere", "centre": [{}, 0.5, 0], "radius": 0.5, "material": "{}"}})",
                    i == 0 ? "" : ", ", 1.1 * i - 1.65, "abcd"[i]);
  return scene_of(
      {.position = "[0, 2, 6]", .look_at = "[0, 0.4, 0]", .fov_deg = 35, .width = 40, .height = 20},
      R"("environment": [0.2, 0.3, 0.4], "materials": [)" + materials + R"(], "shapes": [)" + shapes + "], " +
          meshes({square({0, 0, 0}, {0, 1, 0}, 20, "floor"), square({0.8, 1, 3}, {0, 0, 1}, 0.3, "filter")}) +
          R"(, "lights": [{"type": "sphere", "radius": 0.4, "radiance": [9, 8, 7], "matrix": [{"translate": [1, 3, 1]}]}])");
}

image::Image rendered(const std::string& text, int threads, std::uint64_t seed, bool stokes) {
  auto scene = scene::load_scene_text("test.json", text, ORBS_SOURCE_DIR);
  scene.outputs.stokes = stokes;
  const std::atomic<bool> never{false};
  return tracer::render(tracer::make_world(scene),
                        {.samples_per_pixel = 12, .seed = seed, .threads = threads}, never,
                        [](const tracer::Progress&) {})
      .image;
}

}  // namespace

TEST(RicherTransports, ImagesDoNotDependOnTheNumberOfThreads) {
  for (const auto transport : scene::kTransports)
    for (const bool stokes : {false, true}) {
      const auto text = busy_scene(transport);
      const auto name = std::string(scene::transport_name(transport)) + (stokes ? " with Stokes" : "");
      if (!stokes) {
        const auto scene = scene::load_scene_text("test.json", text, ORBS_SOURCE_DIR);
        ASSERT_EQ(scene::transport(scene::effects(scene)), transport) << name;
      }
      const auto one = rendered(text, 1, 7, stokes);
      EXPECT_EQ(one.pixels, rendered(text, 3, 7, stokes).pixels) << name;
      EXPECT_NE(one.pixels, rendered(text, 3, 8, stokes).pixels) << name;
    }
}

// The four Stokes parameters describe the same light in more detail.
TEST(RicherTransports, StokesLayersDoNotChangeTheImage) {
  const auto text = busy_scene(LightTransport::Polarised);
  const auto plain = rendered(text, 1, 7, false);
  const auto stokes = rendered(text, 1, 8, true);
  for (std::size_t channel = 0; channel < 3; ++channel)
    EXPECT_NEAR(mean_of_channel(stokes, channel), mean_of_channel(plain, channel),
                4 * std::hypot(error_of_mean(stokes, channel), error_of_mean(plain, channel)));
  EXPECT_EQ(mean_of(stokes, "S0.R"), mean_of_channel(stokes, 0));
}

// Effects that a path does not encounter do not change its rounding either.
TEST(RicherTransports, WithoutFluorescenceBispectralImagesAreTheSpectralOnesToTheBit) {
  const auto text = busy_scene(LightTransport::Spectral);
  const auto image = [&](LightTransport transport) {
    return image_of(text, 8, {.transport = transport, .light_paths = false}).pixels;
  };
  EXPECT_EQ(image(LightTransport::Bispectral), image(LightTransport::Spectral));
  EXPECT_EQ(image(LightTransport::PolarisedBispectral), image(LightTransport::Polarised));
}

// With or without dispersion, light paths find the same caustic of a ball as camera paths.
TEST(RicherTransports, LightPathsShowTheSameDispersedCaustic) {
  for (const std::string& index : {std::string("1.5"), std::string(R"({"cauchy": [1.5, 0.01]})")}) {
    const auto text = scene_of(
        {.position = "[0, 3, 4]", .look_at = "[0, 0, 0]", .fov_deg = 40, .width = 16, .height = 16},
        R"("materials": [{"name": "ball", "type": "dielectric", "index": )" + index +
            R"(}, {"name": "floor", "type": "lambert", "reflectance": [0.8, 0.8, 0.8]}],
               "shapes": [{"type": "sphere", "centre": [0, 1, 0], "radius": 0.7, "material": "ball"}], )" +
            meshes({square({0, 0, 0}, {0, 1, 0}, 5, "floor")}) +
            R"(, "lights": [{"type": "rect", "half_width": 2, "half_length": 2, "radiance": [2, 2, 2], "matrix": [{"translate": [1, 4, 0]}]}])",
        "6");
    const auto spectral = LightTransport::Spectral;
    const auto with = image_of(text, 64, {.transport = spectral});
    const auto without = image_of(text, 512, {.transport = spectral, .light_paths = false});
    expect_same_means(with, without, index);
  }
}

namespace {

std::string refusal(const std::string& text, LightTransport transport) {
  try {
    tracer::make_world(scene::load_scene_text("test.json", text, ORBS_SOURCE_DIR), {.transport = transport});
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace

TEST(RicherTransports, ATransportThatLacksWhatTheSceneCallsForIsRefused) {
  const auto text = [](const std::string& material) {
    return scene_of({}, R"("materials": [{"name": "m", )" + material + "}], " +
                            meshes({square({0, 0, 0}, {0, 0, 1}, 1, "m")}));
  };
  const auto polariser = text(R"("type": "polariser", "axis": [1, 0, 0])");
  const auto fluorescent = text(
      R"("type": "fluorescent", "reflectance": [0, 0, 0], "reradiation": {"first_nm": 400, "width_nm": 50, "bins": 2, "shares": [[0, 0], [1, 0]]})");
  EXPECT_EQ(refusal(text(R"("type": "dielectric", "index": {"cauchy": [1.5, 0.01]})"), LightTransport::Rgb),
            "scene 'test' calls for spectral transport because material 'm' has an index that varies by "
            "0.0966, which rgb transport does not have");
  EXPECT_EQ(refusal(polariser, LightTransport::Bispectral),
            "scene 'test' calls for polarised transport because material 'm' is a polariser, which "
            "bispectral transport does not have");
  EXPECT_EQ(refusal(fluorescent, LightTransport::Polarised),
            "scene 'test' calls for bispectral transport because material 'm' turns light of 400 to 450 "
            "nm into light of 450 to 500 nm, which polarised transport does not have");
  EXPECT_EQ(refusal(polariser, LightTransport::PolarisedBispectral), "");
  EXPECT_EQ(refusal(fluorescent, LightTransport::PolarisedBispectral), "");
}
