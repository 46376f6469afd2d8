import { useEffect, useRef, useState } from "preact/hooks";
import { messageOf } from "../common/message";
import type { Raster } from "../data/raster";
import type { ImageEntry } from "../data/source";
import type { ImageHome } from "./extra_images";

export type Loaded = Raster | { problem: string } | undefined;

export const isRaster = (loaded: Loaded): loaded is Raster =>
  loaded !== undefined && "planes" in loaded;

/** The images that are `wanted`, by name; each is requested when it is first wanted. */
export function useRasters(
  { source, run }: ImageHome,
  images: ImageEntry[],
  wanted: string[],
  layer: string,
): Map<string, Loaded> {
  const [loaded, setLoaded] = useState(new Map<string, Loaded>());
  const requested = useRef(new Set<string>());
  const abort = useRef(new AbortController());
  const key = images.map((image) => `${image.run ?? run} ${image.file}`).join("\n");
  useEffect(() => {
    abort.current = new AbortController();
    requested.current = new Set();
    setLoaded(new Map());
    return () => abort.current.abort();
  }, [source, run, key, layer]);
  useEffect(() => {
    const { signal } = abort.current;
    for (const image of images) {
      if (!image.file || !wanted.includes(image.name) || requested.current.has(image.name))
        continue;
      requested.current.add(image.name);
      const put = (value: Loaded): void => {
        if (!signal.aborted) setLoaded((old) => new Map(old).set(image.name, value));
      };
      // A map has no layers, whichever layer is chosen for the images.
      const own = image.kind === "map" ? "" : layer;
      source
        .raster(image.run ?? run, image.file, own, signal)
        .then(put, (error: unknown) => put({ problem: `${image.name}: ${messageOf(error)}` }));
    }
  }, [source, run, key, layer, wanted.join("\n")]);
  return loaded;
}
