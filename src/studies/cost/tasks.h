#pragma once

#include "studies/cost/record.h"

#include <cstddef>
#include <vector>

namespace orbs::studies {

/// A render to be made.
struct CostTask {
  CostRender render;  // without what is measured
  std::size_t ladder = 0;
  std::size_t rung = 0;
  bool is_first = false;  // its image is kept
};

/// One seed of every rung of every ladder, of each fixed cost, and of the rung of the comparison of the first
/// renderer with itself; shuffled by the study's seed and the round, so that drift of the machine hits all
/// alike.
std::vector<CostTask> tasks_of_round(const CostRecord& record, int round);

/// Whether the record has this render already.
bool is_done(const CostRecord& record, const CostRender& wanted);

}  // namespace orbs::studies
