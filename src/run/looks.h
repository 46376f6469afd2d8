#pragma once

#include "judge/judge.h"
#include "registry/renderer.h"
#include "results/record.h"
#include "run/plan/plan.h"

#include <string>

/// Sequential verdicts: a job is rendered in looks until its targets are decided. Each look renders as many
/// samples as are there, in two renders with seeds of their own, and is judged together with all before.
/// docs/understand/verdicts.md says why and derives the error rates.
namespace orbs::run {

/// How many looks the error rates hold for. It is fixed before the first, whatever the budget: 12 in place of
/// 6 cost 8 % of samples.
constexpr int kMostLooks = 12;

/// The file beside the image of such a job that holds the halves of its samples.
inline constexpr const char* kHalvesFile = "halves.exr";

/// The samples of the first look, both renders together, a power of two: a quarter of those of the case, at
/// least 16 and twice what one render of the renderer has at least. 0 where all samples are rendered at once:
/// the run wants it so, the renderer has no noise or none that more seeds lower, its command takes no samples
/// or no seed, or the images are rendered elsewhere.
int first_look_spp(const Plan& plan, const registry::Renderer& renderer, int spp);

/// The samples, as a power of two, before which no image passes in which noise hides errors: the nearest to
/// those of the case.
int first_guess_spp(const PlannedJob& job);

/// All samples after so many looks.
int samples_after(const PlannedJob& job, int looks);

/// The look after so many. Its seeds are below 2049, far from those of references, no two of one job are
/// equal, and all jobs of a run have the same, so that the difference of two scenes loses their common noise.
PlannedLook next_look(const PlannedJob& job, int looks, int run_seed);

/// The look of a job of the plan. Where seeds count the images of a run (registry::ImageSequence), its
/// renders are the third and the fourth image of one: a look has as many samples as all before, half of them
/// in each render, so the first two images hold the random numbers of all looks before. The first look takes
/// these two. The seed of the run shifts all by four.
PlannedLook next_look(const Plan& plan, const PlannedJob& job, int looks);

/// Seconds of rendering that one target gets at most.
double target_budget_seconds(const registry::RunSettings& settings);

/// Why a job gets no more samples: JobSampling::end, and the text for a target that is left undecided.
struct End {
  std::string name;  // "" : it gets more
  std::string text;
};

/// What is to be done after a look that took all looks together to `seconds`.
End end_after(const judge::Look& look, int looks, double seconds, double budget_seconds);

/// The end of what a run's budget stops.
End end_by_budget(const judge::Look& look, double seconds);

/// About how long it takes to decide it, seconds.
double seconds_to_decide(const judge::Look& look, double seconds);

/// As the target's record has it.
results::LookRecord look_record(const judge::Look& look, results::Verdict verdict, int spp);

}  // namespace orbs::run
