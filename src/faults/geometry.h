#pragma once

#include "base/rectangle.h"
#include "image/image.h"

#include <string>

/// Faults that show the right values in the wrong places. Beyond its edge an image continues as its edge
/// pixels. All channels are moved, the variances as well: what a camera elsewhere renders has noise like that
/// of its neighbours.
namespace orbs::faults {

/// How values between pixels are made: of the nearest pixel, linearly, or by the cubic of Catmull and Rom
/// (1974).
enum class Between { Nearest, Linear, Cubic };

/// Moved to the right and down.
struct Shift {
  double dx_px = 0;
  double dy_px = 0;
  Between between = Between::Linear;
  image::Image apply(const image::Image& image) const;
  std::string text() const;
};

/// Mirrored or turned: x and y are exchanged first, then counted from the other side. The image of a camera
/// with x and y exchanged is square.
struct Turn {
  bool mirrors_x = false;
  bool mirrors_y = false;
  bool exchanges = false;
  image::Image apply(const image::Image& image) const;
  std::string text() const;
};

/// Magnified about the centre: another field of view.
struct Magnification {
  double by = 1;
  Between between = Between::Linear;
  image::Image apply(const image::Image& image) const;
  std::string text() const;
};

/// Turned about the centre by a small angle.
struct Rotation {
  double degrees = 0;
  image::Image apply(const image::Image& image) const;
};

/// Black beside a rectangle.
struct Crop {
  Rectangle kept;
  image::Image apply(const image::Image& image) const;
  std::string text() const;
};

}  // namespace orbs::faults
