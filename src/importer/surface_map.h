#pragma once

#include "base/matrix.h"
#include "image/image.h"
#include "importer/import.h"

#include <array>
#include <optional>

namespace orbs::importer {

/// The texture of metal (its blue) and roughness (its green) of a material. The scene format has numbers
/// alone: a triangle gets the mean over it, in steps.
class SurfaceMap {
 public:
  /// Nothing if the material has no such texture, or none that is read.
  static std::optional<SurfaceMap> of(Import& import, int index);

  /// The set of coordinates that it uses.
  int coordinates() const { return coordinates_; }
  /// Over a triangle with these coordinates.
  Shown shown(const std::array<Vec2f, 3>& corners, scene::RgbColour tint) const;

 private:
  image::Image picture_;
  std::array<std::size_t, 3> channels_{};
  Mat4 matrix_;
  scene::Texture sampled_;  // how it goes on beyond its edges
  int coordinates_ = 0;
  bool is_even_ = false;
};

}  // namespace orbs::importer
