// Scenes beyond ORB.S: what the reader makes of them, what it refuses, and that writing loses nothing.
#include "base/error.h"
#include "base/files.h"
#include "scene/load/load_scene.h"
#include "scene/load/write_scene.h"
#include "spectra/observer.h"
#include "spectra/rgb.h"

#include <gtest/gtest.h>

namespace {

using namespace orbs;

const std::string kGood = R"({
  "format": "orbs-scene/1",
  "name": "good",
  "camera": {"position": [0, -5, 0], "look_at": [0, 0, 0], "up": [0, 0, 1]},
  "spectra": [
    {"name": "ramp", "wavelengths": [400, 500, 700], "values": [0.1, 0.5, 0.9]},
    {"name": "half", "constant": 0.5},
    {"name": "D50", "illuminant": "D50"},
    {"name": "skin", "file": "data/common/spectra/colorchecker.csv", "column": "p02_light_skin"},
    {"name": "blue", "wavelengths": [440, 450, 460], "values": [0, 1, 0], "beyond": "zero"}
  ],
  "environment": {"spectrum": "D50", "scale": 2},
  "materials": [
    {"name": "wall", "type": "lambert", "reflectance": {"spectrum": "ramp", "scale": 0.5}},
    {"name": "copper", "type": "conductor", "index": {"file": "data/common/spectra/metals/copper.csv"},
     "outside": 1.000277, "alpha": 0.2, "distribution": "beckmann", "masking": "correlated",
     "film": {"index": {"cauchy": [1.3, 0.003]}, "height_nm": 550}},
    {"name": "flint", "type": "dielectric",
     "index": {"file": "data/common/spectra/glasses_sellmeier.csv", "material": "SF10"}},
    {"name": "filter", "type": "polariser", "axis": [0, 0, 1]},
    {"name": "wave", "type": "retarder", "axis": [1, 0, 1], "retardance_deg": 90},
    {"name": "paper", "type": "fluorescent", "reflectance": [0.1, 0.1, 0.1],
     "reradiation": {"peak_per_nm": 0.017, "absorbed_nm": 450, "absorbed_reach_nm": 40, "emitted_nm": 650,
                     "emitted_reach_nm": 50}},
    {"name": "dye", "type": "fluorescent", "reflectance": [0.1, 0.1, 0.1],
     "reradiation": {"first_nm": 400, "width_nm": 100, "bins": 3, "shares": [[0, 0, 0], [0.3, 0, 0], [0.4, 0.5, 0]]}}
  ],
  "meshes": [{"name": "sheet", "generator": "plane", "half_size": 1, "material": "filter"}],
  "instances": [{"mesh": "sheet"}],
  "shapes": [{"type": "sphere", "name": "ball", "centre": [1, 2, 3], "radius": 2, "material": "paper"}],
  "lights": [{"name": "lamp", "type": "disk", "radius": 1, "radiance": {"spectrum": "blue"}, "reflectance": [0.5, 0.5, 0.5]}],
  "integrator": {"trace_depth": "unlimited"},
  "outputs": {"stokes": true}
}
)";

scene::Scene load(const std::string& text) {
  return scene::load_scene_text("scene.json", text, ORBS_SOURCE_DIR);
}

template <typename Model>
const Model& model(const scene::Scene& scene, std::size_t material) {
  return std::get<Model>(scene.materials.at(material).model);
}

TEST(AppearanceScene, ASpectrumKeepsTheColourThatTheEyeMakesOfIt) {
  const auto scene = load(kGood);
  const auto& wall = model<scene::Lambert>(scene, 0);
  ASSERT_TRUE(wall.spectrum);
  EXPECT_EQ(wall.spectrum->scale, 0.5);
  EXPECT_GT(wall.reflectance.x, 2 * wall.reflectance.z) << "the ramp rises towards red";
  const Vec3d d50 = spectra::rgb_of_xyz(spectra::xyz_of_light(spectra::illuminant("D50")));
  EXPECT_NEAR(scene.environment.radiance.x, 2 * d50.x, 1e-12);
  EXPECT_LT(scene.lights[0].radiance.y, 0) << "light of 450 nm lies outside of Rec.709";
}

TEST(AppearanceScene, ModelsAreReadWithTheirIndicesAndFilms) {
  const auto scene = load(kGood);
  const auto& copper = model<scene::Conductor>(scene, 1);
  EXPECT_GT(copper.index.k.values.size(), 10U);
  EXPECT_EQ(index_at(copper.outside, 500), 1.000277);
  EXPECT_EQ(copper.roughness->distribution, scene::Distribution::Beckmann);
  EXPECT_EQ(copper.roughness->masking, scene::Masking::Correlated);
  EXPECT_NEAR(index_at(copper.film->index, 500), 1.3 + 0.003 / 0.25, 1e-12);
  EXPECT_FALSE(model<scene::Dielectric>(scene, 2).roughness);
  EXPECT_NEAR(index_at(model<scene::Dielectric>(scene, 2).index, 587.5618), 1.72828, 1e-4);
  EXPECT_EQ(model<scene::Retarder>(scene, 4).retardance_deg, 90);
  EXPECT_EQ(scene.trace_depth, scene::kUnlimitedDepth);
  EXPECT_TRUE(scene.outputs.stokes);
  EXPECT_EQ(scene.spheres[0].material, 5);
  EXPECT_EQ(scene.lights[0].reflectance.x, 0.5);
  EXPECT_EQ(scene.notes.tables.size(), 3U) << "their content belongs to the hash of the scene";
}

