import type { Raster } from "../data/raster";
import type { ImageEntry } from "../data/types";
import { kCurves, type ViewState } from "./view_state";

/** What of the view decides how the numbers of one picture become colours. */
export interface PaintSettings {
  falseColour: boolean;
  diverging: boolean;
  log: boolean;
  scaleEnd: number;
  channel: number;
  gain: number;
  offset: number;
  curve: number;
  gamma: number;
}

export const isMap = (image: ImageEntry): boolean => image.kind === "map";

/** The channel of that name; -1 for colour, -2 for luminance. A picture without it is shown in colour. */
function channelIndex(raster: Raster | undefined, name: string): number {
  if (name === "luminance") return -2;
  return name === "" || !raster ? -1 : raster.channels.findIndex((channel) => channel.name === name);
}

/**
 * Maps, and layers beyond the colour itself, are numbers and get false colours; what holds both signs a diverging scale.
 * `largest` is the largest magnitude in the picture, where it has been counted.
 */
export function paintSettings(image: ImageEntry, view: ViewState, raster: Raster | undefined,
                              range: { min: number; max: number } | undefined): PaintSettings {
  const layered = !isMap(image) && view.layer !== "";
  const numbers = isMap(image) || layered;
  const largest = range ? Math.max(Math.abs(range.min), Math.abs(range.max)) : 1;
  const usual = isMap(image) ? (image.scale_maximum ?? largest) : layered ? largest : 2 ** -view.exposure;
  return {
    falseColour: numbers || view.curve === "false",
    diverging: image.signed ?? (layered && (range?.min ?? 0) < 0),
    log: view.log,
    scaleEnd: view.ends[image.name] ?? usual,
    channel: channelIndex(raster, view.channel) === -1 && view.curve === "false" && !numbers ? -2 : channelIndex(raster, view.channel),
    gain: 2 ** view.exposure,
    offset: view.offset,
    curve: Math.max(0, Math.min(2, kCurves.indexOf(view.curve))),
    gamma: view.gamma,
  };
}
