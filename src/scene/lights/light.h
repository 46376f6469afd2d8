#pragma once

#include "base/matrix.h"
#include "scene/colour.h"
#include "scene/lights/directional.h"
#include "scene/lights/disk.h"
#include "scene/lights/ies.h"
#include "scene/lights/point.h"
#include "scene/lights/rect.h"
#include "scene/lights/sphere.h"
#include "scene/lights/spot.h"

#include <optional>
#include <string>
#include <variant>

namespace orbs::scene {

struct DataFolders;
struct SpectralData;

/// Variants of kinds of lights only, see LightType.
template <LightType... Types>
using LightVariant = std::variant<Types...>;

/// All kinds, in the order in which messages list them.
using LightShape = LightVariant<RectShape, DiskShape, SphereShape, PointShape, SpotShape, DirectionalShape>;

/// A shape that emits the same radiance everywhere and in all directions, or by an IES profile; or what
/// shines without an area.
struct Light {
  std::string name;
  LightShape shape;
  RgbColour radiance;  // of a shape without an area: its intensity or irradiance (kEmission)
  Mat4 matrix;         // moves, turns and scales the shape; radiance stays
  std::optional<IesUse> ies;
  std::optional<SpectrumUse> spectrum = {};
  RgbColour reflectance = {};  // Lambertian, of the side that shines
  bool operator==(const Light&) const = default;
};

/// The word of the scene file for the shape: "rect".
const char* type_name(const LightShape& shape);

/// False for a point or a direction: no ray meets it.
bool has_area(const LightShape& shape);

/// The power of the scale of the world that what it emits goes with (kPowerOfScale).
int power_of_scale(const LightShape& shape);

/// Half the size of the box about the light's origin that holds the shape, along its own axes.
Vec3d half_size(const LightShape& shape);

/// One entry of "lights". InputError at the key that is wrong.
Light load_light(json::ObjectReader& in, const DataFolders& folders, const SpectralData& spectra);

/// Writes a light as load_light reads it.
void write_light(json::Writer& out, const SpectrumList& spectra, const Light& light);

/// A light with a translation alone that looks the same; nothing when there is none.
std::optional<Light> without_matrix(const Light& light);

}  // namespace orbs::scene
