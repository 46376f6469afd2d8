// LDR-FLIP (Andersson et al. 2020) of two linear images, as src/metrics/flip_map.cpp computes it.
import { floatsOf, type Raster } from "../data/raster";

type Plane = Float32Array;
type Kernel = Float32Array; // of odd length, with the centre in the middle

const kPixelsPerDegree = (0.7 * 3840 * Math.PI) / (0.7 * 180); // 67.02
const kEdgeWidth_deg = 0.082;
const [kQc, kPc, kPt] = [0.7, 0.4, 0.95];

// Linear Rec.709 to XYZ over the white of D65, so that white is (1, 1, 1).
const kRows = [
  [10135552, 8788810, 4435075],
  [2613072, 8788810, 887015],
  [1425312, 8788810, 70074185],
].map((row) => row.map((value) => value / row.reduce((sum, one) => sum + one, 0))) as Matrix;

type Vector = [number, number, number];
type Matrix = [Vector, Vector, Vector];

function inverseOf(m: Matrix): Matrix {
  const at = (i: number, j: number): number => m[(i % 3) as 0 | 1 | 2][(j % 3) as 0 | 1 | 2];
  const cofactor = (i: number, j: number): number =>
    at(i + 1, j + 1) * at(i + 2, j + 2) - at(i + 1, j + 2) * at(i + 2, j + 1);
  const determinant =
    at(0, 0) * cofactor(0, 0) + at(0, 1) * cofactor(0, 1) + at(0, 2) * cofactor(0, 2);
  return [0, 1, 2].map((i) => [0, 1, 2].map((j) => cofactor(j, i) / determinant)) as Matrix;
}

const kInverse = inverseOf(kRows);

const times = (m: Matrix, [x, y, z]: Vector): Vector => [
  m[0][0] * x + m[0][1] * y + m[0][2] * z,
  m[1][0] * x + m[1][1] * y + m[1][2] * z,
  m[2][0] * x + m[2][1] * y + m[2][2] * z,
];

const clamped = (value: number): number => Math.min(1, Math.max(0, value));

function labCurve(t: number): number {
  const delta = 6 / 29;
  return t > delta ** 3 ? Math.cbrt(t) : t / (3 * delta * delta) + 4 / 29;
}

/** CIELAB with the chroma scaled by the lightness (Hunt 1977). */
function huntLab(xyz: Vector): Vector {
  const [fx, fy, fz] = xyz.map(labCurve) as Vector;
  const lightness = 116 * fy - 16;
  return [lightness, 5 * lightness * (fx - fy), 2 * lightness * (fy - fz)];
}

const hyab = (a: Vector, b: Vector): number =>
  Math.abs(a[0] - b[0]) + Math.hypot(a[1] - b[1], a[2] - b[2]);

const kMost = hyab(huntLab(times(kRows, [0, 1, 0])), huntLab(times(kRows, [0, 0, 1]))) ** kQc;

function colourError(a: Vector, b: Vector): number {
  const bend = kPc * kMost;
  const distance = hyab(a, b) ** kQc;
  return distance < bend
    ? (distance * kPt) / bend
    : kPt + ((distance - bend) / (kMost - bend)) * (1 - kPt);
}

function kernelOf(radius: number, weight: (i: number) => number): Kernel {
  return Float32Array.from({ length: 2 * radius + 1 }, (_, i) => weight(i - radius));
}

const sumOf = (kernel: Kernel): number => kernel.reduce((sum, one) => sum + one, 0);

/** Section 4.1.2, table 1: the Gaussians of the contrast sensitivity of each channel. */
function sensitivities(): Kernel[][] {
  const radius = Math.ceil(3 * Math.sqrt(0.04 / (2 * Math.PI ** 2)) * kPixelsPerDegree);
  const gaussian = (a: number, b: number): Kernel =>
    kernelOf(
      radius,
      (i) =>
        Math.sqrt(a * Math.sqrt(Math.PI / b)) *
        Math.exp((-(Math.PI ** 2) * (i / kPixelsPerDegree) ** 2) / b),
    );
  return [
    [gaussian(1, 0.0047)],
    [gaussian(1, 0.0053)],
    [gaussian(34.1, 0.04), gaussian(13.5, 0.025)],
  ].map((parts) => {
    const total = parts.reduce((sum, part) => sum + sumOf(part) ** 2, 0);
    return parts.map((part) => part.map((weight) => weight / Math.sqrt(total)));
  });
}

