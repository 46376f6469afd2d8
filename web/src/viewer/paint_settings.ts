import type { Raster } from "../data/raster";
import type { ImageEntry } from "../data/source";
import { isLuminance, seenChannels } from "./channels";
import type { Range } from "./statistics";
import { kCurves, type ViewState } from "./view_state";

/** How the values of one image become colours. */
export interface PaintSettings {
  falseColour: boolean;
  diverging: boolean;
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
    ? (image.scale_maximum ?? largest)
    : layered
      ? largest
      : 2 ** -view.exposure;
  return {
    falseColour: numbers || view.curve === "false",
    diverging: image.signed ?? (layered && (range?.min ?? 0) < 0),
    log: view.log,
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
