import type { RunComparison } from "../compare/statistics";
import type { Studies } from "../studies";
import type { Editing } from "./edit";
import { embeddedSource } from "./embedded";
import { embeddedStudy } from "./embedded_study";
import type {
  CostChanges,
  ImageFile,
  Overview,
  Progress,
  StudyKind,
  TargetDetail,
} from "./generated";
import type { Raster } from "./raster";
import { servedSource } from "./served";

/** "disconnected" while the browser reconnects, "closed" if the server sends no more updates. */
export type Update = Progress | "disconnected" | "closed";

/** What a folder holds. */
export type Kind = "run" | StudyKind;

/** An image of a target; `run`: the index of the run that holds it, if it is not the one that is shown. */
/** `noise`: its values are in units of the noise of each pixel, and NaN where there is none. */
export type ImageEntry = ImageFile & { run?: number; noise?: boolean };

/** Where the page gets its data from: a server, or the page's own file. */
export interface Source {
  /** Names of the runs and studies; the page opens with the first. */
  runs: string[];
  kinds: Kind[];
  /** Suite and size of each run, "" of a study: only runs of the same are compared. */
  suites: string[];
  /** False for a page in one file, whose data never changes. */
  isServed: boolean;
  /** What the page may write; "off" if it is left out. */
  edit?: Editing;
  overview(run: number): Promise<Overview>;
  target(run: number, index: number): Promise<TargetDetail>;
  /** What `orbs compare-runs` says of two runs, or of one renderer of each. */
  comparison(before: number, after: number, renderers: [string, string]): Promise<RunComparison>;
  /** What it says of two studies of cost; rejects with an Error that says why they cannot be compared. */
  costChanges(before: number, after: number): Promise<CostChanges>;
  /** One layer of an image; rejects with an Error that says why. */
  raster(run: number, file: string, layer: string, signal: AbortSignal): Promise<Raster>;
  /** Address of a small picture of an image, as a display shows it. */
  preview(run: number, file: string): Promise<string>;
  /** A study of that kind as it is now. */
  study<K extends StudyKind>(kind: K, run: number): Promise<Studies[K]>;
  /** Address of an image of a study, ready to be shown; rejects with an Error that says why. */
  picture(run: number, file: string): Promise<string>;
  /** Address of a file of the run; undefined if the source has no files. */
  fileAddress(run: number, file: string): string | undefined;
  /** Reports updates of a live run; the function that is returned stops that. */
  follow(run: number, onUpdate: (update: Update) => void): () => void;
}

export async function openSource(): Promise<Source> {
  if (document.getElementById("orbs-study")) return embeddedStudy();
  return document.getElementById("orbs-overview") ? embeddedSource() : servedSource();
}
