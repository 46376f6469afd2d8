// How many pixels of two images differ, as the page counts it.
import { floatsOf, type Raster } from "../data/raster";
import { forEachRow } from "./statistics";

const kLargestHalf = 65504;

/** A float rounded to a half, 11 significant bits, the nearest and at a tie the even one; `bits` are its own. */
function toHalf(value: number, bits: number): number {
  const exponent = ((bits >> 23) & 255) - 127;
  const step = 2 ** (Math.max(exponent, -14) - 10);
  const even = 1.5 * 2 ** 52; // doubles of this size are whole numbers
  return (value / step + even - even) * step;
}

/** Whether a channel keeps all its bits in a page of one file: see Rounding of src/report/packed_image.h. */
function staysExact(raster: Raster, channel: number): boolean {
  const plane = raster.planes[channel];
  if (!(plane instanceof Float32Array)) return true; // it is of halves
  return plane.some((value) => Math.abs(value) > kLargestHalf && Math.abs(value) < Infinity);
}

/**
 * The pixels whose first three channels differ. Values count as a page of one file holds them, rounded to
 * halves, so that the number is the same wherever the page comes from.
 */
export async function differingPixels(a: Raster, b: Raster, signal: AbortSignal): Promise<number> {
  const channels = [0, 1, 2].filter((c) => a.planes[c] && b.planes[c]);
  const exact = channels.map((c) => [staysExact(a, c), staysExact(b, c)] as const);
  let count = 0;
  await forEachRow(a, undefined, signal, (begin, end) => {
    const differs = new Uint8Array(end - begin);
    channels.forEach((c, i) => {
      const [keepsA, keepsB] = exact[i] ?? [true, true];
      const [one, other] = [floatsOf(a, c, begin, end), floatsOf(b, c, begin, end)];
      const bits = (of: Float32Array) => new Uint32Array(of.buffer, of.byteOffset, of.length);
      const [bitsOne, bitsOther] = [bits(one), bits(other)];
      for (let x = 0; x < one.length; ++x) {
        const [v, w] = [one[x] ?? NaN, other[x] ?? NaN];
        if (v === w || (Number.isNaN(v) && Number.isNaN(w))) continue;
        const seen = keepsA ? v : toHalf(v, bitsOne[x] ?? 0);
        if (seen !== (keepsB ? w : toHalf(w, bitsOther[x] ?? 0))) differs[x] = 1;
      }
    });
    for (const one of differs) count += one;
  });
  return count;
}
