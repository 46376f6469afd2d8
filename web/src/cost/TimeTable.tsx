import { Scroll } from "../common/Scroll";
import { useMemo } from "preact/hooks";
import { seconds } from "../common/format";
import { note, routeText, type Route } from "../route";
import { levelsOf } from "./ranking";
import { timeToErrorRows } from "./csv_rows";
import { timeTable, sortedRows, type TimeRow, type Sorting } from "./time_rows";
import { boundText, levelText, short, withEnds } from "./quantities";
import { SaveButtons } from "./SaveButtons";
import type { CostStudy, TimeToError } from "../data/generated";

interface HeadProps {
  by: string;
  label: string;
  title: string;
  sorting: Sorting;
  isNumber?: boolean;
}

/** A head that sorts: the first click ascending, the second descending. */
function SortHead({ by, label, title, sorting, isNumber }: HeadProps) {
  const own = sorting.by === by;
  const order = own ? (sorting.descending ? "descending" : "ascending") : undefined;
  return (
    <th scope="col" class={isNumber ? "number" : undefined} aria-sort={order}>
      <button
        title={title}
        onClick={() => note({ sort: by, order: own && !sorting.descending ? "down" : "" })}
      >
        {label}
        <span aria-hidden="true">{own ? (sorting.descending ? " ▼" : " ▲") : ""}</span>
      </button>
    </th>
  );
}

interface CellProps {
  time: TimeToError | undefined;
  isFastest: boolean;
  isMeasured: boolean;
}

function TimeCell({ time, isFastest, isMeasured }: CellProps) {
  const interval = time?.cpu_seconds;
  if (interval?.value == null)
    return <td class="quiet note">{time ? boundText(time, isMeasured) : "–"}</td>;
  return (
    <td class="number" title={withEnds(interval, seconds)}>
      {isFastest ? (
        <b title="shown to be the fastest">★ {seconds(interval.value)}</b>
      ) : (
        seconds(interval.value)
      )}
      {interval.low !== null && interval.high !== null ? (
        <span class="ends">
          {seconds(interval.low)} to {seconds(interval.high)}
        </span>
      ) : null}
    </td>
  );
}

function Row({ row, route }: { row: TimeRow; route: Route }) {
  const { curve, floor } = row;
  const link = { path: route.path, query: { ...route.query, target: row.target, point: "" } };
  const perDb = curve.seconds_per_db?.value;
  return (
    <tr>
      <th scope="row">
        <a href={routeText(link)}>{row.target}</a>
      </th>
      <td>{row.renderer}</td>
      {row.times.map((time, i) => (
        <TimeCell
          key={i}
          time={time}
          isFastest={row.isFastest[i] ?? false}
          isMeasured={curve.points.length > 0}
        />
      ))}
      <td class="number" title={withEnds(curve.efficiency)}>
        {short(curve.efficiency?.value ?? null)}
      </td>
      <td class="number">{perDb == null ? "–" : `+${(100 * perDb).toFixed(0)} %`}</td>
      <td class="number" title={`${withEnds(floor)} ${curve.fit?.floor_named ?? ""}`}>
        {short(floor?.value ?? null)}
      </td>
    </tr>
  );
}

interface Props {
  study: CostStudy;
  metric: string;
  /** Indices of the targets to show. */
  targets: number[];
  route: Route;
}

/** CPU seconds to each level, by target and renderer; every column sorts. */
export function TimeTable({ study, metric, targets, route }: Props) {
  const sorting = {
    by: route.query["sort"] || "target",
    descending: route.query["order"] === "down",
  };
  const all = useMemo(() => timeTable(study, metric), [study, metric]);
  const rows = sortedRows(
    all.filter(({ curve }) => targets.includes(curve.target)),
    sorting,
  );
  const head = (by: string, label: string, title: string, isNumber = true) => (
    <SortHead key={by} {...{ by, label, title, sorting, isNumber }} />
  );
  return (
    <section class="cost-panel times" aria-label="Times to error">
      <div class="panel-head">
        <h2>Time to error: CPU seconds to a quality</h2>
        <span class="quiet">★ shown to be the fastest of the renderers that reach it</span>
        <SaveButtons name={`${study.suite} times to error`} rows={() => timeToErrorRows(study)} />
      </div>
      <Scroll label="Table of times">
        <table>
          <thead>
            <tr>
              {head("target", "Target", "in the order of the suite", false)}
              {head("renderer", "Renderer", "by name", false)}
              {levelsOf(study, metric).map((level, i) =>
                head(String(i), levelText(study, metric, level), "CPU seconds to this quality"),
              )}
              {head("efficiency", "Efficiency", "1 / (relMSE × CPU seconds); higher is better")}
              {head("db", "One more dB", "additional time for one more decibel")}
              {head("floor", "Floor", "relMSE that no time removes, where the study shows one")}
            </tr>
          </thead>
          <tbody>
            {rows.map((row) => (
              <Row key={`${row.curve.target} ${row.curve.renderer}`} row={row} route={route} />
            ))}
          </tbody>
        </table>
      </Scroll>
    </section>
  );
}
