import { useState } from "preact/hooks";
import { PairList } from "../common/PairList";
import type { ChartOfTarget, Placed, Ranges } from "./chart_data";
import {
  AxesPart,
  CurvesPart,
  FrontierPart,
  LevelsPart,
  placeOf,
  PointMark,
  scalesOf,
  yLabel,
  type Box,
  type Scales,
} from "./Drawing";
import { kLegendRow_px, Legend, legendRows, lineItem, rendererItems } from "./Legend";
import { Marker } from "./Marker";
import { numbersOf, short } from "./quantities";
import { useTheme, type Theme } from "./theme";
import type { CostStudy } from "../data/generated";
import { useWidth } from "../common/use_width";

interface Props {
  study: CostStudy;
  chart: ChartOfTarget;
  ranges: Ranges;
  chosen: { renderer: number; index: number } | undefined;
  onChoose: (point: Placed) => void;
}

const kMargin = { left: 66, right: 12, top: 8, axis: 46 };
const kReach_px = 28; // points farther from the pointer are ignored

/** The noise of the reference with its value, which may lie outside the chart. */
function noiseText({ referenceNoise: noise }: ChartOfTarget, { y }: Ranges): string {
  const outside = noise !== null && (noise < y[0] || noise > y[1]);
  return `noise of the reference ${short(noise)}${outside ? ", outside the chart" : ""}`;
}

function lineItems(chart: ChartOfTarget, ranges: Ranges, theme: Theme) {
  const { axes, curves } = chart;
  const isFitted = axes.x === "cpu_seconds" && axes.y.name === "relmse";
  const has = (what: boolean, text: string, attributes: Record<string, string | number>) =>
    what ? [lineItem(text, { stroke: theme.quiet, "stroke-width": 1.4, ...attributes })] : [];
  const points = curves.flatMap((one) => one.points);
  const hollow = points.some(({ point }) => point.below_reference_noise);
  return [
    ...has(isFitted && curves.some(({ curve }) => curve.fit), "fit b² + v / tᵖ", {
      stroke: theme.text,
    }),
    ...has(true, "95 % band", { "stroke-width": 12, "stroke-opacity": 0.3 }),
    ...has(true, "frontier: no point is faster and better", {
      stroke: theme.text,
      "stroke-width": 1,
      "stroke-opacity": 0.55,
    }),
    ...has(isFitted && curves.some(({ curve }) => curve.fit?.has_floor), "floor of the bias", {
      "stroke-dasharray": "9 3 2 3",
    }),
    ...has(chart.levels.length > 0, "levels with a time to error", { "stroke-dasharray": "5 4" }),
    ...has(chart.referenceNoise !== null, noiseText(chart, ranges), { "stroke-dasharray": "1 3" }),
    ...(hollow
      ? [
          {
            text: "error within that noise",
            sign: (x: number, y: number) => (
              <Marker
                shape={0}
                x={x + 10}
                y={y}
                size={4.5}
                colour={theme.quiet}
                hollow={theme.panel}
              />
            ),
          },
        ]
      : []),
  ];
}

function Tip({
  study,
  placed,
  scales,
  width,
}: {
  study: CostStudy;
  placed: Placed;
  scales: Scales;
  width: number;
}) {
  const [x, y] = placeOf(scales, placed);
  const side = x > width / 2 ? { right: `${width - x + 14}px` } : { left: `${x + 14}px` };
  const { point, curve } = placed;
  return (
    <div class="point-tip" role="status" style={{ top: `${Math.max(0, y - 60)}px`, ...side }}>
      <b>
        {study.renderers[curve.renderer]?.name}, {point.setting}
      </b>
      <PairList pairs={numbersOf(study, point)} />
      {point.on_frontier ? <p>On the frontier.</p> : null}
      {point.below_reference_noise ? <p>This error is within the noise of the reference.</p> : null}
    </div>
  );
}

interface PointsProps extends Props {
  scales: Scales;
  theme: Theme;
  onHover: (point: Placed | undefined) => void;
}

