import type { Raster } from "../data/raster";
import type { ImageEntry } from "../data/source";
import { isLuminance, seenChannels } from "./channels";
import type { Range } from "./statistics";
import { kCurves, type ViewState } from "./view_state";

/** How the values of one image become colours. */
export interface PaintSettings {
  falseColour: boolean;
  diverging: boolean;
  /** In units of the noise: a scale of its own, and NaN means that there is no noise. */
  noise: boolean;
  log: boolean;
  scaleEnd: number;
  /** Indices of the channels that are shown: three for colour, otherwise one. */
  channels: number[];
  luminance: boolean;
  gain: number;
  offset: number;
  curve: number;
  gamma: number;
}

export const isMap = (image: ImageEntry): boolean => image.kind === "map";

/** The end of the scale of a map; a measure in units of the noise means the same in all images. */
function mapEnd(image: ImageEntry, view: ViewState, range: Range | undefined, largest: number) {
  const fixed = image.scale_maximum ?? largest;
  return view.scale === "fixed" || image.noise ? fixed : (range?.percentile ?? fixed);
}

/**
 * The settings of an image in a view. Maps and layers other than colour are shown in false colour,
 * with a diverging scale if they hold both signs. `range` is the range of the channels that are
 * shown; undefined until it is counted.
 */
export function paintSettings(
  image: ImageEntry,
  view: ViewState,
  raster: Raster | undefined,
  range: Range | undefined,
): PaintSettings {
  const layered = !isMap(image) && view.layer !== "";
  const numbers = isMap(image) || layered;
  const largest = range ? Math.max(Math.abs(range.min), Math.abs(range.max)) : 1;
  const usual = isMap(image)
    ? mapEnd(image, view, range, largest)
    : layered
      ? largest
      : 2 ** -view.exposure;
  return {
    falseColour: numbers || view.curve === "false",
    diverging: image.signed ?? (layered && (range?.min ?? 0) < 0),
    noise: image.noise ?? false,
    log: view.log && !image.noise,
    scaleEnd: view.ends[image.name] ?? usual,
    channels: raster ? seenChannels(raster, view.channel) : [],
    luminance:
      raster !== undefined &&
      (isLuminance(raster, view.channel) || (view.curve === "false" && !numbers)),
    gain: 2 ** view.exposure,
    offset: view.offset,
    curve: Math.max(0, Math.min(2, kCurves.indexOf(view.curve))),
    gamma: view.gamma,
  };
}
