#include "adapters/povray/clamp.h"

#include "adapters/povray/materials.h"
#include "base/error.h"
#include "base/files.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

namespace orbs::adapters::povray {

namespace {

using Polygon = std::vector<Corner>;

// This far inside the edge: more than the rounding of POV-Ray's float coordinates, and far less than a texel.
constexpr double kEdge = 1e-6;

struct Size {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
};

// PNG (ISO/IEC 15948, 11.2.2): 8 bytes signature, length and name of IHDR, then width and height, most
// significant byte first.
Size png_size(const std::filesystem::path& file) {
  const std::string bytes = read_file(file);
  if (bytes.size() < 24 || bytes.substr(12, 4) != "IHDR")
    throw InputError(fmt::format("{}: no PNG image; expected a header IHDR", file.string()));
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
  };
  return {number(16), number(20)};
}

double coordinate(const Corner& corner, std::size_t axis) { return axis == 0 ? corner.uv.x : corner.uv.y; }

Corner between(const Corner& a, const Corner& b, double t) {
  return {a.position + t * (b.position - a.position),
          a.normal + t * (b.normal - a.normal),
          {a.uv.x + t * (b.uv.x - a.uv.x), a.uv.y + t * (b.uv.y - a.uv.y)}};
}

// The part of the polygon where sign * (coordinate - bound) >= 0 (Sutherland and Hodgman 1974).
Polygon clip(const Polygon& polygon, std::size_t axis, double bound, double sign) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner& a = polygon[i];
    const Corner& b = polygon[(i + 1) % polygon.size()];
    const double side_a = sign * (coordinate(a, axis) - bound);
    const double side_b = sign * (coordinate(b, axis) - bound);
    if (side_a >= 0) result.push_back(a);
    if ((side_a > 0 && side_b < 0) || (side_a < 0 && side_b > 0))
      result.push_back(between(a, b, side_a / (side_a - side_b)));
  }
  return result;
}

bool lies_within(const Polygon& polygon, const ClampAxis& bounds, std::size_t axis) {
  return std::all_of(polygon.begin(), polygon.end(), [&](const Corner& corner) {
    return coordinate(corner, axis) >= bounds.low - kEdge && coordinate(corner, axis) <= bounds.high + kEdge;
  });
}

std::vector<Polygon> cut(const Polygon& polygon, const ClampAxis& bounds, std::size_t axis) {
  if (!bounds.active || lies_within(polygon, bounds, axis)) return {polygon};
  std::vector<Polygon> pieces{clip(polygon, axis, bounds.low, -1),
                              clip(clip(polygon, axis, bounds.low, 1), axis, bounds.high, -1),
                              clip(polygon, axis, bounds.high, 1)};
  std::erase_if(pieces, [](const Polygon& piece) { return piece.size() < 3; });
  return pieces;
}

Corner clamped(Corner corner, const std::array<ClampAxis, 2>& axes) {
  if (axes[0].active) corner.uv.x = std::clamp(corner.uv.x, axes[0].low, axes[0].high);
  if (axes[1].active) corner.uv.y = std::clamp(corner.uv.y, axes[1].low, axes[1].high);
  return corner;
}

}  // namespace

bool has_area(const std::array<Corner, 3>& t) {
  const Vec3d normal = cross(t[1].position - t[0].position, t[2].position - t[0].position);
  return dot(normal, normal) > 0;
}

std::array<ClampAxis, 2> clamp_axes(const scene::Texture& texture) {
  const bool u = texture.wrap_u == scene::Wrap::Clamp;
  const bool v = texture.wrap_v == scene::Wrap::Clamp;
  if (!u && !v) return {};
  if (u && v) return {{{true, kEdge, 1 - kEdge}, {true, kEdge, 1 - kEdge}}};
  if (image_type(texture.file) != "png")
    throw InputError(
        fmt::format("texture '{}' is clamped along one axis only, which needs the image's size: expected "
                    "a PNG, found {}",
                    texture.name, texture.file.string()));
  const Size size = png_size(texture.file);
  const double half_u = 0.5 / size.width;
  const double half_v = 0.5 / size.height;
  return {{{u, half_u, 1 - half_u}, {v, half_v, 1 - half_v}}};
}

std::vector<std::array<Corner, 3>> clamp_triangle(const std::array<Corner, 3>& triangle,
                                                  const std::array<ClampAxis, 2>& axes) {
  std::vector<std::array<Corner, 3>> result;
  for (const Polygon& strip : cut({triangle.begin(), triangle.end()}, axes[0], 0))
    for (const Polygon& piece : cut(strip, axes[1], 1))
      for (std::size_t i = 1; i + 1 < piece.size(); ++i) {
        const std::array<Corner, 3> part{clamped(piece[0], axes), clamped(piece[i], axes),
                                         clamped(piece[i + 1], axes)};
        if (has_area(part)) result.push_back(part);
      }
  return result;
}

}  // namespace orbs::adapters::povray
