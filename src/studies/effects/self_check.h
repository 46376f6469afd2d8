#pragma once

#include "studies/effects/effect_cost.h"

namespace orbs::studies {

/// What the pages say of the study: machine, settings, what others took, and the A/A comparison.
results::EffectStudyRecord study_record(const EffectCosts& list);

}  // namespace orbs::studies
