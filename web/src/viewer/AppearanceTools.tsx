import { ActionButton, ChoiceField, NumberField, type ToolsProps } from "./tools";
import { kCurves, type Curve, type ViewState } from "./view_state";

const kCurveNames: Record<Curve, string> = {
  srgb: "sRGB",
  gamma: "gamma",
  linear: "linear",
  false: "false colour",
};

/** The tools that decide how the values of an image become colours. */
export function AppearanceTools({ controls: c, actions }: ToolsProps) {
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
      <NumberField
        label="offset"
        value={view.offset}
        step={0.05}
        onChange={(offset) => set({ offset })}
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
      <ActionButton actions={actions} action="n" text="Normalise" />
      <ActionButton actions={actions} action="l" text="Log" pressed={view.log} />
      <ActionButton actions={actions} action="z" text="Zebra" pressed={view.zebra} />
      <ActionButton actions={actions} action="r" text="Reset" />
    </span>
  );
}
