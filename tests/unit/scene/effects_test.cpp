// What a scene calls for, and what only looks as if it did.
#include "scene/effects/effects.h"

#include "scene/load/load_scene.h"
#include "scene/lower/lower.h"

#include <filesystem>
#include <map>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
using scene::Effect;
using scene::LightTransport;

// A ball of the material, and a plane of grey that nothing can be said against.
scene::Scene scene_of(const std::string& material, const std::string& more = "") {
  const std::string text = R"({"format": "orbs-scene/1", "name": "s",
    "camera": {"position": [0, 0, 5], "look_at": [0, 0, 0]},
    "spectra": [{"name": "flat", "constant": 0.5}, {"name": "even", "wavelengths": [400, 700], "values": [0.5, 0.5]},
                {"name": "ramp", "wavelengths": [400, 700], "values": [0, 1]}, {"name": "D50", "illuminant": "D50"},
                {"name": "D65", "illuminant": "D65"}, {"name": "E", "illuminant": "E"},
                {"name": "dark", "wavelengths": [400, 700], "values": [0, 0], "beyond": "zero"}],
    "materials": [{"name": "m", )" +
                           material +
                           R"(}, {"name": "grey", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}],
    "meshes": [{"name": "sheet", "generator": "plane", "half_size": 1, "material": "m"}],
    "instances": [{"mesh": "sheet"}])" +
                           more + "}";
  return scene::load_scene_text("s.json", text, ORBS_SOURCE_DIR);
}

struct Judgement {
  const char* name;
  std::string material;
  std::string more;
  Effect effect;
  bool is_called_for;
  std::string reason;  // part of it
};

const std::string kGrey = R"("type": "lambert", "reflectance": [0.5, 0.5, 0.5])";
const std::string kRed = R"("type": "lambert", "reflectance": [0.5, 0.1, 0.1])";

std::string tents(double peak, const char* absorbed = "370") {
  return fmt::format(R"("type": "fluorescent", "reflectance": [0, 0, 0], "reradiation": {{"peak_per_nm": {},
    "absorbed_nm": {}, "absorbed_reach_nm": 40, "emitted_nm": 650, "emitted_reach_nm": 50}})",
                     peak, absorbed);
}
std::string conductor(const std::string& more) {
  return R"("type": "conductor", "index": {"n": 0.2, "k": 3})" + more;
}

