// What src/report writes for the page (orbs-page/2). No metric, map, suite or state is known here by name.

export interface Host {
  name: string;
  cpu: string;
  cores: number;
  governor: string;
  memory_bytes: number;
  system: string;
  distribution: string;
  compiler: string;
  /** Limits of the container, if it has any. */
  cpu_limit_cores?: number;
  memory_limit_bytes?: number;
}

export interface RunInfo {
  name: string;
  suite: string;
  started: string;
  wall_seconds: number;
  orbs_version: string;
  command: string;
  interrupted: boolean;
  finished: boolean;
  live: boolean;
  /** Processes that wanted to run when it started. */
  load: number;
  host: Host;
}

export interface State {
  name: string;
  failure: boolean;
}

export interface Renderer {
  name: string;
  /** Of all its renders: sums, and the largest. */
  wall_seconds: number;
  cpu_seconds: number;
  peak_rss_bytes: number;
  version?: string;
  declared?: string;
  measured?: string;
}

export interface Case {
  name: string;
  suite: string;
  requirement: string;
  title: string;
  tests: string;
  typical_mistake: string;
  /** The smallest error that the gate of the case is known to see, in words. */
  smallest_error_seen?: string;
}

export interface Metric {
  name: string;
  unit: string;
  definition: string;
  lower_is_better: boolean;
  /** Nearer to zero is better. */
  signed?: boolean;
}

/** One number per image of the run; null where there is none. */
export type Column = (number | null)[];

export interface Cells {
  case: number[];
  target: number[];
  renderer: number[];
  state: number[];
  declared: number[];
  reason: number[];
  thumbnail: number[];
  /** Of Overview.machines; null where the times say nothing about one machine. */
  machine: Column;
  wall_seconds: Column;
  cpu_seconds: Column;
  render_seconds: Column;
  peak_rss_bytes: Column;
  spp: Column;
}

export interface ChartPoint {
  x: number;
  y: number;
  low?: number;
  high?: number;
  /** Index of the image that a click opens. */
  cell?: number;
  label?: string;
}

export interface ChartSeries {
  name: string;
  points: ChartPoint[];
  /** Points are joined by a line in the order of x. */
  line?: boolean;
}

export interface Axis {
  label: string;
  log: boolean;
  /** Names of the positions 0, 1, 2, ... of an axis without numbers. */
  ticks?: string[];
}

export interface Chart {
  title: string;
  x: Axis;
  y: Axis;
  series: ChartSeries[];
}

export interface Overview {
  format: string;
  run: RunInfo;
  /** From best to worst, then those of renders that are not done. */
  states: State[];
  renderers: Renderer[];
  left_out: { renderer: string; reason: string }[];
  cases: Case[];
  requirements: { code: string; title: string }[];
  metrics: Metric[];
  /** The metric that most gates look at; "" when no image was measured. */
  main_metric: string;
  targets: string[];
  reasons: string[];
  /** What times depend on: those of two different texts are not compared. */
  machines: string[];
  cells: Cells;
  measures: Record<string, Column>;
  infinite: Record<string, number[]>;
  /** Curves that studies add. */
  charts?: Chart[];
}

export interface Measure extends Metric {
  value: number | null;
  infinite?: boolean;
  /** Ends of its interval. */
  low?: number;
  high?: number;
  /** x0, y0, x1, y1 of the pixels that it is of, where it is not of all. */
  where?: number[];
}

export interface Check {
  what: string;
  passed: boolean;
  reason: string;
  min?: number;
  max?: number;
}

export interface ImageEntry {
  name: string;
  kind: string;
  file: string;
  definition?: string;
  signed?: boolean;
  scale_maximum?: number;
}

/**
 * The record of one render, as job.json holds it. The page names the members that it lays out itself; the list of all
 * members (RenderRecord) shows the others.
 */
export interface Job {
  identity: {
    id: string;
    scene: string;
    spp: number;
    seed: number;
    /** Number of consecutive seeds that share the samples. */
    seeds: number;
  };
  program: { version: string; shell: string; threads: number };
  cost: {
    started: string;
    load: number;
    wall_seconds: number;
    cpu_seconds: number;
    render_seconds?: number;
    peak_rss_bytes: number;
    host?: Host;
  };
  end: { outcome: string; reason: string; exit_code: number; signal: string };
  /** `native_scene` was written by hand for this renderer; "" if the scene was exported. */
  files: { folder: string; native_scene: string; log: string };
  /** The end of the log's text. */
  log: string;
}

/** An effect of light, and the part of the scene that calls for it. */
export interface Effect {
  effect: string;
  /** "material 'copper'" */
  subject: string;
  reason: string;
}

/** The scene rendered otherwise than it calls for. */
export interface EffectCost {
  name: string;
  time_ratio: number;
  /** 0 where nobody knows. */
  error_ratio: number;
  change: string;
}

export interface Scene {
  name: string;
  transport: string;
  called_for: Effect[];
  not_called_for: Effect[];
  effect_costs: EffectCost[];
}

export interface TargetDetail {
  case: string;
  target: string;
  renderer: string;
  requirement: string;
  reason: string;
  reference: string;
  /** What changes no verdict and yet must be known. */
  remarks?: string[];
  measures: Measure[];
  checks: Check[];
  images: ImageEntry[];
  reference_provenance: Record<string, string>;
  jobs: Job[];
  /** Those that its renders show. */
  scenes: Scene[];
  command: string;
}

export interface Progress {
  live: boolean;
  running: string[];
  done: number;
  total: number;
  seconds_left: number | null;
}
