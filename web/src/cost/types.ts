// cost.json as `orbs cost` writes it (orbs-cost/1).
import type { Host } from "../data/types";

/** A number with the ends of its 95 % confidence interval; null where it is not known. */
export interface Interval {
  value: number | null;
  low: number | null;
  high: number | null;
}
export type MaybeInterval = Interval | null;

export interface CostMetric {
  name: string;
  unit: string;
  lower_is_better: boolean;
  log: boolean;
}

export interface CostRenderer {
  name: string;
  version: string;
  ladder: string;
  /** Why its images are biased; "" if they are not. */
  biased: string;
}

export interface CostTarget {
  name: string;
  requirement: string;
  title: string;
  width: number;
  height: number;
  reference: string;
  reference_noise: Record<string, number | null>;
}

/** One rung of a renderer's ladder on one target. */
export interface CostPoint {
  rung: string;
  spp: number | null;
  renders: number;
  cpu_seconds: MaybeInterval;
  wall_seconds: MaybeInterval;
  render_seconds: MaybeInterval;
  errors: Record<string, MaybeInterval>;
  below_reference_noise: boolean;
  on_frontier: boolean;
  image: string;
  exr: string;
}

/** relMSE(t) = bias_squared + variance / t^exponent, t in CPU seconds above the fixed cost. */
export interface Fit {
  bias_squared: MaybeInterval;
  variance: MaybeInterval;
  exponent: MaybeInterval;
  misfit: number;
  has_floor: boolean;
  floor_named: string;
}

/** CPU seconds to a level of a metric. */
export interface Price {
  metric: string;
  level: number;
  cpu_seconds: MaybeInterval;
  note: string;
}

export interface Curve {
  target: number;
  renderer: number;
  fixed_cpu_seconds: MaybeInterval;
  points: CostPoint[];
  fit: Fit | null;
  prices: Price[];
  efficiency: MaybeInterval;
  seconds_per_db: MaybeInterval;
  note: string;
}

/**
 * `time_ratio` is the second renderer's CPU seconds at that level divided by the first's; `verdict`
 * says of the second that it is "cheaper", "dearer", that "no difference shown", or that it is "not
 * comparable". Without a ratio a bound may still decide.
 */
export interface Comparison {
  target: number;
  metric: string;
  level: number;
  first: number;
  second: number;
  time_ratio: MaybeInterval;
  verdict: string;
  note: string;
}

export interface SelfComparison {
  renderer: number;
  target: number;
  pairs: number;
  time_ratio: MaybeInterval;
  error_ratio: MaybeInterval;
  passed: boolean;
  note: string;
}

export interface CostStudy {
  format: string;
  orbs_version: string;
  started: string;
  finished: boolean;
  suite: string;
  size: string;
  settings: {
    target_db: number | null;
    budget_seconds: number | null;
    seeds: number;
    threads: number;
    order_seed: number;
  };
  host: Host;
  load: number | null;
  load_end: number | null;
  definitions: { name: string; text: string }[];
  metrics: CostMetric[];
  renderers: CostRenderer[];
  targets: CostTarget[];
  curves: Curve[];
  comparisons: Comparison[];
  self_comparison: SelfComparison | null;
}
