// Studies of earlier versions of orbs, whose files lack members that this page shows.
import type { CostStudy, Interval } from "../data/generated";

/** What earlier versions wrote: one scene, on which the first renderer was rendered again. */
interface OlderSelf {
  target?: number;
  pairs?: number;
  time_ratio: Interval;
  error_ratio: Interval;
}

/** True if it compares renderers and states no mean ratios: only an earlier version wrote such a study. */
export const lacksMeans = (study: CostStudy): boolean =>
  study.mean_ratios.length === 0 && study.comparisons.some(({ time_ratio }) => time_ratio);

function completedSelf(self: CostStudy["self_comparison"]): CostStudy["self_comparison"] {
  if (!self || (self.scenes as unknown)) return self;
  const { target = 0, pairs = 0, time_ratio, error_ratio } = self as unknown as OlderSelf;
  return { ...self, scenes: [{ target, pairs, time_ratio, error_ratio }] };
}

/** The study with all members that the page reads. None of its numbers is computed here. */
export function completed(study: CostStudy): CostStudy {
  const older: Partial<CostStudy> = study;
  const renders = study.renders?.length ?? 0;
  return {
    ...study,
    mean_ratios: older.mean_ratios ?? [],
    other_load: older.other_load ?? {
      renders,
      repeats: 0,
      left_out: 0,
      marked: 0,
      unknown: renders,
    },
    self_comparison: completedSelf(study.self_comparison),
  };
}
