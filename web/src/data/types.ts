// The page data that src/report writes (orbs-page/2). The page knows no metric, map, suite or state
// by name.

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
  /** Width and height of the images, as a share of the scenes': "1", "1/4". */
  size: string;
  started: string;
  wall_seconds: number;
  orbs_version: string;
  command: string;
  interrupted: boolean;
  finished: boolean;
  live: boolean;
  /** Load average of the machine at the start of the run. */
  load: number;
  host: Host;
}

export interface State {
  name: string;
  failure: boolean;
}

export interface Renderer {
  name: string;
  /** Sums over all its renders; the memory is the largest of them. */
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
  /** The smallest error that the gate of the case is known to detect, in words. */
  smallest_error_seen?: string;
}

export interface Metric {
  name: string;
  unit: string;
  definition: string;
  lower_is_better: boolean;
  /** Closer to zero is better. */
  signed?: boolean;
}

/** One value per cell of the run; null if it has none. */
export type Column = (number | null)[];

export interface Cells {
  case: number[];
  target: number[];
  renderer: number[];
  state: number[];
  declared: number[];
  reason: number[];
  thumbnail: number[];
  /** Index into Overview.machines; null if the times are not of a single machine. */
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

export interface Overview {
  format: string;
  run: RunInfo;
  /** Verdicts from best to worst, then the states of renders that are not done. */
  states: State[];
  renderers: Renderer[];
  left_out: { renderer: string; reason: string }[];
  cases: Case[];
  requirements: { code: string; title: string }[];
  metrics: Metric[];
  /** The metric of most gates; "" if no target was measured. */
  main_metric: string;
  targets: string[];
  reasons: string[];
  /** Descriptions of the machines; times of two different machines are not compared. */
  machines: string[];
  cells: Cells;
  measures: Record<string, Column>;
  infinite: Record<string, number[]>;
}

export interface Measure extends Metric {
  value: number | null;
  infinite?: boolean;
  /** Ends of the confidence interval. */
  low?: number;
  high?: number;
  /** x0, y0, x1, y1 of the pixels that the value covers, if not all. */
  where?: number[];
}

export interface Check {
  what: string;
  passed: boolean;
  /** False if the size of the run does not allow it; the verdict then does not rest on it. */
  measured?: boolean;
  /** False if noise does not let it be told whether it is met. */
  decided?: boolean;
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
  /** Index of the run that holds the file, if it is not the one that is shown. */
  run?: number;
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

/** The cost of rendering the scene with another transport than it calls for. */
export interface EffectCost {
  name: string;
  time_ratio: number;
  /** 0 if it is unknown. */
  error_ratio: number;
  change: string;
}

export interface Scene {
  name: string;
  transport: string;
  /** The requirements that the scene calls for, in ORB.S notation; "" from older runs. */
  features: string;
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
  /** Facts that change no verdict but that the reader must know. */
  remarks?: string[];
  /** The usual fault that explains a failure, or that none does; "" if none was tried. */
  diagnosis?: string;
  /** Which errors its noise hides; absent where that is nothing worth a word. */
  hidden?: string;
  measures: Measure[];
  checks: Check[];
  images: ImageEntry[];
  reference_provenance: Record<string, string>;
  jobs: Job[];
  /** The scenes of its renders. */
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
