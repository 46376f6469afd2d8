import { useEffect, useState } from "preact/hooks";
import type { Raster } from "../data/raster";
import { differingPixels } from "./differing";
import { channelErrors, type ChannelErrors } from "./region_metrics";
import { statisticsOf, type Region, type Statistics } from "./statistics";
import { worstOf, type Worst } from "./worst";

// Images do not change, so that each is counted once.
const statistics = new WeakMap<Raster, Statistics>();
const worsts = new WeakMap<Raster, Map<Raster | undefined, Worst>>();

export const knownStatistics = (raster: Raster): Statistics | undefined => statistics.get(raster);

/** The result of `count`, undefined until then; it is counted again if one of `of` changes. */
function useCounted<T>(
  of: readonly unknown[],
  count: ((signal: AbortSignal) => Promise<T>) | undefined,
): T | undefined {
  const [found, setFound] = useState<{ of: readonly unknown[]; value: T }>();
  useEffect(() => {
    if (!count) return undefined;
    const abort = new AbortController();
    count(abort.signal).then(
      (value) => {
        if (!abort.signal.aborted) setFound({ of, value });
      },
      () => undefined, // aborted: the result is no longer wanted
    );
    return () => abort.abort();
  }, of);
  return found?.of.every((one, i) => one === of[i]) ? found.value : undefined;
}

/** Statistics of an image, or of a region of it. */
export function useStatistics(
  raster: Raster | undefined,
  region: Region | undefined,
): Statistics | undefined {
  const known = raster && !region ? statistics.get(raster) : undefined;
  const count = async (signal: AbortSignal, of: Raster): Promise<Statistics> => {
    const result = await statisticsOf(of, region, signal);
    if (!region) statistics.set(of, result);
    return result;
  };
  const counted = useCounted(
    [raster, region?.join()],
    raster && !known ? (signal) => count(signal, raster) : undefined,
  );
  return known ?? counted;
}

/** The largest errors: of a map itself, or of an image against its reference. */
export function useWorst(
  raster: Raster | undefined,
  reference: Raster | undefined,
): Worst | undefined {
  const known = raster && worsts.get(raster)?.get(reference);
  const count = async (signal: AbortSignal, of: Raster): Promise<Worst> => {
    const worst = await worstOf(of, reference, signal);
    worsts.set(of, (worsts.get(of) ?? new Map<Raster | undefined, Worst>()).set(reference, worst));
    return worst;
  };
  const counted = useCounted(
    [raster, reference],
    raster && !known ? (signal) => count(signal, raster) : undefined,
  );
  return known ?? counted;
}

/** The errors of two images by channel, in a region that lies within both. */
export const useChannelErrors = (
  a: Raster | undefined,
  b: Raster | undefined,
  region: Region,
): ChannelErrors[] | undefined =>
  useCounted(
    [a, b, region.join()],
    a && b ? (signal) => channelErrors(a, b, region, signal) : undefined,
  );

/** How many pixels of two images of one size differ. */
export const useDiffering = (a: Raster | undefined, b: Raster | undefined): number | undefined =>
  useCounted(
    [a, b],
    a && b && a.width === b.width && a.height === b.height
      ? (signal) => differingPixels(a, b, signal)
      : undefined,
  );
