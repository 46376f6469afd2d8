import type { RefObject } from "preact";
import { useRef } from "preact/hooks";
import { rawFloat } from "../common/format";
import { valueAt, type Raster } from "../data/raster";
import type { ImageEntry } from "../data/source";
import { seenChannels } from "./channels";
import { isRaster, type Loaded } from "./use_rasters";

const kMost = 4; // more columns do not fit

/** The first channels of an image, always with the chosen one. */
function columns(raster: Raster, chosen: string): number[] {
  const all = raster.channels.map((_, c) => c);
  const [seen = 0] = seenChannels(raster, chosen);
  return seen < kMost ? all.slice(0, kMost) : [...all.slice(0, kMost - 1), seen];
}

/** Copies the table of values; where the browser offers no clipboard, selects it. */
function CopyPixel({ table }: { table: RefObject<HTMLTableElement | null> }) {
  const copy = async (): Promise<void> => {
    const rows = [...(table.current?.rows ?? [])].map((row) =>
      [...row.cells].map((cell) => cell.innerText.trim()).join("\t"),
    );
    try {
      await navigator.clipboard.writeText(rows.join("\n"));
    } catch {
      if (table.current) getSelection()?.selectAllChildren(table.current);
    }
  };
  return (
    <button class="copy-pixel" onClick={() => void copy()} title="the values of this pixel">
      Copy values
    </button>
  );
}

interface ReadoutProps {
  at: { x: number; y: number } | undefined;
  images: ImageEntry[];
  rasters: Map<string, Loaded>;
  channel: string;
}

/** The raw values of all images at one pixel. */
export function Readout({ at, images, rasters, channel: chosen }: ReadoutProps) {
  const table = useRef<HTMLTableElement>(null);
  const x = at ? Math.floor(at.x) : -1;
  const y = at ? Math.floor(at.y) : -1;
  return (
    <section class="readout" aria-label="Values of the pixel">
      <h3>Pixel {at ? `${x}, ${y}` : ""}</h3>
      <CopyPixel table={table} />
      <table ref={table}>
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
