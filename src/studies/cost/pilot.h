#pragma once

#include "studies/cost/render.h"

namespace orbs::studies {

/// Renders a pilot of every scene by every renderer that renders it, and chooses the sweeps of a study of
/// `budget_seconds` of wall clock, the pilots included, unless the request gives them. A renderer that fails
/// on a scene gets a sweep without settings, with the reason in its note. False when the user interrupts.
bool find_sweeps(CostMeasurement& study, double budget_seconds);

}  // namespace orbs::studies
