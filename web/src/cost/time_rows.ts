import { levelsOf, mayRank, standingAt } from "./ranking";
import type { CostCurve, CostStudy, Interval, TimeToError } from "../data/generated";
import type { MaybeInterval } from "./quantities";

/** A row of the table of times: one renderer on one target. */
export interface TimeRow {
  curve: CostCurve;
  target: string;
  renderer: string;
  times: (TimeToError | undefined)[];
  /** For each level, whether this renderer is shown to be the fastest. */
  isFastest: boolean[];
  floor: MaybeInterval;
}

export function timeTable(study: CostStudy, metric: string): TimeRow[] {
  const levels = levelsOf(study, metric);
  const winners = study.targets.map((_, target) =>
    levels.map((level) => {
      const standing = mayRank(study) ? standingAt(study, target, metric, level) : undefined;
      return standing?.kind === "fastest" ? standing.renderer : -1;
    }),
  );
  return study.curves.map((curve) => ({
    curve,
    target: study.targets[curve.target]?.name ?? "",
    renderer: study.renderers[curve.renderer]?.name ?? "",
    times: levels.map((level) =>
      curve.times_to_error.find((time) => time.metric === metric && time.level === level),
    ),
    isFastest: levels.map((_, i) => winners[curve.target]?.[i] === curve.renderer),
    floor: curve.fit?.has_floor ? curve.fit.bias_squared : null,
  }));
}

export interface Sorting {
  /** "target", "renderer", "efficiency", "db", "floor", or the index of a level. */
  by: string;
  descending: boolean;
}

const valueOf = (interval: Interval | null | undefined): number | null => interval?.value ?? null;

function keyOf(row: TimeRow, by: string): string | number | null {
  if (by === "target") return row.curve.target;
  if (by === "renderer") return row.renderer;
  if (by === "efficiency") return valueOf(row.curve.efficiency);
  if (by === "db") return valueOf(row.curve.seconds_per_db);
  if (by === "floor") return valueOf(row.floor);
  return valueOf(row.times[Number(by)]?.cpu_seconds);
}

/** The rows in that order; rows without a value come last in both directions. */
export function sortedRows(rows: TimeRow[], { by, descending }: Sorting): TimeRow[] {
  const sign = descending ? -1 : 1;
  return [...rows].sort((a, b) => {
    const [x, y] = [keyOf(a, by), keyOf(b, by)];
    if (x === null || y === null) return Number(x === null) - Number(y === null);
    return sign * (x < y ? -1 : x > y ? 1 : 0);
  });
}
