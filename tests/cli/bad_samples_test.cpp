// What orbs-tracer had to leave out or to guess is counted in its image, and above a stated share its exit
// status says so.
#include "cli/sandbox.h"
#include "image/image_io.h"

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace orbs;
using cli_tests::Answer;
using cli_tests::contains;
using cli_tests::Sandbox;

namespace {

constexpr const char* kCamera =
    R"("format": "orbs-scene/1", "name": "s", "camera": {"position": [0, 4, 0.1], "look_at": [0, 0, 0], "fov_y": 10, "width": 8, "height": 8})";

Answer render(const Sandbox& sandbox, const std::string& scene, const std::string& more = "") {
  sandbox.write("scene.json", fmt::format("{{{}, {}}}", kCamera, scene));
  return sandbox.shell(ORBS_BINARY_WORD "/orbs-tracer scene.json -o out.exr --spp 16 " + more);
}

std::string count(const Sandbox& sandbox, const std::string& attribute) {
  return image::read_image(sandbox.folder() / "out.exr").attributes.at(attribute);
}

// Lit by the sky and by a lamp, whose sum is beyond the range of floats where each is 3e38.
std::string lit_floor(const std::string& radiance) {
  return fmt::format(
      R"("environment": [{0}, 1, 1], "materials": [{{"name": "m", "type": "lambert", "reflectance": [1, 1, 1]}}],
  "meshes": [{{"name": "p", "generator": "plane", "half_size": 1, "material": "m"}}], "instances": [{{"mesh": "p"}}],
  "lights": [{{"type": "rect", "half_width": 0.5, "half_length": 0.5, "radiance": [{0}, 1, 1],
              "matrix": [{{"translate": [0.6, 0.4, 0]}}]}}])",
      radiance);
}

std::string formula(const std::string& expression) {
  return fmt::format(
      R"("environment": [1, 1, 1], "materials": [{{"name": "m", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}}],
  "shapes": [{{"type": "implicit", "expression": "{}", "low": [-1, -1, -1], "high": [1, 1, 1], "material": "m"}}])",
      expression);
}

}  // namespace

TEST(BadSamplesOfTheTracer, MakeItsExitStatusFour) {
  const Sandbox sandbox;
  const auto answer = render(sandbox, lit_floor("3e38"));
  EXPECT_EQ(answer.status, 4) << answer.text;
  EXPECT_TRUE(contains(answer.text, "the image is written and lacks too much: in 1024 samples"))
      << answer.text;
  EXPECT_TRUE(contains(answer.text, "at most 100 in a million may be")) << answer.text;
  EXPECT_GT(std::stoi(count(sandbox, "orbs.bad_samples")), 0);
  const auto counted = render(sandbox, lit_floor("3e38"), "--bad-samples count");
  EXPECT_EQ(counted.status, 0) << counted.text;
  EXPECT_GT(std::stoi(count(sandbox, "orbs.bad_samples")), 0);
}

TEST(BadSamplesOfTheTracer, AreNoneInSoundScenes) {
  const Sandbox sandbox;
  const auto answer = render(sandbox, lit_floor("3e18"));
  EXPECT_EQ(answer.status, 0) << answer.text;
  EXPECT_EQ(count(sandbox, "orbs.bad_samples"), "0");
}

TEST(BadSamplesOfTheTracer, AreLikePointsOfFormulasWithoutNormal) {
  const Sandbox sandbox;
  const auto answer = render(sandbox, formula("0 * x"));
  EXPECT_EQ(answer.status, 4) << answer.text;
  EXPECT_TRUE(contains(answer.text, "points of formulas had no gradient")) << answer.text;
  EXPECT_GT(std::stoi(count(sandbox, "orbs.zero_normals")), 0);
  // The surface only touches zero, and its gradient is zero upon it; it has one beside.
  EXPECT_EQ(render(sandbox, formula("(x^2 + y^2 + z^2 - 0.25)^2")).status, 0);
  EXPECT_EQ(count(sandbox, "orbs.zero_normals"), "0");
  EXPECT_GT(std::stoi(count(sandbox, "orbs.undecided_roots")), 0);
}
