import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { bytes, number, seconds } from "../common/format";
import { isInfinite, namesOf, runQuery, stateOf, type Session } from "../common/session";
import { lookOf } from "../common/states";
import type { Overview } from "../data/types";
import { note, routeText } from "../route";
import { Preview, type Hovered } from "./Preview";
import type { Filter, Row } from "./rows";

const kRowHeight = 34;
const kSpare = 12; // rows kept beyond the edges, so that tabbing and quick scrolling find them there

interface Props {
  session: Session;
  rows: Row[];
  renderers: number[];
  filter: Filter;
  show: string;
}

/** First and last row that can be seen. */
function useWindow(count: number) {
  const body = useRef<HTMLDivElement>(null);
  const [span, setSpan] = useState({ begin: 0, end: 60 });
  useLayoutEffect(() => {
    const update = (): void => {
      const top = body.current?.getBoundingClientRect().top ?? 0;
      const begin = Math.max(0, Math.floor(-top / kRowHeight) - kSpare);
      const end = Math.min(count, Math.ceil((innerHeight - top) / kRowHeight) + kSpare);
      setSpan((old) => (old.begin === begin && old.end === end ? old : { begin, end }));
    };
    update();
    addEventListener("scroll", update, { passive: true });
    addEventListener("resize", update);
    return () => {
      removeEventListener("scroll", update);
      removeEventListener("resize", update);
    };
  }, [count]);
  return { body, ...span };
}

function shown(overview: Overview, show: string, index: number): string {
  if (show === "wall_seconds") return seconds(overview.cells.wall_seconds[index]);
  if (show === "peak_rss_bytes") return bytes(overview.cells.peak_rss_bytes[index]);
  const metric = overview.metrics.find((one) => one.name === show);
  const value = overview.measures[show]?.[index];
  const infinite = isInfinite(overview, show, index);
  if (!metric || ((value === null || value === undefined) && !infinite)) return "";
  return `${number(value, infinite)}${metric.unit === "dB" ? " dB" : ""}`;
}

export function cellLink(session: Session, index: number): string {
  const names = namesOf(session.overview, index);
  return routeText({
    path: ["case", names.case, names.target, names.renderer],
    query: runQuery(session.source, session.run),
  });
}

function Cell({
  session,
  index,
  show,
  onHover,
}: {
  session: Session;
  index: number;
  show: string;
  onHover: (hovered: Hovered | undefined) => void;
}) {
  if (index < 0) return <span role="cell" class="cell none" />;
  const state = stateOf(session.overview, index);
  const look = lookOf(state);
  const enter = (event: Event): void =>
    onHover({ index, box: (event.currentTarget as HTMLElement).getBoundingClientRect() });
  return (
    <span role="cell" class="cell">
      <a
        class={`tone-${look.tone}`}
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
        <span class="value">{shown(session.overview, show, index)}</span>
      </a>
    </span>
  );
}

function RowHead({ row, filter }: { row: Row; filter: Filter }) {
  if (row.kind === "target")
    return (
      <span role="rowheader" class="rowhead image">
        <b>{filter.byTarget ? row.requirement : ""}</b>{" "}
        <span class="title" title={row.title}>
          {row.title}
        </span>
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
      <b>{row.requirement}</b>{" "}
      <span class="title" title={row.title}>
        {row.title}
      </span>
    </span>
  );
}

/** The grid of rows by renderers. Only the rows in surface are there. */
export function Grid({ session, rows, renderers, filter, show }: Props) {
  const { body, begin, end } = useWindow(rows.length);
  const [hovered, setHovered] = useState<Hovered>();
  useEffect(() => setHovered(undefined), [rows]);
  const { overview } = session;
  const columns = `minmax(var(--head), 2fr) repeat(${renderers.length}, minmax(var(--column), 1fr))`;
  const several = new Set(overview.cases.map((one) => one.suite)).size > 1;
  return (
    <div
      class="grid"
      role="table"
      aria-label="Requirements by renderers"
      aria-rowcount={rows.length + 1}
      style={{ "--columns": columns }}
    >
      <div role="row" class="row head" aria-rowindex={1}>
        <span role="columnheader">{filter.byTarget ? "Image" : "Requirement"}</span>
        {renderers.map((r) => (
          <span role="columnheader" key={r}>
            {overview.renderers[r]?.name}
          </span>
        ))}
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
            <RowHead row={row} filter={filter} />
            {renderers.map((r) => (
              <Cell
                key={r}
                session={session}
                index={row.cells[r] ?? -1}
                show={show}
                onHover={setHovered}
              />
            ))}
          </div>
        ))}
      </div>
      {hovered ? <Preview session={session} hovered={hovered} /> : null}
    </div>
  );
}
