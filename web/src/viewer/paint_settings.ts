import type { Raster } from "../data/raster";
import type { ImageEntry } from "../data/types";
import { isLuminance, seenChannels } from "./channels";
import type { Range } from "./statistics";
import { kCurves, type ViewState } from "./view_state";

/** What of the view decides how the numbers of one image become colours. */
export interface PaintSettings {
  falseColour: boolean;
  diverging: boolean;
  log: boolean;
  scaleEnd: number;
  /** Indices of the channels that are seen: three of a colour, else one. */
  channels: number[];
  luminance: boolean;
  gain: number;
  offset: number;
  curve: number;
  gamma: number;
}

export const isMap = (image: ImageEntry): boolean => image.kind === "map";

/**
 * Maps, and layers beyond the colour itself, are numbers and get false colours; what holds both signs a diverging scale.
 * `range` is that of the channels that are seen, where it has been counted.
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
