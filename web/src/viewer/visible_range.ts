import { valueAt, type Raster } from "../data/raster";
import { placed, type Size } from "./geometry";
import type { Range, Region } from "./statistics";
import type { ViewState } from "./view_state";

/** The pixels of the image that a pane of this size shows, at least one. */
export function visiblePixels(view: ViewState, pane: Size, image: Size): Region {
  const { zoom, x, y } = placed(view, pane, image);
  const span = (middle: number, room: number, size: number): [number, number] => {
    const begin = Math.min(size - 1, Math.max(0, Math.floor(middle - room / 2 / zoom)));
    const end = Math.max(begin + 1, Math.min(size, Math.ceil(middle + room / 2 / zoom)));
    return [begin, end];
  };
  const [x0, x1] = span(x, pane.width, image.width);
  const [y0, y1] = span(y, pane.height, image.height);
  return [x0, y0, x1, y1];
}

/**
 * The magnitude that `percent` of the pixels do not exceed; that of a pixel is the largest of these channels,
 * as the painter shows it. Where it is 0, the largest one: errors that lie in few pixels are seen as well.
 * Undefined if no pixel has a magnitude above 0. Of more than 262,144 pixels it looks at a regular grid.
 */
export function percentileOfPixels(
  raster: Raster,
  channels: number[],
  percent: number,
): number | undefined {
  const { width, height } = raster;
  const step = Math.max(1, Math.ceil(Math.sqrt((width * height) / kMostPixels)));
  const values = new Float32Array(Math.ceil(width / step) * Math.ceil(height / step));
  let count = 0;
  for (let y = 0; y < height; y += step)
    for (let x = 0; x < width; x += step) {
      let largest = -1;
      for (const channel of channels) {
        const size = Math.abs(valueAt(raster, channel, y * width + x));
        if (size < Infinity && size > largest) largest = size;
      }
      if (largest >= 0) values[count++] = largest;
    }
  const sorted = values.subarray(0, count).sort();
  const rank = Math.max(0, Math.ceil((percent / 100) * count) - 1);
  return sorted[rank] || sorted[count - 1] || undefined;
}

const kMostPixels = 1 << 18; // sorted in about 50 ms

/**
 * The range of the finite values of these channels without the smallest and the largest of them:
 * `percent` of the values lie at or below the maximum, and as many at or above the minimum. Of more
 * than 262,144 pixels it looks at a regular grid. Undefined if there is no finite value.
 */
export function percentileRange(
  raster: Raster,
  channels: number[],
  [x0, y0, x1, y1]: Region,
  percent: number,
): Range | undefined {
  const step = Math.max(1, Math.ceil(Math.sqrt(((x1 - x0) * (y1 - y0)) / kMostPixels)));
  const values: number[] = [];
  for (const channel of channels)
    for (let y = y0; y < y1; y += step)
      for (let x = x0; x < x1; x += step) {
        const value = valueAt(raster, channel, y * raster.width + x);
        if (Number.isFinite(value)) values.push(value);
      }
  if (values.length === 0) return undefined;
  const sorted = Float32Array.from(values).sort();
  const rank = Math.max(0, Math.ceil((percent / 100) * sorted.length) - 1);
  return { min: sorted[sorted.length - 1 - rank]!, max: sorted[rank]! };
}
