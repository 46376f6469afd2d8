#pragma once

#include "image/image.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// Faults that take the colours of a pixel from the wrong channels.
namespace orbs::faults {

/// R, G and B are those of the channels `from` (0 to 2).
struct ChannelOrder {
  std::array<std::size_t, 3> from{0, 1, 2};
  image::Image apply(const image::Image& image) const;
  std::string text() const;
};

/// "R and G swapped" of the two colours that differ most in the image.
ChannelOrder most_visible_swap(const image::Image& image);

/// Each of R, G and B is a sum of all three. The variances stay.
struct ColourMatrix {
  using Rows = std::array<std::array<double, 3>, 3>;
  Rows rows{};
  image::Image apply(const image::Image& image) const;
};

/// 1: grey; below 0: more colourful.
ColourMatrix less_saturated(double share);

/// Multiplied or divided by alpha once too often. The image then holds that alpha.
struct Alpha {
  enum class Kind { Multiplied, Divided };
  std::vector<float> alpha;  // by pixel
  Kind kind = Kind::Multiplied;
  image::Image apply(const image::Image& image) const;
  std::string text() const;
};

/// Without the light of classes of paths, which the image holds as layers "path.EDL.R".
struct LightPaths {
  std::vector<std::string> missing;
  bool is_direct_left = false;  // as the only light
  image::Image apply(const image::Image& image) const;
  std::string text() const;
};

/// What shines by itself, and nothing that it lights: black where the image is not `lit`.
struct EmittersOnly {
  std::vector<std::uint8_t> lit;  // by pixel
  image::Image apply(const image::Image& image) const;
  std::string text() const;
};

/// Emitters as they are and all other light twice: light sampling and BSDF sampling both count in full.
struct NoMisWeight {
  std::vector<std::uint8_t> emitters;  // by pixel
  image::Image apply(const image::Image& image) const;
  std::string text() const;
};

/// The image of another target, as of another trace depth.
struct OtherImage {
  std::string name;
  const image::Image* other = nullptr;
  image::Image apply(const image::Image&) const { return *other; }
  std::string text() const;
};

}  // namespace orbs::faults
