// Shapes of plug-ins: how libraries are opened and refused, and what becomes of answers that break the rules.
#include "base/error.h"
#include "base/files.h"
#include "plugins/flush_to_zero.h"
#include "structure/source_files.h"
#include "tracer/plugins/plugin_emitter.h"
#include "tracer/plugins/plugin_hit.h"

#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

using namespace orbs;
using tracer::PluginShape;

namespace fs = std::filesystem;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

fs::path library(const std::string& name) { return fs::path(ORBS_BINARY_DIR) / "plugins" / (name + ".so"); }

scene::Shape shape_by(const std::string& plugin, const std::map<std::string, double>& numbers) {
  return {"s", scene::PluginForm{plugin, numbers}, Mat4{}, 3};
}

PluginShape made(const std::string& plugin, const std::map<std::string, double>& numbers = {}) {
  return tracer::make_plugin_shape(shape_by(plugin, numbers), "shape 's'", {},
                                   {{plugin, tracer::open_plugin(library(plugin))}});
}

// What `f` complains of.
template <typename F>
std::string complaint(const F& f) {
  try {
    f();
  } catch (const InputError& e) {
    return e.what();
  }
  return "no complaint";
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
}

std::string refusal(const std::string& plugin, const std::map<std::string, double>& numbers) {
  return complaint([&] { made(plugin, numbers); });
}

// Straight down on the square of the misbehaving plug-in, beside its middle.
const tracer::PluginRay kDown{{0.75, 2, 0.25}, {0, -1, 0}, 0, kInf};

scene::Scene scene_with(std::vector<scene::Shape> shapes) {
  scene::Scene scene;
  scene.shapes = std::move(shapes);
  return scene;
}

}  // namespace

// The loader maps such a file without a complaint; reading beyond its end is a bus error.
TEST(PluginLibraries, ThatAreCutOffAreRefused) {
  const structure::TestFolder folder("plugin");
  const auto whole = read_file(library("misbehaving"));
  for (const double share : {0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.999}) {
    folder.write("cut.so",
                 whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size()))));
    expect_part(complaint([&] { tracer::open_plugin(folder.path() / "cut.so"); }),
                "cut.so: it is cut off: its ");
  }
  folder.write("cut.so", whole.substr(0, 40));
  expect_part(complaint([&] { tracer::open_plugin(folder.path() / "cut.so"); }), "it has 40 bytes");
  folder.write("cut.so", whole);
  EXPECT_EQ(complaint([&] { tracer::open_plugin(folder.path() / "cut.so"); }), "no complaint");
}

TEST(Plugins, AreCalledAsTheirFiles) {
  EXPECT_EQ(tracer::plugin_name("/a/saddle.so"), "saddle");
  EXPECT_EQ(tracer::plugin_name("libsaddle.so"), "saddle");
  expect_part(complaint([] {
                tracer::check_plugin_names({{"a/saddle.so", "b/libsaddle.so"}, {}});
              }),
              "two files are the plug-in 'saddle', the second is b/libsaddle.so");
  EXPECT_EQ(complaint([] {
              tracer::check_plugin_names({{"a/saddle.so", "a/other.so"}, {}});
            }),
            "no complaint");
}

TEST(Plugins, WhatIsNoPluginIsRefusedWithTheReason) {
  const structure::TestFolder folder("plugins");
  folder.write("text.so", "no library");
  const auto problem = [](const fs::path& file) { return complaint([&] { tracer::open_plugin(file); }); };
  expect_part(problem(folder.path() / "absent.so"), "there is no file");
  expect_part(problem(folder.path()), "is a folder, expected a file");
  expect_part(problem(folder.path() / "text.so"), "it cannot be opened as a shared library: ");
  expect_part(
      problem(library("other_version")),
      "it is built for version 2 of orbs/shape_plugin.h, and this orbs-tracer has version 1; build it "
      "with the header of this version");
  expect_part(problem(library("incomplete")),
              "it has no function orbs_shape_intersect, which orbs/shape_plugin.h requires");
  // Of a library that is something else: the version is asked for first.
  for (const char* other :
       {"x86_64-linux-gnu/libm.so.6", "aarch64-linux-gnu/libm.so.6", "x86_64-linux-gnu/libz.so.1"})
    if (const auto file = fs::path("/lib") / other; fs::exists(file))
      expect_part(problem(file),
                  "it has no function orbs_shape_plugin_version, so it is no plug-in for shapes");
}