const std::vector<Judgement> kJudgements{
    {"Reflectance", R"("type": "lambert", "reflectance": {"spectrum": "ramp"})", "", Effect::Spectral, true,
     "reflects by spectrum 'ramp'"},
    {"ConstantReflectance", R"("type": "lambert", "reflectance": {"spectrum": "flat"})", "", Effect::Spectral,
     false, "constant, not spectral"},
    {"EvenSamples", R"("type": "mirror", "reflectance": {"spectrum": "even"})", "", Effect::Spectral, false,
     "constant, not spectral"},
    {"NoReflectance", R"("type": "lambert", "reflectance": {"spectrum": "ramp", "scale": 0})", "",
     Effect::Spectral, false, "times zero"},
    {"LightOnColours", kRed, R"(, "environment": {"spectrum": "D50"})", Effect::Spectral, true, "is not D65"},
    {"EqualEnergyOnColours", kRed, R"(, "environment": {"spectrum": "E"})", Effect::Spectral, true,
     "is not D65"},
    {"LightOnGreys", kGrey, R"(, "environment": {"spectrum": "D50"})", Effect::Spectral, false,
     "colour of the light says it all"},
    {"WhiteLightOnColours", kRed, R"(, "environment": {"spectrum": "D65", "scale": 3})", Effect::Spectral,
     false, "white says the same"},
    {"DarkLight", kRed, R"(, "environment": {"spectrum": "dark"})", Effect::Spectral, false,
     "emits no light"},
    {"EmissiveSurface", R"("type": "emission", "radiance": {"spectrum": "D50"})",
     R"(, "shapes": [{"type": "sphere", "centre": [0, 0, 0], "radius": 1, "material": "grey"}])",
     Effect::Spectral, false, "says it all"},
    {"Metal", R"("type": "conductor", "index": {"file": "data/common/spectra/metals/gold.csv"})", "",
     Effect::MeasuredMetal, true, "n and k that differ"},
    {"ConstantMetal", conductor(""), "", Effect::MeasuredMetal, false, "same n and k"},
    {"Flint", R"("type": "dielectric", "index": {"cauchy": [1.5, 0.01]})", "", Effect::Dispersion, true,
     "varies by 0.0966"},
    {"ConstantGlass", R"("type": "dielectric", "index": 1.5)", "", Effect::Dispersion, false, "same index"},
    {"HardlyAnyDispersion", R"("type": "dielectric", "index": {"cauchy": [1.5, 1e-8]})", "",
     Effect::Dispersion, false, "which is less than 1e-06"},
    {"SameDispersionOutside",
     R"("type": "dielectric", "index": {"cauchy": [1.5, 0.01]}, "outside": {"cauchy": [1.5, 0.01]})", "",
     Effect::Dispersion, false, "same index"},
    {"Film", conductor(R"(, "film": {"index": 1.33, "height_nm": 550})"), "", Effect::ThinFilm, true,
     "550 nm thick"},
    {"LightOnAColouredEmitter", kGrey,
     R"(, "environment": {"spectrum": "D50"},
        "lights": [{"type": "disk", "radius": 1, "radiance": [1, 1, 1], "reflectance": [0.5, 0.1, 0.1]}])",
     Effect::Spectral, true, "is not D65"},
    {"LightOnAFilmOfNoHeight", conductor(R"(, "film": {"index": 1.33, "height_nm": 0})"),
     R"(, "environment": {"spectrum": "D50"})", Effect::Spectral, false, "colour of the light says it all"},
    {"FilmOfNoHeight", conductor(R"(, "film": {"index": 1.33, "height_nm": 0})"), "", Effect::ThinFilm, false,
     "thickness zero"},
    {"FilmOfAir", conductor(R"(, "outside": 1.1, "film": {"index": 1.1, "height_nm": 550})"), "",
     Effect::ThinFilm, false, "which is invisible"},
    {"FilmOfGlassOnGlass", R"("type": "dielectric", "index": 1.5, "film": {"index": 1.5, "height_nm": 550})",
     "", Effect::ThinFilm, false, "which is invisible"},
    {"Polariser", R"("type": "polariser", "axis": [1, 0, 0])", "", Effect::Polarisation, true,
     "is a polariser"},
    {"Retarder", R"("type": "retarder", "axis": [1, 0, 0], "retardance_deg": 90)", "", Effect::Polarisation,
     true, "retards by 90"},
    {"WholeWave", R"("type": "retarder", "axis": [1, 0, 0], "retardance_deg": 720)", "", Effect::Polarisation,
     false, "whole waves"},
    {"Stokes", kGrey, R"(, "outputs": {"stokes": true})", Effect::Polarisation, true, "Stokes"},
    {"Dye", tents(0.01), "", Effect::Fluorescence, true,
     "light of 330 to 410 nm into light of 600 to 700 nm"},
    {"NoDye", tents(0), "", Effect::Fluorescence, false, "re-radiates nothing"},
    {"DyeBeyondLight", tents(0.01, "250"), "", Effect::Fluorescence, false, "re-radiates nothing"},
    {"Rough", conductor(R"(, "alpha": 0.2)"), "", Effect::RoughBoundary, true, "GGX, alpha 0.2"},
    {"LightThatReflects", kGrey,
     R"(, "lights": [{"type": "disk", "radius": 1, "radiance": [1, 1, 1], "reflectance": [0.5, 0.5, 0.5]}])",
     Effect::ReflectingLight, true, "reflects light"},
    {"SurfaceLayers", kGrey, R"(, "outputs": {"layers": ["depth"]})", Effect::SurfaceLayers, true,
     "holds layers"},
    {"PathClasses", kGrey, R"(, "outputs": {"path_classes": true})", Effect::PathClasses, true, "split"},
};

class EffectOfScene : public testing::TestWithParam<Judgement> {};

TEST_P(EffectOfScene, IsJudgedWithAReason) {
  const auto& [name, material, more, effect, is_called_for, reason] = GetParam();
  const auto found = scene::effects(scene_of(material, more));
  EXPECT_EQ(scene::calls_for(found, effect), is_called_for);
  bool has_reason = false;
  for (const auto& finding : is_called_for ? found.called_for : found.not_called_for)
    has_reason = has_reason || (finding.effect == effect && finding.reason.find(reason) != std::string::npos);
  EXPECT_TRUE(has_reason) << reason;
}

INSTANTIATE_TEST_SUITE_P(All, EffectOfScene, testing::ValuesIn(kJudgements), [](const auto& one) {
  return one.param.name;
});

TEST(Effects, APolariserBehindTheCameraIsStillCalledFor) {
  auto behind = scene_of(R"("type": "polariser", "axis": [1, 0, 0])");
  behind.instances[0].matrix = translation({0, 0, 50});
  EXPECT_TRUE(scene::calls_for(scene::effects(behind), Effect::Polarisation));
}

TEST(Effects, AMaterialThatNothingShowsCallsForNothing) {
  auto hidden = scene_of(R"("type": "polariser", "axis": [1, 0, 0])");
  hidden.instances[0].remap = {{0, 1}};
  const auto found = scene::effects(hidden);
  EXPECT_EQ(scene::transport(found), LightTransport::Rgb);
  ASSERT_EQ(found.not_called_for.size(), 1U);
  EXPECT_EQ(found.not_called_for[0].object, "material 'm'");
  EXPECT_NE(found.not_called_for[0].reason.find("no surface shows it"), std::string::npos);
}

