import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { number } from "../common/format";
import { besidePsnr, isInfinite, reasonOf, stateOf, type Session } from "../common/session";
import { StateMark } from "../common/StateMark";
import type { Row } from "./rows";
import { cellLink } from "./Grid";
import { loadPictures, type Pictures } from "./pictures";
import { useWindow } from "./use_window";

interface Props {
  session: Session;
  /** Rows of targets. */
  rows: Row[];
  renderers: number[];
  /** The metric that the cells show. */
  show: string;
}

const kHead = 208; // width of the titles
const kText = 74; // height of the lines below the pictures
const kGap = 8;
const kNarrow = 700; // below this width the titles stand above the pictures

/** Width of the pictures of a row at this side: one reference, and two for each renderer. */
const picturesWidth = (side: number, renderers: number): number =>
  (2 * renderers + 1) * (side + kGap) + kGap;

/** Rows that stand beside each other: as many as the width holds with pictures that are large enough. */
function columnsOf(width: number, renderers: number): number {
  return Math.max(1, Math.floor(width / (kHead + picturesWidth(128, renderers))));
}

/** Side of a picture, so that all renderers fit the width. */
function pictureSide(width: number, head: number, renderers: number): number {
  const room = width - head - picturesWidth(0, renderers);
  return Math.max(72, Math.min(220, Math.floor(room / (2 * renderers + 1))));
}

function useWidth() {
  const box = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(1200);
  useLayoutEffect(() => {
    const element = box.current;
    if (!element) return undefined;
    const observer = new ResizeObserver(() => setWidth(element.clientWidth));
    setWidth(element.clientWidth);
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  return { box, width };
}

/** The pictures of a cell, once it has been in the window for a moment. */
function usePictures(session: Session, cell: number): Pictures {
  const [found, setFound] = useState<{ cell: number; pictures: Pictures }>();
  const { source, run, overview } = session;
  const state = `${overview.cells.state[cell]} ${overview.cells.spp[cell]}`;
  useEffect(() => {
    if (cell < 0) return undefined;
    const abort = new AbortController();
    // Rows that are only scrolled past are not loaded.
    const timer = setTimeout(() => {
      void loadPictures(session, cell, abort.signal, (pictures) => {
        if (!abort.signal.aborted) setFound({ cell, pictures });
      });
    }, 120);
    return () => {
      clearTimeout(timer);
      abort.abort();
    };
  }, [source, run, cell, state]);
  return found?.cell === cell ? found.pictures : {};
}

function Picture({
  address,
  label,
  side,
}: {
  address: string | undefined;
  label: string;
  side: number;
}) {
  // What cannot be shown as colours, such as an image of another renderer's own channels, stays empty.
  const [failed, setFailed] = useState<string>();
  return (
    <span class="picture" style={{ width: `${side}px`, height: `${side}px` }}>
      {address && address !== failed ? (
        <img src={address} alt={label} title={label} onError={() => setFailed(address)} />
      ) : null}
    </span>
  );
}

function Card({
  session,
  cell,
  show,
  side,
}: {
  session: Session;
  cell: number;
  show: string;
  side: number;
}) {
  const { overview } = session;
  const pictures = usePictures(session, cell);
  if (cell < 0) return <span class="card none" style={{ width: `${2 * side + kGap}px` }} />;
  const value = overview.measures[show]?.[cell];
  const infinite = isInfinite(overview, show, cell);
  const beside = besidePsnr(overview, show, cell);
  const reason = reasonOf(overview, cell);
  return (
    <span role="cell" class="card" style={{ width: `${2 * side + kGap}px` }}>
      <a href={cellLink(session, cell)} class="pictures">
        <Picture address={pictures.result} label="result" side={side} />
        <Picture address={pictures.difference} label="|result − reference|" side={side} />
      </a>
      <span class="line">
        <StateMark state={stateOf(overview, cell)} />{" "}
        <span class="number">{number(value, infinite)}</span>
        {beside && <span class="beside"> {beside}</span>}
      </span>
      <span class="why" title={reason}>
        {reason}
      </span>
    </span>
  );
}

function GalleryRow({
  session,
  row,
  renderers,
  show,
  side,
}: Omit<Props, "rows"> & { row: Row; side: number }) {
  const cells = renderers.map((renderer) => row.cells[renderer] ?? -1);
  const first = cells.find((cell) => cell >= 0) ?? -1;
  const { reference } = usePictures(session, first);
  return (
    <>
      <span role="rowheader" class="gallery-head">
        <b>{row.requirement}</b>{" "}
        <a href={first < 0 ? "#/" : cellLink(session, first)}>{row.title}</a>
        {row.about ? <span class="about quiet">{row.about}</span> : null}
      </span>
      <span role="cell" class="card">
        <Picture address={reference} label="reference" side={side} />
        <span class="line quiet">reference</span>
      </span>
      {cells.map((cell, i) => (
        <Card key={renderers[i]} session={session} cell={cell} show={show} side={side} />
      ))}
    </>
  );
}

/**
 * Each target, or the worst of each requirement, as pictures: its reference, and the result and the
 * difference of each renderer. Where the width allows, rows stand beside each other.
 */
export function Gallery({ session, rows, renderers, show }: Props) {
  const { box, width } = useWidth();
  const columns = columnsOf(width, renderers.length);
  const isNarrow = width < kNarrow;
  const side = pictureSide(width / columns, isNarrow ? 0 : kHead, renderers.length);
  const height = side + kText + (isNarrow ? 24 : 0);
  const lines = Math.ceil(rows.length / columns);
  const { body, begin, end } = useWindow(lines, height, 2);
  return (
    <div
      class={`gallery ${isNarrow ? "narrow" : ""} ${columns > 1 ? "several" : ""}`}
      role="table"
      aria-label="Targets as pictures"
      ref={box}
    >
      <div role="row" class="gallery-row head">
        <span role="columnheader" class="gallery-head">
          {rows[0]?.kind === "requirement" ? "Requirement" : "Target"}
        </span>
        <span role="columnheader" class="card" style={{ width: `${side}px` }}>
          Reference
        </span>
        {renderers.map((renderer) => (
          <span
            role="columnheader"
            class="card"
            key={renderer}
            style={{ width: `${2 * side + kGap}px` }}
          >
            {session.overview.renderers[renderer]?.name}
          </span>
        ))}
      </div>
      {rows.length === 0 ? <p class="quiet empty">Nothing matches the filter.</p> : null}
      <div class="body" ref={body} role="rowgroup" style={{ height: `${lines * height}px` }}>
        {rows.slice(begin * columns, end * columns).map((row, i) => (
          <div
            role="row"
            class="gallery-row"
            key={row.key}
            style={{
              top: `${(begin + Math.floor(i / columns)) * height}px`,
              height: `${height}px`,
              left: `${(100 / columns) * (i % columns)}%`,
              width: `${100 / columns}%`,
            }}
          >
            <GalleryRow session={session} row={row} renderers={renderers} show={show} side={side} />
          </div>
        ))}
      </div>
    </div>
  );
}
