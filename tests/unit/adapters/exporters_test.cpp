// The table of exporters, and what becomes of a type of material that an exporter does not know.
#include "adapters/export.h"
#include "adapters/kind_support.h"
#include "base/files.h"
#include "json/document.h"
#include "json/object_reader.h"
#include "registry/features.h"
#include "scene/geometry/world_bounds.h"
#include "scene/load/load_scene.h"
#include "scene/relations/motion.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace {

using namespace orbs;

TEST(Exporters, TheSchemaOfTheConfigurationHasTheirWords) {
  const auto document = json::parse_file(ORBS_SOURCE_DIR "/data/schema/orbs-configuration-1.schema.json");
  json::ObjectReader schema(document);
  const auto words = schema.object("properties")
                         .object("renderers")
                         .object("items")
                         .object("properties")
                         .object("scene_format")
                         .texts("enum");
  EXPECT_EQ(std::set<std::string>(words.begin(), words.end()), adapters::scene_formats());
}

TEST(Exporters, EachHasAFileOfItsOwn) {
  std::set<std::string> files;
  for (const auto& exporter : adapters::exporters()) files.insert(exporter.scene_file);
  EXPECT_EQ(files.size(), adapters::exporters().size());
}

TEST(Exporters, AnUnknownFormatIsAnsweredWithAllFormatsAndTheNearest) {
  registry::Renderer renderer;
  renderer.name = "r";
  renderer.place = "configuration.json:7";
  EXPECT_NO_THROW(adapters::check_scene_format(renderer));
  renderer.format.name = registry::kNativeFormat;
  EXPECT_NO_THROW(adapters::check_scene_format(renderer));
  renderer.format.name = "mitsubo";
  try {
    adapters::check_scene_format(renderer);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_STREQ(
        e.what(),
        "configuration.json:7: renderer 'r': scene_format: 'mitsubo' is not one of: gltf, hydra, mitsuba, native, obj, "
        "orbs-scene, pbrt, ply, povray (did you mean 'mitsuba'?)");
  }
}

// Moved by a multiple of 256 m, which floats at 10^6 m no longer tell from what is 6 cm beside it.
TEST(Exporters, TheOriginIsNearTheCamera) {
  const auto scene = scene::load_scene(ORBS_SOURCE_DIR "/data/bench/glass.json");
  const auto far = scene::with_moved_vertices(scene, {256e4, -512e4, 1024e4});
  const auto prepared = [&](const char* format, adapters::SceneSettings settings) {
    registry::Renderer renderer;
    renderer.support.declares = registry::parse_features("G5/M8/L4/A4");
    renderer.format.name = format;
    renderer.format.settings = std::move(settings);
    EXPECT_NO_THROW(adapters::check_scene_settings(renderer));
    return std::get<scene::Scene>(adapters::prepare_scene(renderer, far));
  };
  // Doubles at 10^7 m are 2e-9 m apart.
  const auto distance_m = [&](const scene::Scene& moved, const scene::Scene& from) {
    return length(moved.camera.position_m - from.camera.position_m) +
           length(moved.camera.look_at_m - from.camera.look_at_m);
  };
  for (const auto& exporter : adapters::exporters()) {
    const bool is_neutral = exporter.format == std::string(registry::kNeutralFormat);
    EXPECT_LT(distance_m(prepared(exporter.format, {}), is_neutral ? far : scene), 1e-8) << exporter.format;
    const auto near = prepared(exporter.format, {{"origin_near_camera", 1}});
    EXPECT_LT(distance_m(near, scene), 1e-8) << exporter.format;
    EXPECT_LT(scene::world_bounds(near)->high.y, 2) << exporter.format;
    EXPECT_EQ(distance_m(prepared(exporter.format, {{"origin_near_camera", 0}}), far), 0) << exporter.format;
  }
}

