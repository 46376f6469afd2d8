// Cases of group B whose images are known, most of them balls whose albedos are: the tracer shows them, and
// the typical mistakes fail.
#include "property/judged_case.h"
#include "registry/configuration.h"
#include "scene/load/load_scene.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
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
        wrong.materials.back().model = change(scene.materials.back().model);
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

namespace {

Mistake nonlinear_as_linear() {
  return mistake<scene::Plastic>("with the other reflections inside", [](scene::Plastic m) {
    m.is_nonlinear = !m.is_nonlinear;
    return m;
  });
}

Mistake other_index() {
  return mistake<scene::Plastic>("with an index that is 3 % off", [](scene::Plastic m) {
    m.ior *= 1.03;
    return m;
  });
}

// Right in a furnace: its albedo is (1 - F) rho, as that of the base of linear plastic.
Mistake lambert_under_fresnel_of_the_view() {
  return mistake<scene::Plastic>("with Lambert's law times 1 - F of the view", [](const scene::Plastic& m) {
    constexpr double kAlongTheNormal = 0.96;
    return scene::Lambert{m.reflectance * kAlongTheNormal, {}};
  });
}

}  // namespace

TEST(AlbedoBalls, AnisotropicReflection) {
  const auto turned = mistake<scene::AnisotropicGgx>("with x for y", [](scene::AnisotropicGgx m) {
    std::swap(m.alpha_x, m.alpha_y);
    return m;
  });
  const auto squared =
      mistake<scene::AnisotropicGgx>("with alpha squared once more", [](scene::AnisotropicGgx m) {
        m.alpha_x *= m.alpha_x;
        m.alpha_y *= m.alpha_y;
        return m;
      });
  const auto other_axis =
      mistake<scene::AnisotropicGgx>("with the other rotation", [](scene::AnisotropicGgx m) {
        m.rotation_deg = m.rotation_deg == 0 ? 20 : -m.rotation_deg;
        return m;
      });
  expect_the_ball_and_no_mistake("b2_anisotropic", {turned, squared, other_axis});
  expect_the_ball_and_no_mistake("b2_anisotropic_sun", {turned, squared});
}

TEST(AlbedoBalls, RoughnessByATexture) {
  expect_the_ball_and_no_mistake(
      "b3_roughness_texture",
      {mistake<scene::VaryingGgx>("with glossiness for alpha", [](scene::VaryingGgx m) {
        m.is_glossiness = !m.is_glossiness;
        return m;
      })});
}

TEST(AlbedoBalls, BlendsOfTwoMaterials) {
  expect_the_ball_and_no_mistake("b6_blend",
                                 {mistake<scene::Blend>("with the parts swapped",
                                                        [](scene::Blend m) {
                                                          std::swap(m.parts[0], m.parts[1]);
                                                          return m;
                                                        }),
                                  mistake<scene::Blend>("with the weight squared", [](scene::Blend m) {
                                    m.weight *= m.weight;
                                    return m;
                                  })});
}

TEST(AlbedoBalls, MixesOfGgxAndLambert) {
  expect_the_ball_and_no_mistake(
      "b9_mixes",
      {mistake<scene::GgxLambert>("with a diffuse part times 1 - max r",
                                  [](scene::GgxLambert m) {
                                    const double left = 1 - std::max({m.colour.x, m.colour.y, m.colour.z});
                                    m.diffuse = m.diffuse * left;
                                    return m;
                                  }),
       mistake<scene::GgxLambert>("with no glossy part", [](scene::GgxLambert m) {
         m.colour = {};
         return m;
       })});
}

TEST(AlbedoBalls, OfSmoothPlastic) {
  expect_the_ball_and_no_mistake("b4_plastic",
                                 {nonlinear_as_linear(), other_index(),
                                  mistake<scene::Plastic>("without a coat",
                                                          [](const scene::Plastic& m) {
                                                            return scene::Lambert{m.reflectance, {}};
                                                          }),
                                  mistake<scene::Plastic>("with a rough coat", [](scene::Plastic m) {
                                    m.alpha = 0.1;
                                    return m;
                                  })});
}

TEST(AlbedoBalls, SmoothPlasticInParallelLight) {
  expect_the_ball_and_no_mistake("b4_plastic_sun",
                                 {nonlinear_as_linear(), lambert_under_fresnel_of_the_view()});
}

TEST(AlbedoBalls, OfRoughPlastic) {
  expect_the_ball_and_no_mistake(
      "b5_rough_plastic", {nonlinear_as_linear(), other_index(),
                           mistake<scene::Plastic>("with a smooth coat",
                                                   [](scene::Plastic m) {
                                                     m.alpha.reset();
                                                     return m;
                                                   }),
                           mistake<scene::Plastic>("with alpha squared once more", [](scene::Plastic m) {
                             m.alpha = *m.alpha * *m.alpha;
                             return m;
                           })});
}

TEST(AlbedoBalls, RoughPlasticInParallelLight) {
  expect_the_ball_and_no_mistake(
      "b5_rough_plastic_sun",
      {nonlinear_as_linear(), mistake<scene::Plastic>("with a smooth coat", [](scene::Plastic m) {
         m.alpha.reset();
         return m;
       })});
}
