#include "adapters/export.h"
#include "base/files.h"
#include "golden/read_back.h"
#include "scene/load/load_scene.h"
#include "spectra/observer.h"
#include "spectra/rgb.h"

#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>

/// What goes beyond ORB.S, by the entries of configuration.json: what the exporters write of the appearance
/// suite is read back and compared with the scene, and the rest is refused with the reason that is true.
namespace {

using namespace orbs;
namespace fs = std::filesystem;

const registry::Renderer& renderer(const std::string& name) {
  static const auto kConfiguration =
      registry::load_configuration(fs::path(ORBS_SOURCE_DIR) / "configuration.json");
  for (const auto& one : kConfiguration.renderers)
    if (one.name == name) return one;
  throw std::runtime_error("no renderer " + name);
}

scene::Scene appearance_scene(const std::string& name) {
  return scene::load_scene(fs::path(ORBS_SOURCE_DIR) / "data/cases/appearance" / (name + ".json"));
}

// Why the renderer cannot have it; "" when it can.
std::string refusal(const std::string& name, const scene::Scene& scene) {
  const auto prepared = adapters::prepare_scene(renderer(name), scene);
  return std::holds_alternative<std::string>(prepared) ? std::get<std::string>(prepared) : "";
}

struct Exported {
  scene::Scene scene;  // as it was prepared
  tests::ReadScene read;
};

Exported exported(const std::string& name, const scene::Scene& scene) {
  auto prepared = adapters::prepare_scene(renderer(name), scene);
  if (const auto* reason = std::get_if<std::string>(&prepared)) throw std::runtime_error(*reason);
  const ScratchFolder folder("orbs-exported-appearance-" + name);
  const fs::path file = folder.path() / "scene.txt";
  Exported out{std::get<scene::Scene>(prepared), {}};
  adapters::export_scene(renderer(name), out.scene, file);
  out.read = name == "mitsuba" ? tests::read_mitsuba(file) : tests::read_pbrt(file);
  return out;
}

const scene::NamedSpectrum& spectrum_named(const scene::Scene& scene, const std::string& name) {
  for (const auto& one : scene.spectra)
    if (one.name == name) return one;
  throw std::runtime_error("no spectrum " + name);
}

// Also between the samples and at the ends, where a list that is too short would read as zero.
constexpr std::array kProbes_nm{360.0, 380.0, 437.5, 550.0, 612.25, 730.0, 830.0};

void expect_spectrum(const tests::ReadSpectrum& found,
                     const spectra::Spectrum& expected,
                     const std::string& what) {
  for (const double nm : kProbes_nm)
    EXPECT_NEAR(tests::value_at(found, nm), value_at(expected, nm), 1e-6) << what << " at " << nm;
}

class Spectral : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Formats, Spectral, testing::Values("mitsuba", "pbrt"), [](const auto& format) {
  return std::string(format.param);
});

TEST_P(Spectral, ReflectancesAndTheLightOfTheColourCheckerReadBack) {
  for (const std::string light : {"D50", "D65"}) {
    const auto [scene, read] =
        exported(GetParam(), appearance_scene("e2_spectral_accuracy/macbeth_chart_" + light));
    EXPECT_EQ(read.trace_depth, scene::kUnlimitedDepth);
    ASSERT_EQ(read.surfaces.size(), 25U);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
      const auto& name = scene.materials[i].name;
      const auto& surface = read.surfaces.at(fmt::format("material{}", i));
      EXPECT_EQ(surface.type, "diffuse");
      expect_spectrum(surface.spectra.at("reflectance"),
                      name == "board" ? spectra::constant(0.042) : spectrum_named(scene, name).spectrum,
                      name);
    }
    expect_spectrum(read.environment_spectrum, spectra::illuminant(light), light);
  }
}

TEST_P(Spectral, ALampGivesTheSpectrumThatItsColourMeans) {
  scene::Scene scene = appearance_scene("e2_spectral_accuracy/macbeth_chart_D50");
  scene.environment.radiance = {};
  scene.environment.spectrum.reset();
  scene.lights = {{"white", scene::RectShape{1, 1}, {3, 3, 3}, {}, {}},
                  {"green", scene::RectShape{1, 1}, {0.2, 1, 0.1}, {}, {}}};
  const auto read = exported(GetParam(), scene).read;
  ASSERT_EQ(read.lights.size(), 2U);
  const auto& d65 = spectra::illuminant("D65");
  const auto green = spectra::reflectance_of_rgb({0.2, 1, 0.1});
  for (const double nm : {400.0, 555.0, 700.0}) {
    EXPECT_NEAR(tests::value_at(read.lights[0].spectrum, nm), 3 * value_at(d65, nm), 1e-5) << nm;
    EXPECT_NEAR(tests::value_at(read.lights[1].spectrum, nm), value_at(green, nm) * value_at(d65, nm), 1e-5)
        << nm;
  }
}