// A reader that refuses keys that it does not know is right, so it is given none that it did not ask for.
TEST(Exporters, WhatASceneCallsForIsWrittenForWhoAsksForIt) {
  const auto scene = scene::load_scene(ORBS_SOURCE_DIR "/data/bench/glass.json");
  const ScratchFolder folder("exporters");
  registry::Renderer renderer;
  renderer.support.declares = registry::parse_features("G5/M8/L4/A4");
  renderer.format.name = registry::kNeutralFormat;
  const auto written = [&] {
    EXPECT_NO_THROW(adapters::check_scene_settings(renderer));
    const auto prepared = std::get<scene::Scene>(adapters::prepare_scene(renderer, scene));
    adapters::export_scene(renderer, prepared, folder.path() / "scene.json");
    return read_file(folder.path() / "scene.json");
  };
  EXPECT_EQ(written().find("calls_for"), std::string::npos);
  renderer.format.settings = {{"calls_for", 1}};
  EXPECT_NE(written().find("\"calls_for\": [\n    \"glass\""), std::string::npos) << written().substr(0, 300);
}

TEST(Exporters, WholeRepetitionsOfTexturesAreLeftOut) {
  const auto scene =
      scene::load_scene(ORBS_SOURCE_DIR "/data/cases/stability/far_textures/texture-offset-1e7.json");
  registry::Renderer renderer;
  renderer.support.declares = registry::parse_features("G5/M8");
  for (const double is_moved : {0, 1}) {
    renderer.format.name = registry::kNeutralFormat;
    renderer.format.settings = {{"origin_near_camera", is_moved}};
    const auto prepared = std::get<scene::Scene>(adapters::prepare_scene(renderer, scene));
    const auto& floor = std::get<scene::Lambert>(prepared.materials[0].model);
    EXPECT_EQ(floor.texture.value().matrix(0, 3), is_moved == 1 ? 0 : 1e7);
  }
}

struct WriterOfTwo {
  std::string operator()(const scene::Lambert&) const { return "lambert"; }
  std::string operator()(const scene::Mirror&) const { return "mirror"; }
};

struct NoMirrors {
  std::string operator()(const scene::Mirror&) const { return "mirrors are out of fashion"; }
};

std::string limit_of(const scene::MaterialModel& model) {
  const adapters::BeyondOrbs levels{{"E1"}, {}};
  return adapters::limit_of_material<WriterOfTwo>({"a", model}, "Fake", levels, NoMirrors{});
}

TEST(MaterialSupport, ATypeThatTheWriterDoesNotKnowIsRefusedByName) {
  EXPECT_EQ(limit_of(scene::Lambert{}), "");
  EXPECT_EQ(limit_of(scene::Mirror{}), "mirrors are out of fashion");
  EXPECT_EQ(limit_of(scene::RoughGlass{}), "material 'a': Fake has no rough_glass");
  EXPECT_EQ(limit_of(scene::Conductor{}), "material 'a': Fake has no conductor");
  EXPECT_EQ(limit_of(scene::Polariser{}), "") << "beyond_orbs_limits refuses E3";
}

TEST(MaterialSupport, NothingIsWrittenForATypeThatTheWriterDoesNotKnow) {
  EXPECT_EQ(adapters::text_of_material({"a", scene::Lambert{}}, "Fake", WriterOfTwo{}), "lambert");
  EXPECT_THROW(adapters::text_of_material({"a", scene::Glass{}}, "Fake", WriterOfTwo{}), InputError);
}

struct WriterOfDisks {
  std::string operator()(const scene::DiskShape&) const { return "disk"; }
};

TEST(KindSupport, ALightThatTheWriterDoesNotKnowIsRefusedByName) {
  scene::Light light{"lamp", scene::DiskShape{1}, {1, 1, 1}, {}, {}};
  EXPECT_EQ(adapters::limit_of_shape<WriterOfDisks>(light, "light 'lamp'", "Fake"), "");
  EXPECT_EQ(adapters::text_of_shape(light, "Fake", WriterOfDisks{}), "disk");
  light.shape = scene::RectShape{1, 1};
  EXPECT_EQ(adapters::limit_of_shape<WriterOfDisks>(light, "light 'lamp'", "Fake"),
            "light 'lamp': Fake has no light of type rect");
  EXPECT_THROW(adapters::text_of_shape(light, "Fake", WriterOfDisks{}), InputError);
}

}  // namespace
