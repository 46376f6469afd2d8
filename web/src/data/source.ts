import { embeddedSource } from "./embedded";
import type { Raster } from "./raster";
import { servedSource } from "./served";
import type { Overview, TargetDetail, Progress } from "./types";

/** "disconnected" while the browser reconnects, "closed" if the server sends no more updates. */
export type Update = Progress | "disconnected" | "closed";

/** Where the page gets its data from: a server, or the page's own file. */
export interface Source {
  /** Names of the runs; the page opens with the first. */
  runs: string[];
  overview(run: number): Promise<Overview>;
  target(run: number, index: number): Promise<TargetDetail>;
  /** One layer of an image; rejects with an Error that says why. */
  raster(run: number, file: string, layer: string, signal: AbortSignal): Promise<Raster>;
  /** Address of the thumbnail of a cell; undefined if it has none. */
  thumbnail(
    run: number,
    index: number,
    target: () => Promise<TargetDetail>,
  ): Promise<string | undefined>;
  /** Address of a file of the run; undefined if the source has no files. */
  fileAddress(run: number, file: string): string | undefined;
  /** Reports updates of a live run; the function that is returned stops that. */
  follow(run: number, onUpdate: (update: Update) => void): () => void;
}

export async function openSource(): Promise<Source> {
  return document.getElementById("orbs-overview") ? embeddedSource() : servedSource();
}
