import { kTimes, metricName } from "./quantities";
import {
  fittedCurve,
  floorOf,
  type Axes,
  type ChartOfTarget,
  type Placed,
  type Ranges,
} from "./chart_data";
import { Marker } from "./Marker";
import { scaleOf, tickText, type Scale } from "./scale";
import type { Theme } from "./theme";

/** The box of the axes within the drawing, in pixels. */
export interface Box {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

export interface Scales {
  x: Scale;
  y: Scale;
}

export const scalesOf = (ranges: Ranges, axes: Axes, box: Box): Scales => ({
  x: scaleOf(ranges.x, true, [box.left, box.right]),
  y: scaleOf(ranges.y, axes.y.log, [box.bottom, box.top]),
});

export const placeOf = ({ x, y }: Scales, point: { x: number; y: number }): [number, number] => [
  x.at(point.x),
  y.at(point.y),
];

const pathOf = (scales: Scales, points: { x: number; y: number }[]): string =>
  points
    .map((point, i) => {
      const [x, y] = placeOf(scales, point);
      return `${i === 0 ? "M" : "L"}${x.toFixed(1)},${y.toFixed(1)}`;
    })
    .join("");

interface PartProps {
  chart: ChartOfTarget;
  scales: Scales;
  box: Box;
  theme: Theme;
  /** Of the small multiples: thinner, and without words. */
  small: boolean;
}

export const yLabel = ({ y }: Axes): string =>
  `${metricName(y.name)}${y.unit ? ` (${y.unit})` : ""}, ${y.lower_is_better ? "lower" : "higher"} is better`;

export const xLabel = ({ x }: Axes): string => kTimes.find(({ name }) => name === x)?.label ?? x;

function AxisLabels({ chart: { axes }, box, theme }: PartProps) {
  const middle = (box.top + box.bottom) / 2;
  return (
    <g font-size={12} fill={theme.text} text-anchor="middle">
      <text x={(box.left + box.right) / 2} y={box.bottom + 36}>
        {xLabel(axes)}
      </text>
      <text transform={`translate(${box.left - 46},${middle}) rotate(-90)`}>{yLabel(axes)}</text>
    </g>
  );
}

// Labels below this are powers of ten.
const kPlainTime = 0.001;
/** The same for errors: an axis of small ones has powers only. */
const plainError = ({ y }: Scales): number => (y.min < 0.005 ? 0.1 : 0.001);

/** The grid, its numbers, and the names of the axes. */
export function AxesPart(props: PartProps) {
  const { scales, box, theme, small } = props;
  const every = small ? 2 : 1;
  return (
    <g font-size={small ? 10 : 11} fill={theme.quiet} stroke-width={1}>
      {scales.x.ticks.map((tick, i) => (
        <g key={tick}>
          <line
            x1={scales.x.at(tick)}
            x2={scales.x.at(tick)}
            y1={box.top}
            y2={box.bottom}
            stroke={theme.line}
          />
          {i % every === 0 ? (
            <text x={scales.x.at(tick)} y={box.bottom + (small ? 12 : 16)} text-anchor="middle">
              {tickText(tick, kPlainTime)}
            </text>
          ) : null}
        </g>
      ))}
      {scales.y.ticks.map((tick, i) => (
        <g key={tick}>
          <line
            x1={box.left}
            x2={box.right}
            y1={scales.y.at(tick)}
            y2={scales.y.at(tick)}
            stroke={theme.line}
          />
          {i % every === 0 ? (
            <text x={box.left - 5} y={scales.y.at(tick) + 4} text-anchor="end">
              {tickText(tick, plainError(scales))}
            </text>
          ) : null}
        </g>
      ))}
      {small ? null : <AxisLabels {...props} />}
    </g>
  );
}

const isWithin = (scale: Scale, value: number): boolean => value >= scale.min && value <= scale.max;

/** Lines over the whole width: levels to which times are stated, and the noise of the reference. */
export function LevelsPart({ chart, scales, box, theme, small }: PartProps) {
  const { referenceNoise: noise, levels, axes } = chart;
  const line = (value: number, dashes: string) => (
    <line
      x1={box.left}
      x2={box.right}
      y1={scales.y.at(value)}
      y2={scales.y.at(value)}
      stroke={theme.quiet}
      stroke-width={1}
      stroke-dasharray={dashes}
    />
  );
  return (
    <g font-size={11} fill={theme.quiet}>
      {levels
        .filter((level) => isWithin(scales.y, level))
        .map((level) => (
          <g key={level} class="level">
            {line(level, "5 4")}
            {small ? null : (
              <text x={box.right - 3} y={scales.y.at(level) - 4} text-anchor="end">
                {tickText(level, plainError(scales))}
                {axes.y.unit ? ` ${axes.y.unit}` : ""}
              </text>
            )}
          </g>
        ))}
      {noise !== null && isWithin(scales.y, noise) ? (
        <g class="reference-noise">{line(noise, "1 3")}</g>
      ) : null}
    </g>
  );
}

/**
 * The frontier as steps: from each point on, its error is the best one until the next point. To the
 * left of the steps and below them (above, if higher is better) is nothing.
 */
export function FrontierPart({ chart, scales, box, theme, small }: PartProps) {
  const { frontier, axes } = chart;
  const [first] = frontier;
  const worst = axes.y.lower_is_better ? box.top : box.bottom;
  if (!first) return null;
  const steps = frontier.map((point) => {
    const [x, y] = placeOf(scales, point);
    return `H${x.toFixed(1)}V${y.toFixed(1)}`;
  });
  return (
    <path
      class="frontier"
      d={`M${scales.x.at(first.x)},${worst}${steps.join("")}H${box.right}`}
      fill="none"
      stroke={theme.text}
      stroke-opacity={0.55}
      stroke-width={small ? 0.8 : 1}
    />
  );
}

/** The band of the intervals, the line of the measured points, the fit and its floor. */
export function CurvesPart({ chart, scales, box, theme, small }: PartProps) {
  const inside = (value: number): number => Math.max(value, scales.y.min);
  return (
    <g fill="none">
      {chart.curves.map((one) => {
        const { curve, points } = one;
        const colour = theme.series(one.series);
        const upper = points.map(({ x, yEnds }) => ({ x, y: inside(yEnds[1]) }));
        const lower = points.map(({ x, yEnds }) => ({ x, y: inside(yEnds[0]) })).reverse();
        const fit = fittedCurve(one, chart.axes);
        const floor = floorOf(curve, chart.axes);
        return (
          <g key={curve.renderer}>
            {points.length > 1 ? (
              <path
                class="band"
                d={`${pathOf(scales, [...upper, ...lower])}Z`}
                fill={colour}
                fill-opacity={0.18}
              />
            ) : null}
            <path
              d={pathOf(scales, fit.length > 0 ? fit : points)}
              class={fit.length > 0 ? "fit" : "joined"}
              stroke={colour}
              stroke-width={small ? 1.2 : 1.6}
              {...(fit.length > 0 ? {} : { "stroke-opacity": 0.6 })}
            />
            {floor !== null && isWithin(scales.y, floor) ? (
              <line
                class="floor"
                x1={box.left}
                x2={box.right}
                y1={scales.y.at(floor)}
                y2={scales.y.at(floor)}
                stroke={colour}
                stroke-width={1.4}
                stroke-dasharray="9 3 2 3"
              />
            ) : null}
          </g>
        );
      })}
    </g>
  );
}

/** One marker per point; hollow if its error is not well above the reference's noise. */
export function PointMark({
  placed,
  scales,
  theme,
  size,
}: {
  placed: Placed;
  scales: Scales;
  theme: Theme;
  size: number;
}) {
  const [x, y] = placeOf(scales, placed);
  const colour = theme.series(placed.series);
  return (
    <>
      <line
        x1={scales.x.at(Math.max(placed.xEnds[0], scales.x.min))}
        x2={scales.x.at(placed.xEnds[1])}
        y1={y}
        y2={y}
        stroke={colour}
        stroke-width={1.2}
      />
      <Marker
        shape={placed.series}
        x={x}
        y={y}
        size={size}
        colour={colour}
        hollow={placed.point.below_reference_noise ? theme.panel : undefined}
      />
    </>
  );
}
