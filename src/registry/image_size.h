#pragma once

#include "registry/case.h"

#include <array>
#include <functional>
#include <string>
#include <string_view>

/// The size of a run: by what the width and the height of each scene's image are divided.

namespace orbs::registry {

enum SizeDivisor : int { FullSize = 1, HalfSize = 2, QuarterSize = 4, EighthSize = 8 };

inline constexpr std::array kSizeDivisors{FullSize, HalfSize, QuarterSize, EighthSize};

/// "1", "1/4": the share of the full width, as --size, results and messages write it.
std::string size_text(int divisor);
inline std::string to_text(SizeDivisor divisor) { return size_text(divisor); }

/// The divisor that `text` stands for. InputError for any other text than those of kSizeDivisors.
SizeDivisor size_divisor(std::string_view text);
inline void from_text(std::string_view text, SizeDivisor& divisor) { divisor = size_divisor(text); }

/// The size of a run.
struct ReducedSize {
  int divisor = FullSize;
  int least_side_px = 1;  // of the shorter side of an image that is reduced
};

/// By what an image of this full size is divided: the largest of kSizeDivisors up to that of the run that
/// divides both sides and leaves as many pixels of the shorter one, or 1. Fewer pixels decide nothing and
/// save nothing: the mean of 64 needs as many paths as that of 4096, and 4 cannot be judged.
int divisor_of_image(int width_px, int height_px, const ReducedSize& size);

/// The case for images of targets whose width and height are divided by `divisor_of(target)`: each of their
/// pixels is the mean of so many by so many px of the full size. A masked rectangle grows to every reduced
/// pixel that it touches, because part of what these show is masked. The region of a pixel check shrinks to
/// the reduced pixels that lie in it as a whole; where there is none, the check keeps its region, and
/// not_measured says so.
Case reduced_case(Case one_case, const std::function<int(const std::string& target)>& divisor_of);

/// The same, of targets that are all divided alike.
Case reduced_case(Case one_case, int divisor);

}  // namespace orbs::registry
