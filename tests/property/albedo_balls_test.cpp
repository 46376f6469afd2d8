// The balls of the cases B1, B7 and B8, whose albedos are known: the tracer shows them, and the typical
// mistakes fail.
#include "property/judged_case.h"
#include "registry/configuration.h"
#include "scene/load/load_scene.h"

#include <cmath>
#include <functional>
#include <vector>

using namespace orbs;

namespace {

struct Mistake {
  const char* what;
  std::function<scene::MaterialModel(const scene::MaterialModel&)> change;
};

template <typename Model, typename Change>
Mistake mistake(const char* what, Change change) {
  return {what, [change](const scene::MaterialModel& model) -> scene::MaterialModel {
            return change(std::get<Model>(model));
          }};
}

void expect_the_ball_and_no_mistake(const std::string& name, const std::vector<Mistake>& mistakes) {
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
      for (const auto& [what, change] : mistakes) {
        auto wrong = scene;
        wrong.materials.front().model = change(scene.materials.front().model);
        expect(wrong, results::Verdict::Fail, std::string(" ") + what);
      }
    }
  }
}

}  // namespace

TEST(AlbedoBalls, OfMetals) {
  expect_the_ball_and_no_mistake("b1_metal",
                                 {mistake<scene::Metal>("without a Fresnel factor",
                                                        [](const scene::Metal& m) {
                                                          return scene::Ggx{m.reflectance, m.alpha};
                                                        }),
                                  mistake<scene::Metal>("with alpha squared once more", [](scene::Metal m) {
                                    m.alpha *= m.alpha;
                                    return m;
                                  })});
}

TEST(AlbedoBalls, OfMetallicAndRoughness) {
  using Model = scene::MetallicRoughness;
  expect_the_ball_and_no_mistake("b7_metallic_roughness",
                                 {mistake<Model>("with roughness that is not squared",
                                                 [](Model m) {
                                                   m.roughness = std::sqrt(m.roughness);
                                                   return m;
                                                 }),
                                  mistake<Model>("of which a quarter more is metal", [](Model m) {
                                    m.metallic = m.metallic < 0.5 ? m.metallic + 0.25 : m.metallic - 0.25;
                                    return m;
                                  })});
}

TEST(AlbedoBalls, OfPhong) {
  expect_the_ball_and_no_mistake(
      "b8_phong", {mistake<scene::Phong>("with n + 1 for n + 2",
                                         [](scene::Phong m) {
                                           m.reflectance =
                                               m.reflectance * ((m.exponent + 1) / (m.exponent + 2));
                                           return m;
                                         }),
                   mistake<scene::Phong>("with a lobe like Lambert's", [](scene::Phong m) {
                     m.exponent = 0;
                     return m;
                   })});
}
