import { useEffect, useRef } from "preact/hooks";
import { number } from "../common/format";
import type { ImageEntry } from "../data/source";
import { scaleBytes } from "./colour_scales";
import type { PaintSettings } from "./paint_settings";

const kDecades = 4; // of a logarithmic scale, as in the shader

/** The labels of the scale with their positions, from 0 to 1. */
export function ticksOf({
  diverging,
  log,
  scaleEnd,
}: PaintSettings): { place: number; text: string }[] {
  const positive = log
    ? Array.from({ length: kDecades + 1 }, (_, k) => ({
        t: k / kDecades,
        value: scaleEnd * 10 ** (k - kDecades),
      }))
    : [0, 0.25, 0.5, 0.75, 1].map((t) => ({ t, value: t * scaleEnd }));
  if (!diverging)
    return positive.map(({ t, value }) => ({
      place: t,
      text: (log && t === 0 ? "≤ " : "") + number(value),
    }));
  const half = positive.filter(({ t }) => t === 0 || t === 0.5 || t === 1);
  return [
    ...half
      .filter(({ t }) => t > 0)
      .reverse()
      .map(({ t, value }) => ({ place: 0.5 - t / 2, text: `−${number(value)}` })),
    { place: 0.5, text: log ? "0 ±" : "0" },
    ...half
      .filter(({ t }) => t > 0)
      .map(({ t, value }) => ({ place: 0.5 + t / 2, text: number(value) })),
  ];
}

interface LegendProps {
  image: ImageEntry;
  settings: PaintSettings;
  onEnd: (end: number | undefined) => void;
  onLog: () => void;
}

/** The colour scale of the image in front, with its labels. */
export function Legend({ image, settings, onEnd, onLog }: LegendProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const pen = canvas.current?.getContext("2d");
    if (!pen) return;
    const pixels = pen.createImageData(256, 1);
    pixels.data.set(scaleBytes(settings.diverging));
    pen.putImageData(pixels, 0, 0);
  }, [settings.diverging]);
  return (
    <figure class="legend" aria-label={`Colour scale of ${image.name}`}>
      <canvas ref={canvas} width={256} height={1} />
      <div class="ticks">
        {ticksOf(settings).map(({ place, text }) => (
          <span
            key={place}
            style={{ left: `${place * 100}%` }}
            class={place === 0 ? "first" : place === 1 ? "last" : ""}
          >
            {text}
          </span>
        ))}
      </div>
      <figcaption>
        <span>
          <b>{image.name}</b> <span class="quiet">{image.definition ?? ""}</span>
        </span>
        <span class="scale-buttons">
          <label>
            ends at{" "}
            <input
              type="number"
              step="any"
              min="0"
              value={Number(settings.scaleEnd.toPrecision(4))}
              onChange={(event) =>
                onEnd(
                  event.currentTarget.value === "" ? undefined : Number(event.currentTarget.value),
                )
              }
            />
          </label>
          <button aria-pressed={settings.log} onClick={onLog} title="Linear or logarithmic (L)">
            log
          </button>
        </span>
      </figcaption>
    </figure>
  );
}
