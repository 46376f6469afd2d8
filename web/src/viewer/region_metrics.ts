import { floatsOf, type Raster } from "../data/raster";
import { forPieces, type Region } from "./statistics";

export interface RegionMetrics {
  absolute: number;
  squared: number;
  signed: number;
}

/** Means of the difference of two images in a region that lies within both, in the linear values of the images. */
export async function regionMetrics(
  result: Raster,
  reference: Raster,
  region: Region,
  signal: AbortSignal,
): Promise<RegionMetrics> {
  const sum: RegionMetrics = { absolute: 0, squared: 0, signed: 0 };
  let count = 0;
  const channels = Math.min(3, result.planes.length, reference.planes.length);
  for (let c = 0; c < channels; ++c)
    await forPieces(result, region, signal, (begin, end) => {
      const a = floatsOf(result, c, begin, end);
      const row = Math.floor(begin / result.width);
      const column = begin % result.width;
      const at = row * reference.width + column;
      const b = floatsOf(reference, c, at, at + end - begin);
      for (let i = 0; i < a.length; ++i) {
        const error = (a[i] ?? NaN) - (b[i] ?? NaN);
        sum.absolute += Math.abs(error);
        sum.squared += error * error;
        sum.signed += error;
        ++count;
      }
    });
  return {
    absolute: sum.absolute / count,
    squared: sum.squared / count,
    signed: sum.signed / count,
  };
}
