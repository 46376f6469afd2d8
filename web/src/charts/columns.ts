import type uPlot from "uplot";
import type { Chart, ChartPoint } from "../data/types";
import { isDrawable } from "./drawable";
import { seriesColour } from "./palette";

export interface Columns {
  data: uPlot.AlignedData;
  /** The point at each x of each series. */
  points: (ChartPoint | undefined)[][];
  bands: uPlot.Band[];
  series: uPlot.Series[];
}

/** All series over the union of their x, as uPlot expects them; a band adds two series. */
export function columnsOf(chart: Chart, dark: boolean): Columns {
  const kept = chart.series.map((one) => one.points.filter((point) => isDrawable(chart, point)));
  // uPlot takes one point per x and series: a second one is shifted by an invisible amount.
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
