import { number } from "../common/format";
import type { Action } from "../common/keys";
import { toWorst, zoomTo, type Controls } from "./controls";
import { kCurves, type ViewState } from "./view_state";
import type { Worst } from "./worst";

const curveNames: Record<(typeof kCurves)[number], string> = {
  srgb: "sRGB",
  gamma: "gamma",
  linear: "linear",
  false: "false colour",
};

function ImageTabs({ controls: c }: { controls: Controls }) {
  const tick = (name: string): void => {
    const ticked = c.ticked.includes(name)
      ? c.ticked.filter((one) => one !== name)
      : [...c.ticked, name];
    c.setView({ ...c.view, ticked });
  };
  return (
    <div class="tabs" role="group" aria-label="Image">
      {c.images.map((image, i) => (
        <span class="tab" key={image.name}>
          <button
            aria-pressed={c.front?.name === image.name}
            title={`${image.definition ?? image.name} (${i + 1})`}
            onClick={() => {
              c.setBlinking(false);
              c.setView({ ...c.view, image: image.name });
            }}
          >
            {i < 9 ? <kbd>{i + 1}</kbd> : null} {image.name}
          </button>
          <input
            type="checkbox"
            checked={c.ticked.includes(image.name)}
            onChange={() => tick(image.name)}
            aria-label={`${image.name} in blink and side by side`}
            title="in blink and side by side"
          />
        </span>
      ))}
    </div>
  );
}

function NumberField({
  label,
  value,
  step,
  onChange,
}: {
  label: string;
  value: number;
  step: number;
  onChange: (value: number) => void;
}) {
  return (
    <label class="field">
      {label}
      <input
        type="number"
        step={step}
        value={Number(value.toFixed(3))}
        onChange={(event) =>
          Number.isFinite(event.currentTarget.valueAsNumber) &&
          onChange(event.currentTarget.valueAsNumber)
        }
      />
    </label>
  );
}

/** Only the worst of many pixels can be visited. */
function worstText({ pixels, count }: Worst, index: number, error: number): string {
  const all = count > pixels.length ? `the ${pixels.length} worst` : String(count);
  return `${index + 1} of ${all}: ${number(error, error === Infinity)}`;
}

/** A button for every key of the viewer. */
export function Toolbar({ controls: c, actions }: { controls: Controls; actions: Action[] }) {
  const { view, setView } = c;
  const set = (change: Partial<ViewState>): void => setView({ ...view, ...change });
  const button = (key: string, text: string, pressed?: boolean) => {
    const action = actions.find((one) => one.key === key);
    return (
      <button
        onClick={action?.run}
        aria-pressed={pressed}
        title={`${action?.label ?? text} (${action?.keyName ?? key})`}
      >
        {text}
      </button>
    );
  };
  const worst = c.worst?.pixels[c.worstIndex];
  const counted = c.worst
    ? `${c.worst.count} ${c.worst.count === 1 ? "pixel differs" : "pixels differ"}`
    : "";
  return (
    <div class="toolbar">
      <ImageTabs controls={c} />
      <div class="tools">
        <span class="group" role="group" aria-label="Arrangement">
          <button
            aria-pressed={view.mode === "flip"}
            onClick={() => set({ mode: "flip" })}
            title="one image at a time (m)"
          >
            Flip
          </button>
          {button("s", "Swipe", view.mode === "swipe")}
          <button
            aria-pressed={view.mode === "side"}
            onClick={() => set({ mode: "side" })}
            title="the ticked images side by side (m)"
          >
            Side by side
          </button>
          {button(" ", "Blink", c.blinking)}
        </span>
        <span class="group" role="group" aria-label="Zoom">
          {button("f", "Fit", view.zoom === 0)}
          <button
            aria-pressed={view.zoom === 1}
            onClick={() => zoomTo(c, 1)}
            title="one to one (0)"
          >
            1:1
          </button>
          {button("-", "−")}
          {button("+", "+")}
        </span>
        <span class="group" role="group" aria-label="How numbers look">
          <NumberField
            label="EV"
            value={view.exposure}
            step={0.5}
            onChange={(exposure) => set({ exposure })}
          />
          <NumberField
            label="offset"
            value={view.offset}
            step={0.05}
            onChange={(offset) => set({ offset })}
          />
          <label class="field">
            <span class="unseen">Curve</span>
            <select
              value={view.curve}
              title="sRGB, gamma, linear, false colour (g)"
              onChange={(event) =>
                set({ curve: kCurves.find((one) => one === event.currentTarget.value) ?? "srgb" })
              }
            >
              {kCurves.map((curve) => (
                <option key={curve} value={curve}>
                  {curveNames[curve]}
                </option>
              ))}
            </select>
          </label>
          {view.curve === "gamma" ? (
            <NumberField
              label="γ"
              value={view.gamma}
              step={0.1}
              onChange={(gamma) => set({ gamma: Math.max(0.1, gamma) })}
            />
          ) : null}
          <label class="field">
            <span class="unseen">Channel</span>
            <select
              value={c.channel}
              title="channel (x)"
              onChange={(event) => set({ channel: event.currentTarget.value })}
            >
              {c.channels.map(({ value, label }) => (
                <option key={value} value={value}>
                  {label}
                </option>
              ))}
            </select>
          </label>
          {c.layers.length > 1 ? (
            <label class="field">
              <span class="unseen">Layer</span>
              <select
                value={view.layer}
                title="layer of the image"
                onChange={(event) => set({ layer: event.currentTarget.value })}
              >
                {c.layers.map((name) => (
                  <option key={name} value={name}>
                    {name || "colour"}
                  </option>
                ))}
              </select>
            </label>
          ) : null}
          {button("n", "Normalise")}
          {button("l", "Log", view.log)}
          {button("z", "Zebra", view.zebra)}
          {button("r", "Reset")}
        </span>
        <span class="group" role="group" aria-label="Errors">
          {button("y", "◂")}
          <button
            onClick={() => toWorst(c, 1)}
            title="next worst pixel (u)"
            disabled={!c.worst?.pixels.length}
          >
            {c.worst && worst ? worstText(c.worst, c.worstIndex, worst.error) : "Worst pixel"}
          </button>
          {button("u", "▸")}
          {button("w", "Worst tile")}
          {button("a", "Region", c.selecting)}
          <span class="quiet worst-count" role="status">
            {counted}
          </span>
        </span>
      </div>
    </div>
  );
}
