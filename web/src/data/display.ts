import { floatsOf, type Raster } from "./raster";

/** Display-encoded value of 0 to 1, IEC 61966-2-1. */
export const encoded = (linear: number): number =>
  linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;

/** The image as a display shows it, as the address of a PNG; NaN is magenta. */
export function pngAddress(raster: Raster): string {
  const { width, height, channels } = raster;
  const planes = ["R", "G", "B"].map((name) =>
    floatsOf(
      raster,
      channels.findIndex((channel) => channel.name === name),
      0,
      width * height,
    ),
  );
  const image = new ImageData(width, height);
  for (let i = 0; i < width * height; ++i) {
    const colour = planes.map((plane) => plane[i] ?? NaN);
    const shown = colour.some(Number.isNaN)
      ? [255, 0, 255]
      : colour.map((value) => 255 * encoded(Math.min(1, Math.max(0, value))));
    image.data.set([...shown.map(Math.round), 255], 4 * i);
  }
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  canvas.getContext("2d")?.putImageData(image, 0, 0);
  return canvas.toDataURL("image/png");
}
