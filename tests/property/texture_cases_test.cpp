// The cases of textures and surface detail, whose images are known: the tracer shows them, and the typical
// mistakes fail.
#include "property/mistaken_scenes.h"

using namespace orbs;

namespace {

using tests::Mistake;

void expect_mistakes_to_fail(const std::string& name, const std::vector<Mistake>& mistakes) {
  tests::expect_the_case_and_no_mistake(name, mistakes, tests::Remarks::Allowed);
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
  expect_mistakes_to_fail(
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
  expect_mistakes_to_fail(
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

namespace {

void for_each_opacity(scene::Scene& scene, const std::function<void(scene::SurfaceDetail&)>& change) {
  for (auto& material : scene.materials)
    if (lets_rays_pass(material.detail)) change(material.detail);
}

}  // namespace

TEST(TextureCases, SurfacesThatLetRaysPass) {
  const auto inverted = [](scene::Scene& scene) {
    for_each_opacity(scene, [](scene::SurfaceDetail& detail) { detail.opacity = 1 - detail.opacity; });
  };
  const auto none = [](scene::Scene& scene) {
    for_each_opacity(scene, [](scene::SurfaceDetail& detail) { detail = {}; });
  };
  const auto twice = [](scene::Scene& scene) {
    for_each_opacity(scene, [](scene::SurfaceDetail& detail) {
      detail.opacity = 1 - (1 - detail.opacity) * (1 - detail.opacity);
    });
  };
  expect_mistakes_to_fail(
      "n3_opacity",
      {{"the opacity inverted", {"n3-sheets", "n3-leaves", "n3-lamp"}, inverted},
       {"no opacity", {"n3-sheets", "n3-mask", "n3-leaves"}, none},
       {"each pass counted twice, as through a closed box", {"n3-sheets", "n3-leaves", "n3-lamp"}, twice},
       {"a mask that is decoded as colours",
        {"n3-mask"},
        [](scene::Scene& scene) { texture_in(scene).encoding = scene::Encoding::Srgb; }},
       {"a mask upside down",
        {"n3-mask"},
        [](scene::Scene& scene) {
          for_each_opacity(scene, [](scene::SurfaceDetail& detail) {
            detail.opacity_texture->matrix = translation({0, 1, 0}) * scaling({1, -1, 1});
          });
        }},
       {"remap lists that keep the opacity", {"n3-sheets"}, [](scene::Scene& scene) {
          for (auto& material : scene.materials)
            if (material.name != "floor") material.detail.opacity = 0.3;
        }}});
}

TEST(TextureCases, BumpMaps) {
  const std::set<std::string> all{"n2-ramp", "n2-scaled", "n2-ridges"};
  const auto heights = [](double factor) {
    return [factor](scene::Scene& scene) {
      for (auto& material : scene.materials) material.detail.bump_map->height_m *= factor;
    };
  };
  // As where a matrix makes heights larger, too.
  const auto higher = [](const char* name, double factor) {
    return [=](scene::Scene& scene) {
      auto material = scene.materials.front();
      material.detail.bump_map->height_m *= factor;
      scene.materials.push_back(material);
      for (auto& instance : scene.instances)
        if (instance.name == name) instance.remap = {{0, static_cast<int>(scene.materials.size()) - 1}};
    };
  };
  expect_mistakes_to_fail(
      "n2_bump_map",
      {{"heights inverted", all, heights(-1)},
       {"no heights", all, [](scene::Scene& scene) { scene.materials[0].detail = {}; }},
       {"heights half as high, as a normal that is mixed with the surface's", all, heights(0.5)},
       {"heights that are decoded as colours",
        {"n2-ramp", "n2-scaled"},
        [](scene::Scene& scene) { texture_in(scene).encoding = scene::Encoding::Srgb; }},
       {"heights that a matrix enlarges", {"n2-scaled"}, higher("larger", 2)},
       {"heights that a matrix stretches", {"n2-scaled"}, higher("thick", 3), registry::FullSize},
       {"slopes without the texture matrix",
        {"n2-scaled"},
        [](scene::Scene& scene) { scene.materials[1].detail.bump_map->texture.matrix = {}; }},
       {"u and v swapped", all, [](scene::Scene& scene) {
          for (auto& mesh : scene.meshes)
            for (auto& uv : mesh.uvs) std::swap(uv.x, uv.y);
        }}});
}

namespace {

// Of all textures of the scene.
void for_each_use(scene::Scene& scene, const std::function<void(scene::TextureUse&)>& change) {
  for (auto& material : scene.materials) {
    std::visit(
        [&](auto& model) {
          if constexpr (requires { model.texture; })
            if (model.texture) change(*model.texture);
        },
        material.model);
    if (material.detail.normal_map) change(material.detail.normal_map->texture);
  }
}

}  // namespace

TEST(TextureCases, SecondCoordinates) {
  const std::set<std::string> all{"n6-second", "n6-both", "n6-glow", "n6-normals"};
  const auto sets = [](const std::function<int(int)>& change) {
    return [=](scene::Scene& scene) {
      for_each_use(scene, [&](scene::TextureUse& use) { use.uv_set = change(use.uv_set); });
    };
  };
  expect_mistakes_to_fail("n6_second_coordinates",
                          {{"the first coordinates alone", all, sets([](int) { return 0; })},
                           {"the second coordinates alone", {"n6-both"}, sets([](int) { return 1; })},
                           {"the sets swapped", all, sets([](int set) { return 1 - set; })},
                           {"no texture matrix", {"n6-glow"}, [](scene::Scene& scene) {
                              for_each_use(scene, [](scene::TextureUse& use) { use.matrix = {}; });
                            }}});
}

TEST(TextureCases, NormalMaps) {
  const auto strength = [](double factor) {
    return [factor](scene::Scene& scene) { scene.materials[0].detail.normal_map->strength *= factor; };
  };
  // Coordinates that run the other way along v make a map with y flipped where v is not looked at.
  const auto flipped = [](scene::Scene& scene) {
    for (auto& mesh : scene.meshes)
      for (auto& uv : mesh.uvs) uv.y = 1 - uv.y;
  };
  expect_mistakes_to_fail(
      "n1_normal_map",
      {{"y flipped", {"n1-right", "n1-above", "n1-below"}, flipped},
       {"no map",
        {"n1-right", "n1-above", "n1-below"},
        [](scene::Scene& scene) { scene.materials[0].detail = {}; }},
       {"a map that is decoded as colours",
        {"n1-right", "n1-above", "n1-below"},
        [](scene::Scene& scene) { texture_in(scene).encoding = scene::Encoding::Srgb; }},
       {"half the strength", {"n1-right", "n1-above", "n1-below"}, strength(0.5)},
       {"a mirrored instance that shows the map as it is", {"n1-right"}, [](scene::Scene& scene) {
          scene.instances.back().matrix = scene.instances.back().matrix * scaling({-1, 1, 1});
        }}});
}
