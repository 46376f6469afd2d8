import type { Overview } from "../data/types";
import type { Change } from "./changes";

const machineOf = (overview: Overview, cell: number): string =>
  overview.machines[overview.cells.machine[cell] ?? -1] ?? "";

/** Times of one kind of machine, or the kinds that they are of. */
export type Times = { ratio: number } | { machines: [string, string] };

/** Wall clock after over before; undefined where one of them was not rendered. */
export function timesOf(
  a: Overview,
  before: number,
  b: Overview,
  after: number,
): Times | undefined {
  const [old, now] = [a.cells.wall_seconds[before] ?? null, b.cells.wall_seconds[after] ?? null];
  if (old === null || now === null || old <= 0 || now <= 0) return undefined;
  const machines: [string, string] = [machineOf(a, before), machineOf(b, after)];
  return machines[0] !== "" && machines[0] === machines[1] ? { ratio: now / old } : { machines };
}

export interface TimeSummary {
  /** Geometric mean over the images: twice as fast here and half as fast there is as before. */
  ratio: number;
  targets: number;
  /** Images whose times are of different machines, and those of the first of them. */
  apart: number;
  machines?: [string, string];
}

export function timeSummary(a: Overview, b: Overview, changes: Change[]): TimeSummary {
  const summary: TimeSummary = { ratio: 1, targets: 0, apart: 0 };
  let logs = 0;
  for (const { before, after } of changes) {
    const times = timesOf(a, before, b, after);
    if (!times) continue;
    if ("ratio" in times) {
      logs += Math.log(times.ratio);
      summary.targets += 1;
    } else {
      summary.apart += 1;
      summary.machines ??= times.machines;
    }
  }
  if (summary.targets > 0) summary.ratio = Math.exp(logs / summary.targets);
  return summary;
}
