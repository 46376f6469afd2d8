// The variances of the two compared images, to divide their difference by its noise.
import type { Raster } from "../data/raster";
import type { ImageEntry } from "../data/source";
import { kVariance, type Variances } from "./difference";
import type { ImageHome } from "./extra_images";
import type { Pair } from "./use_front";
import { isRaster, useRasters } from "./use_rasters";

/** Why the difference of two images cannot be divided by its noise; "" if it can, as far as is known. */
export function lackOfNoise(
  { source }: ImageHome,
  pair: Pair,
  layer: string,
  a: Raster | undefined,
  b: Raster | undefined,
): string {
  if (layer !== "") return "only colour has variances";
  const without = [
    ...(a && !a.layers.includes(kVariance) ? [pair.a] : []),
    ...(b && !b.layers.includes(kVariance) ? [pair.b] : []),
  ];
  if (without.length > 0) return `no variance is stated by ${without.join(" and ")}`;
  return source.isServed ? "" : "this file holds no variances; 'orbs serve' has them";
}

/** The variances once they are loaded, where they are `wanted`. */
export function useVariances(
  home: ImageHome,
  images: ImageEntry[],
  pair: Pair,
  wanted: boolean,
): Variances | { problem: string } | undefined {
  const files = useRasters(home, images, wanted ? [pair.a, pair.b] : [], kVariance);
  const [a, b] = [files.get(pair.a), files.get(pair.b)];
  for (const one of [a, b]) if (one && !isRaster(one)) return one;
  return isRaster(a) && isRaster(b) ? { a, b } : undefined;
}
