import { useEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import { number } from "../common/format";
import type { Chart, ChartPoint } from "./from_run";
import { columnsOf, type Columns } from "./columns";

interface Props {
  chart: Chart;
  onOpen: (cell: number) => void;
}

function axisOf(axis: Chart["x"], colour: string, line: string, isX: boolean): uPlot.Axis {
  const { ticks } = axis;
  return {
    label: axis.label,
    stroke: colour,
    grid: { stroke: line, width: 1 },
    ticks: { stroke: line, width: 1 },
    size: isX ? (ticks ? 70 : 46) : 70,
    ...(ticks
      ? {
          splits: () => ticks.map((_, i) => i),
          values: (_u: uPlot, splits: number[]) => splits.map((i) => ticks[i] ?? ""),
          rotate: -50,
          gap: 2,
        }
      : {
          values: (_u: uPlot, splits: (number | null)[]) =>
            splits.map((v) => (v === null ? "" : number(v))),
        }),
  };
}

interface Nearest {
  point: ChartPoint;
  /** Index of its series in uPlot; series 0 holds the x. */
  series: number;
}

const kReach_px = 24; // points farther from the pointer are ignored

/** The visible point nearest to the pointer. */
function nearestPoint(plot: uPlot, { points, data }: Columns): Nearest | undefined {
  const { left = -1, top = -1 } = plot.cursor;
  let best: (Nearest & { distance: number }) | undefined;
  points.forEach((column, series) =>
    column.forEach((point, i) => {
      if (!point || !plot.series[series]?.show) return;
      const x = plot.valToPos(data[0][i] ?? 0, "x");
      const distance = Math.hypot(x - left, plot.valToPos(point.y, "y") - top);
      if (distance < kReach_px && (!best || distance < best.distance))
        best = { point, series, distance };
    }),
  );
  return best;
}

const kHeight_px = 380;

function optionsOf(
  chart: Chart,
  { series }: Columns,
  element: HTMLElement,
  onCursor: (plot: uPlot) => void,
): uPlot.Options {
  const style = getComputedStyle(element);
  const line = style.getPropertyValue("--line");
  const { ticks } = chart.x;
  return {
    width: element.clientWidth,
    height: kHeight_px,
    series,
    scales: {
      x: {
        time: false,
        distr: chart.x.log ? 3 : 1,
        ...(ticks ? { range: [-0.5, ticks.length - 0.5] as [number, number] } : {}),
      },
      y: { distr: chart.y.log ? 3 : 1 },
    },
    axes: [axisOf(chart.x, style.color, line, true), axisOf(chart.y, style.color, line, false)],
    legend: {
      live: false,
      show: true,
      markers: { fill: (_u, s) => seriesColourOf(series[s]) },
    },
    cursor: { points: { show: false }, drag: { x: true, y: true, uni: 20 } },
    hooks: { setCursor: [onCursor] },
  };
}

/** A chart of any number of series; its data decides about logarithmic axes. */
export function Plot({ chart, onOpen }: Props) {
  const box = useRef<HTMLDivElement>(null);
  const tip = useRef<HTMLParagraphElement>(null);
  useEffect(() => {
    const element = box.current;
    if (!element) return undefined;
    const columns = columnsOf(chart, matchMedia("(prefers-color-scheme: dark)").matches);
    const showTip = (plot: uPlot): void => {
      const found = nearestPoint(plot, columns);
      if (tip.current)
        tip.current.textContent = found
          ? tipText(chart, columns.series[found.series], found.point)
          : "";
      plot.over.style.cursor = found?.point.cell === undefined ? "" : "pointer";
    };
    const plot = new uPlot(optionsOf(chart, columns, element, showTip), columns.data, element);
    const open = (): void => {
      const cell = nearestPoint(plot, columns)?.point.cell;
      if (cell !== undefined) onOpen(cell);
    };
    plot.over.addEventListener("click", open);
    const observer = new ResizeObserver(() =>
      plot.setSize({ width: element.clientWidth, height: kHeight_px }),
    );
    observer.observe(element);
    return () => {
      observer.disconnect();
      plot.destroy();
    };
  }, [chart]);
  return (
    <>
      <div ref={box} class="plot" />
      <p ref={tip} class="plot-tip quiet" role="status" />
    </>
  );
}

const seriesColourOf = (one: uPlot.Series | undefined): string =>
  typeof one?.stroke === "string" ? one.stroke : "transparent";

function tipText(chart: Chart, series: uPlot.Series | undefined, point: ChartPoint): string {
  const name = typeof series?.label === "string" ? series.label : "";
  const label = point.label ? ` · ${point.label}` : "";
  const x = chart.x.ticks ? "" : `${chart.x.label} ${number(point.x)}, `;
  const y = `${chart.y.label} ${number(point.y)}`;
  const hint = point.cell === undefined ? "" : " · click to open the target";
  return `${name}${label}: ${x}${y}${hint}`;
}
