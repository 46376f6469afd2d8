// Rough glass whose index is next to 1 bends hardly anything: a slab of it lets the view through. Its lobe is
// a few floats wide, so that light sampling and BSDF sampling must mean the same density by it.
#include "property/light_images.h"

#include <numbers>

namespace {

using namespace orbs;
using namespace orbs::tests;

struct Glass {
  double index = 1;
  double alpha = 0.1;
};

const std::vector<Glass> kGlasses{{1.0001, 1e-3}, {1.0001, 1e-2}, {1.0001, 0.1},
                                  {0.9999, 1e-2}, {1.001, 1e-3},  {1.001, 0.1}};

std::string name_of(const Glass& glass) { return fmt::format("index {} alpha {}", glass.index, glass.alpha); }

// The ORB.S material, or that by index of refraction.
std::string material(const Glass& glass, bool is_by_index) {
  return is_by_index ? fmt::format(R"({{"name": "glass", "type": "dielectric", "index": {}, "alpha": {}}})",
                                   glass.index, glass.alpha)
                     : fmt::format(R"({{"name": "glass", "type": "rough_glass", "ior": {}, "alpha": {}}})",
                                   glass.index, glass.alpha);
}

std::string slab(const std::string& y) {
  return R"("shapes": [{"type": "box", "half_sizes": [3, 0.02, 3], "material": "glass",
                        "matrix": [{"translate": [0, )" +
         y + "0]}]}]";
}

// Of a square of half the side a, for a point h below its centre: four times that of a rectangle with a
// corner above the point (Siegel and Howell, Thermal Radiation Heat Transfer).
double form_factor(double a, double h) {
  const double x = a / h;
  const double root = std::sqrt(1 + x * x);
  return 4 / std::numbers::pi * x / root * std::atan(x / root);
}

void expect_mean(const image::Image& image, double expected, const std::string& what) {
  EXPECT_NEAR(mean_of_channel(image, 0), expected, 4 * error_of_mean(image, 0) + 1e-3 * expected) << what;
}

// The part of the light that passes a surface at this angle and is not masked (Heitz 2014, eq. 72).
double masking(const Glass& glass, double cosine) {
  const double tan2 = 1 / (cosine * cosine) - 1;
  return 2 / (1 + std::sqrt(1 + glass.alpha * glass.alpha * tan2));
}

}  // namespace

// A floor under a lamp, both with and without the slab between them: rho L F. The lamp is found through two
// rough surfaces, which mask next to nothing up to this roughness; by camera paths, as light paths to the
// whole slab hardly ever meet the half a millimetre that the camera sees.
TEST(RoughGlassNextToOne, LetsTheLightOfALampThrough) {
  const View from_below_the_slab{.position = "[0.03, 0.06, 0.05]", .fov_deg = 0.5};
  for (const Glass& glass : kGlasses)
    for (const bool is_by_index : {false, true}) {
      if (glass.alpha > 0.02) continue;
      const auto text = scene_of(
          from_below_the_slab,
          R"("materials": [{"name": "floor", "type": "lambert", "reflectance": [0.5, 0.5, 0.5]}, )" +
              material(glass, is_by_index) + "], " + meshes({square({0, 0, 0}, {0, 1, 0}, 5, "floor")}) +
              ", " + slab("0.5, ") +
              R"(, "lights": [{"type": "rect", "half_width": 0.5, "half_length": 0.5, "radiance": [1, 1, 1],
                               "matrix": [{"translate": [0, 1, 0]}]}])");
      expect_mean(image_of(text, 2048, {.light_paths = false}), 0.5 * form_factor(0.5, 1), name_of(glass));
    }
}

// A lamp that is hardly wider than what the slab blurs: its light is only moved. Each technique alone finds
// as much of it as both.
TEST(RoughGlassNextToOne, KeepsTheLightOfASmallLamp) {
  const View from_above{
      .position = "[0, 4, 0]", .up = "[0, 0, -1]", .fov_deg = 0.4583662, .width = 16, .height = 16};
  // Half the image is 5 tan(fov / 2) = 0.02 m at the lamp, a metre below the slab.
  constexpr double kShare = 2e-3 * 2e-3 / (0.02 * 0.02);
  for (const Glass& glass : kGlasses)
    for (const auto direct_light : {tracer::DirectLight::Mis, tracer::DirectLight::Bsdf}) {
      const auto text = scene_of(
          from_above,
          R"("materials": [)" + material(glass, false) + "], " + slab("0, ") +
              R"(, "lights": [{"type": "rect", "half_width": 0.002, "half_length": 0.002, "radiance": [1, 1, 1],
                               "matrix": [{"translate": [0, -1, 0]}, {"rotate_x": 180}]}])");
      expect_mean(image_of(text, 512, {.direct_light = direct_light}), kShare, name_of(glass));
    }
}

// What lies behind it is as bright as without it but for what two surfaces mask, head-on and at an angle.
TEST(RoughGlassNextToOne, LetsTheViewThrough) {
  for (const Vec3d eye : {Vec3d{0.2, 4, 0.1}, Vec3d{2, 1, 0.5}})
    for (const Glass& glass : kGlasses) {
      const View view{.position = text_of(eye), .fov_deg = 0.1};
      const auto text =
          scene_of(view, R"("materials": [{"name": "glow", "type": "emission", "radiance": [1, 1, 1]}, )" +
                             material(glass, false) + "], " +
                             meshes({square({0, -1, 0}, {0, 1, 0}, 50, "glow")}) + ", " + slab("0, "));
      const double passes = masking(glass, eye.y / length(eye));
      expect_mean(image_of(text, 64), passes * passes, name_of(glass));
    }
}
