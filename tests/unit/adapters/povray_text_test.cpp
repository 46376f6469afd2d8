#include "adapters/povray/dispersion.h"
#include "adapters/povray/povray.h"
#include "base/error.h"
#include "base/files.h"
#include "scene/geometry/generators.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

/// What the exporter writes, in fragments; that POV-Ray makes the right image of it is tested in
/// tests/peers.
namespace {

using namespace orbs;
namespace fs = std::filesystem;

class PovrayText : public testing::Test {
 protected:
  void SetUp() override {
    scene_.camera = {};
    scene_.camera.position_m = {0, 0, 5};
    scene_.trace_depth = 1;
  }

  int material(const scene::MaterialModel& model) {
    scene_.materials.push_back({"m", model});
    return static_cast<int>(scene_.materials.size()) - 1;
  }
  scene::Instance& instance(scene::Mesh mesh, int material_index) {
    mesh.triangle_materials.assign(mesh.triangles.size(), material_index);
    scene_.meshes.push_back(std::move(mesh));
    scene_.instances.push_back({"i", static_cast<int>(scene_.meshes.size()) - 1, {}, {}});
    return scene_.instances.back();
  }
  std::string written(const adapters::PovraySettings& settings = {}) {
    adapters::write_povray(scene_, settings, folder_ / "a.pov");
    return read_file(folder_ / "a.pov");
  }
  std::string meshes() const { return read_file(folder_ / "a-meshes.inc"); }