TEST(Plugins, OpeningOneLeavesTheArithmeticAsItIs) {
  ASSERT_FALSE(tests::small_numbers_are_flushed());
  expect_part(complaint([] { tracer::open_plugin(library("flushing")); }), "it is built for version 0");
  EXPECT_FALSE(tests::small_numbers_are_flushed());
}

TEST(Plugins, AreLookedForByTheirNamesInFilesAndThenInAFolder) {
  const auto folder = library("saddle").parent_path();
  const auto scene = scene_with({shape_by("saddle", {}), shape_by("saddle", {})});
  EXPECT_EQ(tracer::open_plugins(scene, {{library("saddle")}, {}}).at("saddle")->file, library("saddle"));
  EXPECT_EQ(tracer::open_plugins(scene, {{}, folder}).at("saddle")->file, folder / "saddle.so");
  // Nothing that the scene does not name is opened.
  EXPECT_TRUE(tracer::open_plugins(scene_with({}), {{"/absent/other.so"}, {}}).empty());
  expect_part(complaint([&] {
                tracer::open_plugins(scene, {{library("misbehaving")}, {}});
              }),
              "shape 's' is by the plug-in 'saddle', and there is none of that name; give its file with "
              "--plugin, or the folder that holds saddle.so with --plugin-folder");
  expect_part(complaint([&] {
                tracer::open_plugins(scene_with({shape_by("sadle", {})}), {{}, folder});
              }),
              "there is none of that name in " + folder.string());
}

TEST(Plugins, RefuseNumbersInTheirOwnWords) {
  expect_part(
      refusal("saddle", {{"half_size", -1}}),
      "shape 's': the plug-in 'saddle' makes no shape of its numbers: half_size must be above 0, is -1");
  expect_part(refusal("saddle", {{"size", 1}}), "there is no number 'size'; a saddle has half_size and k");
  expect_part(refusal("misbehaving", {{"fault", 12}}), "makes no shape of its numbers: it does not say why");
  expect_part(refusal("misbehaving", {{"fault", 10}}),
              "extends from -1 to inf along x; bounds must be finite");
  expect_part(refusal("misbehaving", {{"fault", 11}}), "extends from 2 to 1 along z");
}

// Without a fault, the answer is as the shape says: the normal is made a unit vector.
TEST(Plugins, AnswersThatKeepTheRulesAreHits) {
  const auto square = made("misbehaving");
  const auto hit = intersect(square, kDown);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->t, 2);
  EXPECT_EQ(hit->normal, (Vec3d{0, 1, 0}));
  EXPECT_EQ(hit->uv.x, 0.75);
  EXPECT_EQ(hit->uv.y, 0.25);
  EXPECT_FALSE(intersect(square, {kDown.origin, kDown.direction, 2, kInf}));
  EXPECT_FALSE(intersect(square, {kDown.origin, kDown.direction, 0, 2}));
  std::vector<PluginShape> shapes;
  shapes.push_back(made("misbehaving"));
  EXPECT_EQ(tracer::plugin_faults(shapes).count, 0U);
  EXPECT_EQ(tracer::plugin_faults(shapes).what, "");
}

TEST(Plugins, AnswersThatBreakTheRulesAreMissesAndCounted) {
  for (const auto& [fault, what] :
       {std::pair{1, "distances outside of the ray's range"},
        std::pair{2, "distances outside of the ray's range"},
        std::pair{3, "distances outside of the ray's range"}, std::pair{4, "normals without a direction"},
        std::pair{5, "normals without a direction"}, std::pair{6, "texture coordinates that are no numbers"},
        std::pair{7, "points outside of the bounds"}}) {
    std::vector<PluginShape> shapes;
    shapes.push_back(made("misbehaving", {{"fault", fault}}));
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(intersect(shapes[0], kDown)) << fault;
    EXPECT_EQ(tracer::plugin_faults(shapes).what, fmt::format("3 {} of 'misbehaving'", what)) << fault;
    EXPECT_EQ(tracer::plugin_faults(shapes).count, 3U) << fault;
  }
}

