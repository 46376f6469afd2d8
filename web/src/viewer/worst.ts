import { floatsOf, type Raster } from "../data/raster";
import { forPieces } from "./statistics";

export interface WorstPixel {
  x: number;
  y: number;
  error: number;
}

export interface Worst {
  /** The largest errors, the largest first. */
  pixels: WorstPixel[];
  /** Pixels with any error. */
  count: number;
  /** The tile whose mean error is largest: x0, y0, x1, y1. */
  tile: [number, number, number, number] | undefined;
}

const kMost = 1000;
const kTile = 32;

/** The kMost largest of many: a heap with the smallest of them on top. */
class Largest {
  private readonly errors = new Float64Array(kMost);
  private readonly places = new Float64Array(kMost);
  private size = 0;

  get least(): number {
    return this.size < kMost ? -Infinity : (this.errors[0] ?? 0);
  }

  add(error: number, place: number): void {
    if (this.size < kMost) {
      let at = this.size++;
      for (
        let parent = (at - 1) >> 1;
        at > 0 && (this.errors[parent] ?? 0) > error;
        parent = (at - 1) >> 1
      ) {
        this.move(parent, at);
        at = parent;
      }
      this.put(at, error, place);
      return;
    }
    let at = 0;
    for (;;) {
      let child = 2 * at + 1;
      if (child >= this.size) break;
      if (child + 1 < this.size && (this.errors[child + 1] ?? 0) < (this.errors[child] ?? 0))
        ++child;
      if ((this.errors[child] ?? 0) >= error) break;
      this.move(child, at);
      at = child;
    }
    this.put(at, error, place);
  }

  sorted(): { error: number; place: number }[] {
    return Array.from({ length: this.size }, (_, i) => ({
      error: this.errors[i] ?? 0,
      place: this.places[i] ?? 0,
    })).sort((a, b) => b.error - a.error || a.place - b.place);
  }

  private move(from: number, to: number): void {
    this.put(to, this.errors[from] ?? 0, this.places[from] ?? 0);
  }
  private put(at: number, error: number, place: number): void {
    this.errors[at] = error;
    this.places[at] = place;
  }
}

/** Largest |number| of a pixel: of a map itself, or of the difference to `reference`. What is not a number is worst. */
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
      // NaN in a map means that there is no value, in an image that the number is wrong.
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
  const largest = new Largest();
  const columns = Math.ceil(raster.width / kTile);
  const sums = new Float64Array(columns * Math.ceil(raster.height / kTile));
  let count = 0;
  await forPieces(raster, undefined, signal, (begin, end) => {
    const errors = errorsOf(raster, reference, begin, end);
    const row = Math.floor(begin / raster.width / kTile) * columns;
    for (let i = 0; i < errors.length; ++i) {
      const error = errors[i] ?? 0;
      if (!(error > 0)) continue;
      ++count;
      const tile = row + Math.floor(((begin + i) % raster.width) / kTile);
      sums[tile] = (sums[tile] ?? 0) + Math.min(error, 1e30);
      if (error > largest.least) largest.add(error, begin + i);
    }
  });
  let best = -1;
  let most = 0;
  for (let tile = 0; tile < sums.length; ++tile) {
    const x = (tile % columns) * kTile;
    const y = Math.floor(tile / columns) * kTile;
    // Tiles at the edges are smaller.
    const mean =
      (sums[tile] ?? 0) / (Math.min(kTile, raster.width - x) * Math.min(kTile, raster.height - y));
    if (mean > most) [best, most] = [tile, mean];
  }
  const x = (best % columns) * kTile;
  const y = Math.floor(best / columns) * kTile;
  return {
    pixels: largest.sorted().map(({ error, place }) => ({
      x: place % raster.width,
      y: Math.floor(place / raster.width),
      error,
    })),
    count,
    tile:
      best < 0
        ? undefined
        : [x, y, Math.min(x + kTile, raster.width), Math.min(y + kTile, raster.height)],
  };
}
