#include "studies/cost/record.h"

#include <fmt/format.h>

namespace orbs::studies {

std::string image_file(const CostRecord& record,
                       const CostLadder& ladder,
                       std::size_t rung,
                       const char* ending) {
  return fmt::format("images/{}/{}/{}.{}", record.renderers[ladder.renderer].name,
                     record.targets[ladder.target].name, rung, ending);
}

}  // namespace orbs::studies
