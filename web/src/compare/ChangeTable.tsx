import { number } from "../common/format";
import { StateMark } from "../common/StateMark";
import { TableHead, type Column } from "../common/TableHead";
import type { Overview } from "../data/types";
import { stateOf, valueOf, type Change, type Kind, type Side } from "./changes";
import { timesOf, timeSummary } from "./times";

const kColumns: Column[] = [
  { label: "Case" },
  { label: "Target" },
  { label: "Renderer" },
  { label: "Before" },
  { label: "After" },
  { label: "Time", isNumber: true, title: "wall-clock time, after divided by before" },
];

export const kHeadings: Record<Kind, string> = {
  worse: "Became worse",
  better: "Became better",
  open: "Not rendered before or after",
  new: "New",
  gone: "Removed",
  same: "Unchanged",
};
const kMostRows = 500; // per heading

interface CellProps {
  overview: Overview;
  cell: number;
  metric: string;
  link: string;
}

function Cell({ overview, cell, metric, link }: CellProps) {
  if (cell < 0) return <td class="quiet">–</td>;
  const value = valueOf(overview, metric, cell);
  return (
    <td>
      <a href={link}>
        <StateMark state={stateOf(overview, cell)} />
      </a>{" "}
      <span class="quiet">{value === undefined ? "" : number(value, value === Infinity)}</span>
    </td>
  );
}

const kApart = "measured on different machines";
const apartText = ([before, after]: [string, string]): string =>
  `${before || "unknown"} before, ${after || "unknown"} after`;

function TimeCell({ a, b, change }: { a: Overview; b: Overview; change: Change }) {
  const times = timesOf(a, change.before, b, change.after);
  if (!times) return <td class="quiet number">–</td>;
  if ("ratio" in times) return <td class="number">× {number(times.ratio)}</td>;
  return (
    <td class="quiet number" title={apartText(times.machines)}>
      {kApart}
    </td>
  );
}

/** The change of the render time, as far as the times can be compared. */
export function TimeLine({ a, b, changes }: { a: Overview; b: Overview; changes: Change[] }) {
  const { ratio, targets, apart, machines } = timeSummary(a, b, changes);
  const loads = `load at the start ${a.run.load.toFixed(2)} before, ${b.run.load.toFixed(2)} after`;
  return (
    <p class="compare-time quiet">
      {targets > 0 ? (
        <span>
          Wall clock × {number(ratio)}, geometric mean over {targets} targets; {loads}.{" "}
        </span>
      ) : null}
      {machines ? (
        <span>
          Times of {apart} targets are not compared: {kApart} ({apartText(machines)}).
        </span>
      ) : null}
    </p>
  );
}

interface ChangeTableProps {
  kind: Kind;
  changes: Change[];
  a: Side;
  b: Side;
  metric: string;
  links: { a: (cell: number) => string; b: (cell: number) => string };
}

export function ChangeTable({ kind, changes, a, b, metric, links }: ChangeTableProps) {
  if (changes.length === 0) return null;
  return (
    <section data-kind={kind}>
      <details open={kind !== "same"}>
        <summary>
          <h2 style={{ display: "inline" }}>
            {kHeadings[kind]} <span class="count">{changes.length}</span>
          </h2>
        </summary>
        <table>
          <TableHead columns={kColumns} />
          <tbody>
            {changes.slice(0, kMostRows).map((change) => (
              <tr key={`${change.names.case} ${change.names.target} ${change.names.renderer}`}>
                <th scope="row">{change.names.case}</th>
                <td>{change.names.target}</td>
                <td>
                  {a.renderer && b.renderer
                    ? `${a.renderer} → ${b.renderer}`
                    : change.names.renderer}
                </td>
                <Cell
                  overview={a.overview}
                  cell={change.before}
                  metric={metric}
                  link={links.a(change.before)}
                />
                <Cell
                  overview={b.overview}
                  cell={change.after}
                  metric={metric}
                  link={links.b(change.after)}
                />
                <TimeCell a={a.overview} b={b.overview} change={change} />
              </tr>
            ))}
          </tbody>
        </table>
        {changes.length > kMostRows ? (
          <p class="quiet">… and {changes.length - kMostRows} more.</p>
        ) : null}
      </details>
    </section>
  );
}
