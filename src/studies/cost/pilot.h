#pragma once

#include "studies/cost/render.h"

namespace orbs::studies {

/// Renders a pilot of every scene by every renderer that renders it, and chooses the rungs of their ladders
/// for a study of `budget_seconds` of wall clock, the pilots included, unless the request gives them. A
/// renderer that fails on a scene gets a ladder without rungs, with the reason in its note. False when the
/// user interrupts.
bool choose_rungs(CostStudy& study, double budget_seconds);

}  // namespace orbs::studies
