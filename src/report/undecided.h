#pragma once

#include <optional>
#include <string>
#include <vector>

namespace orbs::report {

/// Why a target in looks is not decided, of the text of its reason, see run/looks.h.
struct Undecided {
  std::string cause;            // "its noise"
  std::optional<double> times;  // the samples that would decide it, over those that it has
};

/// Nothing for a reason of another kind.
std::optional<Undecided> undecided_of(const std::string& reason);

/// Of several targets with the same cause: "14 undecided: its noise; 2 times the samples would decide 3 of
/// them, 4 times 8, 16 times 12".
std::string undecided_text(const std::vector<Undecided>& targets);

}  // namespace orbs::report
