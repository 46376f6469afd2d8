import { useEffect, useRef } from "preact/hooks";
import uPlot from "uplot";
import { number } from "../common/format";
import type { Chart, ChartPoint } from "../data/types";
import { isDrawable } from "./drawable";
import { seriesColour } from "./palette";

interface Props {
  chart: Chart;
  onOpen: (cell: number) => void;
}

interface Columns {
  data: uPlot.AlignedData;
  /** By series, then x: the point that stands there. */
  points: (ChartPoint | undefined)[][];
  bands: uPlot.Band[];
  series: uPlot.Series[];
}

/** All series over the union of their x, as uPlot wants them; a band is two series more. */
function columnsOf(chart: Chart, dark: boolean): Columns {
  const kept = chart.series.map((one) => one.points.filter((point) => isDrawable(chart, point)));
  // Two points of one series at the same x must both be seen: x of the second is moved by the least that keeps them apart.
  const xs = new Set<number>();
  const placed = kept.map((points) => {
    const own = new Map<number, ChartPoint>();
    for (const point of [...points].sort((a, b) => a.x - b.x)) {
      let { x } = point;
      while (own.has(x)) x += Math.abs(x) * 1e-9 + 1e-12;
      own.set(x, point);
      xs.add(x);
    }
    return own;
  });
  const x = [...xs].sort((a, b) => a - b);
  const data: (number | null)[][] = [x];
  const series: uPlot.Series[] = [{}];
  const bands: uPlot.Band[] = [];
  const points: (ChartPoint | undefined)[][] = [[]];
  placed.forEach((own, s) => {
    const stroke = seriesColour(s, dark);
    const one = chart.series[s];
    data.push(x.map((at) => own.get(at)?.y ?? null));
    points.push(x.map((at) => own.get(at)));
    series.push({
      label: one?.name ?? "",
      stroke,
      width: 1.5,
      spanGaps: true,
      points: { show: true, size: 9, fill: stroke, stroke },
      ...(one?.line ? {} : { paths: () => null }),
    });
    if (![...own.values()].some((point) => point.low !== undefined && point.high !== undefined))
      return;
    for (const end of ["high", "low"] as const) {
      data.push(x.map((at) => own.get(at)?.[end] ?? null));
      points.push([]);
      series.push({
        label: `${one?.name} ${end}`,
        show: true,
        stroke: "transparent",
        spanGaps: true,
        points: { show: false },
      });
    }
    bands.push({ series: [data.length - 2, data.length - 1], fill: `${stroke}33` });
  });
  return { data: data as uPlot.AlignedData, points, bands, series };
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

/** Chart of any number of series, with log axes, lines and bands where the data asks for them. */
export function Plot({ chart, onOpen }: Props) {
  const box = useRef<HTMLDivElement>(null);
  const tip = useRef<HTMLParagraphElement>(null);
  useEffect(() => {
    const element = box.current;
    if (!element) return undefined;
    const dark = matchMedia("(prefers-color-scheme: dark)").matches;
    const style = getComputedStyle(element);
    const { data, points, bands, series } = columnsOf(chart, dark);
    const nearest = (plot: uPlot): { point: ChartPoint; series: number } | undefined => {
      const { left = -1, top = -1 } = plot.cursor;
      let best: { point: ChartPoint; series: number; distance: number } | undefined;
      points.forEach((column, s) =>
        column.forEach((point, i) => {
          if (!point || !plot.series[s]?.show) return;
          const x = plot.valToPos(data[0][i] ?? 0, "x");
          const distance = Math.hypot(x - left, plot.valToPos(point.y, "y") - top);
          if (distance < 24 && (!best || distance < best.distance))
            best = { point, series: s, distance };
        }),
      );
      return best;
    };
    const { ticks } = chart.x;
    const plot = new uPlot(
      {
        width: element.clientWidth,
        height: 380,
        series,
        bands,
        scales: {
          x: {
            time: false,
            distr: chart.x.log ? 3 : 1,
            ...(ticks ? { range: [-0.5, ticks.length - 0.5] as [number, number] } : {}),
          },
          y: { distr: chart.y.log ? 3 : 1 },
        },
        axes: [
          axisOf(chart.x, style.color, style.getPropertyValue("--line"), true),
          axisOf(chart.y, style.color, style.getPropertyValue("--line"), false),
        ],
        legend: {
          live: false,
          show: true,
          markers: { fill: (_u, s) => seriesColourOf(series[s]) },
        },
        cursor: { points: { show: false }, drag: { x: true, y: true, uni: 20 } },
        hooks: {
          setCursor: [
            (u) => {
              const found = nearest(u);
              if (tip.current)
                tip.current.textContent = found
                  ? tipText(chart, found.series, found.point, series)
                  : "";
              u.over.style.cursor = found?.point.cell === undefined ? "" : "pointer";
            },
          ],
        },
      },
      data,
      element,
    );
    const open = (): void => {
      const cell = nearest(plot)?.point.cell;
      if (cell !== undefined) onOpen(cell);
    };
    plot.over.addEventListener("click", open);
    const observer = new ResizeObserver(() =>
      plot.setSize({ width: element.clientWidth, height: 380 }),
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

function tipText(chart: Chart, s: number, point: ChartPoint, series: uPlot.Series[]): string {
  const name = typeof series[s]?.label === "string" ? series[s]?.label : "";
  const x = chart.x.ticks ? "" : `${chart.x.label} ${number(point.x)}, `;
  return `${name}${point.label ? ` · ${point.label}` : ""}: ${x}${chart.y.label} ${number(point.y)}${point.cell === undefined ? "" : " · click to open the image"}`;
}
