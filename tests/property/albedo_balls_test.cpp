// Cases of group B whose images are known, most of them balls whose albedos are: the tracer shows them, and
// the typical mistakes fail.
#include "property/mistaken_scenes.h"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace orbs;
using tests::expect_the_case_and_no_mistake;
using tests::Mistake;

namespace {

// Another model in the place of the last material's.
template <typename Model, typename Change>
Mistake mistake(const char* what, Change change) {
  return {what, {}, [change](scene::Scene& scene) {
            auto& model = scene.materials.back().model;
            model = change(std::get<Model>(model));
          }};
}

}  // namespace

TEST(AlbedoBalls, OfMetals) {
  expect_the_case_and_no_mistake("b1_metal",
                                 {mistake<scene::Metal>("no Fresnel factor",
                                                        [](const scene::Metal& m) {
                                                          return scene::Ggx{m.reflectance, m.alpha};
                                                        }),
                                  mistake<scene::Metal>("alpha squared once more", [](scene::Metal m) {
                                    m.alpha *= m.alpha;
                                    return m;
                                  })});
}

TEST(AlbedoBalls, OfMetallicAndRoughness) {
  using Model = scene::MetallicRoughness;
  expect_the_case_and_no_mistake("b7_metallic_roughness",
                                 {mistake<Model>("roughness that is not squared",
                                                 [](Model m) {
                                                   m.roughness = std::sqrt(m.roughness);
                                                   return m;
                                                 }),
                                  mistake<Model>("a quarter more of metal", [](Model m) {
                                    m.metallic = m.metallic < 0.5 ? m.metallic + 0.25 : m.metallic - 0.25;
                                    return m;
                                  })});
}

TEST(AlbedoBalls, OfPhong) {
  expect_the_case_and_no_mistake(
      "b8_phong", {mistake<scene::Phong>("n + 1 for n + 2",
                                         [](scene::Phong m) {
                                           m.reflectance =
                                               m.reflectance * ((m.exponent + 1) / (m.exponent + 2));
                                           return m;
                                         }),
                   mistake<scene::Phong>("a lobe like Lambert's", [](scene::Phong m) {
                     m.exponent = 0;
                     return m;
                   })});
}

namespace {

Mistake nonlinear_as_linear() {
  return mistake<scene::Plastic>("the other reflections inside", [](scene::Plastic m) {
    m.is_nonlinear = !m.is_nonlinear;
    return m;
  });
}

Mistake other_index() {
  return mistake<scene::Plastic>("an index that is 3 % off", [](scene::Plastic m) {
    m.ior *= 1.03;
    return m;
  });
}

// Right in a furnace: its albedo is (1 - F) rho, as that of the base of linear plastic.
Mistake lambert_under_fresnel_of_the_view() {
  return mistake<scene::Plastic>("Lambert's law times 1 - F of the view", [](const scene::Plastic& m) {
    constexpr double kAlongTheNormal = 0.96;
    return scene::Lambert{m.reflectance * kAlongTheNormal, {}};
  });
}

}  // namespace

TEST(AlbedoBalls, AnisotropicReflection) {
  const auto turned = mistake<scene::AnisotropicGgx>("x for y", [](scene::AnisotropicGgx m) {
    std::swap(m.alpha_x, m.alpha_y);
    return m;
  });
  const auto squared = mistake<scene::AnisotropicGgx>("alpha squared once more", [](scene::AnisotropicGgx m) {
    m.alpha_x *= m.alpha_x;
    m.alpha_y *= m.alpha_y;
    return m;
  });
  const auto other_axis = mistake<scene::AnisotropicGgx>("the other rotation", [](scene::AnisotropicGgx m) {
    m.rotation_deg = m.rotation_deg == 0 ? 20 : -m.rotation_deg;
    return m;
  });
  expect_the_case_and_no_mistake("b2_anisotropic", {turned, squared, other_axis});
  expect_the_case_and_no_mistake("b2_anisotropic_sun", {turned, squared});
}

TEST(AlbedoBalls, RoughnessByATexture) {
  expect_the_case_and_no_mistake("b3_roughness_texture",
                                 {mistake<scene::VaryingGgx>("glossiness for alpha", [](scene::VaryingGgx m) {
                                   m.is_glossiness = !m.is_glossiness;
                                   return m;
                                 })});
}

TEST(AlbedoBalls, BlendsOfTwoMaterials) {
  expect_the_case_and_no_mistake("b6_blend", {mistake<scene::Blend>("the parts swapped",
                                                                    [](scene::Blend m) {
                                                                      std::swap(m.parts[0], m.parts[1]);
                                                                      return m;
                                                                    }),
                                              mistake<scene::Blend>("the weight squared", [](scene::Blend m) {
                                                m.weight *= m.weight;
                                                return m;
                                              })});
}

TEST(AlbedoBalls, MixesOfGgxAndLambert) {
  expect_the_case_and_no_mistake(
      "b9_mixes",
      {mistake<scene::GgxLambert>("a diffuse part times 1 - max r",
                                  [](scene::GgxLambert m) {
                                    const double left = 1 - std::max({m.colour.x, m.colour.y, m.colour.z});
                                    m.diffuse = m.diffuse * left;
                                    return m;
                                  }),
       mistake<scene::GgxLambert>("no glossy part", [](scene::GgxLambert m) {
         m.colour = {};
         return m;
       })});
}

TEST(AlbedoBalls, OfSmoothPlastic) {
  expect_the_case_and_no_mistake("b4_plastic",
                                 {nonlinear_as_linear(), other_index(),
                                  mistake<scene::Plastic>("no coat",
                                                          [](const scene::Plastic& m) {
                                                            return scene::Lambert{m.reflectance, {}};
                                                          }),
                                  mistake<scene::Plastic>("a rough coat", [](scene::Plastic m) {
                                    m.alpha = 0.1;
                                    return m;
                                  })});
}

TEST(AlbedoBalls, SmoothPlasticInParallelLight) {
  expect_the_case_and_no_mistake("b4_plastic_sun",
                                 {nonlinear_as_linear(), lambert_under_fresnel_of_the_view()});
}

TEST(AlbedoBalls, OfRoughPlastic) {
  expect_the_case_and_no_mistake("b5_rough_plastic",
                                 {nonlinear_as_linear(), other_index(),
                                  mistake<scene::Plastic>("a smooth coat",
                                                          [](scene::Plastic m) {
                                                            m.alpha.reset();
                                                            return m;
                                                          }),
                                  mistake<scene::Plastic>("alpha squared once more", [](scene::Plastic m) {
                                    m.alpha = *m.alpha * *m.alpha;
                                    return m;
                                  })});
}

TEST(AlbedoBalls, RoughPlasticInParallelLight) {
  expect_the_case_and_no_mistake(
      "b5_rough_plastic_sun",
      {nonlinear_as_linear(), mistake<scene::Plastic>("a smooth coat", [](scene::Plastic m) {
         m.alpha.reset();
         return m;
       })});
}
