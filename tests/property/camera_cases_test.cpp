// The cases of cameras, whose right images are known: the tracer shows them, and other cameras fail.
#include "property/judged_case.h"
#include "registry/configuration.h"
#include "scene/load/load_scene.h"

#include <cmath>
#include <functional>
#include <map>
#include <numbers>

using namespace orbs;

namespace {

using Change = std::function<void(scene::Camera&)>;
struct Mistake {
  const char* what;
  Change change;
};

void turn_about(scene::Camera& camera) { camera.look_at_m = camera.position_m * 2 - camera.look_at_m; }

// What a renderer that has the feature may get wrong; of C5 nothing that a camera could say.
std::map<std::string, std::vector<Mistake>> mistakes() {
  return {{"C1",
           {{"a pinhole", [](auto& camera) { camera.aperture_radius_m = 0; }},
            {"the diameter for the radius", [](auto& camera) { camera.aperture_radius_m *= 2; }}}},
          {"C2",
           {{"a perspective", [](auto& camera) { camera.projection = scene::Perspective{}; }},
            {"half the height",
             [](auto& camera) { std::get<scene::Orthographic>(camera.projection).height_m /= 2; }}}},
          {"C3",
           {{"no shift", [](auto& camera) { camera.shift = {}; }},
            {"the other way",
             [](auto& camera) {
               camera.shift = {-camera.shift.x, -camera.shift.y};
             }},
            {"half of it",
             [](auto& camera) {
               camera.shift = {camera.shift.x / 2, camera.shift.y / 2};
             }}}},
          {"C4",
           {{"half a turn", turn_about},
            {"upside down", [](auto& camera) { camera.up = -camera.up; }},
            {"a perspective", [](auto& camera) { camera.projection = scene::Perspective{}; }}}}};
}

class CameraCases : public testing::Test {
 protected:
  results::Verdict verdict(const registry::Case& one_case,
                           const std::string& target,
                           const scene::Scene& scene,
                           int divisor = registry::QuarterSize) {
    return tests::judged(one_case, target, scene, suite_.references, divisor).verdict;
  }

  registry::Suite suite_ =
      registry::find_suite(registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json"), "everyday");
};

}  // namespace

TEST_F(CameraCases, KnownImagesAreShownAndOtherCamerasFail) {
  const auto wrong = mistakes();
  int seen = 0;
  for (const auto& one_case : registry::load_cases(suite_)) {
    if (one_case.requirement.front() != 'C') continue;
    for (const auto& one : one_case.scenes) {
      const auto scene = scene::load_scene(one.file, {}, one.camera);
      EXPECT_EQ(verdict(one_case, one.name, scene, registry::FullSize), results::Verdict::Pass) << one.name;
      ++seen;
      if (!wrong.contains(one_case.requirement)) continue;
      for (const auto& [what, change] : wrong.at(one_case.requirement)) {
        auto changed = scene;
        change(changed.camera);
        EXPECT_EQ(verdict(one_case, one.name, changed), results::Verdict::Fail) << one.name << ": " << what;
      }
    }
  }
  EXPECT_GE(seen, 15);
}

TEST_F(CameraCases, AFocusThatIsATwentiethOffIsSeen) {
  for (const auto& one_case : registry::load_cases(suite_))
    for (const auto& one : one_case.scenes) {
      if (one.name != "c1-focus") continue;
      const auto scene = scene::load_scene(one.file, {}, one.camera);
      for (const double factor : {0.95, 1.05}) {
        auto changed = scene;
        changed.camera.focus_distance_m = factor * scene.camera.focus_distance_m.value();
        EXPECT_EQ(verdict(one_case, one.name, changed), results::Verdict::Fail) << factor;
      }
    }
}

// The image of a shifted window is a part of that of a larger one: with the same pixels and the same random
// numbers, which belong to the pixel, only the noise differs, and there is none in what glows evenly.
TEST(ShiftedCamera, ShowsAPartOfALargerImage) {
  const auto scene = scene::load_scene(ORBS_SOURCE_DIR "/data/cases/everyday/c3_lens_shift/c3-squares.json");
  auto larger = scene;
  // Twice as wide and high, so that a shift of a quarter of the small width is one of 1/8 of the large one.
  larger.camera.width_px *= 2;
  larger.camera.height_px *= 2;
  larger.camera.shift = {};
  larger.camera.fov_y_deg =
      2 * std::atan(2 * std::tan(scene.camera.fov_y_deg * std::numbers::pi / 360)) * 180 / std::numbers::pi;
  const auto small = tests::rendered(scene, 1024);
  const auto large = tests::rendered(larger, 1024);
  const int x0 = scene.camera.width_px / 2 + scene.camera.width_px / 4;
  const int y0 = scene.camera.height_px / 2 + scene.camera.height_px / 8;
  for (int y = 0; y < scene.camera.height_px; ++y)
    for (int x = 0; x < scene.camera.width_px; ++x)
      ASSERT_NEAR(small.at(x, y, 0), large.at(x0 + x, y0 + y, 0), 0.02) << x << ", " << y;
}
