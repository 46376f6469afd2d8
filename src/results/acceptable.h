#pragma once

#include "results/verdict.h"

namespace orbs::results {

/// Whether an entry of the configuration can expect the verdict. A run that ended early and a reference that
/// is missing say nothing of the renderer. Remarks can be known where a strict run is to accept them.
inline bool can_be_expected(Verdict verdict) {
  return verdict == Verdict::PassWithRemarks ||
         (counts_as_failure(verdict) && verdict != Verdict::Skipped && verdict != Verdict::MissingReference);
}

}  // namespace orbs::results
