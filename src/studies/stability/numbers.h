#pragma once

#include "studies/stability/record.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace orbs::studies {

/// How far one renderer follows one relation, over all scenes.
struct StabilityCell {
  std::size_t relation = 0;
  std::size_t renderer = 0;
  int scenes = 0;                          // on which it was measured
  std::optional<double> held_to;           // of a ladder: the magnitude up to which it held on all of them
  std::optional<double> decades;           // of a ladder: |log10| of that; 0 if the first step broke
  std::optional<std::size_t> first_break;  // index of the step; the easiest one that broke
  bool is_bit_equal = false;               // of all steps
  int inconclusive = 0;                    // scenes whose noise hides what happens
};

/// One cell for each relation and renderer, by relation and then by renderer.
std::vector<StabilityCell> stability_cells(const StabilityRecord& record);

}  // namespace orbs::studies