TEST(AppearanceScene, WhatIsWrittenReadsBackAsTheSameScene) {
  const ScratchFolder folder("orbs-appearance");
  const auto scene = load(kGood);
  scene::write_scene(scene, folder.path() / "copy.json");
  const auto copy = scene::load_scene(folder.path() / "copy.json");
  scene::write_scene(copy, folder.path() / "again.json");
  auto first = read_file(folder.path() / "copy.json");
  const auto again = read_file(folder.path() / "again.json");
  for (auto at = first.find("copy.0.ply"); at != std::string::npos; at = first.find("copy.0.ply"))
    first.replace(at, 10, "again.0.ply");
  EXPECT_EQ(first, again);
  EXPECT_TRUE(copy == scene);
  EXPECT_EQ(copy.environment.radiance.x, scene.environment.radiance.x);
  EXPECT_EQ(model<scene::Conductor>(copy, 1).index.n.values,
            model<scene::Conductor>(scene, 1).index.n.values);
  EXPECT_EQ(copy.spectra[4].spectrum.beyond, spectra::Beyond::IsZero);
}

struct BrokenScene {
  const char* name;
  std::string find;
  std::string replace;
  std::vector<std::string> complaint;
};

const std::vector<BrokenScene> kBroken{
    {"EndlessReach",
     "\"absorbed_reach_nm\": 40",
     "\"absorbed_reach_nm\": 1e17",
     {"absorbed_reach_nm", "2000"}},
    {"EndlessBins", "\"width_nm\": 100", "\"width_nm\": 1e17", {"width_nm", "2000"}},
    {"UnknownSpectrum",
     "\"ramp\", \"scale\": 0.5",
     "\"rump\"",
     {"scene.json:14:", "there is no spectrum 'rump'", "'ramp'"}},
    {"TooReflective",
     "\"scale\": 0.5",
     "\"scale\": 1.5",
     {"scene.json:14:", "reaches 1.35", "share in [0, 1]"}},
    {"LightThatGoesOnForEver",
     "{\"spectrum\": \"blue\"}",
     "{\"spectrum\": \"ramp\"}",
     {"/lights/0/radiance", "\"beyond\": \"zero\""}},
    {"UnsortedSamples", "[400, 500, 700]", "[400, 700, 500]", {"scene.json:6"}},
    {"UnknownColumn", "p02_light_skin", "p02_light_skim", {"p02_light_skin", "scene.json:9"}},
    {"UnknownIlluminant", "\"illuminant\": \"D50\"", "\"illuminant\": \"D51\"", {"scene.json:8:", "D50"}},
    {"UnknownGlass", "\"SF10\"", "\"SF12\"", {"no material 'SF12'", "scene.json:19"}},
    {"IndexBelowZero", "[1.3, 0.003]", "[0.1, -0.3]", {"scene.json:17:", "must be above 0"}},
    {"NoAxis", "\"axis\": [0, 0, 1]", "\"axis\": [0, 0, 0]", {"scene.json:20:", "must have a length"}},
    {"AxisAcrossTheSheet",
     "\"axis\": [0, 0, 1]",
     "\"axis\": [0, 1, 0]",
     {"/materials/3", "perpendicular to triangle 0"}},
    {"BallOfPolariser",
     "\"radius\": 2, \"material\": \"paper\"",
     "\"radius\": 2, \"material\": \"filter\"",
     {"shape 'ball' is a sphere and no thin optical element"}},
    {"GainsEnergy", "0.017", "0.025", {"scene.json:23", "450 nm 1.3500", "\"gains_energy\": true"}},
    {"MatrixGainsEnergy", "[0.4, 0.5, 0]", "[0.7, 0.5, 0]", {"/materials/6/reradiation", "1.1000"}},
    {"TowardsShorterWavelengths",
     "[0.3, 0, 0]",
     "[0.3, 0, 0.1]",
     {"/reradiation/shares/1", "longer wavelengths only"}},
    {"UnknownShape", "\"type\": \"sphere\"", "\"type\": \"pyramid\"", {"'pyramid' is not one of: sphere"}},
    {"UnknownDepth", "\"unlimited\"", "\"endless\"", {"'endless' is not one of: unlimited"}},
    {"FilmOfNothing",
     "\"height_nm\": 550",
     "\"height_nm\": -1",
     {"/materials/1/film/height_nm", "[0, 1000000]"}},
};

class BrokenAppearanceScene : public testing::TestWithParam<BrokenScene> {};

TEST_P(BrokenAppearanceScene, SaysWhereAndWhat) {
  auto text = kGood;
  const auto at = text.find(GetParam().find);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, GetParam().find.size(), GetParam().replace);
  try {
    load(text);
    FAIL() << "was accepted";
  } catch (const InputError& e) {
    for (const auto& part : GetParam().complaint)
      EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << part << "\nin: " << e.what();
  }
}

INSTANTIATE_TEST_SUITE_P(All, BrokenAppearanceScene, testing::ValuesIn(kBroken), [](const auto& broken) {
  return broken.param.name;
});

TEST(AppearanceScene, AGainOfEnergyThatIsMeantIsAWarning) {
  auto text = kGood;
  text.replace(text.find("0.017"), 5, "0.025");
  text.replace(text.find("\"reradiation\""), 0, "\"gains_energy\": true, ");
  const auto scene = load(text);
  ASSERT_EQ(scene.notes.warnings.size(), 1U);
  EXPECT_NE(scene.notes.warnings[0].find("scene.json:23"), std::string::npos) << scene.notes.warnings[0];
}

}  // namespace
