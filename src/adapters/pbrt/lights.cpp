#include "adapters/pbrt/lights.h"

#include "adapters/exporter.h"
#include "adapters/kind_support.h"
#include "adapters/light_frame.h"
#include "adapters/pbrt/directives.h"

namespace orbs::adapters::pbrt {

namespace {

constexpr const char* kName = "pbrt";

struct ShapeWriter {
  const scene::Light& light;

  // A bilinear patch in world space, corners (0,0), (1,0), (0,1), (1,1). Its normal is dp/du x dp/dv; u x v
  // of the frame is the direction in which the light shines.
  std::string operator()(const scene::RectShape& rect) const {
    const LightFrame frame = light_frame(light.matrix);
    const Vec3d u = frame.u * rect.half_width_m;
    const Vec3d v = frame.v * rect.half_length_m;
    return fmt::format("  Shape \"bilinearmesh\" \"point3 P\" [{}  {}  {}  {}]\n",
                       numbers(frame.centre - u - v), numbers(frame.centre + u - v),
                       numbers(frame.centre - u + v), numbers(frame.centre + u + v));
  }
  // pbrt takes the area of disks and spheres from the radius alone, so that the transformation must not
  // scale. Disks lie in XY and face +Z.
  std::string operator()(const scene::DiskShape& disk) const {
    const LightFrame frame = light_frame(light.matrix);
    const Vec3d x = normalised(frame.u);
    return fmt::format("  {}  Shape \"disk\" \"float radius\" {}\n",
                       transform(flat_light_matrix(frame, x, cross(frame.facing, x))),
                       disk.radius_m * length(frame.u));
  }
  // lower() lets spheres through with a uniform scale only.
  std::string operator()(const scene::SphereShape& sphere) const {
    return fmt::format("  Translate {}\n  Shape \"sphere\" \"float radius\" {}\n",
                       numbers(transform_point(light.matrix, {})),
                       sphere.radius_m * length(transform_direction(light.matrix, {1, 0, 0})));
  }
};

}  // namespace

std::string light_limit(const scene::Light& light, const std::string& display_name) {
  if (auto reason = limit_of_shape<ShapeWriter>(light, display_name, kName); !reason.empty()) return reason;
  return adapters::light_limit(light, display_name, kName, "has them for points without size only");
}

std::string light_text(const Colours& colours, const scene::Light& light) {
  return fmt::format(
      "# light {}\n"
      "AttributeBegin\n"
      "  Material \"diffuse\" {}\n"
      "  AreaLightSource \"diffuse\" {}\n"
      "{}AttributeEnd\n",
      comment_text(light.name), rgb("reflectance", {}), colours.radiance(light.radiance, light.spectrum),
      text_of_shape(light, kName, ShapeWriter{light}));
}

}  // namespace orbs::adapters::pbrt
