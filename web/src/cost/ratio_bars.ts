import { meanRatio, type MeanRatio } from "./ranking";
import type { CostStudy } from "../data/generated";

/** A renderer and how many times as long as the base it takes to one quality. */
export interface RatioRow {
  renderer: number;
  name: string;
  /** Undefined if it cannot be compared with the base there. */
  ratio: MeanRatio | undefined;
}

/** The renderers at one level, the fastest first; what cannot be compared comes last. */
export function ratioRows(
  study: CostStudy,
  base: number,
  metric: string,
  level: number,
): RatioRow[] {
  const one = { value: 1, low: 1, high: 1, count: study.targets.length };
  return study.renderers
    .map(({ name }, renderer) => ({
      renderer,
      name,
      ratio: renderer === base ? one : meanRatio(study, base, renderer, metric, level),
    }))
    .sort((a, b) => (a.ratio?.value ?? Infinity) - (b.ratio?.value ?? Infinity));
}

export interface RatioScale {
  /** Position of a ratio, 0 to 1. */
  at: (ratio: number) => number;
  ticks: number[];
}

const kTicks = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];

/** A logarithmic scale that holds all intervals and 1, from tick to tick. */
export function ratioScale(rows: RatioRow[]): RatioScale {
  const ends = rows.flatMap(({ ratio }) => (ratio ? [ratio.low, ratio.high] : []));
  const [least, most] = [Math.min(1, ...ends), Math.max(1, ...ends)];
  const low = kTicks.filter((tick) => tick <= least).at(-1) ?? least;
  const found = kTicks.find((tick) => tick >= most) ?? most;
  const high = found > low ? found : low * 2;
  return {
    at: (ratio) => Math.log(ratio / low) / Math.log(high / low),
    ticks: kTicks.filter((tick) => tick >= low && tick <= high),
  };
}

/** The level at which most renderers can be compared with the base, the highest quality of equal ones. */
export function fullestLevel(
  study: CostStudy,
  base: number,
  metric: string,
  levels: number[],
): number | undefined {
  const counts = levels.map(
    (level) => ratioRows(study, base, metric, level).filter(({ ratio }) => ratio).length,
  );
  return levels[counts.lastIndexOf(Math.max(...counts))];
}
