// Who is fastest at which quality. Only comparisons whose ranking says so rank any renderer.
import { errorOf } from "./quantities";
import type { CostComparison, CostStudy, Interval } from "../data/generated";

/** The standing of all renderers on one target at one level. */
export type Standing =
  | { kind: "fastest"; renderer: number }
  | { kind: "only"; renderer: number }
  | { kind: "open" }
  | { kind: "unreached" };

/** True if a measured point is at least that good: its time may still lie before that of the first point. */
function reaches(
  study: CostStudy,
  target: number,
  renderer: number,
  metric: string,
  level: number,
) {
  const lowerIsBetter = study.metrics.find(({ name }) => name === metric)?.lower_is_better ?? true;
  const curve = study.curves.find((one) => one.target === target && one.renderer === renderer);
  return curve?.points.some((point) => {
    const value = errorOf(point, metric)?.value;
    return value != null && (lowerIsBetter ? value <= level : value >= level);
  });
}

/** True if the comparison shows that `renderer` is the faster of its two: the ranking is of the second. */
const showsFaster = ({ first, second, ranking }: CostComparison, renderer: number): boolean =>
  (ranking === "slower" && renderer === first) || (ranking === "faster" && renderer === second);

export function standingAt(
  study: CostStudy,
  target: number,
  metric: string,
  level: number,
): Standing {
  const reached = study.renderers
    .map((_, renderer) => renderer)
    .filter((renderer) => reaches(study, target, renderer, metric, level));
  const [only] = reached;
  if (only === undefined) return { kind: "unreached" };
  if (reached.length === 1) return { kind: "only", renderer: only };
  const own = study.comparisons.filter(
    (one) => one.target === target && one.metric === metric && one.level === level,
  );
  const between = (a: number, b: number): CostComparison | undefined =>
    own.find(({ first, second }) => (first === a && second === b) || (first === b && second === a));
  const winner = reached.find((renderer) =>
    reached.every((other) => {
      const comparison = between(renderer, other);
      return other === renderer || (comparison && showsFaster(comparison, renderer));
    }),
  );
  return winner === undefined ? { kind: "open" } : { kind: "fastest", renderer: winner };
}

export interface MeanRatio extends Interval {
  value: number;
  low: number;
  high: number;
  /** Number of targets. */
  count: number;
}

/**
 * Geometric mean over targets of the time of `other` divided by that of `base`, at one level, with the
 * interval that the study states: the same as in the terminal and in reports.
 */
export function meanRatio(
  study: CostStudy,
  base: number,
  other: number,
  metric: string,
  level: number,
): MeanRatio | undefined {
  const found = study.mean_ratios.find(
    (one) =>
      one.metric === metric &&
      one.level === level &&
      ((one.first === base && one.second === other) ||
        (one.first === other && one.second === base)),
  );
  const { value, low, high } = found?.time_ratio ?? {};
  if (!found || !value || !low || !high) return undefined;
  const count = found.scenes;
  return found.first === base
    ? { value, low, high, count }
    : { value: 1 / value, low: 1 / high, high: 1 / low, count };
}

export interface LevelAnswer {
  metric: string;
  level: number;
  targets: number;
  /** Number of targets of each renderer. */
  fastest: number[];
  only: number[];
  open: number;
  unreached: number;
  /** The renderer that is shown to be the fastest on the most targets, if there is one. */
  leader: number | undefined;
}

export function answerAt(study: CostStudy, metric: string, level: number): LevelAnswer {
  const count = (): number[] => study.renderers.map(() => 0);
  const [fastest, only] = [count(), count()];
  let [open, unreached] = [0, 0];
  study.targets.forEach((_, target) => {
    const standing = standingAt(study, target, metric, level);
    if (standing.kind === "open") ++open;
    else if (standing.kind === "unreached") ++unreached;
    else {
      const list = standing.kind === "fastest" ? fastest : only;
      list[standing.renderer] = (list[standing.renderer] ?? 0) + 1;
    }
  });
  const most = Math.max(...fastest);
  const leaders = fastest.flatMap((wins, renderer) =>
    wins === most && most > 0 ? [renderer] : [],
  );
  const leader = leaders.length === 1 ? leaders[0] : undefined;
  const targets = study.targets.length;
  return { metric, level, targets, fastest, only, open, unreached, leader };
}

/** The levels of a metric to which times are stated, the lowest quality first. */
export function levelsOf(study: CostStudy, metric: string): number[] {
  const levels = new Set(
    study.curves.flatMap(({ times_to_error }) =>
      times_to_error.filter((time) => time.metric === metric).map(({ level }) => level),
    ),
  );
  const lowerIsBetter = study.metrics.find(({ name }) => name === metric)?.lower_is_better;
  return [...levels].sort((a, b) => (lowerIsBetter ? b - a : a - b));
}

/** The metrics to which times are stated, PSNR first. */
export function metricsWithTimes(study: CostStudy): string[] {
  const metrics = new Set(
    study.curves.flatMap(({ times_to_error }) => times_to_error.map(({ metric }) => metric)),
  );
  return [...metrics].sort((a, b) => Number(b === "psnr_srgb8") - Number(a === "psnr_srgb8"));
}

/**
 * False if the same renderer under two names was not shown to be like itself, and while nothing is
 * compared yet: then nobody may be ranked.
 */
export const mayRank = ({ self_comparison: self, comparisons }: CostStudy): boolean =>
  self?.passed !== false && comparisons.length > 0;