/** Section 4.2: a Gaussian and its first two derivatives. */
function featureKernels(): { blur: Kernel; edge: Kernel; point: Kernel } {
  const sigma = 0.5 * kEdgeWidth_deg * kPixelsPerDegree;
  const radius = Math.ceil(3 * sigma);
  const gaussian = (i: number): number => Math.exp((-i * i) / (2 * sigma * sigma));
  const bySign = (kernel: Kernel): Kernel => {
    const up = sumOf(kernel.filter((weight) => weight > 0));
    const down = -sumOf(kernel.filter((weight) => weight < 0));
    return kernel.map((weight) => weight / (weight > 0 ? up : down));
  };
  const blur = kernelOf(radius, gaussian);
  const sum = sumOf(blur);
  return {
    blur: blur.map((weight) => weight / sum),
    edge: bySign(kernelOf(radius, (i) => -i * gaussian(i))),
    point: bySign(kernelOf(radius, (i) => ((i * i) / (sigma * sigma) - 1) * gaussian(i))),
  };
}

interface Grid {
  width: number;
  height: number;
}

/** Filters along x and then along y; the image goes on as its edge pixels. */
function filtered({ width, height }: Grid, plane: Plane, alongX: Kernel, alongY: Kernel): Plane {
  const pass = (from: Plane, kernel: Kernel, isX: boolean): Plane => {
    const to = new Float32Array(from.length);
    const radius = kernel.length >> 1;
    for (let y = 0; y < height; ++y)
      for (let x = 0; x < width; ++x) {
        let sum = 0;
        for (let k = -radius; k <= radius; ++k) {
          const u = isX ? Math.min(width - 1, Math.max(0, x + k)) : x;
          const v = isX ? y : Math.min(height - 1, Math.max(0, y + k));
          sum += (kernel[k + radius] ?? 0) * (from[v * width + u] ?? 0);
        }
        to[y * width + x] = sum;
      }
    return to;
  };
  return pass(pass(plane, alongX, true), alongY, false);
}

interface Seen {
  /** What the eye still sees, in YCxCz. */
  seen: Plane[];
  edge: Plane;
  point: Plane;
}

/** Lets the browser handle events; throws if the result is no longer wanted. */
async function pause(signal: AbortSignal): Promise<void> {
  await new Promise((resolve) => setTimeout(resolve));
  signal.throwIfAborted();
}

async function seenOf(raster: Raster, signal: AbortSignal): Promise<Seen> {
  const count = raster.width * raster.height;
  const rgb = [0, 1, 2].map((c) => floatsOf(raster, c, 0, count));
  const ycxcz = [0, 1, 2].map(() => new Float32Array(count));
  for (let i = 0; i < count; ++i) {
    const [x, y, z] = times(kRows, rgb.map((plane) => clamped(plane[i] ?? 0)) as Vector);
    [116 * y - 16, 500 * (x - y), 200 * (y - z)].forEach((value, c) => (ycxcz[c]![i] = value));
  }
  const seen: Plane[] = [];
  for (const [c, kernels] of sensitivities().entries()) {
    const sum = new Float32Array(count);
    for (const kernel of kernels) {
      await pause(signal);
      filtered(raster, ycxcz[c]!, kernel, kernel).forEach((value, i) => (sum[i]! += value));
    }
    seen.push(sum);
  }
  const grey = ycxcz[0]!.map((value) => (value + 16) / 116);
  const { blur, edge, point } = featureKernels();
  const strength = async (kernel: Kernel): Promise<Plane> => {
    await pause(signal);
    const across = filtered(raster, grey, kernel, blur);
    const down = filtered(raster, grey, blur, kernel);
    return across.map((value, i) => Math.hypot(value, down[i] ?? 0));
  };
  return { seen, edge: await strength(edge), point: await strength(point) };
}

/** The error of each pixel, 0 to 1. */
export async function flipMap(a: Raster, b: Raster, signal: AbortSignal): Promise<Float32Array> {
  const [one, other] = [await seenOf(a, signal), await seenOf(b, signal)];
  const lab = ({ seen }: Seen, i: number): Vector => {
    const y = ((seen[0]![i] ?? 0) + 16) / 116;
    const xyz: Vector = [y + (seen[1]![i] ?? 0) / 500, y, y - (seen[2]![i] ?? 0) / 200];
    return huntLab(times(kRows, times(kInverse, xyz).map(clamped) as Vector));
  };
  await pause(signal);
  return Float32Array.from({ length: a.width * a.height }, (_, i) => {
    const colour = colourError(lab(one, i), lab(other, i));
    const feature = Math.max(
      Math.abs((one.edge[i] ?? 0) - (other.edge[i] ?? 0)),
      Math.abs((one.point[i] ?? 0) - (other.point[i] ?? 0)),
    );
    return colour ** (1 - Math.sqrt(feature / Math.SQRT2));
  });
}
