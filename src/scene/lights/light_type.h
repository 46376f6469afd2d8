#pragma once

#include "base/matrix.h"
#include "base/vec.h"

#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace orbs::json {
class ObjectReader;
class Writer;
}  // namespace orbs::json

/// A kind of light is the shape that shines: a struct with the constants below and the free functions of
/// LightType beside it. All of it is one header and one source file of this folder and a line in the
/// variant LightShape; how the built-in tracer samples it is a file of tracer/light. A function that is
/// missing is a compile error. A flat shape lies in the local XZ plane and emits towards local -Y only; its
/// back is black, opaque and visible.
namespace orbs::scene {

/// Where a ray meets a light, in lengths of its direction.
struct LightHit {
  double distance = std::numeric_limits<double>::infinity();
  bool is_front = true;  // the side that shines
};

///   kType          its word in the scene file
///   kRequirement   the level that draws it; kProfileRequirement: with an IES profile, if it can have one
///   kWhat          follows "is" in messages
///   kEmission      the key of what it emits: "radiance", "intensity" in W/sr, "irradiance" in W/m^2
///   kHasArea       false for a point or a direction (without_area.h)
///   kPowerOfScale  the image stays the same if the world is scaled by s and what it emits by s to this power
///
/// load, write: the members of the shape; InputError at the key that is wrong.
/// check_placed: InputError at the key of a size that no renderer can hold under the light's matrix.
/// half_size: of the box about the origin that holds the shape, along its own axes.
/// cross_section_m2: area of what is seen of the shape against local -Y.
/// absorbed: the shape that looks the same when nothing but the translation of the matrix places it.
/// beyond_levels: why no level of ORB.S has the shape under that matrix, "" where one has it.
/// hit: by a ray in the shape's frame, on either side.
template <typename Shape>
concept LightType = requires(json::ObjectReader& in,
                             json::Writer& out,
                             const Mat4& matrix,
                             Shape& loaded,
                             const Shape& shape,
                             Vec3d ray) {
  { Shape::kType } -> std::convertible_to<std::string_view>;
  { Shape::kRequirement } -> std::convertible_to<std::string_view>;
  { Shape::kWhat } -> std::convertible_to<std::string_view>;
  { Shape::kEmission } -> std::convertible_to<std::string_view>;
  { Shape::kHasArea } -> std::convertible_to<bool>;
  { Shape::kPowerOfScale } -> std::convertible_to<int>;
  { load(in, loaded) } -> std::same_as<void>;
  { write(out, shape) } -> std::same_as<void>;
  { check_placed(in, shape, matrix) } -> std::same_as<void>;
  { half_size(shape) } -> std::same_as<Vec3d>;
  { cross_section_m2(shape) } -> std::same_as<double>;
  { absorbed(shape, matrix) } -> std::same_as<std::optional<Shape>>;
  { beyond_levels(shape, matrix) } -> std::same_as<std::string>;
  { hit(shape, ray, ray) } -> std::same_as<LightHit>;
};

}  // namespace orbs::scene
