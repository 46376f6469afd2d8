import { useEffect, useRef } from "preact/hooks";
import { number } from "../common/format";
import type { ImageEntry } from "../data/source";
import { scaleBytes, scaleOf } from "./colour_scales";
import { isMap, type PaintSettings } from "./paint_settings";
import { ChoiceField } from "./tools";
import { kScaleEnds, type ScaleEnd, type ViewState } from "./view_state";

const kDecades = 4; // of a logarithmic scale, as in the shader

/** The labels of the scale with their positions, from 0 to 1. */
export function ticksOf({
  diverging,
  noise,
  log,
  scaleEnd,
}: PaintSettings): { place: number; text: string }[] {
  if (noise)
    return [-6, -3, 0, 3, 6].map((sixth) => {
      const value = (sixth / 6) * scaleEnd;
      return { place: 0.5 + sixth / 12, text: `${number(value).replace("-", "−")} σ` };
    });
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
  view: ViewState;
  onView: (view: ViewState) => void;
}

/** The view without an end of its own for the scale of an image, or with one, if it is a positive number. */
function withEnd(view: ViewState, name: string, end: number | undefined): ViewState {
  const { [name]: _, ...others } = view.ends;
  return { ...view, ends: end && end > 0 ? { ...others, [name]: end } : others };
}

const kTyped = "typed";

/** What decides where the scale of a map ends. */
function endChoices({ scale_maximum: fixed }: ImageEntry): { value: string; label: string }[] {
  const label = (end: ScaleEnd): string =>
    end === "fixed"
      ? `fixed: ${number(fixed ?? 1)}`
      : end === "100"
        ? "largest pixel"
        : `${end} % of pixels`;
  return kScaleEnds.map((end) => ({ value: end, label: label(end) }));
}

function EndTools({ image, settings, view, onView }: LegendProps) {
  const isTyped = view.ends[image.name] !== undefined;
  const choose = (text: string): void => {
    const scale = kScaleEnds.find((one) => one === text);
    if (scale) onView({ ...withEnd(view, image.name, undefined), scale });
  };
  return (
    <span class="scale-buttons">
      <label>
        ends at{" "}
        <input
          type="number"
          step="any"
          min="0"
          value={Number(settings.scaleEnd.toPrecision(4))}
          onChange={({ currentTarget: { value } }) =>
            onView(withEnd(view, image.name, value === "" ? undefined : Number(value)))
          }
        />
      </label>
      {isMap(image) && !settings.noise ? (
        <ChoiceField
          label="End of the scale"
          title="where the scale ends: at what this share of the pixels does not exceed, or at a fixed number"
          value={isTyped ? kTyped : view.scale}
          choices={[
            ...endChoices(image),
            ...(isTyped ? [{ value: kTyped, label: "as typed" }] : []),
          ]}
          onChange={choose}
        />
      ) : null}
      {settings.noise ? null : (
        <button
          aria-pressed={settings.log}
          onClick={() => onView({ ...view, log: !view.log })}
          title="Linear or logarithmic (L)"
        >
          log
        </button>
      )}
    </span>
  );
}

/** The colour scale of an image, with its labels. */
export function Legend(props: LegendProps) {
  const { image, settings } = props;
  const canvas = useRef<HTMLCanvasElement>(null);
  const scale = scaleOf(settings);
  useEffect(() => {
    const pen = canvas.current?.getContext("2d");
    if (!pen) return;
    const pixels = pen.createImageData(256, 1);
    pixels.data.set(scaleBytes(scale));
    pen.putImageData(pixels, 0, 0);
  }, [scale]);
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
          {settings.noise ? <NoiseMeaning /> : null}
        </span>
        <EndTools {...props} />
      </figcaption>
    </figure>
  );
}

// P(|z| > 3) of the normal distribution is 0.0027.
const NoiseMeaning = () => (
  <span class="noise-meaning">
    <b>3</b>: noise alone does this in 1 of 370 pixels of a channel, in more after few samples.{" "}
    <span class="no-noise" aria-hidden="true" /> hatched: no noise is stated there.
  </span>
);
