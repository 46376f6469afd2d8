import { floatsOf, type Raster } from "../data/raster";
import { forEachRow, type Region } from "./statistics";

/** Mean differences A − B of linear values. */
export interface Errors {
  absolute: number;
  squared: number;
  signed: number;
}

/** Errors of one channel, and the mean of B² there. */
export interface ChannelErrors extends Errors {
  name: string;
  squaredB: number;
}

/** The errors of the first three channels in a region that lies within both images. */
export async function channelErrors(
  a: Raster,
  b: Raster,
  region: Region,
  signal: AbortSignal,
): Promise<ChannelErrors[]> {
  const channels: ChannelErrors[] = [];
  for (let c = 0; c < Math.min(3, a.planes.length, b.planes.length); ++c) {
    const sum = { absolute: 0, squared: 0, signed: 0, squaredB: 0 };
    let count = 0;
    await forEachRow(a, region, signal, (begin, end) => {
      const row = Math.floor(begin / a.width);
      const at = row * b.width + (begin % a.width);
      const [one, other] = [floatsOf(a, c, begin, end), floatsOf(b, c, at, at + end - begin)];
      for (let i = 0; i < one.length; ++i) {
        const value = other[i] ?? NaN;
        const error = (one[i] ?? NaN) - value;
        sum.absolute += Math.abs(error);
        sum.squared += error * error;
        sum.signed += error;
        sum.squaredB += value * value;
        ++count;
      }
    });
    channels.push({
      name: a.channels[c]?.name ?? "",
      absolute: sum.absolute / count,
      squared: sum.squared / count,
      signed: sum.signed / count,
      squaredB: sum.squaredB / count,
    });
  }
  return channels;
}

/** The mean over channels, which have equally many pixels. */
export function meanErrors(channels: ChannelErrors[]): Errors {
  const mean = (of: (one: ChannelErrors) => number): number =>
    channels.reduce((sum, one) => sum + of(one), 0) / channels.length;
  return {
    absolute: mean((one) => one.absolute),
    squared: mean((one) => one.squared),
    signed: mean((one) => one.signed),
  };
}
