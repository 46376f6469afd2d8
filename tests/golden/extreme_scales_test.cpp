/// What is exported for scenes very small or wide, and seen from far away.
#include "adapters/mitsuba/mitsuba.h"
#include "adapters/pbrt/pbrt.h"
#include "base/files.h"
#include "scene/load/load_scene.h"
#include "scene/relations/ground.h"
#include "scene/relations/motion.h"

#include <regex>

#include <gtest/gtest.h>

namespace {

using namespace orbs;
namespace fs = std::filesystem;

class ExtremeScales : public testing::Test {
 protected:
  std::string exported(const scene::Scene& scene,
                       void (*write)(const scene::Scene&, const fs::path&) = adapters::write_mitsuba) const {
    write(scene, scratch_.path() / "scene.txt");
    return read_file(scratch_.path() / "scene.txt");
  }
  static double number(const std::string& text, const std::string& name) {
    std::smatch found;
    if (!std::regex_search(text, found, std::regex("\"" + name + "\" value=\"([^\"]*)\""))) return -1;
    return std::stod(found[1]);
  }

  // The ball is 2.4 m from the camera.
  const scene::Scene scene_ = scene::load_scene(ORBS_SOURCE_DIR "/data/bench/block-on-ground.json");
  const ScratchFolder scratch_{"orbs-extreme-scales"};
};

TEST_F(ExtremeScales, MitsubaClipsNothingOfATinyScene) {
  const double usual = number(exported(scene_), "near_clip");
  EXPECT_GT(usual, 0);
  EXPECT_LT(usual, 1e-4);
  const auto tiny = exported(scene::moved(scene_, scaling({1e-7, 1e-7, 1e-7})));
  EXPECT_NEAR(number(tiny, "near_clip"), 1e-7 * usual, 1e-12 * usual);
  EXPECT_GT(number(tiny, "far_clip"), 5e-7);
}

TEST_F(ExtremeScales, MitsubaClipsNothingBeforeAVastGround) {
  const auto vast = std::get<scene::Scene>(scene::with_large_ground(scene_, 1e9));
  const auto text = exported(vast);
  EXPECT_GT(number(text, "near_clip"), 0);
  EXPECT_LT(number(text, "near_clip"), 0.02);
  EXPECT_GT(number(text, "far_clip"), 1e8);
}

// The image is a matter of the blocks, so their size is one of the image and not of the threads.
TEST_F(ExtremeScales, MitsubaHasBlocksForManyThreadsWhateverTheirNumber) {
  scene::Scene scene = scene_;
  const auto size = [&](int width_px, int height_px) {
    scene.camera.width_px = width_px;
    scene.camera.height_px = height_px;
    return number(exported(scene), "block_size");
  };
  EXPECT_EQ(size(1024, 1024), 32);
  EXPECT_EQ(size(256, 256), 32);
  EXPECT_EQ(size(255, 128), 16);
  EXPECT_EQ(size(32, 32), 4);
  EXPECT_EQ(size(1, 1), 1);
}

TEST_F(ExtremeScales, PbrtKeepsTheOriginOfASceneThatIsSeenFromAfar) {
  const std::string frame = "Option \"rendercoordsys\" \"world\"\n";
  const auto keeps = [&](const scene::Scene& scene) {
    return exported(scene, adapters::write_pbrt).find(frame) != std::string::npos;
  };
  EXPECT_FALSE(keeps(scene_));
  const auto seen_from_afar = std::get<scene::Scene>(scene::with_far_camera(scene_, 1000));
  EXPECT_TRUE(keeps(seen_from_afar));
  // A scene far from its origin is no nearer to it than its camera is.
  EXPECT_FALSE(keeps(scene::moved(scene_, translation({1e6, 0, 0}))));
}

}  // namespace
