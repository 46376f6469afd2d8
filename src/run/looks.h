#pragma once

#include "judge/judge.h"
#include "registry/renderer.h"
#include "results/record.h"
#include "run/pace.h"
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

/// The samples of the first look, both renders together, a power of two: 16, and twice what one render of the
/// renderer has at least. 0 where all samples are rendered at once: the run wants it so, the renderer has no
/// noise or none that more seeds lower, its command takes no samples or no seed, or the images are rendered
/// elsewhere.
int first_look_spp(const Plan& plan, const registry::Renderer& renderer);

/// The most samples that looks give a job where no time is set: 4096, or in small images what makes 2^28
/// paths of the whole image. The mean over an image needs the same number of paths at any size, and paths say
/// the same on any machine, which a clock does not.
int most_spp(const Plan& plan, const PlannedJob& job);

/// The samples, as a power of two, before which a plain number that has no interval is no miss: the nearest
/// to those of the case.
int first_guess_spp(const PlannedJob& job);

/// All samples after the next look, of `spp` that are there after so many looks: as many times as many as its
/// open targets need at best, as a power of two from 2 to 16, and as many as let the looks that are left
/// reach most_spp. Each look has its price, as a renderer starts twice and the image is judged. From 512
/// samples on, half as many again come first where they are likely to decide it, and then what is left to the
/// next power of two, so that no more samples are rendered than by doubling. A renderer whose seeds count
/// images (registry::ImageSequence) doubles its samples.
int samples_after_next(const Plan& plan, const PlannedJob& job, int looks, int spp, const judge::Need& need);

/// The look after so many, from `before` to `after` samples in all. Its seeds are below 2049, far from those
/// of references, no two of one job are equal, and all jobs of a run have the same, so that the difference of
/// two scenes loses their common noise. Where seeds count the images of a run, its renders are the third and
/// the fourth image of one: a look has as many samples as all before, half of them in each render, so the
/// first two images hold the random numbers of all looks before. The first look takes these two. The seed of
/// the run shifts all by four.
PlannedLook next_look(const Plan& plan, const PlannedJob& job, int looks, int before, int after);

/// The first look of a job.
PlannedLook first_look(const Plan& plan, const PlannedJob& job);

/// Why a job gets no more samples: JobSampling::end, and the text for a target that is left undecided.
struct End {
  std::string name;  // "" : it gets more
  std::string text;
};

/// How far a job, or the jobs of a group, have come.
struct LooksSoFar {
  int looks = 0;
  int spp = 0;
  int most_spp = 0;
  double seconds = 0;  // that their renders took, all looks together
  Pace pace = {};
  double budget_seconds = 0;  // that the user has set, for the samples that a run gives by itself; 0: none
};

/// What is to be done after a look.
End end_after(const judge::Look& look, const LooksSoFar& so_far);

/// The end of what a run's budget stops.
End end_by_budget(const judge::Look& look, const LooksSoFar& so_far);

/// About how long it takes to decide it, seconds.
double seconds_to_decide(const judge::Look& look, const LooksSoFar& so_far);

/// As the target's record has it.
results::LookRecord look_record(const judge::Look& look, results::Verdict verdict, int spp);

}  // namespace orbs::run
