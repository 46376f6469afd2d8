import { useEffect, useState } from "preact/hooks";
import type { Raster } from "../data/raster";
import { statisticsOf, type Region, type Statistics } from "./statistics";
import { worstOf, type Worst } from "./worst";

// Counting a picture again would give the same.
const statistics = new WeakMap<Raster, Statistics>();
const worsts = new WeakMap<Raster, Map<Raster | undefined, Worst>>();

export const knownStatistics = (raster: Raster): Statistics | undefined => statistics.get(raster);

/** Statistics of a picture, or of a region of it, as soon as they are counted. */
export function useStatistics(raster: Raster | undefined, region: Region | undefined): Statistics | undefined {
  const [found, setFound] = useState<{ raster: Raster; region: string; statistics: Statistics }>();
  const key = region?.join(",") ?? "";
  useEffect(() => {
    if (!raster || (!region && statistics.has(raster))) return undefined;
    const abort = new AbortController();
    statisticsOf(raster, region, abort.signal).then(
      (result) => {
        if (!region) statistics.set(raster, result);
        setFound({ raster, region: key, statistics: result });
      },
      () => undefined, // nobody waits any more
    );
    return () => abort.abort();
  }, [raster, key]);
  if (!raster) return undefined;
  if (!region && statistics.has(raster)) return statistics.get(raster);
  return found && found.raster === raster && found.region === key ? found.statistics : undefined;
}

/** Where the errors are largest: of a map itself, or of a picture against its reference. */
export function useWorst(raster: Raster | undefined, reference: Raster | undefined): Worst | undefined {
  const [, redraw] = useState(0);
  const known = raster && worsts.get(raster)?.get(reference);
  useEffect(() => {
    if (!raster || known) return undefined;
    const abort = new AbortController();
    worstOf(raster, reference, abort.signal).then(
      (worst) => {
        const all = worsts.get(raster) ?? new Map<Raster | undefined, Worst>();
        worsts.set(raster, all.set(reference, worst));
        redraw((n) => n + 1);
      },
      () => undefined, // nobody waits any more
    );
    return () => abort.abort();
  }, [raster, reference, known]);
  return known;
}
