import { number } from "../common/format";
import { StateMark } from "../common/StateMark";
import { TableHead, type Column } from "../common/TableHead";
import type { Overview } from "../data/generated";
import { stateOf, valueOf, type Change, type Kind, type Side } from "./changes";
import { timesOf, timeSummary } from "./times";

/** What the two sides are called: two runs are before and after, two renderers of one run A and B. */
export interface SideNames {
  before: string;
  after: string;
}

const columnsOf = ({ before, after }: SideNames): Column[] => [
  { label: "Case" },
  { label: "Target" },
  { label: "Renderer" },
  { label: before },
  { label: after },
  { label: "Time", isNumber: true, title: `wall-clock time, ${after} divided by ${before}` },
  { label: "Images" },
];

export const kKinds: readonly Kind[] = [
  "worse",
  "better",
  "changed",
  "open",
  "new",
  "gone",
  "same",
];

const headingOf = (kind: Kind, { before, after }: SideNames): string => {
  const isRuns = after === "After";
  const headings: Record<Kind, string> = {
    worse: isRuns ? "Became worse" : `${after} is worse`,
    better: isRuns ? "Became better" : `${after} is better`,
    changed: isRuns ? "Changed otherwise" : "Different, neither is better",
    open: isRuns ? "Not rendered before or after" : `Not rendered by ${before} or ${after}`,
    new: isRuns ? "New" : `Only ${after}`,
    gone: isRuns ? "Removed" : `Only ${before}`,
    same: isRuns ? "Unchanged" : "Alike",
  };
  return headings[kind];
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
  const loads =
    a === b
      ? "in one run"
      : `load at the start ${a.run.load.toFixed(2)} before, ${b.run.load.toFixed(2)} after`;
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
  names: SideNames;
  /** Address of both images of a change in one viewer; "" if one of them is missing. */
  pairLink: (change: Change) => string;
}

export function ChangeTable(props: ChangeTableProps) {
  const { kind, changes, a, b, metric, links, names, pairLink } = props;
  if (changes.length === 0) return null;
  return (
    <section data-kind={kind}>
      <details open={kind !== "same"}>
        <summary>
          <h2 style={{ display: "inline" }}>
            {headingOf(kind, names)} <span class="count">{changes.length}</span>
          </h2>
        </summary>
        <table>
          <TableHead columns={columnsOf(names)} />
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
                <td>{pairLink(change) ? <a href={pairLink(change)}>A × B</a> : null}</td>
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
