import type { Controls } from "./controls";
import { kDifference, kMeasureKinds } from "./difference";
import { ChoiceField, type ToolsProps } from "./tools";
import { kMeasures, type ViewState } from "./view_state";

/** One that these images do not allow is named with the reason. */
const measureChoices = (c: Controls) =>
  kMeasures.map((value) => {
    const lack = value === "noise" ? c.lackOfNoise : "";
    const { label } = kMeasureKinds[value];
    return { value, label: lack ? `${label}: ${lack}` : label, isOff: lack !== "" };
  });

/** The two images that are compared, how, and which others are loaded beside those of the target. */
export function PairTools({ controls: c }: ToolsProps) {
  const { view } = c;
  const set = (change: Partial<ViewState>): void => c.setView({ ...view, ...change });
  const choices = c.images
    .filter(({ kind }) => kind !== "map")
    .map(({ name }) => ({ value: name, label: name }));
  const { [kDifference]: _, ...ends } = view.ends;
  return (
    <span class="group compared" role="group" aria-label="Compared images">
      <ChoiceField
        label="A"
        shown
        title="the image that is compared"
        value={c.pair.a}
        choices={choices}
        onChange={(a) => set({ a })}
      />
      <ChoiceField
        label="B"
        shown
        title="the image that it is compared with (b: next)"
        value={c.pair.b}
        choices={choices}
        onChange={(b) => set({ b })}
      />
      <ChoiceField
        label="Measure"
        title="how the difference is measured (i: next)"
        value={view.measure}
        choices={measureChoices(c)}
        onChange={(name) =>
          set({ measure: kMeasures.find((one) => one === name) ?? view.measure, ends })
        }
      />
      {c.extra.length > 0 ? (
        <ChoiceField
          label="Add an image"
          title="the same target by another renderer or in another run"
          value=""
          choices={[
            { value: "", label: "+ image …" },
            ...c.extra
              .filter((name) => !view.more.includes(name))
              .map((value) => ({ value, label: value })),
          ]}
          onChange={(name) => name && set({ more: [...view.more, name], b: name })}
        />
      ) : null}
      {view.more.map((name) => (
        <button
          key={name}
          title={`remove ${name}`}
          aria-label={`Remove ${name}`}
          onClick={() => set({ more: view.more.filter((one) => one !== name) })}
        >
          {name} ×
        </button>
      ))}
    </span>
  );
}
