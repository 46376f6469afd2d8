// stability.json as `orbs stability` writes it (orbs-stability/1).
import type { Host } from "../data/types";

export interface Relation {
  name: string;
  change: string;
  /** Of the magnitudes; "" for a ratio. */
  unit: string;
  is_ladder: boolean;
}

/** One relation at one magnitude, on one scene, by one renderer: indices into the lists of the study. */
export interface Step {
  scene: number;
  renderer: number;
  relation: number;
  magnitude: number;
  outcome: "holds" | "breaks" | "no image" | "inconclusive" | "not applicable";
  reason: string;
  is_bit_equal: boolean;
  mean: number;
  mean_error: number;
  block: number;
  block_error: number;
  /** Mean of the absolute differences of single pixels; absent in older studies. */
  pixels?: number;
  confidence: number;
  /** Folder of images, of a first break or of double precision; "" where there are none. */
  images: string;
}

export interface Cell {
  relation: string;
  renderer: string;
  scenes: number;
  bit_equal: boolean;
  inconclusive: number;
  held_to?: number;
  decades?: number;
  first_break?: { magnitude: number; scene: string; outcome: string; reason: string };
}

export interface StabilityStudy {
  orbs_version: string;
  started: string;
  finished: boolean;
  suite: string;
  settings: { size_px: number; spp: number; seeds: number };
  host: Host;
  renderers: { name: string; version: string }[];
  scenes: { name: string }[];
  relations: Relation[];
  steps: Step[];
  definitions: { name: string; text: string }[];
  matrix: Cell[];
}
