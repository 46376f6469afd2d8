// Small pictures of a cell for the gallery: result, reference and their difference.
import type { Session } from "../common/session";
import { floatsOf, type Raster } from "../data/raster";
import { scaleBytes } from "../viewer/colour_scales";

/** Addresses of PNGs; absent until they are there, or if there is no such image. */
export interface Pictures {
  result?: string;
  reference?: string;
  difference?: string;
}

const kEnd = 0.2; // of the colour scale, as for the map of |result − reference|

/** |result − reference|, the mean of R, G and B, on the sequential colour scale. */
export function differenceAddress(result: Raster, reference: Raster): string | undefined {
  const { width, height } = result;
  if (width !== reference.width || height !== reference.height) return undefined;
  const count = width * height;
  const sum = new Float32Array(count);
  const planes = Math.min(3, result.planes.length, reference.planes.length);
  for (let c = 0; c < planes; ++c) {
    const [a, b] = [floatsOf(result, c, 0, count), floatsOf(reference, c, 0, count)];
    for (let i = 0; i < count; ++i) sum[i]! += Math.abs((a[i] ?? NaN) - (b[i] ?? NaN)) / planes;
  }
  const scale = scaleBytes("sequential");
  const image = new ImageData(width, height);
  sum.forEach((value, i) => {
    const at = 4 * Math.round(255 * Math.min(1, value / kEnd));
    const isBad = Number.isNaN(value);
    image.data.set(isBad ? [255, 0, 255, 255] : scale.slice(at, at + 4), 4 * i);
  });
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  canvas.getContext("2d")?.putImageData(image, 0, 0);
  return canvas.toDataURL("image/png");
}

// References are shared by renderers, and rows come back into the window.
const kMostKept = 400;
const kept = new Map<string, Pictures>();

function keep(key: string, pictures: Pictures): void {
  kept.set(key, pictures);
  const [oldest] = kept.keys();
  if (kept.size > kMostKept && oldest !== undefined) kept.delete(oldest);
}

/** Calls `onPictures` as they arrive: the small pictures first, then what needs the floats. */
export async function loadPictures(
  { source, run, overview }: Session,
  cell: number,
  signal: AbortSignal,
  onPictures: (pictures: Pictures) => void,
): Promise<void> {
  const { state, spp } = overview.cells;
  const key = `${source.runs[run]} ${cell} ${state[cell]} ${spp[cell]}`;
  const known = kept.get(key);
  if (known) return onPictures(known);
  const pictures: Pictures = {};
  const add = (change: Pictures): void => onPictures({ ...Object.assign(pictures, change) });
  try {
    const { images } = await source.target(run, cell);
    const file = (kind: string) => images.find((image) => image.kind === kind)?.file;
    const [own, right] = [file("result"), file("reference")];
    // The small pictures of all come before the floats of any.
    if (own) add({ result: await source.preview(run, own) });
    if (right) add({ reference: await source.preview(run, right) });
    if (own && right) {
      const floats = [right, own].map((one) => source.raster(run, one, "", signal));
      const [reference, result] = await Promise.all(floats);
      const difference = result && reference ? differenceAddress(result, reference) : undefined;
      if (difference) add({ difference });
    }
    keep(key, pictures);
  } catch {
    // Without an image its place stays empty; the verdict beside it says why there is none.
  }
}
