// Differences of two images, computed from their values: A − B in several measures.
import { encoded } from "../data/display";
import { floatsOf, type Raster } from "../data/raster";
import type { ImageEntry } from "../data/source";
import { flipMap } from "./flip";
import { ssimMap } from "./ssim";
import { forEachRow } from "./statistics";
import type { Measure } from "./view_state";

interface Kind {
  label: string;
  /** What the values are, with the names of the images for A and B. */
  definition: string;
  signed: boolean;
  /** Fixed, so that maps of different images can be compared. */
  scaleMaximum: number;
}

export const kMeasureKinds: Record<Measure, Kind> = {
  signed: { label: "A − B", definition: "A − B", signed: true, scaleMaximum: 0.2 },
  absolute: { label: "|A − B|", definition: "|A − B|", signed: false, scaleMaximum: 0.2 },
  relative: {
    label: "relative",
    definition: "(A − B) / (|B| + 0.01)",
    signed: true,
    scaleMaximum: 0.5,
  },
  squared: { label: "squared", definition: "(A − B)²", signed: false, scaleMaximum: 0.04 },
  relmse: {
    label: "relMSE",
    definition: "(A − B)² / (B² + 0.01)",
    signed: false,
    scaleMaximum: 0.1,
  },
  smape: {
    label: "SMAPE",
    definition: "2 |A − B| / (|A| + |B| + 0.02)",
    signed: false,
    scaleMaximum: 0.5,
  },
  srgb8: {
    label: "squared, sRGB",
    definition: "squared difference of the clamped, sRGB-encoded values times 255",
    signed: false,
    scaleMaximum: 650.25,
  },
  ssim: {
    label: "1 − SSIM",
    definition:
      "1 − SSIM (Wang et al. 2004) of the window of 11 × 11 px around each pixel, on the luma of the " +
      "clamped, sRGB-encoded values; NaN in the outer 5 px",
    signed: false,
    scaleMaximum: 1,
  },
  flip: {
    label: "FLIP",
    definition: "LDR-FLIP of A and B (Andersson et al. 2020), clamped to [0, 1], 67 px per degree",
    signed: false,
    scaleMaximum: 1,
  },
  noise: {
    label: "(A − B) / σ",
    definition: "(A − B) / σ, where σ² is the variance of A and that of B, which the images state",
    signed: true,
    scaleMaximum: 6,
  },
};

/** The layer of an image that holds the variance of the mean of each of its pixels, by channel. */
export const kVariance = "variance";

export const kDifference = "difference";

/** The entry of the difference among the images; its pixels are computed, not loaded. */
export function differenceEntry(a: string, b: string, measure: Measure): ImageEntry {
  const { definition, signed, scaleMaximum } = kMeasureKinds[measure];
  const where =
    measure in kImageMaps ? "" : ` in each channel${measure === "srgb8" ? "" : "; linear"}`;
  return {
    name: kDifference,
    kind: "map",
    file: "",
    definition: `${definition}${where}; A is ${a}, B is ${b}`,
    signed,
    scale_maximum: scaleMaximum,
    noise: measure === "noise",
  };
}

type ImageMeasure = "flip" | "ssim";

/** Measures that look at the neighbours of a pixel and give one channel. */
const kImageMaps: Record<
  ImageMeasure,
  { channel: string; map: (a: Raster, b: Raster, signal: AbortSignal) => Promise<Float32Array> }
> = {
  flip: { channel: "FLIP", map: flipMap },
  ssim: { channel: "Y", map: ssimMap },
};

const isImageMeasure = (measure: Measure): measure is ImageMeasure => measure in kImageMaps;

const shown = (value: number): number => 255 * encoded(Math.min(1, Math.max(0, value)));

/** The values of A and B, and of their variances where a measure needs them. */
type Formula = (a: number, b: number, varianceA: number, varianceB: number) => number;

/** NaN where there is no noise; infinite where A, B or a variance is no number. */
const overNoise: Formula = (a, b, varianceA, varianceB) => {
  const variance = varianceA + varianceB;
  if (variance === 0) return NaN;
  const value = (a - b) / Math.sqrt(variance);
  return Number.isFinite(value) ? value : Infinity;
};

const kFormulas: Record<Exclude<Measure, ImageMeasure>, Formula> = {
  signed: (a, b) => a - b,
  absolute: (a, b) => Math.abs(a - b),
  relative: (a, b) => (a - b) / (Math.abs(b) + 0.01),
  squared: (a, b) => (a - b) * (a - b),
  relmse: (a, b) => ((a - b) * (a - b)) / (b * b + 0.01),
  smape: (a, b) => (2 * Math.abs(a - b)) / (Math.abs(a) + Math.abs(b) + 0.02),
  srgb8: (a, b) => (shown(a) - shown(b)) ** 2,
  noise: overNoise,
};

/** Variances of two images, of the same channels. */
export interface Variances {
  a: Raster;
  b: Raster;
}

/** Throws an Error with a message if the images cannot be subtracted. Only "noise" needs variances. */
export async function differenceOf(
  a: Raster,
  b: Raster,
  measure: Measure,
  variances: Variances | undefined,
  signal: AbortSignal,
): Promise<Raster> {
  const { width, height } = a;
  if (width !== b.width || height !== b.height)
    throw new Error(
      `there is no difference of ${width} × ${height} and ${b.width} × ${b.height} pixels`,
    );
  const names = a.channels.slice(0, Math.min(3, b.channels.length));
  const exact = [...a.channels, ...b.channels].every((channel) => channel.exact);
  const raster = (planes: Float32Array[], channels: string[]): Raster => ({
    width,
    height,
    layer: "",
    layers: [""],
    channels: channels.map((name) => ({ name, type: "float", exact })),
    attributes: {},
    planes,
  });
  if (isImageMeasure(measure)) {
    const { channel, map } = kImageMaps[measure];
    if (names.length < 3)
      throw new Error(`${kMeasureKinds[measure].label} needs the channels R, G and B`);
    return raster([await map(a, b, signal)], [channel]);
  }
  const planes = await planesOf(a, b, kFormulas[measure], variances, signal);
  return raster(
    planes,
    names.map(({ name }) => name),
  );
}

/** The channels of a formula of the values of A and B. */
async function planesOf(
  a: Raster,
  b: Raster,
  formula: Formula,
  variances: Variances | undefined,
  signal: AbortSignal,
): Promise<Float32Array[]> {
  const count = Math.min(3, a.planes.length, b.planes.length);
  const planes = Array.from({ length: count }, () => new Float32Array(a.width * a.height));
  const none = new Float32Array(0);
  await forEachRow(a, undefined, signal, (begin, end) => {
    planes.forEach((plane, c) => {
      const of = (raster: Raster | undefined) => (raster ? floatsOf(raster, c, begin, end) : none);
      const [one, other] = [of(a), of(b)];
      const [varianceA, varianceB] = [of(variances?.a), of(variances?.b)];
      for (let i = 0; i < one.length; ++i)
        plane[begin + i] = formula(
          one[i] ?? NaN,
          other[i] ?? NaN,
          varianceA[i] ?? NaN,
          varianceB[i] ?? NaN,
        );
    });
  });
  return planes;
}
