import { number, seconds } from "../common/format";
import type { CostMetric, CostPoint, CostStudy, Interval, TimeToError } from "../data/generated";

/** Null where the study does not know the number. */
export type MaybeInterval = Interval | null;

export type TimeName = "cpu_seconds" | "wall_seconds" | "render_seconds";

export const kTimes: { name: TimeName; label: string }[] = [
  { name: "cpu_seconds", label: "CPU seconds" },
  { name: "wall_seconds", label: "wall seconds" },
  { name: "render_seconds", label: "render seconds (renderer's own)" },
];

const kMetricNames: Record<string, string> = {
  relmse: "relMSE",
  mse: "MSE",
  flip: "FLIP",
  psnr_srgb8: "PSNR",
};

export const metricName = (name: string): string => kMetricNames[name] ?? name;

/** "35 dB", "relMSE 0.001". */
export function levelText(study: CostStudy, metric: string, level: number): string {
  const unit = study.metrics.find(({ name }) => name === metric)?.unit ?? "";
  return unit ? `${level} ${unit}` : `${metricName(metric)} ${number(level)}`;
}

export const metricOf = (study: CostStudy, name: string | undefined): CostMetric | undefined =>
  study.metrics.find((metric) => metric.name === name) ??
  study.metrics.find((metric) => metric.name === "relmse") ??
  study.metrics[0];

export function errorOf({ errors }: CostPoint, metric: string): MaybeInterval {
  const byName: Record<string, MaybeInterval> = errors;
  return byName[metric] ?? null;
}

/** What the study knows of a time to error that it does not know exactly. */
export function boundText(
  { bound, bound_seconds: bound_s }: TimeToError,
  isMeasured: boolean,
): string {
  if (bound === "at least") return `not reached in ${seconds(bound_s)}`;
  if (bound === "at most") return `the first point reaches it: at most ${seconds(bound_s)}`;
  return isMeasured ? "too short to be told from the fixed cost" : "not measured";
}

/** Three significant digits: more than an interval of four seeds can carry. */
export function short(value: number | null): string {
  if (value === null) return "–";
  const size = Math.abs(value);
  if (value === 0 || (size >= 1e-3 && size < 1e5)) return String(Number(value.toPrecision(3)));
  return Number(value.toPrecision(3)).toExponential();
}

/** The value with its ends: "0.12 (0.10–0.14)". */
export function withEnds(
  interval: MaybeInterval,
  text: (value: number | null) => string = short,
): string {
  if (!interval || interval.value === null) return "–";
  const { value, low, high } = interval;
  // One render has no interval.
  return low === null || high === null || low === high
    ? text(value)
    : `${text(value)} (${text(low)} to ${text(high)})`;
}

/** "× 2.4 (2.2 to 2.6)" */
export const ratioText = (interval: MaybeInterval): string =>
  interval?.value == null ? "–" : `× ${withEnds(interval)}`;

/** Every number of a point, as the hover and the panel beside the chart show it. */
export function numbersOf(study: CostStudy, point: CostPoint): [string, string][] {
  return [
    ["CPU", withEnds(point.cpu_seconds, seconds)],
    ["wall", withEnds(point.wall_seconds, seconds)],
    ["render", withEnds(point.render_seconds, seconds)],
    ["trials in it", withEnds(point.trial_seconds, seconds)],
    ...study.metrics.map(({ name, unit }): [string, string] => [
      metricName(name),
      `${withEnds(errorOf(point, name))}${unit ? ` ${unit}` : ""}`,
    ]),
    ["renders", String(point.renders)],
  ];
}
