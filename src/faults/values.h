#pragma once

#include "image/image.h"

#include <optional>
#include <string>

/// Faults that change each value by itself. The variance follows by the slope of the change (delta method),
/// as a renderer with this fault would state it.
namespace orbs::faults {

/// All light times a number.
struct Factor {
  double by = 1;
  image::Image apply(const image::Image& image) const;
  image::Image undo(const image::Image& image) const;
  std::string text() const;
};

/// A constant added to all values.
struct Offset {
  double by = 0;
  image::Image apply(const image::Image& image) const;
  image::Image undo(const image::Image& image) const;
  std::string text() const;
};

/// A display curve applied once too often, or removed from linear values.
struct Curve {
  enum class Kind { SrgbEncoded, SrgbDecoded, Gamma22Encoded, Gamma22Decoded, SrgbEncodedAndClamped };
  Kind kind = Kind::SrgbEncoded;
  image::Image apply(const image::Image& image) const;
  std::optional<image::Image> undo(const image::Image& image) const;  // nothing where values are lost
  std::string text() const;
};

/// Highlights cut off.
struct Clamp {
  float at = 1;
  image::Image apply(const image::Image& image) const;
  std::string text() const;
};

/// Values farther from a middle one, or nearer to it.
struct Contrast {
  double middle = 0;
  double by = 1;
  image::Image apply(const image::Image& image) const;
};

/// A power of each value that leaves a middle one as it is.
struct Power {
  double middle = 1;
  double exponent = 1;
  image::Image apply(const image::Image& image) const;
};

/// Values in steps: those in [0, 1] rounded as an sRGB image holds them, or all of them cut, linearly.
struct Steps {
  enum class Kind { RoundedAsSrgb, Cut };
  int levels = 255;
  Kind kind = Kind::RoundedAsSrgb;
  image::Image apply(const image::Image& image) const;
};

/// The mean of the image all over.
struct Constant {
  image::Image apply(const image::Image& image) const;
};

/// One NaN in the middle.
struct InvalidPixel {
  image::Image apply(const image::Image& image) const;
};

}  // namespace orbs::faults
