import { isInfinite, namesOf, stateOf, type CellNames } from "../common/session";
import { isOpen } from "../common/states";
import type { Overview } from "../data/generated";

/** "open" means not rendered before or not rendered after, so that nothing can be compared. */
export type Kind = "worse" | "better" | "open" | "new" | "gone" | "same";

export interface Change {
  kind: Kind;
  names: CellNames;
  before: number; // index of the cell, -1 for none
  after: number;
}

const rankOf = (overview: Overview, cell: number): number => overview.cells.state[cell] ?? 0;

const valueOf = (overview: Overview, metric: string, cell: number): number | undefined =>
  isInfinite(overview, metric, cell) ? Infinity : (overview.measures[metric]?.[cell] ?? undefined);

// A relative change of 1 % or less counts as none: another seed or machine causes as much.
function kindOf(a: Overview, before: number, b: Overview, after: number, metric: string): Kind {
  if (isOpen(stateOf(a, before)) || isOpen(stateOf(b, after))) return "open";
  const step = rankOf(b, after) - rankOf(a, before);
  if (step !== 0) return step > 0 ? "worse" : "better";
  const known = b.metrics.find((one) => one.name === metric);
  const sized = (value: number | undefined) =>
    known?.signed && value !== undefined ? Math.abs(value) : value;
  const [old, now] = [sized(valueOf(a, metric, before)), sized(valueOf(b, metric, after))];
  if (old === undefined || now === undefined || old === now) return "same";
  if (Number.isFinite(old) && Math.abs(now - old) <= 0.01 * Math.abs(old)) return "same";
  return now > old === (known?.lower_is_better ?? false) ? "worse" : "better";
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
export function changesOf(a: Side, b: Side, metric: string): Change[] {
  const common = a.renderer && b.renderer ? "both" : "";
  const before = byKey(a.overview, a.renderer, common);
  const after = byKey(b.overview, b.renderer, common);
  const changes: Change[] = [];
  for (const [key, { cell, names }] of after) {
    const old = before.get(key);
    changes.push(
      old
        ? {
            kind: kindOf(a.overview, old.cell, b.overview, cell, metric),
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
