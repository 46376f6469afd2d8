#include "scene/lights/light.h"

#include "base/files.h"
#include "scene/lights/placement.h"
#include "scene/load/kind.h"
#include "scene/load/spectra.h"

namespace orbs::scene {

namespace {

IesUse load_ies_use(json::ObjectReader in, const DataFolders& folders) {
  IesUse use;
  use.file = existing_file(in, "file", folders);
  use.profile = std::make_shared<const IesProfile>(
      with_note("loading the profile that " + in.place("file") + " names",
                [&] { return parse_ies(use.file.string(), read_file(use.file)); }));
  use.matrix = load_matrix(in, "matrix");
  use.point_area = in.boolean_or("point_area", false);
  in.finish();
  return use;
}

void write_ies_use(json::Writer& out, const IesUse& use) {
  out.key("ies").begin_object();
  out.member("file", use.file.string()).member("point_area", use.point_area);
  out.key("matrix").numbers(use.matrix.m).end_object();
}

const char* emission_key(const LightShape& shape) {
  return std::visit([](const auto& s) { return s.kEmission; }, shape);
}

bool takes_profile(const LightShape& shape) {
  return std::visit(
      [](const auto& s) {
        return requires { s.kProfileRequirement; };
      },
      shape);
}

}  // namespace

const char* type_name(const LightShape& shape) {
  return std::visit([](const auto& s) { return s.kType; }, shape);
}

bool has_area(const LightShape& shape) {
  return std::visit([](const auto& s) { return s.kHasArea; }, shape);
}

int power_of_scale(const LightShape& shape) {
  return std::visit([](const auto& s) { return s.kPowerOfScale; }, shape);
}

Vec3d half_size(const LightShape& shape) {
  return std::visit([](const auto& s) { return half_size(s); }, shape);
}

Light load_light(json::ObjectReader& in, const DataFolders& folders, const SpectralData& spectra) {
  Light light;
  light.name = in.text_or("name", "");
  light.shape = load_kind<LightShape>(in, in);
  const auto radiance = load_radiance(in, emission_key(light.shape), spectra);
  light.radiance = radiance.rgb;
  light.spectrum = radiance.spectrum;
  if (has_area(light.shape)) light.reflectance = in.vec3_or("reflectance", {}, {0.0, 1.0});
  light.matrix = load_matrix(in, "matrix");
  refuse_motion(in, "lights");
  std::visit([&](const auto& shape) { check_placed(in, shape, light.matrix); }, light.shape);
  if (takes_profile(light.shape) && in.has("ies")) light.ies = load_ies_use(in.object("ies"), folders);
  in.finish();
  return light;
}

void write_light(json::Writer& out, const SpectrumList& spectra, const Light& light) {
  out.begin_object().member("name", light.name).member("type", type_name(light.shape));
  std::visit([&](const auto& shape) { write(out, shape); }, light.shape);
  write_colour(out, spectra, emission_key(light.shape), light.radiance, light.spectrum);
  if (light.reflectance != RgbColour{}) out.member("reflectance", light.reflectance);
  out.key("matrix").numbers(light.matrix.m);
  if (light.ies) write_ies_use(out, *light.ies);
  out.end_object();
}

std::optional<Light> without_matrix(const Light& light) {
  if (is_translation(light.matrix)) return light;
  // The profile rotates and scales with the frame of the light; only a uniform scale leaves it unchanged.
  const bool only_scaled = light.matrix(0, 0) > 0 && light.matrix(1, 1) > 0 && light.matrix(2, 2) > 0 &&
                           light.matrix(0, 1) == 0 && light.matrix(0, 2) == 0 && light.matrix(1, 2) == 0 &&
                           uniform_scale(light.matrix);
  if (light.ies && !only_scaled) return std::nullopt;
  const auto shape = std::visit(
      [&](const auto& s) -> std::optional<LightShape> { return absorbed(s, light.matrix); }, light.shape);
  if (!shape) return std::nullopt;
  Light moved = light;
  moved.shape = *shape;
  moved.matrix = translation({light.matrix(0, 3), light.matrix(1, 3), light.matrix(2, 3)});
  return moved;
}

}  // namespace orbs::scene
