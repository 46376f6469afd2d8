import { floatsOf, type Raster } from "../data/raster";

export interface ChannelStatistics {
  name: string;
  min: number;
  max: number;
  mean: number;
  nan: number;
  infinite: number;
  aboveOne: number;
  belowZero: number;
}

export interface Histogram {
  /** Lower edge of each bin, then the upper edge of the last. */
  edges: number[];
  /** Pixels by channel, then by bin. */
  counts: number[][];
}

export interface Statistics {
  pixels: number;
  channels: ChannelStatistics[];
  histogram: Histogram;
}

export type Region = [number, number, number, number];

/** Whether the region is not empty and lies within the image; links may hold any region. */
export const isWithin = ([x0, y0, x1, y1]: Region, { width, height }: Raster): boolean =>
  0 <= x0 && x0 < x1 && x1 <= width && 0 <= y0 && y0 < y1 && y1 <= height;

export interface Range {
  min: number;
  max: number;
  /** A percentile of the magnitudes, where one was asked for. */
  percentile?: number | undefined;
}

/** Range of the finite values of some channels; undefined if there are none. */
export function rangeOf(statistics: Statistics, channels: number[]): Range | undefined {
  const counted = statistics.channels.filter(
    (one, c) => channels.includes(c) && one.min <= one.max,
  );
  if (counted.length === 0) return undefined;
  return {
    min: Math.min(...counted.map((one) => one.min)),
    max: Math.max(...counted.map((one) => one.max)),
  };
}

const kPixelsAtOnce = 1 << 20; // takes about 10 ms, so that the page stays responsive

/** Lets the browser paint and handle events; throws if the result is no longer wanted. */
async function yieldToBrowser(signal: AbortSignal): Promise<void> {
  await new Promise((resolve) => setTimeout(resolve));
  signal.throwIfAborted();
}

/** Calls `work` with the index range [begin, end) of each row of the region. */
export async function forEachRow(
  raster: Raster,
  region: Region | undefined,
  signal: AbortSignal,
  work: (begin: number, end: number) => void,
): Promise<void> {
  const [x0, y0, x1, y1] = region ?? [0, 0, raster.width, raster.height];
  let since = 0;
  for (let y = y0; y < y1; ++y) {
    work(y * raster.width + x0, y * raster.width + x1);
    since += x1 - x0;
    if (since < kPixelsAtOnce) continue;
    since = 0;
    await yieldToBrowser(signal);
  }
}

// Bins have equal width in asinh: linear around 0, logarithmic beyond, for both signs.
const kLinear = 1e-3;
const squeezed = (v: number): number => Math.asinh(v / kLinear);
const kBins = 160;

async function channelStatistics(
  raster: Raster,
  c: number,
  region: Region | undefined,
  signal: AbortSignal,
): Promise<ChannelStatistics> {
  const out: ChannelStatistics = {
    name: raster.channels[c]?.name ?? "",
    min: Infinity,
    max: -Infinity,
    mean: NaN,
    nan: 0,
    infinite: 0,
    aboveOne: 0,
    belowZero: 0,
  };
  let sum = 0;
  let count = 0;
  await forEachRow(raster, region, signal, (begin, end) => {
    for (const v of floatsOf(raster, c, begin, end)) {
      if (Number.isNaN(v)) ++out.nan;
      else if (v === Infinity || v === -Infinity) ++out.infinite;
      else {
        if (v < out.min) out.min = v;
        if (v > out.max) out.max = v;
        if (v > 1) ++out.aboveOne;
        if (v < 0) ++out.belowZero;
        sum += v;
        ++count;
      }
    }
  });
  out.mean = sum / count;
  return out;
}

/** Statistics of an image, or of a region of it. */
export async function statisticsOf(
  raster: Raster,
  region: Region | undefined,
  signal: AbortSignal,
): Promise<Statistics> {
  const channels: ChannelStatistics[] = [];
  for (let c = 0; c < raster.planes.length; ++c)
    channels.push(await channelStatistics(raster, c, region, signal));
  const low = squeezed(
    Math.min(...channels.map((one) => (Number.isFinite(one.min) ? one.min : 0))),
  );
  const high = squeezed(
    Math.max(...channels.map((one) => (Number.isFinite(one.max) ? one.max : 0))),
  );
  const width = (high - low || 1) / kBins;
  const counts: number[][] = [];
  for (let c = 0; c < raster.planes.length; ++c) {
    const bins = new Array<number>(kBins).fill(0);
    await forEachRow(raster, region, signal, (begin, end) => {
      for (const v of floatsOf(raster, c, begin, end)) {
        if (!Number.isFinite(v)) continue;
        const bin = Math.min(kBins - 1, Math.max(0, Math.floor((squeezed(v) - low) / width)));
        bins[bin] = (bins[bin] ?? 0) + 1;
      }
    });
    counts.push(bins);
  }
  const edges = Array.from({ length: kBins + 1 }, (_, i) => kLinear * Math.sinh(low + i * width));
  const [x0, y0, x1, y1] = region ?? [0, 0, raster.width, raster.height];
  return { pixels: (x1 - x0) * (y1 - y0), channels, histogram: { edges, counts } };
}
