import { useRef } from "preact/hooks";
import type { Raster } from "../data/raster";
import type { ImageEntry } from "../data/source";
import { seenChannels } from "./channels";
import type { Size } from "./geometry";
import { isMap } from "./paint_settings";
import { kDifference } from "./difference";
import type { ImageHome } from "./extra_images";
import { rangeOf, type Range, type Statistics } from "./statistics";
import { useDifference } from "./use_difference";
import type { Front, Pair } from "./use_front";
import { knownStatistics, useDiffering, useStatistics, useWorst } from "./use_counted";
import { usePreviews } from "./use_previews";
import { percentileOfPixels } from "./visible_range";
import { isRaster, useRasters, type Loaded } from "./use_rasters";
import { lackOfNoise, useVariances } from "./use_variances";
import type { ViewState } from "./view_state";
import type { Worst } from "./worst";

/** The pixels of the images of a target, and what is counted from them. */
export interface LoadedImages {
  rasters: Map<string, Loaded>;
  /** What stands in for visible images until their pixels are there, by name. */
  previews: Map<string, Raster>;
  /** The image in front, once it is loaded. */
  raster: Raster | undefined;
  /** Size of the images; a guess until one of them is loaded. */
  size: Size;
  layers: string[];
  /** Statistics of the image in front. */
  statistics: Statistics | undefined;
  worst: Worst | undefined;
  /** How many pixels of A and B differ. */
  differing: number | undefined;
  /** Why the difference cannot be divided by its noise; "" if it can. */
  lackOfNoise: string;
  /** Range of an image in the channels that are seen; undefined until it is loaded and counted. */
  rangeFor: (image: ImageEntry) => Range | undefined;
}

function unionOf(ranges: Range[]): Range | undefined {
  if (ranges.length === 0) return undefined;
  return {
    min: Math.min(...ranges.map((one) => one.min)),
    max: Math.max(...ranges.map((one) => one.max)),
  };
}

// Images do not change, so that each percentile is counted once.
const percentiles = new WeakMap<Raster, Map<string, number | undefined>>();

/** The percentile at which the scale of a map ends. */
function mapPercentile(raster: Raster, view: ViewState): number | undefined {
  if (view.scale === "fixed") return undefined;
  const channels = seenChannels(raster, view.channel);
  const key = `${view.scale} ${channels.join()}`;
  const known = percentiles.get(raster) ?? new Map<string, number | undefined>();
  percentiles.set(raster, known);
  if (!known.has(key)) known.set(key, percentileOfPixels(raster, channels, Number(view.scale)));
  return known.get(key);
}

/** The range of images in the channels that are seen; undefined until one of them is counted. */
function rangeOfAll(images: (Raster | undefined)[], channel: string): Range | undefined {
  const ranges = images.map((one) => {
    const known = one && knownStatistics(one);
    return known && rangeOf(known, seenChannels(one, channel));
  });
  return unionOf(ranges.filter((range) => range !== undefined));
}

/** The largest errors: of a map itself, otherwise of a result and a reference of equal size. */
function useErrors(
  map: Raster | undefined,
  result: Raster | undefined,
  reference: Raster | undefined,
  isMapInFront: boolean,
): Worst | undefined {
  const sameSize =
    result && reference && result.width === reference.width && result.height === reference.height;
  return useWorst(
    isMapInFront ? map : sameSize ? result : undefined,
    isMapInFront ? undefined : reference,
  );
}

interface PairToShow {
  home: ImageHome;
  images: ImageEntry[];
  view: ViewState;
  pair: Pair;
  /** Whether the difference is on the stage. */
  isSeen: boolean;
}

/** The difference of A and B, and why it cannot be divided by its noise. */
function usePairDifference(
  { home, images, view, pair, isSeen }: PairToShow,
  a: Raster | undefined,
  b: Raster | undefined,
): { difference: Loaded; lack: string } {
  const lack = lackOfNoise(home, pair, view.layer, a, b);
  const isOverNoise = isSeen && view.measure === "noise";
  const variances = useVariances(home, images, pair, isOverNoise && lack === "");
  const difference = useDifference(
    isSeen ? a : undefined,
    isSeen ? b : undefined,
    view.measure,
    isOverNoise && lack ? { problem: `${kDifference}: ${lack}` } : variances,
  );
  return { difference, lack };
}

/** Loads the images that are visible, the result and the reference, and counts them. */
export function useLoadedImages(
  home: ImageHome,
  images: ImageEntry[],
  view: ViewState,
  { front, visible, pair }: Front,
): LoadedImages {
  const last = useRef(new Map<string, Loaded>());
  const missing = visible.filter(({ name }) => last.current.get(name) === undefined);
  const previews = usePreviews(home, missing, view.layer);
  const wanted = previews.settled ? [pair.a, pair.b, ...visible.map(({ name }) => name)] : [];
  const files = useRasters(home, images, [...new Set(wanted)], view.layer);
  last.current = files;
  const loadedAs = (name: string): Raster | undefined => {
    const loaded = files.get(name);
    return isRaster(loaded) ? loaded : undefined;
  };
  const [result, reference] = [loadedAs(pair.a), loadedAs(pair.b)];
  const isSeen = visible.some(({ name }) => name === kDifference);
  const { difference, lack } = usePairDifference(
    { home, images, view, pair, isSeen },
    result,
    reference,
  );
  const rasters = new Map(files).set(kDifference, difference);
  const rasterOf = (image: ImageEntry | undefined): Raster | undefined => {
    const loaded = image && rasters.get(image.name);
    return isRaster(loaded) ? loaded : undefined;
  };
  const raster = rasterOf(front);
  const worst = useErrors(raster, result, reference, front !== undefined && isMap(front));
  const differing = useDiffering(result, reference);
  const statistics = useStatistics(raster, undefined);
  const layered = view.layer !== "";
  useStatistics(layered ? result : undefined, undefined);
  useStatistics(layered ? reference : undefined, undefined);
  const rangeFor = (image: ImageEntry): Range | undefined => {
    const own = rasterOf(image);
    if (!own) return undefined;
    // Result and reference of a layer share one scale: a colour means the same value in both.
    const alike = layered && !isMap(image) ? [own, result, reference] : [own];
    const union = rangeOfAll(alike, view.channel);
    if (!isMap(image)) return union;
    return { ...(union ?? { min: -1, max: 1 }), percentile: mapPercentile(own, view) };
  };
  const known = raster ?? reference ?? result;
  const preview = front && previews.rasters.get(front.name);
  // A preview tells the shape; how many pixels the image has follows with the floats.
  const size = known ?? preview ?? { width: 512, height: 512 };
  const waiting = [...previews.rasters].filter(([name]) => files.get(name) === undefined);
  const shownPreviews = new Map(known || view.zoom === 0 ? waiting : []);
  const layers = (result ?? reference)?.layers ?? [""];
  return {
    rasters,
    previews: shownPreviews,
    raster,
    size,
    layers,
    statistics,
    worst,
    differing,
    lackOfNoise: lack,
    rangeFor,
  };
}