TEST(Effects, TheCheapestTransportThatHasThemAllIsChosen) {
  const std::string dye = tents(0.01);
  const std::string stokes = R"(, "outputs": {"stokes": true})";
  const auto transport_of = [](const scene::Scene& one) { return scene::transport(scene::effects(one)); };
  EXPECT_EQ(transport_of(scene_of(kRed)), LightTransport::Rgb);
  EXPECT_EQ(transport_of(scene_of(R"("type": "dielectric", "index": {"cauchy": [1.5, 0.01]})")),
            LightTransport::Spectral);
  EXPECT_EQ(transport_of(scene_of(kRed, stokes)), LightTransport::Polarised);
  EXPECT_EQ(transport_of(scene_of(dye)), LightTransport::Bispectral);
  EXPECT_EQ(transport_of(scene_of(dye, stokes)), LightTransport::PolarisedBispectral);
}

TEST(Effects, ScenesOfOrbsCallForColoursAlone) {
  const auto cases = std::filesystem::path(ORBS_SOURCE_DIR) / "data/cases/orbs";
  for (const char* file :
       {"m8_smooth_glass/113.json", "l4_light_ies/250.json", "a4_paths_glossy_glass/a4-water.json"}) {
    if (!std::filesystem::exists(cases / file)) continue;
    const auto loaded = scene::load_scene(cases / file);
    EXPECT_EQ(scene::transport(scene::effects(loaded)), LightTransport::Rgb) << file;
  }
}

// By appearance-scenes, what each scene of the suite is there to show.
TEST(Effects, TheAppearanceSuiteCallsForWhatItTests) {
  const std::map<std::string, LightTransport> expected{
      {"e1_ggx_reflectance/ggx_copper_50", LightTransport::Spectral},
      {"e1_ggx_reflectance/ggx_glass", LightTransport::Rgb},
      {"e2_spectral_accuracy/macbeth_chart_D65", LightTransport::Spectral},
      {"e3_polarisation/polarizing_plane_0", LightTransport::Polarised},
      {"e3_polarisation/polarizing_spheres", LightTransport::Polarised},
      {"e4_fluorescence/fluorescent_sphere_D50_red", LightTransport::Bispectral},
      {"e4_fluorescence/fluorescent_sphere_D65_plain", LightTransport::Spectral},
      {"e5_iridescence/iridescent_spheres_height", LightTransport::Spectral},
      {"e6_dispersion/prism_SF10", LightTransport::Spectral},
      {"e6_dispersion/prism_achromatic", LightTransport::Rgb},
      {"e6_dispersion/caustic_diamond_achromatic", LightTransport::Rgb}};
  for (const auto& [name, transport] : expected) {
    const auto file = std::filesystem::path(ORBS_SOURCE_DIR) / "data/cases/appearance" / (name + ".json");
    EXPECT_EQ(scene::transport(scene::effects(scene::load_scene(file))), transport) << name;
  }
}

TEST(LowerEffects, SpheresBecomeMeshesThatTouchThem) {
  const auto ball = scene_of(
      kGrey,
      R"(, "shapes": [{"type": "sphere", "name": "b", "centre": [1, 2, 3], "radius": 2, "material": "m"}])");
  const std::set<std::string> orbs{"G1", "G2", "G3", "G4", "G5", "M1"};
  const auto lowered = std::get<scene::Scene>(scene::lower(ball, orbs));
  EXPECT_TRUE(lowered.spheres.empty());
  ASSERT_EQ(lowered.instances.size(), 2U);
  const auto& mesh = lowered.meshes[static_cast<std::size_t>(lowered.instances[1].mesh)];
  for (const auto& p : mesh.positions) {
    const Vec3d world = transform_point(lowered.instances[1].matrix, cast<double>(p));
    ASSERT_NEAR(length(world - Vec3d{1, 2, 3}), 2, 1e-6);
  }
  EXPECT_EQ(mesh.triangle_materials[0], 0);
  auto with_spheres = orbs;
  with_spheres.insert("S1");
  EXPECT_EQ(std::get<scene::Scene>(scene::lower(ball, with_spheres)).spheres.size(), 1U);
}

TEST(LowerEffects, SpectraThatColoursCanStandForAreLeftOut) {
  const auto flat = scene_of(R"("type": "lambert", "reflectance": {"spectrum": "flat"})");
  const auto lowered = std::get<scene::Scene>(scene::lower(flat, {"G1", "G2", "G3", "M1"}));
  EXPECT_TRUE(lowered.spectra.empty());
  EXPECT_NEAR(std::get<scene::Lambert>(lowered.materials[0].model).reflectance.y, 0.5, 1e-12);
  const auto ramp = scene_of(R"("type": "lambert", "reflectance": {"spectrum": "ramp"})");
  EXPECT_EQ(std::get<std::string>(scene::lower(ramp, {"G1", "G2", "G3", "M1"})),
            "material 'm' reflects by spectrum 'ramp', which needs E2");
}

}  // namespace
