import type { Raster } from "../data/raster";

const kLuminance = "luminance";

/** What of an image can be shown: "" is its colour, or the first channel of an image that has no three. */
export function channelChoices(raster: Raster | undefined): { value: string; label: string }[] {
  const names = raster?.channels.map(({ name }) => name) ?? [];
  const each = names.map((name) => ({ value: name, label: name }));
  if (names.length >= 3)
    return [
      { value: "", label: names.slice(0, 3).join("") },
      ...each,
      { value: kLuminance, label: kLuminance },
    ];
  return [{ value: "", label: names[0] ?? "RGB" }, ...each.slice(1)];
}

/** The choice that is in force: an image that has no such channel is shown as if nothing was chosen. */
export const channelInForce = (raster: Raster | undefined, chosen: string): string =>
  channelChoices(raster).some(({ value }) => value === chosen) ? chosen : "";

/** Indices of the channels that are seen: three of a colour, else one. */
export function seenChannels(raster: Raster, chosen: string): number[] {
  const at = raster.channels.findIndex(({ name }) => name === chosen);
  if (at >= 0) return [at];
  return raster.channels.length < 3 ? [0] : [0, 1, 2];
}

export const isLuminance = (raster: Raster, chosen: string): boolean =>
  chosen === kLuminance && seenChannels(raster, chosen).length === 3;