/** The points as buttons: reachable by Tab, chosen by Enter. */
function Points({ study, chart, chosen, scales, theme, onChoose, onHover }: PointsProps) {
  return (
    <>
      {chart.curves.flatMap(({ points }) =>
        points.map((placed) => {
          const { curve, index, point } = placed;
          const is = chosen?.renderer === curve.renderer && chosen.index === index;
          const name = `${study.renderers[curve.renderer]?.name}, ${point.setting}`;
          const numbers = numbersOf(study, point).map(([label, text]) => `${label} ${text}`);
          return (
            <g
              key={`${curve.renderer} ${index}`}
              class="point"
              data-point={`${curve.renderer}/${index}`}
              role="button"
              tabindex={0}
              aria-pressed={is}
              aria-label={`${name}: ${numbers.join(", ")}. Opens its image.`}
              onFocus={() => onHover(placed)}
              onBlur={() => onHover(undefined)}
              onKeyDown={(event) => {
                if (event.key !== "Enter" && event.key !== " ") return;
                event.preventDefault();
                onChoose(placed);
              }}
            >
              {is ? <Ring placed={placed} scales={scales} theme={theme} /> : null}
              <PointMark placed={placed} scales={scales} theme={theme} size={5} />
            </g>
          );
        }),
      )}
    </>
  );
}

function Ring({ placed, scales, theme }: { placed: Placed; scales: Scales; theme: Theme }) {
  const [x, y] = placeOf(scales, placed);
  return <circle cx={x} cy={y} r={10} fill="none" stroke={theme.text} stroke-width={1.6} />;
}

function nearest(chart: ChartOfTarget, scales: Scales, x: number, y: number): Placed | undefined {
  let best: { placed: Placed; distance: number } | undefined;
  for (const { points } of chart.curves)
    for (const placed of points) {
      const [px, py] = placeOf(scales, placed);
      const distance = Math.hypot(px - x, py - y);
      if (distance < kReach_px && (!best || distance < best.distance)) best = { placed, distance };
    }
  return best?.placed;
}

/** Error against time of one target. Hover or focus says all numbers, a click opens the image. */
export function CostChart(props: Props) {
  const { study, chart, ranges } = props;
  const theme = useTheme();
  const { element, width } = useWidth();
  const [hovered, setHovered] = useState<Placed>();
  const shown = new Set(chart.curves.map(({ curve }) => curve.renderer));
  const renderers = rendererItems(study, theme).filter((_, i) => shown.has(i));
  const lines = lineItems(chart, ranges, theme);
  const room = Math.max(200, width - 16);
  const top = kMargin.top + legendRows(renderers, room).rows * kLegendRow_px + 6;
  const plot = width < 500 ? 270 : 350;
  const box: Box = { left: kMargin.left, right: width - kMargin.right, top, bottom: top + plot };
  const height = box.bottom + kMargin.axis + legendRows(lines, room).rows * kLegendRow_px + 6;
  const scales = scalesOf(ranges, chart.axes, box);
  const parts = { chart, scales, box, theme, small: false };
  const pointAt = (event: MouseEvent & { currentTarget: SVGSVGElement }): Placed | undefined => {
    const own = event.currentTarget.getBoundingClientRect();
    return nearest(chart, scales, event.clientX - own.left, event.clientY - own.top);
  };
  const legend = { x: 8, width: room, theme };
  return (
    <div class="cost-plot" ref={element}>
      {width > 0 ? (
        <svg
          xmlns="http://www.w3.org/2000/svg"
          width={width}
          height={height}
          viewBox={`0 0 ${width} ${height}`}
          font-family="system-ui, sans-serif"
          role="group"
          aria-label={`${titleOf(study, chart.target)}: ${yLabel(chart.axes)}`}
          class={hovered ? "over-point" : undefined}
          onMouseMove={(event) => setHovered(pointAt(event))}
          onMouseLeave={() => setHovered(undefined)}
          onClick={(event) => {
            const placed = pointAt(event);
            if (placed) props.onChoose(placed);
          }}
        >
          <Legend items={renderers} y={kMargin.top} {...legend} />
          <AxesPart {...parts} />
          <LevelsPart {...parts} />
          <FrontierPart {...parts} />
          <CurvesPart {...parts} />
          <Points {...props} scales={scales} theme={theme} onHover={setHovered} />
          <Legend items={lines} y={box.bottom + kMargin.axis} {...legend} />
        </svg>
      ) : null}
      {hovered ? <Tip study={study} placed={hovered} scales={scales} width={width} /> : null}
    </div>
  );
}

export const titleOf = (study: CostStudy, target: number): string => {
  const one = study.targets[target];
  return one ? `${one.requirement} ${one.name}: ${one.title}` : "";
};
