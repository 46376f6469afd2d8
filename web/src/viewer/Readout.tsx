import { rawFloat } from "../common/format";
import { valueAt } from "../data/raster";
import type { ImageEntry } from "../data/types";
import { isRaster, type Loaded } from "./use_rasters";

/** The raw numbers of all pictures at one pixel. */
export function Readout({ at, images, rasters }: {
  at: { x: number; y: number } | undefined;
  images: ImageEntry[];
  rasters: Map<string, Loaded>;
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
                <th scope="row">{image.name}</th>
                {loaded.channels.slice(0, 4).map((channel, c) => (
                  <td key={channel.name} class="number" title={channel.exact ? channel.name : `${channel.name}, rounded to 11 bits in this file`}>
                    {inside ? (channel.exact ? "" : "≈ ") + rawFloat(valueAt(loaded, c, y * loaded.width + x)) : "–"}
                  </td>
                ))}
              </tr>
            );
          })}
        </tbody>
      </table>
    </section>
  );
}