TEST_P(Spectral, ImagesAreRefusedWhereWavelengthsCount) {
  scene::Scene scene = appearance_scene("e2_spectral_accuracy/macbeth_chart_D50");
  scene.textures = {{"bricks", fs::path(ORBS_SOURCE_DIR) / "data/common/textures/chess_red.png"}};
  std::get<scene::Lambert>(scene.materials[0].model).texture = scene::TextureUse{};
  EXPECT_NE(refusal(GetParam(), scene).find("texture 'bricks' is seen by wavelengths"), std::string::npos)
      << refusal(GetParam(), scene);
}

TEST(MitsubaAppearance, CopperHasItsIndicesOverThoseOfTheAirAndReflectsOnOneSide) {
  for (const std::string distribution : {"ggx", "beckmann"}) {
    const auto [scene, read] =
        exported("mitsuba", appearance_scene("e1_ggx_reflectance/" + distribution + "_copper_60"));
    const auto& copper = read.surfaces.at("material0");
    EXPECT_EQ(copper.type, "roughconductor");
    EXPECT_EQ(copper.words,
              (std::map<std::string, std::string>{{"distribution", distribution}, {"alpha", "0.2"}}));
    const auto& metal = std::get<scene::Conductor>(scene.materials[0].model);
    for (const double nm : {360.0, 450.5, 620.0, 830.0}) {
      const auto index = index_at(metal.index, nm) / 1.000277;
      // The measured table bends between the whole nanometres.
      EXPECT_NEAR(tests::value_at(copper.spectra.at("eta"), nm), index.real(), 1e-4) << nm;
      EXPECT_NEAR(tests::value_at(copper.spectra.at("k"), nm), index.imag(), 1e-4) << nm;
    }
    ASSERT_EQ(read.lights.size(), 1U);
    ASSERT_TRUE(read.lights[0].reflectance);
    EXPECT_NEAR(tests::value_at(*read.lights[0].reflectance, 500), 0.5, 1e-6);
  }
}

TEST(MitsubaAppearance, ARoughDielectricHasBothIndicesAndIsDrawnInThreeColours) {
  const auto read = exported("mitsuba", appearance_scene("e1_ggx_reflectance/ggx_glass")).read;
  EXPECT_EQ(read.surfaces.at("material0").type, "roughdielectric");
  EXPECT_EQ(read.surfaces.at("material0").words,
            (std::map<std::string, std::string>{
                {"distribution", "ggx"}, {"alpha", "0.2"}, {"int_ior", "1.5046"}, {"ext_ior", "1.000277"}}));
  EXPECT_EQ(read.lights.at(0).radiance, (scene::RgbColour{5, 5, 5}));
}

// u of the sheet's texture coordinates is the direction that Mitsuba's polariser transmits.
TEST(MitsubaAppearance, APolariserTransmitsAlongItsAxisProjectedIntoTheSheet) {
  for (const auto& [name, axis] : std::map<std::string, Vec3d>{{"0", {0, 0, 1}}, {"90", {1, 0, 0}}}) {
    scene::Scene scene = appearance_scene("e3_polarisation/polarizing_plane_" + name);
    const auto [prepared, read] = exported("mitsuba", scene);
    EXPECT_FALSE(read.has_stokes);
    EXPECT_EQ(read.surfaces.at("material2").type, "polarizer");
    EXPECT_FALSE(read.u_directions.at("material2").empty());
    for (const Vec3d u : read.u_directions.at("material2"))
      EXPECT_NEAR(std::abs(dot(u, axis)), 1, 1e-6) << name;
    // A sheet that leans, with an axis that does not lie in it.
    for (auto& instance : scene.instances)
      if (scene.meshes[static_cast<std::size_t>(instance.mesh)].name == "filter")
        instance.matrix = translation({1, -5, 2}) * rotation_x(30) * rotation_z(20);
    const auto leaning = exported("mitsuba", scene).read;
    EXPECT_FALSE(leaning.u_directions.at("material2").empty());
    const Vec3d normal = transform_direction(rotation_x(30) * rotation_z(20), {0, 1, 0});
    const Vec3d within = normalised(axis - normal * dot(axis, normal));
    for (const Vec3d u : leaning.u_directions.at("material2"))
      EXPECT_NEAR(std::abs(dot(u, within)), 1, 1e-6) << name;
  }
}

