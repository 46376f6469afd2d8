import { errorOf, kTimes } from "./quantities";
import type { CostStudy } from "../data/generated";
import type { MaybeInterval } from "./quantities";

type Row = (string | number | boolean | null)[];

const heads = (name: string): string[] => [name, `${name}_low`, `${name}_high`];
const cells = (interval: MaybeInterval): (number | null)[] => [
  interval?.value ?? null,
  interval?.low ?? null,
  interval?.high ?? null,
];

/** One row per point of these targets, with all its numbers. */
export function pointRows(study: CostStudy, targets: number[]): Row[] {
  const head: Row = [
    ...["target", "renderer", "setting", "spp", "renders"],
    ...kTimes.flatMap(({ name }) => heads(name)),
    ...heads("trial_seconds"),
    ...heads("fixed_cpu_seconds"),
    ...study.metrics.flatMap(({ name }) => heads(name)),
    ...["below_reference_noise", "on_frontier"],
  ];
  const rows = study.curves
    .filter(({ target }) => targets.includes(target))
    .flatMap((curve) =>
      curve.points.map((point): Row => [
        study.targets[curve.target]?.name ?? "",
        study.renderers[curve.renderer]?.name ?? "",
        point.setting,
        point.spp,
        point.renders,
        ...kTimes.flatMap(({ name }) => cells(point[name])),
        ...cells(point.trial_seconds),
        ...cells(curve.fixed_cpu_seconds),
        ...study.metrics.flatMap(({ name }) => cells(errorOf(point, name))),
        point.below_reference_noise,
        point.on_frontier,
      ]),
    );
  return [head, ...rows];
}

/** One row per target, renderer and level. */
export function timeToErrorRows(study: CostStudy): Row[] {
  const head: Row = [
    "target",
    "renderer",
    "metric",
    "level",
    ...heads("cpu_seconds"),
    "bound",
    "bound_seconds",
  ];
  const rows = study.curves.flatMap((curve) =>
    curve.times_to_error.map((time): Row => [
      study.targets[curve.target]?.name ?? "",
      study.renderers[curve.renderer]?.name ?? "",
      time.metric,
      time.level,
      ...cells(time.cpu_seconds),
      time.bound,
      time.bound_seconds,
    ]),
  );
  return [head, ...rows];
}