TEST(Plugins, RandomPointsThatBreakTheRulesAreNoneAndCounted) {
  EXPECT_EQ(tracer::sampled_area(made("misbehaving")), 4);
  for (const int fault : {14, 15}) {
    std::vector<PluginShape> shapes;
    shapes.push_back(made("misbehaving", {{"fault", fault}}));
    EXPECT_FALSE(tracer::sampled_point(shapes[0], 0.5, 0.5)) << fault;
    EXPECT_EQ(tracer::plugin_faults(shapes).what,
              "1 random points outside of the bounds or without normal or density of 'misbehaving'");
  }
  expect_part(
      complaint([] {
        tracer::sampled_area(made("misbehaving", {{"fault", 16}}));
      }),
      "the plug-in 'misbehaving' gives a point of its shape two densities: that of orbs_shape_pdf is 2 "
      "times that of orbs_shape_sample");
}

TEST(Plugins, AnAnswerThatChangesIsCountedAndItsNormalFacesTheRay) {
  std::vector<PluginShape> shapes;
  shapes.push_back(made("misbehaving", {{"fault", 8}}));
  const tracer::Ray ray{{0.5F, 2, 0}, {0, -1, 0}};
  const auto hit = hit_of(shapes[0], 0, {ray.origin, ray.direction, 0, ray.reach});
  ASSERT_TRUE(hit);
  const auto point = point_on_plugin(shapes[0], ray, *hit);
  EXPECT_EQ(point.normal, (Vec3d{0, 1, 0}));
  EXPECT_EQ(point.position, (Vec3d{0.5, 0, 0}));
  EXPECT_EQ(point.material, 3);
  EXPECT_EQ(tracer::plugin_faults(shapes).what,
            "1 answers that change when the same ray asks again of 'misbehaving'");
}

// The square turned, then stretched, and lifted to y = 5: a ray of world space has the same t in the
// plug-in's own space, and the normal goes by the inverse transpose.
TEST(Plugins, SeeRaysInTheSpaceOfTheShape) {
  auto shape = shape_by("misbehaving", {});
  shape.matrix = translation({10, 5, 0}) * scaling({2, 1, 3}) * rotation_z(45);
  const auto placed = tracer::make_plugin_shape(
      shape, "s", {10, 0, 0}, {{"misbehaving", tracer::open_plugin(library("misbehaving"))}});
  const auto hit = intersect(placed, {{1, 9, 2.5}, {0, -2, 0}, 0, kInf});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 1.75, 1e-14);  // the plane y = 5 + x / 2, relative to the origin
  EXPECT_NEAR(hit->normal.x, -1 / std::sqrt(5.0), 1e-14);
  EXPECT_NEAR(hit->normal.y, 2 / std::sqrt(5.0), 1e-14);
  EXPECT_NEAR(hit->uv.x, std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(hit->uv.y, 2.5 / 3, 1e-14);
  EXPECT_LE(placed.low.z, -3);
  EXPECT_GE(placed.high.z, 3);
  EXPECT_NEAR(placed.high.y, 5 + std::sqrt(0.5), 1e-4);
}

// Shadow rays ask orbs_shape_occluded where there is one, else orbs_shape_intersect.
TEST(Plugins, BlockWhatTheyAreHitBy) {
  for (const char* plugin : {"saddle", "misbehaving"}) {
    const auto shape = made(plugin);
    EXPECT_EQ(shape.library->occluded != nullptr, std::string(plugin) == "saddle");
    for (int i = 0; i < 400; ++i) {
      const float x = -1.5F + 3.0F * static_cast<float>(i % 20) / 19;
      const float z = -1.5F + 3.0F * static_cast<float>(i / 20) / 19;
      const tracer::UserRay ray{{x, 3, z}, {0.1F, -1, 0.2F}, 0, 3.3F};
      EXPECT_EQ(is_blocked(shape, 0, ray), hit_of(shape, 0, ray).has_value()) << plugin << " " << i;
    }
  }
}
