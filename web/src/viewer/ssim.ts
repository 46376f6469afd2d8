// SSIM (Wang et al. 2004) of two linear images, as src/metrics/ssim.h computes it.
import { encoded } from "../data/display";
import { floatsOf, type Raster } from "../data/raster";
import { forEachRow } from "./statistics";

const kRadius = 5; // 11 x 11 pixels
const kSigma_px = 1.5;
const [kC1, kC2] = [0.01 ** 2, 0.03 ** 2];

/** By the distance from the centre; the window is symmetric and of sum 1. */
function windowWeights(): number[] {
  const weights = Array.from({ length: kRadius + 1 }, (_, i) =>
    Math.exp((-0.5 * i * i) / kSigma_px ** 2),
  );
  const sum = weights.reduce((all, one, i) => all + (i === 0 ? one : 2 * one), 0);
  return weights.map((one) => one / sum);
}

/** The luma of the displayed values. */
function lumaOf(raster: Raster): Float64Array {
  const count = raster.width * raster.height;
  const [red, green, blue] = [0, 1, 2].map((c) => floatsOf(raster, c, 0, count));
  const shown = (plane: Float32Array | undefined, i: number): number =>
    encoded(Math.min(1, Math.max(0, plane?.[i] ?? NaN)));
  return Float64Array.from(
    { length: count },
    (_, i) => 0.2126 * shown(red, i) + 0.7152 * shown(green, i) + 0.0722 * shown(blue, i),
  );
}

/** What SSIM needs of each column: both lumas, their product and the sum of their squares. */
type Moments = [Float64Array, Float64Array, Float64Array, Float64Array];

function filterColumns(
  a: Float64Array,
  b: Float64Array,
  width: number,
  y: number,
  weights: number[],
  [x1, x2, product, squares]: Moments,
): void {
  for (const values of [x1, x2, product, squares]) values.fill(0);
  for (let k = -kRadius; k <= kRadius; ++k) {
    const weight = weights[Math.abs(k)]!;
    for (let x = 0; x < width; ++x) {
      const [p, q] = [a[(y + k) * width + x]!, b[(y + k) * width + x]!];
      x1[x]! += weight * p;
      x2[x]! += weight * q;
      product[x]! += weight * p * q;
      squares[x]! += weight * (p * p + q * q);
    }
  }
}

function indexAt(moments: Moments, weights: number[], x: number): number {
  const [meanA, meanB, product, squares] = moments.map((values) => {
    let sum = weights[0]! * values[x]!;
    for (let k = 1; k <= kRadius; ++k) sum += weights[k]! * (values[x - k]! + values[x + k]!);
    return sum;
  }) as [number, number, number, number];
  const both = meanA * meanA + meanB * meanB;
  return (
    ((2 * meanA * meanB + kC1) * (2 * (product - meanA * meanB) + kC2)) /
    ((both + kC1) * (squares - both + kC2))
  );
}

/** 1 − SSIM of the window around each pixel; NaN in the outer 5 pixels, whose windows leave the image. */
export async function ssimMap(a: Raster, b: Raster, signal: AbortSignal): Promise<Float32Array> {
  const { width, height } = a;
  const map = new Float32Array(width * height).fill(NaN);
  const [one, other, weights] = [lumaOf(a), lumaOf(b), windowWeights()];
  const moments = [0, 1, 2, 3].map(() => new Float64Array(width)) as Moments;
  await forEachRow(a, undefined, signal, (begin) => {
    const y = begin / width;
    if (y < kRadius || y >= height - kRadius) return;
    filterColumns(one, other, width, y, weights, moments);
    for (let x = kRadius; x < width - kRadius; ++x)
      map[begin + x] = 1 - indexAt(moments, weights, x);
  });
  return map;
}
