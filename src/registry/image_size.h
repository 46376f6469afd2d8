#pragma once

#include <array>
#include <string>

/// The size of a run: by what the width and the height of each scene's image are divided.
namespace orbs::registry {

inline constexpr std::array kSizeDivisors{1, 2, 4, 8};

/// "1", "1/4": the share of the full width, as --size, results and messages write it.
std::string size_text(int divisor);

/// The divisor that `text` stands for. InputError for any other text than those of kSizeDivisors.
int size_divisor(const std::string& text);

}  // namespace orbs::registry
