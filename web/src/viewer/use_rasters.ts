import { useEffect, useRef, useState } from "preact/hooks";
import { reasonOf } from "../common/answer";
import type { Session } from "../common/session";
import type { Raster } from "../data/raster";
import type { ImageEntry } from "../data/types";

export type Loaded = Raster | { problem: string } | undefined;

export const isRaster = (loaded: Loaded): loaded is Raster =>
  loaded !== undefined && "planes" in loaded;

/** The images among `images` that are `wanted`, each loaded when it is wanted first. */
export function useRasters(
  session: Session,
  images: ImageEntry[],
  wanted: string[],
  layer: string,
): Map<string, Loaded> {
  const [loaded, setLoaded] = useState(new Map<string, Loaded>());
  const asked = useRef(new Set<string>());
  const abort = useRef(new AbortController());
  const { source, run } = session;
  const key = images.map((image) => image.file).join("\n");
  useEffect(() => {
    abort.current = new AbortController();
    asked.current = new Set();
    setLoaded(new Map());
    return () => abort.current.abort();
  }, [source, run, key, layer]);
  useEffect(() => {
    const { signal } = abort.current;
    for (const image of images) {
      if (!wanted.includes(image.name) || asked.current.has(image.name)) continue;
      asked.current.add(image.name);
      const put = (value: Loaded): void => {
        if (!signal.aborted) setLoaded((old) => new Map(old).set(image.name, value));
      };
      // Only images have layers; a map has one, whatever is chosen.
      const own = image.kind === "map" ? "" : layer;
      source
        .raster(run, image.file, own, signal)
        .then(put, (error: unknown) => put({ problem: `${image.name}: ${reasonOf(error)}` }));
    }
  }, [source, run, key, layer, wanted.join("\n")]);
  return loaded;
}
