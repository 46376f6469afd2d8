import { isInfinite, isPreliminary, namesOf, stateOf, type CellNames } from "../common/session";
import { isOpen } from "../common/states";
import type { Overview } from "../data/generated";
import type { NumberKinds } from "./statistics";

/** "open" means not rendered, or not to its end, before or after, so that nothing can be compared. */
export type Kind = "worse" | "better" | "changed" | "open" | "new" | "gone" | "same";

export interface Change {
  kind: Kind;
  names: CellNames;
  before: number; // index of the cell, -1 for none
  after: number;
}

const valueOf = (overview: Overview, metric: string, cell: number): number | undefined =>
  isInfinite(overview, metric, cell) ? Infinity : (overview.measures[metric]?.[cell] ?? undefined);

const kRemarks = "pass with remarks";
const passes = (state: string): boolean =>
  state === "pass" || state === kRemarks || state === "unexpected pass";

// What another state means, as `orbs compare-runs` has it (src/history/verdict_change.h). Which verdict a known
// failure has is not said here. `step` is above 0 where the later verdict is the worse one.
function kindOfStates(before: string, after: string, step: number): Kind {
  if (before === after) return "same";
  if (passes(before) && after === kRemarks) return "worse";
  if (before === kRemarks && after === "pass") return "better";
  if (passes(before) && passes(after)) return "changed";
  if (after === "unsupported" || after === "missing reference") return "worse";
  if (passes(after)) return before === "inconclusive" ? "changed" : "better";
  if (after === "inconclusive")
    return before === "unsupported" || before === "known" ? "worse" : "changed";
  if (after === "known") return passes(before) || before === "inconclusive" ? "worse" : "changed";
  if (before === "known" || passes(before)) return "worse";
  return step > 0 ? "worse" : "better";
}

// Where the verdicts are the same, what a test against noise says of the numbers.
function kindOf(
  a: Overview,
  before: number,
  b: Overview,
  after: number,
  ofNumbers: NumberKinds,
): Kind {
  const [old, now] = [stateOf(a, before), stateOf(b, after)];
  if (!old || !now || isOpen(old) || isOpen(now)) return "open";
  if (isPreliminary(a, before) || isPreliminary(b, after)) return "open";
  const step = (b.cells.state[after] ?? 0) - (a.cells.state[before] ?? 0);
  const kind = kindOfStates(old.name, now.name, step);
  const { renderer, target } = namesOf(b, after);
  return kind === "same" ? ofNumbers(renderer, target) : kind;
}

function byKey(
  overview: Overview,
  renderer: string,
  asRenderer: string,
): Map<string, { cell: number; names: CellNames }> {
  const out = new Map<string, { cell: number; names: CellNames }>();
  overview.cells.case.forEach((_, cell) => {
    const names = namesOf(overview, cell);
    if (renderer && names.renderer !== renderer) return;
    out.set([names.case, names.target, asRenderer || names.renderer].join("\n"), { cell, names });
  });
  return out;
}

export interface Side {
  overview: Overview;
  /** Only this renderer; "" compares every renderer with the one of the same name. */
  renderer: string;
}

/** The change of each target from one side to the other. */
export function changesOf(a: Side, b: Side, ofNumbers: NumberKinds): Change[] {
  const common = a.renderer && b.renderer ? "both" : "";
  const before = byKey(a.overview, a.renderer, common);
  const after = byKey(b.overview, b.renderer, common);
  const changes: Change[] = [];
  for (const [key, { cell, names }] of after) {
    const old = before.get(key);
    changes.push(
      old
        ? {
            kind: kindOf(a.overview, old.cell, b.overview, cell, ofNumbers),
            names,
            before: old.cell,
            after: cell,
          }
        : { kind: "new", names, before: -1, after: cell },
    );
  }
  for (const [key, { cell, names }] of before)
    if (!after.has(key)) changes.push({ kind: "gone", names, before: cell, after: -1 });
  return changes;
}

export { stateOf, valueOf };
