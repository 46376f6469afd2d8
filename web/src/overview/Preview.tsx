import { useEffect, useState } from "preact/hooks";
import { bytes, counted, seconds } from "../common/format";
import { goesOnText, namesOf, reasonOf, type Session } from "../common/session";
import type { Overview } from "../data/generated";
import type { Source } from "../data/source";

/** Address of a small picture of the result; undefined if there is none. */
async function previewOf(source: Source, run: number, index: number): Promise<string | undefined> {
  const { images } = await source.target(run, index);
  const result = images.find((image) => image.kind === "result");
  return result && source.preview(run, result.file);
}

export interface Hovered {
  index: number;
  box: DOMRect;
}

/** Samples, time and memory of a cell. */
function costText(overview: Overview, index: number): string {
  const { spp, wall_seconds: wall, peak_rss_bytes: memory } = overview.cells;
  const own = spp[index] ?? null;
  const samples = own === null ? "" : `${counted(own, "sample")} per pixel`;
  const parts = [
    goesOnText(overview, index) || samples,
    seconds(wall[index]),
    bytes(memory[index]),
  ];
  return parts.filter(Boolean).join(" · ");
}

/** The thumbnail, the reason and the cost of the cell under the pointer or the focus. */
export function Preview({ session, hovered }: { session: Session; hovered: Hovered }) {
  const { overview, source, run } = session;
  const { index, box } = hovered;
  const [image, setImage] = useState<string>();
  useEffect(() => {
    let wanted = true;
    setImage(undefined);
    previewOf(source, run, index).then(
      (address) => wanted && setImage(address),
      () => undefined, // the reason of the verdict is shown without it
    );
    return () => void (wanted = false);
  }, [index, run]);
  const names = namesOf(overview, index);
  const width = 300;
  const left = Math.min(Math.max(8, box.left), innerWidth - width - 8);
  const above = box.bottom + 300 > innerHeight && box.top > 300;
  const place = above
    ? { bottom: `${innerHeight - box.top + 6}px` }
    : { top: `${box.bottom + 6}px` };
  return (
    <div
      class="preview"
      style={{ left: `${left}px`, width: `${width}px`, ...place }}
      role="presentation"
    >
      <p>
        <b>{names.target}</b> by {names.renderer}
      </p>
      {image ? <img src={image} alt="" width={256} onError={() => setImage(undefined)} /> : null}
      <p>{reasonOf(overview, index)}</p>
      <p class="quiet">{costText(overview, index)}</p>
    </div>
  );
}
