// The cases of textures and surface detail, whose images are known: the tracer shows them, and the typical
// mistakes fail.
#include "property/judged_case.h"
#include "registry/configuration.h"
#include "scene/load/load_scene.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

using namespace orbs;

namespace {

struct Mistake {
  const char* what;
  std::set<std::string> scenes;  // that show it
  std::function<void(scene::Scene&)> make;
};

void expect_the_case_and_no_mistake(const std::string& name, const std::vector<Mistake>& mistakes) {
  const auto suite =
      registry::find_suite(registry::load_configuration(ORBS_SOURCE_DIR "/configuration.json"), "everyday");
  for (const auto& one_case : registry::load_cases(suite)) {
    if (one_case.name != name) continue;
    for (const auto& one : one_case.scenes) {
      const auto scene = scene::load_scene(one.file, {}, one.camera);
      const auto expect = [&](const scene::Scene& shown, results::Verdict expected, const std::string& what) {
        tests::expect_verdict(tests::judged(one_case, one.name, shown, suite.references), expected, what);
      };
      expect(scene, results::Verdict::Pass, "");
      for (const auto& [what, scenes, make] : mistakes) {
        if (!scenes.contains(one.name)) continue;
        auto wrong = scene;
        make(wrong);
        expect(wrong, results::Verdict::Fail, std::string(" with ") + what);
      }
    }
  }
}

scene::Texture& texture_in(scene::Scene& scene) { return scene.textures.front(); }

// Changes the texture matrix of the first material.
void move_texture(scene::Scene& scene, const Mat4& by) {
  std::visit(
      [&](auto& model) {
        if constexpr (requires { model.texture; }) model.texture->matrix = by * model.texture->matrix;
      },
      scene.materials.front().model);
}

}  // namespace

TEST(TextureCases, BeyondTheEdge) {
  const auto wraps = [](scene::Wrap u, scene::Wrap v) {
    return [u, v](scene::Scene& scene) {
      texture_in(scene).wrap_u = u;
      texture_in(scene).wrap_v = v;
    };
  };
  using scene::Wrap;
  // A mirror that shows the edge texel once has a period of 2n - 2: of two texels, that is to repeat.
  expect_the_case_and_no_mistake(
      "n4_wrap",
      {{"a texture that repeats, as one mirrored without its edge does",
        {"n4-mirror", "n4-mixed", "n4-turned", "n4-glow"},
        wraps(Wrap::Repeat, Wrap::Repeat)},
       {"a texture that is clamped", {"n4-mirror", "n4-mixed"}, wraps(Wrap::Clamp, Wrap::Clamp)},
       {"the rules of the axes swapped",
        {"n4-mixed", "n4-clamped", "n4-glow"},
        [](scene::Scene& scene) { std::swap(texture_in(scene).wrap_u, texture_in(scene).wrap_v); }},
       {"one rule for both axes", {"n4-mixed", "n4-clamped"}, wraps(Wrap::Mirror, Wrap::Mirror)},
       {"v upside down", {"n4-mirror", "n4-clamped", "n4-glow"}, [](scene::Scene& scene) {
          move_texture(scene, translation({0, 1, 0}) * scaling({1, -1, 1}));
        }}});
}

TEST(TextureCases, BetweenTexels) {
  const auto filters = [](scene::Filter filter) {
    return [filter](scene::Scene& scene) { texture_in(scene).filter = filter; };
  };
  expect_the_case_and_no_mistake(
      "n5_filter", {{"interpolation", {"n5-nearest", "n5-edges", "n5-glow"}, filters(scene::Filter::Linear)},
                    {"no interpolation", {"n5-linear"}, filters(scene::Filter::Nearest)},
                    {"half a texel too much",
                     {"n5-nearest", "n5-edges", "n5-linear", "n5-glow"},
                     [](scene::Scene& scene) {
                       move_texture(scene, translation({0.25, 0.25, 0}));
                     }},
                    {"encoded values", {"n5-nearest", "n5-linear"}, [](scene::Scene& scene) {
                       texture_in(scene).encoding = scene::Encoding::Linear;
                     }}});
}
