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
import type { Front } from "./use_front";
import { knownStatistics, useStatistics, useWorst } from "./use_counted";
import { usePreviews } from "./use_previews";
import { isRaster, useRasters, type Loaded } from "./use_rasters";
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
  const difference = useDifference(
    isSeen ? result : undefined,
    isSeen ? reference : undefined,
    view.measure,
  );
  const rasters = new Map(files).set(kDifference, difference);
  const rasterOf = (image: ImageEntry | undefined): Raster | undefined => {
    const loaded = image && rasters.get(image.name);
    return isRaster(loaded) ? loaded : undefined;
  };
  const raster = rasterOf(front);
  const worst = useErrors(raster, result, reference, front !== undefined && isMap(front));
  const statistics = useStatistics(raster, undefined);
  const layered = view.layer !== "";
  useStatistics(layered ? result : undefined, undefined);
  useStatistics(layered ? reference : undefined, undefined);
  const rangeFor = (image: ImageEntry): Range | undefined => {
    const own = rasterOf(image);
    if (!own) return undefined;
    // Result and reference of a layer share one scale: a colour means the same value in both.
    const alike = layered && !isMap(image) ? [own, result, reference] : [own];
    const ranges = alike.map((one) => {
      const known = one && knownStatistics(one);
      return known && rangeOf(known, seenChannels(one, view.channel));
    });
    return unionOf(ranges.filter((range) => range !== undefined));
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
    rangeFor,
  };
}
