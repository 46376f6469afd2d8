import { embeddedSource } from "./embedded";
import type { Raster } from "./raster";
import { servedSource } from "./served";
import type { Overview, TargetDetail, Progress } from "./types";

/** "lost" while the server is waited for, "silent" when it will tell nothing more. */
export type News = Progress | "lost" | "silent";

/** Where the page gets its data from: a server, or the file that it is itself. */
export interface Source {
  /** Names of the runs that are there, the first to open with. */
  runs: string[];
  overview(run: number): Promise<Overview>;
  target(run: number, index: number): Promise<TargetDetail>;
  /** One layer of an image; fails with an Error that says why. */
  raster(run: number, file: string, layer: string, signal: AbortSignal): Promise<Raster>;
  /** Address of the small image of a cell, undefined when there is none. */
  thumbnail(
    run: number,
    index: number,
    target: () => Promise<TargetDetail>,
  ): Promise<string | undefined>;
  /** Address of a file of the run, undefined where it cannot be had. */
  fileAddress(run: number, file: string): string | undefined;
  /** Tells the news of a run that goes on; returns what ends that. */
  follow(run: number, onNews: (news: News) => void): () => void;
}

export async function openSource(): Promise<Source> {
  return document.getElementById("orbs-overview") ? embeddedSource() : servedSource();
}
