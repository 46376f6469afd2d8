#pragma once

#include "faults/fault.h"
#include "image/image.h"
#include "metrics/mask.h"

#include <functional>
#include <map>
#include <optional>
#include <string>

/// The usual faults of renderers as images: what the reference looks like with each of them.
namespace orbs::judge {

/// The reference with one fault. Faults of one kind are told apart by their error only; those of two kinds
/// are two explanations.
struct CandidateFault {
  faults::Fault fault;
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
