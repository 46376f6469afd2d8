#include "scene/relations/light.h"

#include "scene/camera_frame.h"
#include "scene/effects/effects.h"
#include "scene/geometry/world_bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orbs::scene {

namespace {

void multiply(RgbColour& colour, std::optional<SpectrumUse>& spectrum, double factor) {
  colour *= factor;
  if (spectrum) spectrum->scale *= factor;
}

void rotate(RgbColour& colour) { colour = {colour.y, colour.z, colour.x}; }

bool is_plain_point(const Light& light) {
  return std::holds_alternative<PointShape>(light.shape) && !light.ies;
}

constexpr const char* kNoPoint = "it has no point of light without a profile";

Vec3d place_of(const Light& light) { return transform_point(light.matrix, {}); }

// Behind the camera, by a right angle or more from its axis: a perspective and a parallel one see nothing
// there, and a lens is smaller than all distances that count.
bool is_out_of_view(const Camera& camera, Vec3d place) {
  if (std::holds_alternative<LatitudeLongitude>(camera.projection) || camera.end) return false;
  const auto frame = camera_frame(camera);
  const Vec3d to = place - camera.position_m;
  const double depth = dot(to, frame.forward);
  if (depth <= 0) return true;
  const double unit = std::holds_alternative<Perspective>(camera.projection) ? depth : 1;
  constexpr double kMargin = 1.5;  // of half the image: the sphere is small and has its edge in mind
  return std::abs(dot(to, frame.right) / unit - frame.centre.x) > kMargin * frame.half_width ||
         std::abs(dot(to, frame.up) / unit - frame.centre.y) > kMargin * frame.half_height;
}

// Scatters all light over directions, so that a small lamp is never seen in it as an image of its own.
bool is_rough_and_opaque(const Material& material) {
  return !lets_rays_pass(material.detail) &&
         (std::holds_alternative<Lambert>(material.model) ||
          std::holds_alternative<OrenNayar>(material.model) || std::holds_alternative<Phong>(material.model));
}

// Why a lamp in the place of a point would be seen where the point is not; "" if it would not.
std::string why_seen(const Scene& scene, const Light& point) {
  if (!is_out_of_view(scene.camera, place_of(point)))
    return "a sphere in the place of its point could be seen in the image";
  for (const int material : visible_materials(scene))
    if (!is_rough_and_opaque(material_at(scene, material)))
      return "a sphere in the place of its point could be seen in its surfaces";
  return "";
}

Light as_sphere(const Light& point, double radius_m) {
  Light lamp = point;
  lamp.shape = SphereShape{radius_m};
  lamp.matrix = translation(place_of(point));
  multiply_emission(lamp, 1 / (std::numbers::pi * radius_m * radius_m));
  return lamp;
}

}  // namespace

void multiply_emission(Light& light, double factor) { multiply(light.radiance, light.spectrum, factor); }

Scene with_emission_times(const Scene& scene, double factor) {
  Scene out = scene;
  multiply(out.environment.radiance, out.environment.spectrum, factor);
  for (auto& light : out.lights) multiply_emission(light, factor);
  for (auto& material : out.materials)
    if (auto* emission = std::get_if<Emission>(&material.model))
      multiply(emission->radiance, emission->spectrum, factor);
  return out;
}

std::variant<Scene, std::string> with_points_as_spots(const Scene& scene) {
  Scene out = scene;
  out.lights.clear();
  for (const auto& light : scene.lights) {
    out.lights.push_back(light);
    if (!is_plain_point(light)) continue;
    out.lights.back().shape = SpotShape{90, 90};
    Light other = out.lights.back();
    other.name = light.name.empty() ? "" : light.name + " back";
    other.matrix = light.matrix * rotation_x(180);
    out.lights.push_back(std::move(other));
  }
  if (out.lights.size() == scene.lights.size()) return kNoPoint;
  return out;
}

std::variant<Scene, std::string> with_points_as_spheres(const Scene& scene, double share) {
  const auto drawn = world_bounds(scene);
  if (!drawn) return "it is empty";
  Scene out = scene;
  bool is_any = false;
  for (auto& light : out.lights) {
    if (!is_plain_point(light)) continue;
    if (auto reason = why_seen(scene, light); !reason.empty()) return reason;
    const double away = length(place_of(light) - scene.camera.position_m);
    light = as_sphere(light, share * std::fmin(away, radius_of(*drawn)));
    is_any = true;
  }
  if (!is_any) return kNoPoint;
  return out;
}

std::variant<Scene, std::string> with_rotated_channels(const Scene& scene) {
  if (!scene.spectra.empty() || transport(effects(scene)) != LightTransport::Rgb)
    return "its colours are spectra, which have no three channels to exchange";
  Scene out = scene;
  if (scene.environment.map) return "its environment is an image, whose file keeps its channels";
  rotate(out.environment.radiance);
  for (auto& light : out.lights) {
    rotate(light.radiance);
    rotate(light.reflectance);
  }
  for (auto& material : out.materials) {
    if (texture_of(material.model)) return "it has textures, whose files keep their channels";
    std::visit(
        [](auto& model) {
          if constexpr (requires { model.reflectance; }) rotate(model.reflectance);
          if constexpr (requires { model.colour; }) rotate(model.colour);
          if constexpr (requires { model.diffuse; }) rotate(model.diffuse);
          if constexpr (requires { model.radiance; }) rotate(model.radiance);
        },
        material.model);
  }
  return out;
}

}  // namespace orbs::scene
