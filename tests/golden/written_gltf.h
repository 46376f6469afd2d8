#pragma once

#include "adapters/gltf/gltf.h"
#include "base/files.h"
#include "golden/read_gltf.h"

#include <filesystem>

#include <gtest/gtest.h>

namespace orbs::tests {

/// A folder for what the exporter to glTF writes.
class WrittenGltf : public testing::Test {
 protected:
  /// The scene as a file that is read back; the test fails if the exporter refuses it.
  GltfFile written(const scene::Scene& scene) const {
    const auto limits = adapters::gltf_limits(scene);
    EXPECT_TRUE(limits.empty()) << limits.front();
    adapters::write_gltf(scene, folder_ / "scene.glb");
    return read_glb(folder_ / "scene.glb");
  }
  ScratchFolder scratch_{"orbs-gltf"};
  std::filesystem::path folder_ = scratch_.path();
};

}  // namespace orbs::tests
