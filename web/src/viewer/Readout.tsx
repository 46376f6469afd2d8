import { rawFloat } from "../common/format";
import { valueAt, type Raster } from "../data/raster";
import type { ImageEntry } from "../data/types";
import { seenChannels } from "./channels";
import { isRaster, type Loaded } from "./use_rasters";

const kMost = 4; // columns that there is room for

/** The first channels of an image, and the chosen one wherever it stands. */
function columns(raster: Raster, chosen: string): number[] {
  const all = raster.channels.map((_, c) => c);
  const [seen = 0] = seenChannels(raster, chosen);
  return seen < kMost ? all.slice(0, kMost) : [...all.slice(0, kMost - 1), seen];
}

/** The raw numbers of all images at one pixel. */
export function Readout({
  at,
  images,
  rasters,
  channel: chosen,
}: {
  at: { x: number; y: number } | undefined;
  images: ImageEntry[];
  rasters: Map<string, Loaded>;
  channel: string;
}) {
  const x = at ? Math.floor(at.x) : -1;
  const y = at ? Math.floor(at.y) : -1;
  return (
    <section class="readout" aria-label="Numbers of the pixel">
      <h3>Pixel {at ? `${x}, ${y}` : ""}</h3>
      <table>
        <tbody>
          {images.map((image) => {
            const loaded = rasters.get(image.name);
            if (!isRaster(loaded)) return null;
            const inside = at && x >= 0 && y >= 0 && x < loaded.width && y < loaded.height;
            return (
              <tr key={image.name}>
                <th scope="row" title={image.name}>
                  {image.name}
                </th>
                {columns(loaded, chosen).map((c) => {
                  const { name = "", exact = true } = loaded.channels[c] ?? {};
                  return (
                    <td
                      key={c}
                      class="number"
                      title={exact ? name : `${name}, rounded to 11 bits in this file`}
                    >
                      {inside
                        ? (exact ? "" : "≈ ") + rawFloat(valueAt(loaded, c, y * loaded.width + x))
                        : "–"}
                    </td>
                  );
                })}
              </tr>
            );
          })}
        </tbody>
      </table>
    </section>
  );
}