TEST(MitsubaAppearance, StokesVectorsAreWrittenWhereBothFramesAgree) {
  scene::Scene scene = appearance_scene("e3_polarisation/polarizing_spheres");
  EXPECT_NE(refusal("mitsuba", scene).find("lies 4.9 degrees from the camera's horizontal"),
            std::string::npos)
      << refusal("mitsuba", scene);
  scene.camera.fov_y_deg = 10;
  const auto read = exported("mitsuba", scene).read;
  EXPECT_TRUE(read.has_stokes);
  EXPECT_EQ(read.surfaces.at("material2").type, "conductor");
  EXPECT_EQ(tests::value_at(read.surfaces.at("material2").spectra.at("k"), 500), 2.78);
}

TEST(MitsubaAppearance, TheSceneOfCircularLightIsNarrowEnough) {
  const auto read = exported("mitsuba", appearance_scene("e3_polarisation/circular_light")).read;
  EXPECT_TRUE(read.has_stokes);
}

TEST(MitsubaAppearance, WhatMitsubaLacksIsRefusedWithTheReason) {
  const std::map<std::string, std::string> reasons{{"e4_fluorescence/fluorescent_sphere_D50_red", "needs E4"},
                                                   {"e5_iridescence/iridescent_spheres_film", "needs E5"},
                                                   {"e6_dispersion/prism_SF10", "needs E6"}};
  for (const auto& [name, reason] : reasons)
    EXPECT_NE(refusal("mitsuba", appearance_scene(name)).find(reason), std::string::npos)
        << refusal("mitsuba", appearance_scene(name));
  for (const auto& [model, word] : std::vector<std::pair<scene::MaterialModel, std::string>>{
           {scene::Retarder{{0, 0, 1}, 90}, "falls off with the cosine"},
           {scene::Mirror{{1, 1, 1}}, "shifts the phases"},
           {scene::Dielectric{spectra::constant(1.5), spectra::constant(1), scene::Roughness{}, {}},
            "forgets the polarisation"},
           {scene::Conductor{{spectra::constant(1), spectra::constant(3)},
                             spectra::constant(1),
                             scene::Roughness{0.3, scene::Distribution::Ggx, scene::Masking::Correlated},
                             {}},
            "masking is a product of two sides"}}) {
    scene::Scene scene = appearance_scene("e3_polarisation/polarizing_plane_0");
    scene.materials[0].model = model;
    EXPECT_NE(refusal("mitsuba", scene).find(word), std::string::npos) << refusal("mitsuba", scene);
  }
}

// With a lamp that pbrt's path integrator finds behind glass.
scene::Scene with_large_lamp(scene::Scene scene) {
  for (scene::Light& light : scene.lights) light.shape = scene::SphereShape{1};
  return scene;
}

// The whole of the index, over what is outside: one number would be a glass without dispersion.
TEST(PbrtAppearance, GlassThatDispersesHasItsIndexAtEveryWavelength) {
  for (const auto& [name, nm_and_index] : std::map<std::string, std::pair<double, double>>{
           {"prism_SF10", {550, 1.733661}}, {"caustic_BK7", {587.5618, 1.5168}}}) {
    const auto [scene, read] = exported("pbrt", with_large_lamp(appearance_scene("e6_dispersion/" + name)));
    const auto& glass = read.surfaces.at("material0");
    EXPECT_EQ(glass.type, "dielectric");
    EXPECT_EQ(glass.words, (std::map<std::string, std::string>{{"roughness", "0"}}));
    const auto& eta = glass.spectra.at("eta");
    EXPECT_NEAR(tests::value_at(eta, nm_and_index.first), nm_and_index.second, 2e-6);
    for (const double nm : kProbes_nm)
      EXPECT_NEAR(tests::value_at(eta, nm),
                  index_at(std::get<scene::Dielectric>(scene.materials[0].model).index, nm), 1e-6)
          << nm;
  }
  const auto read =
      exported("pbrt", with_large_lamp(appearance_scene("e6_dispersion/caustic_BK7_achromatic"))).read;
  EXPECT_TRUE(read.surfaces.at("material0").spectra.empty());
  EXPECT_EQ(read.surfaces.at("material0").words.at("eta"), "1.5168");
}

// What the entry does not declare as a whole, for who has such a material in a scene of his own.
scene::Scene scene_of_balls(const scene::MaterialModel& model) {
  scene::Scene scene = appearance_scene("e6_dispersion/caustic_BK7");
  scene.materials[0].model = model;
  return scene;
}

registry::Renderer pbrt_with_e1() {
  registry::Renderer out = renderer("pbrt");
  out.support.declares = registry::parse_features("G5/M8-(6,7)/L3/A4/E6-(3-5)");
  return out;
}

