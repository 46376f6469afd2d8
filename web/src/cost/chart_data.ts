import { seriesOf } from "../charts/series";
import { errorOf, type TimeName } from "./quantities";
import { rangeOf } from "./scale";
import type { CostCurve, CostMetric, CostPoint, CostStudy } from "../data/generated";
import type { MaybeInterval } from "./quantities";

export interface Axes {
  x: TimeName;
  y: CostMetric;
}

/** A point with both values, and the ends of their intervals where they are known. */
export interface Placed {
  curve: CostCurve;
  /** Of its renderer: its colour and marker. */
  series: number;
  /** Index within the points of the curve. */
  index: number;
  point: CostPoint;
  x: number;
  y: number;
  xEnds: [number, number];
  yEnds: [number, number];
}

export interface ChartOfTarget {
  target: number;
  axes: Axes;
  curves: { curve: CostCurve; series: number; points: Placed[] }[];
  /** Points that no other is both faster and better than, in the order of x. */
  frontier: Placed[];
  /** Levels of the metric to which times are stated. */
  levels: number[];
  referenceNoise: number | null;
}

const endsOf = (interval: MaybeInterval, value: number): [number, number] => [
  interval?.low ?? value,
  interval?.high ?? value,
];

function placedPoints(curve: CostCurve, series: number, { x, y }: Axes): Placed[] {
  return curve.points.flatMap((point, index) => {
    const [time, error] = [point[x], errorOf(point, y.name)];
    if (time?.value == null || error?.value == null) return [];
    if (time.value <= 0 || (y.log && error.value <= 0)) return [];
    return [
      {
        curve,
        series,
        index,
        point,
        x: time.value,
        y: error.value,
        xEnds: endsOf(time, time.value),
        yEnds: endsOf(error, error.value),
      },
    ];
  });
}

/** Pareto frontier for these axes. */
function frontierOf(points: Placed[], lowerIsBetter: boolean): Placed[] {
  const sign = lowerIsBetter ? 1 : -1;
  let best = Infinity;
  return [...points]
    .sort((a, b) => a.x - b.x || sign * (a.y - b.y))
    .filter((point) => {
      if (sign * point.y >= best) return false;
      best = sign * point.y;
      return true;
    });
}

function noiseOf(study: CostStudy, target: number, metric: string): number | null {
  const byName: Record<string, number | undefined> = study.targets[target]?.reference_noise ?? {};
  return byName[metric] ?? null;
}

export function chartOf(study: CostStudy, target: number, axes: Axes): ChartOfTarget {
  const curves = study.curves
    .filter((curve) => curve.target === target)
    .map((curve) => {
      const series = seriesOf(study, curve.renderer);
      const points = placedPoints(curve, series, axes).sort((a, b) => a.x - b.x);
      return { curve, series, points };
    });
  const levels = new Set(
    curves.flatMap(({ curve }) =>
      curve.times_to_error.filter(({ metric }) => metric === axes.y.name).map(({ level }) => level),
    ),
  );
  return {
    target,
    axes,
    curves,
    frontier: frontierOf(
      curves.flatMap(({ points }) => points),
      axes.y.lower_is_better,
    ),
    levels: [...levels].sort((a, b) => a - b),
    referenceNoise: noiseOf(study, target, axes.y.name),
  };
}

export interface Ranges {
  x: [number, number];
  y: [number, number];
}

/** Ranges that hold all points of the charts; undefined if there are none. */
export function rangesOf(charts: ChartOfTarget[]): Ranges | undefined {
  const points = charts.flatMap((chart) => chart.curves.flatMap((one) => one.points));
  const log = charts[0]?.axes.y.log ?? true;
  const x = rangeOf(
    points.map((point) => point.x),
    true,
  );
  const y = rangeOf(
    // An interval that reaches zero has no end on a logarithmic axis.
    points.flatMap((point) => [
      point.y,
      ...point.yEnds.filter((end) => !log || end > point.y / 10),
    ]),
    log,
  );
  return x && y ? { x, y } : undefined;
}

const kSteps = 60;

/** The fitted curve within the measured times; none for axes that the fit does not describe. */
export function fittedCurve({ curve, points }: ChartOfTarget["curves"][number], axes: Axes) {
  const { fit } = curve;
  const [first, last] = [points[0], points[points.length - 1]];
  const fixed = curve.fixed_cpu_seconds?.value ?? 0;
  const [b2, v, p] = [fit?.bias_squared?.value, fit?.variance?.value, fit?.exponent?.value];
  if (axes.x !== "cpu_seconds" || axes.y.name !== "relmse" || !first || !last) return [];
  if (b2 == null || v == null || p == null) return [];
  return Array.from({ length: kSteps + 1 }, (_, i) => {
    const x = first.x * (last.x / first.x) ** (i / kSteps);
    return { x, y: b2 + v / (x - fixed) ** p };
  }).filter(({ x, y }) => x > fixed && y > 0 && Number.isFinite(y));
}

/** The error that no time removes, if the study shows one and the axes can. */
export function floorOf(curve: CostCurve, axes: Axes): number | null {
  if (axes.y.name !== "relmse" || !curve.fit?.has_floor) return null;
  return curve.fit.bias_squared?.value ?? null;
}
