import { namesOf } from "../common/session";
import type { Chart, ChartPoint, Column, Overview } from "../data/types";

/** A quantity of a picture that a chart can show. */
export interface Quantity {
  name: string;
  label: string;
  column: Column;
  log: boolean;
}

/** What each picture cost, then every metric of the run. Only what the run has numbers for. */
export function quantitiesOf(overview: Overview): Quantity[] {
  const { cells, metrics, measures } = overview;
  const memory = cells.peak_rss_bytes.map((value) => (value === null ? null : value / 1e6));
  const all: Quantity[] = [
    { name: "wall_seconds", label: "wall time (s)", column: cells.wall_seconds, log: true },
    { name: "cpu_seconds", label: "CPU time (s)", column: cells.cpu_seconds, log: true },
    { name: "render_seconds", label: "renderer's own time (s)", column: cells.render_seconds, log: true },
    { name: "peak_rss_bytes", label: "peak memory (MB)", column: memory, log: true },
    // Ratios in dB are logarithms already.
    ...metrics.map((metric) => ({ name: metric.name, label: metric.unit === "1" ? metric.name : `${metric.name} (${metric.unit})`,
      column: measures[metric.name] ?? [], log: metric.lower_is_better && !metric.signed })),
  ];
  return all.filter(({ column }) => column.some((value) => value !== null && value > 0));
}

/** Pictures that are the same for several cases are one point. */
function eachPicture(overview: Overview, visit: (cell: number, renderer: number, picture: string) => void): void {
  const seen = new Set<string>();
  overview.cells.case.forEach((_, cell) => {
    const names = namesOf(overview, cell);
    const key = `${names.renderer}\n${names.picture}`;
    if (seen.has(key)) return;
    seen.add(key);
    visit(cell, overview.cells.renderer[cell] ?? -1, names.picture);
  });
}

/** One quantity of all pictures, a series per renderer. */
export function chartByPicture(overview: Overview, quantity: Quantity): Chart {
  const ticks: string[] = [];
  const place = new Map<string, number>();
  const series = overview.renderers.map(({ name }) => ({ name, points: [] as ChartPoint[] }));
  eachPicture(overview, (cell, renderer, picture) => {
    const y = quantity.column[cell];
    if (y === null || y === undefined) return;
    if (!place.has(picture)) {
      place.set(picture, ticks.length);
      ticks.push(picture);
    }
    // Side by side, so that equal values of two renderers are both seen.
    const shift = (renderer - (overview.renderers.length - 1) / 2) * (0.5 / Math.max(1, overview.renderers.length));
    series[renderer]?.points.push({ x: (place.get(picture) ?? 0) + shift, y, cell, label: picture });
  });
  return { title: `${quantity.label} of each picture`, x: { label: "", log: false, ticks }, y: { label: quantity.label, log: quantity.log }, series };
}

/** One quantity against another, a point per picture and renderer. */
export function chartOfTwo(overview: Overview, x: Quantity, y: Quantity): Chart {
  const series = overview.renderers.map(({ name }) => ({ name, points: [] as ChartPoint[] }));
  eachPicture(overview, (cell, renderer, picture) => {
    const [px, py] = [x.column[cell], y.column[cell]];
    if (px === null || px === undefined || py === null || py === undefined) return;
    series[renderer]?.points.push({ x: px, y: py, cell, label: picture });
  });
  return { title: `${y.label} against ${x.label}`, x: { label: x.label, log: x.log }, y: { label: y.label, log: y.log }, series };
}

export const hasPoints = (chart: Chart): boolean => chart.series.some(({ points }) => points.length > 0);
