import type { Overview } from "../data/generated";
import type { Change } from "./changes";

const machineOf = (overview: Overview, cell: number): string =>
  overview.machines[overview.cells.machine[cell] ?? -1] ?? "";

/** The ratio of two times of one kind of machine, or the two kinds that they were measured on. */
export type Times = { ratio: number } | { machines: [string, string] };

/** Whether the render left an image: the time of one that was killed or failed says nothing. */
const hasImage = (overview: Overview, cell: number): boolean =>
  (overview.cells.thumbnail[cell] ?? 0) > 0 ||
  Object.values(overview.measures).some((column) => (column[cell] ?? null) !== null);

/** Wall-clock time, after divided by before; undefined if one of them has no image. */
export function timesOf(
  a: Overview,
  before: number,
  b: Overview,
  after: number,
): Times | undefined {
  const [old, now] = [a.cells.wall_seconds[before] ?? null, b.cells.wall_seconds[after] ?? null];
  if (old === null || now === null || old <= 0 || now <= 0) return undefined;
  if (!hasImage(a, before) || !hasImage(b, after)) return undefined;
  const machines: [string, string] = [machineOf(a, before), machineOf(b, after)];
  return machines[0] !== "" && machines[0] === machines[1] ? { ratio: now / old } : { machines };
}

export interface TimeSummary {
  /** Geometric mean over the targets: twice as fast and half as fast cancel. */
  ratio: number;
  targets: number;
  /** Number of targets timed on different machines, and the machines of the first of them. */
  apart: number;
  machines?: [string, string];
}

export function timeSummary(a: Overview, b: Overview, changes: Change[]): TimeSummary {
  const summary: TimeSummary = { ratio: 1, targets: 0, apart: 0 };
  let logs = 0;
  const counted = new Set<string>(); // a scene that serves several requirements was rendered once
  for (const { before, after, names } of changes) {
    const key = `${names.target}\n${names.renderer}`;
    if (counted.has(key)) continue;
    counted.add(key);
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
