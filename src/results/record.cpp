#include "results/record.h"

#include <algorithm>

namespace orbs::results {

int exit_status(const RunRecord& run) {
  const bool failed = std::any_of(run.pictures.begin(), run.pictures.end(), [](const PictureRecord& picture) {
    return picture.declared && counts_as_failure(picture.verdict);
  });
  return failed ? 1 : 0;
}

}  // namespace orbs::results
