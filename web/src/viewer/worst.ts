import { floatsOf, type Raster } from "../data/raster";
import { forEachRow } from "./statistics";

export interface WorstPixel {
  x: number;
  y: number;
  error: number;
}

export interface Worst {
  /** The worst pixels of separate spots, at least kApart pixels apart, in descending order. */
  pixels: WorstPixel[];
  /** The tile with the largest mean error: x0, y0, x1, y1, the ends exclusive. */
  tile: [number, number, number, number] | undefined;
}

const kMost = 1000;
const kApart = 8;
const kTile = 32;

/** The largest error of each square of kApart pixels, and its place; 0 where there is none. */
class Spots {
  private readonly columns: number;
  private readonly errors: Float64Array;
  private readonly places: Float64Array;

  constructor(
    private readonly width: number,
    height: number,
  ) {
    this.columns = Math.ceil(width / kApart);
    const count = this.columns * Math.ceil(height / kApart);
    this.errors = new Float64Array(count);
    this.places = new Float64Array(count);
  }

  add(error: number, x: number, y: number): void {
    const at = Math.floor(y / kApart) * this.columns + Math.floor(x / kApart);
    if (error <= (this.errors[at] ?? 0)) return;
    this.errors[at] = error;
    this.places[at] = y * this.width + x;
  }

  /**
   * The largest errors, the largest first, without those that are nearer than kApart to a larger one: what
   * a walk over the worst pixels along one edge would show is one spot.
   */
  apart(): WorstPixel[] {
    const order = [...this.errors.keys()].filter((at) => (this.errors[at] ?? 0) > 0);
    order.sort(
      (a, b) =>
        (this.errors[b] ?? 0) - (this.errors[a] ?? 0) ||
        (this.places[a] ?? 0) - (this.places[b] ?? 0),
    );
    const kept = new Map<number, WorstPixel>(); // by square
    for (const at of order) {
      const place = this.places[at] ?? 0;
      const spot = { x: place % this.width, y: Math.floor(place / this.width) };
      if (this.isNear(kept, at, spot)) continue;
      kept.set(at, { ...spot, error: this.errors[at] ?? 0 });
      if (kept.size === kMost) break;
    }
    return [...kept.values()];
  }

  private isNear(
    kept: Map<number, WorstPixel>,
    at: number,
    { x, y }: { x: number; y: number },
  ): boolean {
    for (const row of [-1, 0, 1])
      for (const column of [-1, 0, 1]) {
        const other = kept.get(at + row * this.columns + column);
        if (other && Math.abs(other.x - x) < kApart && Math.abs(other.y - y) < kApart) return true;
      }
    return false;
  }
}

/**
 * For each pixel, the largest magnitude of its first three channels, or of their difference to the
 * reference.
 */
function errorsOf(
  raster: Raster,
  reference: Raster | undefined,
  begin: number,
  end: number,
): Float32Array {
  const out = new Float32Array(end - begin);
  const planes = Math.min(3, raster.planes.length, reference?.planes.length ?? 3);
  for (let c = 0; c < planes; ++c) {
    const a = floatsOf(raster, c, begin, end);
    const b = reference ? floatsOf(reference, c, begin, end) : undefined;
    for (let i = 0; i < out.length; ++i) {
      const error = Math.abs((a[i] ?? 0) - (b?.[i] ?? 0));
      // NaN in a map means that there is no value; NaN in an image is the worst error.
      if (Number.isNaN(error) ? reference : error > (out[i] ?? 0))
        out[i] = Number.isNaN(error) ? Infinity : error;
    }
  }
  return out;
}

export async function worstOf(
  raster: Raster,
  reference: Raster | undefined,
  signal: AbortSignal,
): Promise<Worst> {
  const spots = new Spots(raster.width, raster.height);
  const columns = Math.ceil(raster.width / kTile);
  const sums = new Float64Array(columns * Math.ceil(raster.height / kTile));
  await forEachRow(raster, undefined, signal, (begin, end) => {
    const errors = errorsOf(raster, reference, begin, end);
    const row = Math.floor(begin / raster.width / kTile) * columns;
    for (let i = 0; i < errors.length; ++i) {
      const error = errors[i] ?? 0;
      if (!(error > 0)) continue;
      const tile = row + Math.floor(((begin + i) % raster.width) / kTile);
      sums[tile] = (sums[tile] ?? 0) + Math.min(error, 1e30);
      spots.add(error, (begin + i) % raster.width, Math.floor((begin + i) / raster.width));
    }
  });
  let best = -1;
  let most = 0;
  for (let tile = 0; tile < sums.length; ++tile) {
    const x = (tile % columns) * kTile;
    const y = Math.floor(tile / columns) * kTile;
    // Tiles at the right and bottom edges are smaller.
    const mean =
      (sums[tile] ?? 0) / (Math.min(kTile, raster.width - x) * Math.min(kTile, raster.height - y));
    if (mean > most) [best, most] = [tile, mean];
  }
  const x = (best % columns) * kTile;
  const y = Math.floor(best / columns) * kTile;
  return {
    pixels: spots.apart(),
    tile:
      best < 0
        ? undefined
        : [x, y, Math.min(x + kTile, raster.width), Math.min(y + kTile, raster.height)],
  };
}
