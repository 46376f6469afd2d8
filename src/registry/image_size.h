#pragma once

#include "registry/case.h"

#include <array>
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

/// The case for images whose width and height are divided by `divisor`: each of their pixels is the mean of
/// divisor x divisor px of the full size. A masked rectangle grows to every reduced pixel that it touches,
/// because part of what these show is masked. The region of a pixel check shrinks to the reduced pixels that
/// lie in it as a whole; where there is none, the check keeps its region, and not_measured says so.
Case reduced_case(Case one_case, int divisor);

}  // namespace orbs::registry
