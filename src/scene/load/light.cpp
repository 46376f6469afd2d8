#include "scene/load/light.h"

#include "base/files.h"
#include "scene/lights/ies.h"

namespace orbs::scene {

namespace {

LightShape load_shape(json::ObjectReader& in) {
  const std::string type = in.one_of("type", {"rect", "disk", "sphere"});
  if (type == "rect") return RectShape{in.number("half_width", kLength), in.number("half_length", kLength)};
  if (type == "disk") return DiskShape{in.number("radius", kLength)};
  return SphereShape{in.number("radius", kLength)};
}

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

}  // namespace

Light load_light(json::ObjectReader in, const DataFolders& folders, const SpectralData& spectra) {
  Light light;
  light.name = in.text_or("name", "");
  light.shape = load_shape(in);
  const auto radiance = load_radiance(in, "radiance", spectra);
  light.radiance = radiance.rgb;
  light.spectrum = radiance.spectrum;
  light.reflectance = in.vec3_or("reflectance", {}, {0.0, 1.0});
  light.matrix = load_matrix(in, "matrix");
  if (const auto* sphere = std::get_if<SphereShape>(&light.shape)) {
    const double r = sphere->radius_m;
    if (!inverse(light.matrix * scaling({r, r, r})))
      in.fail("radius", "times the matrix is too small a sphere");
  }
  if (in.has("ies")) light.ies = load_ies_use(in.object("ies"), folders);
  in.finish();
  return light;
}

}  // namespace orbs::scene