  ScratchFolder scratch_{"orbs-povray-text"};
  fs::path folder_ = scratch_.path();
  scene::Scene scene_;
};

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

int count_of(const std::string& text, const std::string& part) {
  int count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST_F(PovrayText, CameraIsAWindowOfHeightOneAtTheDistanceOfItsAngle) {
  scene_.camera.fov_y_deg = 90;
  scene_.camera.width_px = 300;
  scene_.camera.height_px = 100;
  const std::string text = written();
  // Looking along -Z with y up, +X is on the right: a right-handed image. 0.5 / tan 45 = 0.5.
  EXPECT_TRUE(holds(text, "right <3,")) << text;
  EXPECT_TRUE(holds(text, "up <0,1,0>")) << text;
  EXPECT_TRUE(holds(text, "location <0,0,5>")) << text;
}

TEST_F(PovrayText, DirectLightAloneHasNoRadiosity) {
  scene_.lights.emplace_back();
  EXPECT_FALSE(holds(written(), "radiosity {"));
  scene_.trace_depth = 5;
  EXPECT_TRUE(holds(written(), "recursion_limit 4"));
  scene_.trace_depth = 99;
  EXPECT_TRUE(holds(written(), "recursion_limit 20"));
}

// The sky has no light_source, so even its first reflection is gathered.
TEST_F(PovrayText, LightOfTheSkyIsGatheredOnceMore) {
  scene_.environment.radiance = {1, 1, 1};
  scene_.trace_depth = 1;
  EXPECT_TRUE(holds(written(), "recursion_limit 1"));
  scene_.trace_depth = 2;
  EXPECT_TRUE(holds(written(), "recursion_limit 2"));
}

// However many samples its lamps have.
TEST_F(PovrayText, PhotonsAreAsManyAsWereAskedFor) {
  adapters::PovraySettings settings;
  settings.photons = 1000;
  EXPECT_TRUE(holds(written(settings), "photons { count 1000 }"));
}

// Facing the floor 10 m below: panels of at most 2 m, in powers of two.
TEST_F(PovrayText, LampsAreCutFinelyWhereTheyAreLargeBesideWhatTheyLight) {
  instance(scene::make_plane({1}), material(scene::Lambert{{0.5, 0.5, 0.5}, {}})).matrix =
      translation({0, -10, 0});
  scene_.lights.emplace_back();
  const auto panels = [&](double half_size_m) {
    scene_.lights.front().shape = scene::RectShape{half_size_m, half_size_m};
    return count_of(written(), "light_source {");
  };
  EXPECT_EQ(panels(1), 4);
  EXPECT_EQ(panels(3), 16);
  EXPECT_EQ(panels(7), 64);
  EXPECT_EQ(panels(70), 64);  // two by two samples of each are left
}

TEST_F(PovrayText, InstancesShareAMeshUntilTheirRemapListsDiffer) {
  const int white = material(scene::Lambert{{0.5, 0.5, 0.5}, {}});
  const int red = material(scene::Lambert{{0.9, 0, 0}, {}});
  instance(scene::make_plane({1}), white);
  scene_.instances.push_back({"same", 0, translation({1, 2, 3}), {}});
  scene_.instances.push_back({"red", 0, {}, {{white, red}}});
  scene_.instances.push_back({"red too", 0, {}, {{white, red}, {red, white}}});
  const std::string text = written();
  EXPECT_EQ(count_of(meshes(), "mesh2 {"), 2);
  EXPECT_EQ(count_of(text, "object { Mesh0 "), 2);
  EXPECT_EQ(count_of(text, "object { Mesh1 "), 2);  // not chained: white -> red stays red
  EXPECT_TRUE(holds(text, "matrix <1,0,0, 0,1,0, 0,0,1, 1,2,3>")) << text;
}

TEST_F(PovrayText, MeshWithoutInstanceIsNotWritten) {
  const int white = material(scene::Lambert{{0.5, 0.5, 0.5}, {}});
  instance(scene::make_plane({1}), white);
  scene_.instances.clear();
  EXPECT_FALSE(holds(written(), "Mesh"));
}

TEST_F(PovrayText, GlassGetsAnObjectAndAnInteriorOfItsOwn) {
  const int white = material(scene::Lambert{{0.5, 0.5, 0.5}, {}});
  const int glass = material(scene::Glass{{1, 1, 1}, 1.33});
  instance(scene::make_cube({1}), white);
  scene_.meshes[0].triangle_materials = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
  const std::string text = written();
  EXPECT_EQ(count_of(text, "object { Mesh0"), 2);
  EXPECT_EQ(count_of(text, "interior { ior 1.33 }"), 1);
  EXPECT_TRUE(holds(text, "fresnel on")) << text;
  EXPECT_EQ(glass, 1);
}

// POV-Ray refracts its hues of 474, 582 and 650 nm by ior * dispersion^((555 - nm) / 350); blue, green and
// red of Rec.709 are light of 453, 539 and 609 nm.
TEST_F(PovrayText, GlassThatDispersesRefractsPovraysHuesAsTheLightTheyStandFor) {
  const scene::Dielectric glass{spectra::Cauchy{1.7, 0.012, 0, 0}, spectra::constant(1.25), {}, {}};
  const auto [ior, dispersion] = adapters::povray::dispersion_of(glass);
  for (const auto& [hue_nm, light_nm] : std::map<double, double>{{474, 453.4}, {582, 539.1}, {650, 608.6}})
    EXPECT_NEAR(ior * std::pow(dispersion, (555 - hue_nm) / 350), index_at(glass.index, light_nm) / 1.25,
                1.5e-3)
        << hue_nm;
  instance(scene::make_cube({1}), material(glass));
  adapters::PovraySettings settings;
  settings.dispersion_samples = 33;
  settings.photons = 1000;
  const auto text = written(settings);
  EXPECT_TRUE(
      holds(text, fmt::format("interior {{ ior {} dispersion {} dispersion_samples 33 }} photons {{ target",
                              ior, dispersion)))
      << text;
  EXPECT_TRUE(holds(text, "rgbf <1,1,1,1>"));
  EXPECT_TRUE(holds(text, "photons { count 30 }"));  // of which 33 each are kept
}

// POV-Ray 3.7 takes at most 256 levels.
TEST_F(PovrayText, PathsWithoutAnEndGetAllLevelsThatThereAre) {
  scene_.trace_depth = scene::kUnlimitedDepth;
  EXPECT_TRUE(holds(written(), "max_trace_level 256\n"));
  scene_.trace_depth = 7;
  EXPECT_TRUE(holds(written(), "max_trace_level 8\n"));
}

// A ray that was gathered is at the last level, from which none goes on through an opening.
TEST_F(PovrayText, OpeningsGetAllLevelsWhereNothingElseIsBoundedByThem) {
  const int sheet = material(scene::Lambert{{0.8, 0.8, 0.8}, {}});
  EXPECT_TRUE(holds(written(), "max_trace_level 2\n"));
  scene_.materials[static_cast<std::size_t>(sheet)].detail.opacity = 0.3;
  EXPECT_TRUE(holds(written(), "max_trace_level 256\n"));
  material(scene::Mirror{{0.9, 0.9, 0.9}});
  EXPECT_TRUE(holds(written(), "max_trace_level 2\n"));
}

// Rays of a lens are spread over the pixel by POV-Ray; halving the pixel as well would blur twice.
TEST_F(PovrayText, LensesAreNotAntialiasedTwice) {
  EXPECT_EQ(adapters::povray_antialiasing(scene_), "+A0.05");
  scene_.camera.aperture_radius_m = 0.1;
  EXPECT_EQ(adapters::povray_antialiasing(scene_), "-A");
}

TEST_F(PovrayText, PixelsAreHalvedAsOftenAsASettingSays) {
  const auto exporter = adapters::povray_exporter();
  EXPECT_EQ(exporter.placeholders(scene_, {}, 16).at("aa_grid"), "4");
  EXPECT_EQ(exporter.placeholders(scene_, {{"aa_depth", 9}}, 16).at("aa_grid"), "9");
  EXPECT_THROW(written(adapters::povray_settings({{"aa_depth", 10}})), InputError);
}

// The back of a lamp is a black sheet; past its edge the bright one is seen from behind.
TEST_F(PovrayText, FlatLampsAreBlackFromBehind) {
  scene_.lights.push_back({"lamp", scene::RectShape{1, 1}, {1, 0, 0}, translation({0, 4, 0}), {}});
  scene_.lights.push_back({"round", scene::DiskShape{1}, {1, 0, 0}, translation({0, 4, 0}), {}});
  const std::string text = written();
  EXPECT_EQ(count_of(text, "interior_texture { pigment { rgb 0 }"), 2);
  // The bright side is that of the normal, local -Y: x cross z of the rectangle's corners, too.
  EXPECT_TRUE(holds(text, "disc { <0,0,0>, <0,-1,0>, 1 }"));
  EXPECT_TRUE(holds(text, "polygon { 5, <-1,0,-1>, <1,0,-1>, <1,0,1>,"));
}

// L A / (2 pi f^2) split over 2 x 2 pieces, each with half the grid; samples in cell centres: 1 (n - 1) / n
// for n = 8.
TEST_F(PovrayText, RectBecomesAreaLightsOfItsPower) {
  scene_.lights.push_back(
      {"lamp", scene::RectShape{1, 1}, {std::numbers::pi, 0, 0}, translation({0, 4, 0}), {}});
  const std::string text = written();
  EXPECT_EQ(count_of(text, "light_source {"), 4);
  EXPECT_TRUE(holds(text, "area_light <0.875,0,0>, <0,0,0.875>, 8, 8 area_illumination on")) << text;
  EXPECT_TRUE(holds(text, "point_at <-0.5,3,-0.5>")) << text;  // local -Y
  EXPECT_EQ(count_of(text, "no_shadow no_radiosity"), 1);
}

TEST_F(PovrayText, LightKeepsFacingDownItsOwnMinusYWhateverTheMatrix) {
  scene_.lights.push_back({"lamp", scene::RectShape{1, 1}, {1, 1, 1}, scaling({1, -2, 1}), {}});
  EXPECT_TRUE(holds(written(), "point_at <0.5,1,0.5>"));  // mirrored: local -Y is world +Y
}

TEST_F(PovrayText, NamesCannotBreakOutOfTheirComment) {
  const int white = material(scene::Lambert{{0.5, 0.5, 0.5}, {}});
  instance(scene::make_plane({1}), white).name = "a\n#error \"x\"";
  scene_.lights.push_back({"b\r#error \"y\"", scene::DiskShape{1}, {1, 1, 1}, {}, {}});
  EXPECT_FALSE(holds(written(), "\n#error"));
  EXPECT_FALSE(holds(written(), "\r"));
}

TEST_F(PovrayText, NumbersReadBackAsTheSameNumbers) {
  scene_.camera.position_m = {0.1, 1e-7, 12345.678901234567};
  EXPECT_TRUE(holds(written(), "location <0.1,1e-07,12345.678901234567>"));
}

TEST_F(PovrayText, SameSceneGivesTheSameText) {
  instance(scene::make_sphere({1, 8}), material(scene::Lambert{{0.5, 0.5, 0.5}, {}}));
  const std::string first = written();
  const std::string first_meshes = meshes();
  EXPECT_EQ(first, written());
  EXPECT_EQ(first_meshes, meshes());
}

TEST_F(PovrayText, TextureIsCopiedBesideTheSceneAndItsMatrixGoesIntoTheCoordinates) {
  const fs::path image = folder_ / "My Image.PNG";
  write_file(image, "bytes");
  scene_.textures.push_back({"t", image, scene::Wrap::Repeat, scene::Wrap::Repeat});
  Mat4 matrix;
  matrix.m = {4, 0, 0, -0.5, 0, 2, 0, 0.25, 0, 0, 1, 0, 0, 0, 0, 1};
  instance(scene::make_plane({1}), material(scene::Lambert{{0.5, 0.5, 0.5}, scene::TextureUse{0, matrix}}));
  const std::string text = written();
  EXPECT_TRUE(holds(text, "png \"a-texture0.png\" gamma srgb interpolate 2")) << text;
  EXPECT_EQ(read_file(folder_ / "a-texture0.png"), "bytes");
  EXPECT_TRUE(holds(meshes(), "<-0.5,0.25>")) << meshes();  // u = v = 0
  EXPECT_TRUE(holds(meshes(), "<3.5,2.25>")) << meshes();   // u = v = 1
}

// POV-Ray halves the grid; of an odd half one row would count twice.
TEST_F(PovrayText, LampGridThatWouldBeWeighedUnevenlyIsRefused) {
  adapters::PovraySettings settings;
  settings.area_grid = 12;
  EXPECT_THROW(written(settings), InputError);
  settings.area_grid = 2;
  EXPECT_THROW(written(settings), InputError);  // less than two samples for each of 2 x 2 pieces
  settings.area_grid = 4;
  EXPECT_NO_THROW(written(settings));
}

TEST_F(PovrayText, OneColourIsNoDispersion) {
  adapters::PovraySettings settings;
  settings.dispersion_samples = 1;
  EXPECT_THROW(written(settings), InputError);
}

}  // namespace
