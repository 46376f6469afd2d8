#pragma once

#include "image/image.h"
#include "metrics/mask.h"

#include <functional>
#include <map>
#include <optional>
#include <string>

/// The usual faults of renderers as images: what the reference looks like with each of them.
namespace orbs::judge {

/// Faults of one kind differ by a number alone, or look alike: they are told apart by their error only.
/// Faults of two kinds are two explanations.
enum class FaultKind {
  Shift,        // by whole or half pixels
  Orientation,  // mirrored or turned
  Channels,     // swapped
  Factor,       // all light times a number
  Offset,       // a constant added to all pixels
  Gamma,        // a display curve applied once too often, or removed from linear values
  Clamp,        // highlights cut off
  Blur,         // by a filter wider than a pixel
  Resolution,   // rendered with fewer pixels, scaled up
  Scale,        // magnified about the centre: another field of view
  Crop,         // black outside a rectangle
  Alpha,        // multiplied or divided by its alpha
  LightPaths,   // classes of light paths missing, where the reference holds them as layers
  OtherTarget,  // the image of another target of the case, as of another trace depth
};

/// The reference with one fault.
struct CandidateFault {
  FaultKind kind;
  std::string text;   // what the result then is: "shifted by (2, 1) px"
  image::Image like;  // R, G, B
  /// The pixels that the fault leaves known: a shifted image shows what the reference does not hold.
  Rectangle known;
  /// The fault averages neighbouring pixels, so the noise of the result is correlated over some pixels.
  bool averages_noise = false;
  /// The result with the fault undone, where that can be; it is then compared with the reference.
  std::optional<image::Image> undone = std::nullopt;
};

struct FaultSubject {
  const image::Image& result;                                // R, G, B, and perhaps A
  const image::Image& reference;                             // R, G, B, and perhaps layers of path classes
  const std::map<std::string, image::Image>& other_targets;  // references of the case's other targets
  const metrics::Mask& mask;
};

/// Calls visit for each fault that the reference may have, with its numbers (shift, factor, clamp) read off
/// the result. Both images have R, G, B without NaN or infinite values and the same size.
void for_each_candidate(const FaultSubject& subject, const std::function<void(CandidateFault&&)>& visit);

}  // namespace orbs::judge
