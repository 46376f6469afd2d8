import { useEffect, useState } from "preact/hooks";
import { bytes, number, seconds } from "../common/format";
import {
  goesOnText,
  besidePsnr,
  isInfinite,
  namesOf,
  reasonOf,
  runQuery,
  stateOf,
  type Session,
} from "../common/session";
import { lookOf } from "../common/states";
import type { Overview } from "../data/generated";
import { note, routeText } from "../route";
import { Preview, type Hovered } from "./Preview";
import { worstCell, type Filter, type Row } from "./rows";
import { useWindow } from "./use_window";

const kRowHeight = 34;
const kSpare = 12; // rows kept beyond the edges of the window for the Tab key and fast scrolling

interface Props {
  session: Session;
  rows: Row[];
  renderers: number[];
  filter: Filter;
  show: string;
}

/** The time with the samples that it was taken for: one says little without the other. */
function timeText({ cells }: Overview, index: number): string {
  const spp = cells.spp[index] ?? null;
  return `${spp === null ? "" : `${spp} spp, `}${seconds(cells.wall_seconds[index])}`;
}

function shown(overview: Overview, show: string, index: number): string {
  if (show === "wall_seconds") return timeText(overview, index);
  if (show === "spp") return String(overview.cells.spp[index] ?? "–");
  if (show === "peak_rss_bytes") return bytes(overview.cells.peak_rss_bytes[index]);
  const metric = overview.metrics.find((one) => one.name === show);
  const value = overview.measures[show]?.[index];
  const infinite = isInfinite(overview, show, index);
  if (!metric || ((value === null || value === undefined) && !infinite)) return "";
  const beside = besidePsnr(overview, show, index);
  return `${number(value, infinite)}${metric.unit === "dB" ? " dB" : ""}${beside && `, ${beside}`}`;
}

export function cellLink(session: Session, index: number): string {
  const names = namesOf(session.overview, index);
  return routeText({
    path: ["case", names.case, names.target, names.renderer],
    query: runQuery(session.source, session.run),
  });
}

interface CellProps {
  session: Session;
  index: number;
  show: string;
  onHover: (hovered: Hovered | undefined) => void;
}

function Cell({ session, index, show, onHover }: CellProps) {
  if (index < 0) return <span role="cell" class="cell none" />;
  const state = stateOf(session.overview, index);
  const look = lookOf(state);
  const goesOn = goesOnText(session.overview, index);
  const enter = (event: Event): void =>
    onHover({ index, box: (event.currentTarget as HTMLElement).getBoundingClientRect() });
  return (
    <span role="cell" class="cell">
      <a
        class={`tone-${look.tone} ${goesOn ? "preliminary" : ""}`}
        href={cellLink(session, index)}
        onPointerEnter={enter}
        onFocus={enter}
        onPointerLeave={() => onHover(undefined)}
        onBlur={() => onHover(undefined)}
      >
        <span class="symbol" aria-hidden="true">
          {look.symbol}
        </span>
        <span class="word">{state?.name}</span>
        {goesOn ? <span class="unseen"> {goesOn}</span> : null}
        <span class="value">
          {goesOn ? <span aria-hidden="true">▸ </span> : null}
          {shown(session.overview, show, index)}
        </span>
      </a>
    </span>
  );
}

/** The title of a row, a link to the cell with the worst verdict. */
function Title({ session, row, renderers }: { session: Session; row: Row; renderers: number[] }) {
  const cell = worstCell(session.overview, row, renderers);
  return (
    <a
      class="title"
      title={row.about || row.title}
      href={cell < 0 ? "#/" : cellLink(session, cell)}
    >
      {row.title}
    </a>
  );
}

interface RowHeadProps {
  session: Session;
  row: Row;
  renderers: number[];
  filter: Filter;
}

function RowHead({ session, row, renderers, filter }: RowHeadProps) {
  const title = <Title session={session} row={row} renderers={renderers} />;
  if (row.kind === "target")
    return (
      <span role="rowheader" class="rowhead target">
        <b>{filter.byTarget ? row.requirement : ""}</b> {title}
      </span>
    );
  const open = filter.open.includes(row.requirement);
  const toggle = (): void =>
    note({
      open: (open
        ? filter.open.filter((code) => code !== row.requirement)
        : [...filter.open, row.requirement]
      ).join("|"),
    });
  return (
    <span role="rowheader" class="rowhead">
      <button
        class="twist"
        aria-expanded={open}
        onClick={toggle}
        title={`${row.below} targets`}
        aria-label={`Targets of ${row.requirement}`}
      >
        {open ? "▾" : "▸"}
      </button>
      <b>{row.requirement}</b> {title}
    </span>
  );
}

/** Why the worst verdict of a row is none better. */
function Reason({ session, row, renderers }: { session: Session; row: Row; renderers: number[] }) {
  const cell = worstCell(session.overview, row, renderers);
  const isWorthIt = cell >= 0 && stateOf(session.overview, cell)?.name !== "pass";
  const reason = isWorthIt ? reasonOf(session.overview, cell) : "";
  return (
    <span role="cell" class="reason-cell" title={reason}>
      {reason}
    </span>
  );
}

/** The grid of rows by renderers. Only visible rows are in the document. */
export function Grid({ session, rows, renderers, filter, show }: Props) {
  const { body, begin, end } = useWindow(rows.length, kRowHeight, kSpare);
  const [hovered, setHovered] = useState<Hovered>();
  useEffect(() => setHovered(undefined), [rows]);
  const { overview } = session;
  const isWide = show === "wall_seconds" || (show === "psnr_srgb8" && !!overview.rule_beside_psnr);
  const column = "minmax(var(--column), 1fr)";
  const columns = `minmax(var(--head), 2fr) repeat(${renderers.length}, ${column}) var(--why)`;
  const several = new Set(overview.cases.map((one) => one.suite)).size > 1;
  return (
    <div
      class={`grid ${isWide ? "wide-cells" : ""}`}
      role="table"
      aria-label="Requirements by renderers"
      aria-rowcount={rows.length + 1}
      style={{ "--columns": columns }}
    >
      <div role="row" class="row head" aria-rowindex={1}>
        <span role="columnheader">{filter.byTarget ? "Target" : "Requirement"}</span>
        {renderers.map((r) => (
          <span role="columnheader" key={r}>
            {overview.renderers[r]?.name}
          </span>
        ))}
        <span role="columnheader" class="reason-cell">
          Reason of the worst
        </span>
      </div>
      {rows.length === 0 ? <p class="quiet empty">Nothing matches the filter.</p> : null}
      <div
        class="body"
        ref={body}
        role="rowgroup"
        style={{ height: `${rows.length * kRowHeight}px` }}
      >
        {rows.slice(begin, end).map((row, i) => (
          <div
            role="row"
            class={`row ${row.kind}`}
            key={row.key}
            aria-rowindex={begin + i + 2}
            style={{ top: `${(begin + i) * kRowHeight}px` }}
            data-suite={several ? row.suite : undefined}
          >
            <RowHead session={session} row={row} renderers={renderers} filter={filter} />
            {renderers.map((r) => (
              <Cell
                key={r}
                session={session}
                index={row.cells[r] ?? -1}
                show={show}
                onHover={setHovered}
              />
            ))}
            <Reason session={session} row={row} renderers={renderers} />
          </div>
        ))}
      </div>
      {hovered ? <Preview session={session} hovered={hovered} /> : null}
    </div>
  );
}
