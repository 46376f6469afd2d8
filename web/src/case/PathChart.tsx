import { lookOf } from "../common/states";
import { useWidth } from "../common/use_width";
import type { LookRecord, State, TargetDetail } from "../data/generated";
import {
  barOf,
  gateNumber,
  intervalText,
  isNumber,
  shownRange,
  type Ends,
  type PathOfGate,
} from "./path_to_verdict";

const kMostRows = 3;
const kRow_px = 112; // height of a row
const kOnlyRow_px = 160;
const kGap_px = 26; // between two rows; the name of the lower one's gate stands there
const kMargin = { left: 62, right: 62, top: 42, bottom: 40 };
const kInset_px = 16; // from the frame to the first and last look
const kTick_px = 42; // room for the number of samples of a look
const kLine_px = 13; // of text

interface Props {
  detail: TargetDetail;
  paths: PathOfGate[];
  stateOf: (look: LookRecord) => State | undefined;
}

interface Frame {
  left: number;
  right: number;
  height: number; // of a row
  x: (spp: number) => number;
}

/** Samples on a logarithmic axis: a look has twice as many as the one before. */
function frameOf(looks: LookRecord[], width: number, height: number): Frame {
  const [left, right] = [kMargin.left, Math.max(width - kMargin.right, kMargin.left + 40)];
  const [first, last] = [looks[0]?.spp ?? 1, looks[looks.length - 1]?.spp ?? 1];
  const place = (spp: number) =>
    last > first ? Math.log2(spp / first) / Math.log2(last / first) : 0.5;
  return {
    left,
    right,
    height,
    x: (spp) => left + kInset_px + place(spp) * (right - left - 2 * kInset_px),
  };
}

interface RowProps {
  detail: TargetDetail;
  path: PathOfGate;
  frame: Frame;
  top: number;
  stateOf: Props["stateOf"];
}

/** The limits of the gate with their numbers, and what they allow. */
function Limits({
  detail,
  path,
  frame,
  top,
  y,
}: Omit<RowProps, "stateOf"> & { y: (value: number) => number }) {
  const { gate, min, max } = path;
  const bottom = top + frame.height;
  const limits = [max, min].filter((limit) => limit !== undefined);
  const [from, to] = [max === undefined ? top : y(max), min === undefined ? bottom : y(min)];
  // Two limits that are near to each other keep their numbers apart.
  const apart = limits.length === 2 ? Math.max(0, kLine_px - (to - from)) / 2 : 0;
  return (
    <>
      {limits.length > 0 ? (
        <rect
          class="allowed"
          x={frame.left}
          width={frame.right - frame.left}
          y={from}
          height={Math.max(0, to - from)}
        />
      ) : null}
      {limits.map((limit) => (
        <g key={limit} class="limit">
          <line x1={frame.left} x2={frame.right} y1={y(limit)} y2={y(limit)} />
          <text
            x={frame.left - 6}
            y={y(limit) + 4 + (limit === max ? -apart : apart)}
            text-anchor="end"
          >
            {gateNumber(detail, gate, limit)}
          </text>
        </g>
      ))}
    </>
  );
}

const isIn = (value: number | undefined, { low, high }: Ends): value is number =>
  isNumber(value) && value >= low && value <= high;

const arrow = (x: number, y: number, down: boolean): string => {
  const tip = down ? y + 6 : y - 6;
  return `M${x - 4},${y}L${x + 4},${y}L${x},${tip}Z`;
};

interface MarkProps {
  look: LookRecord;
  path: PathOfGate;
  x: number;
  y: (value: number) => number;
}

/** The interval as a bar, with an arrow where it has no end or one beyond the chart, and the value as a dot. */
function Mark({ look, path, x, y }: MarkProps) {
  const range = shownRange(path);
  const bar = barOf(look, range);
  return (
    <>
      {bar ? (
        <>
          <line class="interval" x1={x} x2={x} y1={y(bar.low)} y2={y(bar.high)} />
          {bar.isOpenBelow ? (
            <path d={arrow(x, y(bar.low) - 6, true)} />
          ) : (
            <line class="interval" x1={x - 5} x2={x + 5} y1={y(bar.low)} y2={y(bar.low)} />
          )}
          {bar.isOpenAbove ? (
            <path d={arrow(x, y(bar.high) + 6, false)} />
          ) : (
            <line class="interval" x1={x - 5} x2={x + 5} y1={y(bar.high)} y2={y(bar.high)} />
          )}
        </>
      ) : null}
      {isIn(look.value, range) ? <circle cx={x} cy={y(look.value)} r={4} /> : null}
    </>
  );
}