TEST(PbrtAppearance, MetalsAndRoughGlassHaveIndicesOverTheOutsideAndAlpha) {
  const scene::Roughness rough{0.3, scene::Distribution::Ggx, scene::Masking::Correlated};
  const ScratchFolder folder("orbs-exported-appearance-e1");
  const auto read_of = [&](const scene::MaterialModel& model) {
    const auto prepared = adapters::prepare_scene(pbrt_with_e1(), scene_of_balls(model));
    if (const auto* reason = std::get_if<std::string>(&prepared)) throw std::runtime_error(*reason);
    adapters::export_scene(pbrt_with_e1(), std::get<scene::Scene>(prepared), folder.path() / "scene.pbrt");
    return tests::read_pbrt(folder.path() / "scene.pbrt").surfaces.at("material0");
  };
  const auto metal = read_of(scene::Conductor{
      {spectra::tabulated({400, 700}, {0.2, 0.8}, spectra::Beyond::HoldsEnds), spectra::constant(3)},
      spectra::constant(1.25),
      rough,
      {}});
  EXPECT_EQ(metal.type, "conductor");
  EXPECT_EQ(metal.words,
            (std::map<std::string, std::string>{{"roughness", "0.3"}, {"remaproughness", "false"}}));
  EXPECT_NEAR(tests::value_at(metal.spectra.at("eta"), 830), 0.8 / 1.25, 1e-6);
  EXPECT_NEAR(tests::value_at(metal.spectra.at("eta"), 550), 0.5 / 1.25, 1e-6);
  EXPECT_NEAR(tests::value_at(metal.spectra.at("k"), 612.5), 3 / 1.25, 1e-6);
  const auto glass = read_of(scene::Dielectric{spectra::constant(1.5), spectra::constant(1.25), rough, {}});
  EXPECT_EQ(glass.words, (std::map<std::string, std::string>{
                             {"eta", "1.2"}, {"roughness", "0.3"}, {"remaproughness", "false"}}));
  EXPECT_EQ(
      read_of(scene::Conductor{{spectra::constant(1), spectra::constant(3)}, spectra::constant(1), {}, {}})
          .words.at("roughness"),
      "0");
}

TEST(PbrtAppearance, WhatPbrtLacksIsRefusedWithTheReason) {
  const std::map<std::string, std::string> reasons{
      {"e1_ggx_reflectance/ggx_copper_60", "which needs E1"},
      {"e3_polarisation/polarizing_plane_0", "which needs E3"},
      {"e4_fluorescence/fluorescent_sphere_D50_red", "which needs E4"},
      {"e5_iridescence/iridescent_spheres_film", "which needs E"}};
  for (const auto& [name, reason] : reasons)
    EXPECT_NE(refusal("pbrt", appearance_scene(name)).find(reason), std::string::npos)
        << refusal("pbrt", appearance_scene(name));
  const auto refusal_with_e1 = [](const scene::Scene& scene) {
    const auto prepared = adapters::prepare_scene(pbrt_with_e1(), scene);
    return std::holds_alternative<std::string>(prepared) ? std::get<std::string>(prepared) : "";
  };
  const auto with = [](scene::Roughness roughness) {
    return scene_of_balls(scene::Dielectric{spectra::constant(1.5), spectra::constant(1), roughness, {}});
  };
  EXPECT_EQ(refusal_with_e1(with({0.3, scene::Distribution::Beckmann, scene::Masking::Correlated})),
            "material 'glass' has Beckmann's distribution: pbrt has GGX alone");
  EXPECT_NE(refusal_with_e1(with({0.3, scene::Distribution::Ggx, scene::Masking::Separable}))
                .find("masking is height-correlated"),
            std::string::npos);
  EXPECT_EQ(refusal_with_e1(with({0.3, scene::Distribution::Ggx, scene::Masking::Correlated})), "");
  scene::Scene scene =
      scene_of_balls(scene::Dielectric{spectra::constant(1.5), spectra::constant(1), {}, {}});
  scene.lights[0].reflectance = {0.5, 0.5, 0.5};
  EXPECT_NE(refusal_with_e1(scene).find("reflect on both sides"), std::string::npos)
      << refusal_with_e1(scene);
  scene.lights[0].reflectance = {};
  scene.materials[1].model =
      scene::Conductor{{spectra::constant(1), spectra::constant(3)}, spectra::constant(1), {}, {}};
  EXPECT_NE(refusal_with_e1(scene).find("conductors reflect from behind"), std::string::npos)
      << refusal_with_e1(scene);
}

}  // namespace
