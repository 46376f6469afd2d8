import { namesOf } from "../common/session";
import type { Overview } from "../data/generated";

/** One value per cell of the run; null if it has none. */
export type Column = (number | null)[];

export interface ChartPoint {
  x: number;
  y: number;
  /** Index of the cell that a click opens. */
  cell?: number;
  label?: string;
}

export interface ChartSeries {
  name: string;
  points: ChartPoint[];
}

export interface Axis {
  label: string;
  log: boolean;
  /** Names of the positions 0, 1, 2, ... of a categorical axis. */
  ticks?: string[];
}

export interface Chart {
  title: string;
  x: Axis;
  y: Axis;
  series: ChartSeries[];
}

/** A quantity of every target that a chart can show. */
export interface Quantity {
  name: string;
  label: string;
  column: Column;
  /** Cells whose value is infinite; JSON has no such number, so the column holds null. */
  infinite: ReadonlySet<number>;
  log: boolean;
}

// A logarithmic axis shows neither negative values nor zeros.
const suitsLog = (column: Column): boolean =>
  column.some((value) => value !== null && value > 0) &&
  !column.some((value) => value !== null && value < 0);

/** Time, memory and samples, then every metric; only quantities that the run has values for. */
export function quantitiesOf(overview: Overview): Quantity[] {
  const { cells, metrics, measures } = overview;
  const memory = cells.peak_rss_bytes.map((value) => (value === null ? null : value / 1e6));
  const cost = (name: string, label: string, column: Column): Quantity => ({
    name,
    label,
    column,
    infinite: new Set(),
    log: suitsLog(column),
  });
  const all: Quantity[] = [
    cost("wall_seconds", "wall time (s)", cells.wall_seconds),
    cost("cpu_seconds", "CPU time (s)", cells.cpu_seconds),
    cost("render_seconds", "renderer's own time (s)", cells.render_seconds),
    cost("peak_rss_bytes", "peak memory (MB)", memory),
    cost("spp", "samples per pixel", cells.spp),
    ...metrics.map((metric) => {
      const column = measures[metric.name] ?? [];
      return {
        name: metric.name,
        label: metric.unit === "1" ? metric.name : `${metric.name} (${metric.unit})`,
        column,
        infinite: new Set(overview.infinite[metric.name]),
        // Values in dB, of which higher is better, are logarithms already.
        log: metric.lower_is_better && !metric.signed && suitsLog(column),
      };
    }),
  ];
  return all.filter(
    ({ column, infinite }) => infinite.size > 0 || column.some((value) => value !== null),
  );
}

const valueOf = ({ column, infinite }: Quantity, cell: number): number | null =>
  infinite.has(cell) ? Infinity : (column[cell] ?? null);

/** Visits each target of each renderer once, even if several cases judge it. */
function eachTarget(
  overview: Overview,
  visit: (cell: number, renderer: number, target: string) => void,
): void {
  const seen = new Set<string>();
  overview.cells.case.forEach((_, cell) => {
    const names = namesOf(overview, cell);
    const key = `${names.renderer}\n${names.target}`;
    if (seen.has(key)) return;
    seen.add(key);
    visit(cell, overview.cells.renderer[cell] ?? -1, names.target);
  });
}

/** One quantity of all targets, with one series per renderer. */
export function chartByTarget(overview: Overview, quantity: Quantity): Chart {
  const ticks: string[] = [];
  const place = new Map<string, number>();
  const series = overview.renderers.map(({ name }) => ({ name, points: [] as ChartPoint[] }));
  eachTarget(overview, (cell, renderer, target) => {
    const y = valueOf(quantity, cell);
    if (y === null) return;
    if (!place.has(target)) {
      place.set(target, ticks.length);
      ticks.push(target);
    }
    // Renderers are placed side by side, so that equal values do not cover each other.
    const shift =
      (renderer - (overview.renderers.length - 1) / 2) *
      (0.5 / Math.max(1, overview.renderers.length));
    series[renderer]?.points.push({ x: (place.get(target) ?? 0) + shift, y, cell, label: target });
  });
  return {
    title: `${quantity.label} of each target`,
    x: { label: "", log: false, ticks },
    y: { label: quantity.label, log: quantity.log },
    series,
  };
}

/** One quantity against another, with one point per target and renderer. */
export function chartOfTwo(overview: Overview, x: Quantity, y: Quantity): Chart {
  const series = overview.renderers.map(({ name }) => ({ name, points: [] as ChartPoint[] }));
  eachTarget(overview, (cell, renderer, target) => {
    const [px, py] = [valueOf(x, cell), valueOf(y, cell)];
    if (px === null || py === null) return;
    series[renderer]?.points.push({ x: px, y: py, cell, label: target });
  });
  return {
    title: `${y.label} against ${x.label}`,
    x: { label: x.label, log: x.log },
    y: { label: y.label, log: y.log },
    series,
  };
}
