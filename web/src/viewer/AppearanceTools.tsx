import { offer } from "../common/offer";
import type { Controls } from "./controls";
import { ActionButton, ChoiceField, NumberField, type ToolsProps } from "./tools";
import { kCurves, kPercentiles, type Curve, type ViewState } from "./view_state";

const kCurveNames: Record<Curve, string> = {
  srgb: "sRGB",
  gamma: "gamma",
  linear: "linear",
  false: "false colour",
};

/** The tools that decide how the values of an image become colours. */
export function AppearanceTools({ controls: c }: Pick<ToolsProps, "controls">) {
  const { view } = c;
  const set = (change: Partial<ViewState>): void => c.setView({ ...view, ...change });
  return (
    <span class="group" role="group" aria-label="Appearance">
      <NumberField
        label="EV"
        value={view.exposure}
        step={0.5}
        onChange={(exposure) => set({ exposure })}
      />
      <ChoiceField
        label="Curve"
        title="sRGB, gamma, linear, false colour (g)"
        value={view.curve}
        choices={kCurves.map((curve) => ({ value: curve, label: kCurveNames[curve] }))}
        onChange={(name) => set({ curve: kCurves.find((curve) => curve === name) ?? "srgb" })}
      />
      {view.curve === "gamma" ? (
        <NumberField
          label="γ"
          value={view.gamma}
          step={0.1}
          onChange={(gamma) => set({ gamma: Math.max(0.1, gamma) })}
        />
      ) : null}
      <ChoiceField
        label="Channel"
        title="channel (x)"
        value={c.channel}
        choices={c.channels}
        onChange={(channel) => set({ channel })}
      />
      {c.layers.length > 1 ? (
        <ChoiceField
          label="Layer"
          title="layer of the image"
          value={view.layer}
          choices={c.layers.map((name) => ({ value: name, label: name || "colour" }))}
          onChange={(layer) => set({ layer })}
        />
      ) : null}
    </span>
  );
}

/** Saves the stage as it is shown, and the files of the images. */
function SaveTools({ controls: c }: { controls: Controls }) {
  const savePng = (): void =>
    document
      .querySelector<HTMLCanvasElement>(".stage canvas")
      ?.toBlob((png) => png && offer(`${c.front?.name ?? "images"}.png`, png));
  const address = c.front && c.addressOf(c.front);
  return (
    <>
      <button onClick={savePng} title="the images as they are shown">
        Save PNG
      </button>
      {address ? (
        <a href={address} download={`${c.front?.name}.exr`} title="the file with all values">
          Save EXR
        </a>
      ) : null}
    </>
  );
}

/** What is needed less often. */
export function RarerTools({ controls: c, actions }: ToolsProps) {
  const { view } = c;
  return (
    <span class="group" role="group" aria-label="More tools">
      <NumberField
        label="offset"
        value={view.offset}
        step={0.05}
        onChange={(offset) => c.setView({ ...view, offset })}
      />
      <ActionButton actions={actions} action="n" text="Normalise" />
      <ChoiceField
        label="Percentile of Normalise"
        title="the share of the visible values that Normalise shows; the others are clipped"
        value={String(view.percentile)}
        choices={kPercentiles.map((one) => ({
          value: String(one),
          label: one === 100 ? "whole range" : `${one} %`,
        }))}
        onChange={(percent) => c.setView({ ...view, percentile: Number(percent) })}
      />
      <ActionButton actions={actions} action="l" text="Log" pressed={view.log} />
      <ActionButton actions={actions} action="z" text="Zebra" pressed={view.zebra} />
      <ActionButton actions={actions} action="r" text="Reset" />
      <ActionButton actions={actions} action="w" text="Worst tile" />
      <SaveTools controls={c} />
    </span>
  );
}
