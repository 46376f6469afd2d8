#pragma once

#include "studies/cost/render.h"

/// What accuracy costs in time: each renderer renders each scene of a plan with more and more samples, or
/// with one setting after the other.
namespace orbs::studies {

/// Renders in the order of cost_tasks until the budget is spent, which counts from the first pilot. One
/// render at a time; all with the same number of threads, and bound to as many cores. Writes the record, and
/// what follows from it, into the folder as it goes on. `record` holds what an interrupted study of the same
/// plan had measured: its sweeps stay, and no render is made twice. is_finished is false when the user
/// interrupts. A renderer that fails on a scene ends its sweep there, with the reason in its note. InputError
/// when a target has no reference or nothing can be rendered.
CostRecord measure_cost(const run::Plan& plan,
                        const CostRequest& request,
                        CostRecord record,
                        const StudyContext& context);

}  // namespace orbs::studies
