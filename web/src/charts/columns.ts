import type uPlot from "uplot";
import type { Chart, ChartPoint } from "./from_run";
import { isDrawable } from "./drawable";
import { seriesColour } from "./palette";
import { seriesOfNames } from "./series";

export interface Columns {
  data: uPlot.AlignedData;
  /** The point at each x of each series. */
  points: (ChartPoint | undefined)[][];
  series: uPlot.Series[];
}

/** All series over the union of their x, as uPlot expects them. */
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
  const points: (ChartPoint | undefined)[][] = [[]];
  const places = seriesOfNames(chart.series.map(({ name }) => name));
  placed.forEach((own, s) => {
    const stroke = seriesColour(places[s] ?? s, dark);
    const one = chart.series[s];
    data.push(x.map((at) => own.get(at)?.y ?? null));
    points.push(x.map((at) => own.get(at)));
    series.push({
      label: one?.name ?? "",
      stroke,
      points: { show: true, size: 9, fill: stroke, stroke },
      paths: () => null,
    });
  });
  return { data: data as uPlot.AlignedData, points, series };
}
