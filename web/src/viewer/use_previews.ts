// Small PNGs of a server, shown until the floats of the images are there.
import { useEffect, useRef, useState } from "preact/hooks";
import type { Raster } from "../data/raster";
import type { ImageEntry } from "../data/source";
import type { ImageHome } from "./extra_images";

const linear = (code: number): number => {
  const value = code / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
};
const kLinear = Float32Array.from({ length: 256 }, (_, code) => linear(code));

/** The pixels of a PNG as linear values; rejects if it cannot be loaded. */
async function rasterOfPng(address: string): Promise<Raster> {
  const image = new Image();
  image.src = address;
  await image.decode();
  const { naturalWidth: width, naturalHeight: height } = image;
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width, height];
  const pen = canvas.getContext("2d");
  if (!pen) throw new Error("this browser has no 2D canvas");
  pen.drawImage(image, 0, 0);
  const { data } = pen.getImageData(0, 0, width, height);
  const channels = ["R", "G", "B"];
  const planes = channels.map((_, c) =>
    Float32Array.from({ length: width * height }, (_, i) => kLinear[data[4 * i + c] ?? 0] ?? 0),
  );
  return {
    width,
    height,
    layer: "",
    layers: [""],
    channels: channels.map((name) => ({ name, type: "float", exact: false })),
    attributes: {},
    planes,
  };
}

export interface Previews {
  /** By the name of the image. */
  rasters: Map<string, Raster>;
  /** False until each of the images has its preview, or is known to have none: floats come after. */
  settled: boolean;
}

/** Previews of images whose floats are missing. A page in one file has none: its floats are at hand. */
export function usePreviews(
  { source, run }: ImageHome,
  missing: ImageEntry[],
  layer: string,
): Previews {
  const [found, setFound] = useState(new Map<string, Raster | undefined>());
  const requested = useRef(new Set<string>());
  const keyOf = (image: ImageEntry): string => `${image.run ?? run} ${image.file}`;
  const files =
    source.isServed && layer === ""
      ? missing.filter((image) => image.file !== "" && image.kind !== "map")
      : [];
  const key = files.map(keyOf).join("\n");
  useEffect(() => {
    for (const image of files) {
      const own = keyOf(image);
      if (requested.current.has(own)) continue;
      requested.current.add(own);
      const put = (raster: Raster | undefined): void =>
        setFound((old) => new Map(old).set(own, raster));
      source
        .preview(image.run ?? run, image.file)
        .then(rasterOfPng)
        // An image without R, G and B, or a very large one, has no preview.
        .then(put, () => put(undefined));
    }
  }, [source, key]);
  const rasters = new Map<string, Raster>();
  for (const image of files) {
    const raster = found.get(keyOf(image));
    if (raster) rasters.set(image.name, raster);
  }
  return { rasters, settled: files.every((image) => found.has(keyOf(image))) };
}