/** One gate: its limits, and what the looks saw of it. */
function GateRow({ detail, path, frame, top, stateOf }: RowProps) {
  const range = shownRange(path);
  const y = (value: number) =>
    top + (frame.height * (range.high - value)) / (range.high - range.low);
  const last = path.looks[path.looks.length - 1];
  return (
    <g class="gate" data-gate={path.gate}>
      <text class="name" x={frame.left} y={top - 6}>
        {path.gate}
      </text>
      <Limits detail={detail} path={path} frame={frame} top={top} y={y} />
      <rect
        class="frame"
        x={frame.left}
        width={frame.right - frame.left}
        y={top}
        height={frame.height}
      />
      {path.looks.map((look) => {
        const state = stateOf(look);
        const numbers = `${gateNumber(detail, path.gate, look.value)}, ${intervalText(detail, look)}`;
        return (
          <g key={look.spp} class={`look tone-${lookOf(state).tone}`} data-spp={look.spp}>
            <title>{`${look.spp} samples: ${look.verdict}, ${path.gate} ${numbers}`}</title>
            <Mark look={look} path={path} x={frame.x(look.spp)} y={y} />
          </g>
        );
      })}
      {last && isIn(last.value, range) ? (
        <text
          class={`value tone-${lookOf(stateOf(last)).tone}`}
          x={frame.x(last.spp) + 9}
          y={y(last.value) + 4}
        >
          {gateNumber(detail, path.gate, last.value)}
        </text>
      ) : null}
    </g>
  );
}

/** A tick at each look, with its samples, and above it the symbol of its verdict. */
function Looks({
  looks,
  frame,
  bottom,
  stateOf,
}: {
  looks: LookRecord[];
  frame: Frame;
  bottom: number;
  stateOf: Props["stateOf"];
}) {
  const every = Math.ceil((looks.length * kTick_px) / (frame.right - frame.left));
  return (
    <>
      {looks.map((look, i) => {
        const x = frame.x(look.spp);
        const { symbol, tone } = lookOf(stateOf(look));
        return (
          <g key={look.spp} class="tick" text-anchor="middle">
            <text class={`symbol tone-${tone}`} x={x} y={14}>
              {symbol}
            </text>
            <line x1={x} x2={x} y1={bottom} y2={bottom + 5} />
            {(looks.length - 1 - i) % every === 0 ? (
              <text x={x} y={bottom + 18}>
                {look.spp}
              </text>
            ) : null}
          </g>
        );
      })}
      <text x={(frame.left + frame.right) / 2} y={bottom + 35} text-anchor="middle">
        samples per pixel
      </text>
    </>
  );
}

/** What the looks saw, one row for each gate that decided one of them or held it up. */
export function PathChart({ detail, paths, stateOf }: Props) {
  const { element, width } = useWidth();
  const rows = paths.slice(0, kMostRows);
  const others = paths.slice(kMostRows).map(({ gate }) => gate);
  const frame = frameOf(detail.looks, width, rows.length === 1 ? kOnlyRow_px : kRow_px);
  const topOf = (row: number) => kMargin.top + row * (frame.height + kGap_px);
  const bottom = topOf(rows.length - 1) + frame.height;
  const gates = rows.map(({ gate }) => gate).join(", ");
  return (
    <div class="path-chart" ref={element}>
      {width > 0 ? (
        <svg
          width={width}
          height={bottom + kMargin.bottom}
          viewBox={`0 0 ${width} ${bottom + kMargin.bottom}`}
          role="img"
          aria-label={`${gates} with intervals at each look; the table below has the numbers`}
        >
          {rows.map((path, row) => (
            <GateRow
              key={path.gate}
              detail={detail}
              path={path}
              frame={frame}
              top={topOf(row)}
              stateOf={stateOf}
            />
          ))}
          <Looks looks={detail.looks} frame={frame} bottom={bottom} stateOf={stateOf} />
        </svg>
      ) : null}
      <p class="quiet">
        Dot: the value; bar: the interval that the decision rests on; lines: what the gate allows.
        {others.length > 0 ? ` The table also has ${others.join(" and ")}.` : null}
      </p>
    </div>
  );
}
