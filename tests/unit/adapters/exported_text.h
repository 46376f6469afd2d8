#pragma once

#include "adapters/gltf/gltf.h"
#include "adapters/hydra/hydra.h"
#include "adapters/mitsuba/mitsuba.h"
#include "adapters/pbrt/pbrt.h"
#include "adapters/povray/povray.h"
#include "base/files.h"
#include "scene/geometry/generators.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

/// What exporters write of a small scene, as text.
namespace orbs::tests {

/// A cube of this material in direct light, which has yet to be added.
inline scene::Scene cube_of(const scene::MaterialModel& model) {
  scene::Scene scene;
  scene.camera.position_m = {0, 0, 5};
  scene.trace_depth = 1;
  scene.materials = {{"m", model}};
  scene.meshes = {scene::make_cube({1})};
  scene.meshes[0].triangle_materials.assign(12, 0);
  scene.instances = {{"i", 0, {}, {}}};
  return scene;
}

class ExportedText : public testing::Test {
 protected:
  std::string read(const char* name) const { return read_file(folder_ / name); }
  std::string mitsuba(const scene::Scene& scene) {
    adapters::write_mitsuba(scene, folder_ / "a.xml");
    return read("a.xml");
  }
  std::string pbrt(const scene::Scene& scene) {
    adapters::write_pbrt(scene, folder_ / "a.pbrt");
    return read("a.pbrt");
  }
  std::string povray(const scene::Scene& scene) {
    adapters::write_povray(scene, {}, folder_ / "a.pov");
    return read("a.pov");
  }
  std::string hydra(const scene::Scene& scene) {
    adapters::write_hydra(scene, {}, folder_ / "a.xml");
    return read("a.xml");
  }
  std::string gltf(const scene::Scene& scene) {
    adapters::write_gltf(scene, folder_ / "a.glb");
    return read("a.glb");
  }

  ScratchFolder scratch_{"orbs-exported-text"};
  std::filesystem::path folder_ = scratch_.path();
};

#define EXPECT_HOLDS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text).substr(0, 4000)

}  // namespace orbs::tests
