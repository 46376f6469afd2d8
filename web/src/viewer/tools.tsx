import type { Action } from "../common/keys";
import type { Controls } from "./controls";

/** A group of the toolbar's buttons. */
export interface ToolsProps {
  controls: Controls;
  actions: Action[];
}

interface ButtonProps {
  actions: Action[];
  /** The key of the action that the button runs. */
  action: string;
  text: string;
  pressed?: boolean;
}

export function ActionButton({ actions, action: key, text, pressed }: ButtonProps) {
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
}

interface NumberProps {
  label: string;
  value: number;
  step: number;
  onChange: (value: number) => void;
}

export function NumberField({ label, value, step, onChange }: NumberProps) {
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

interface ChoiceProps {
  /** For screen readers only, unless it is `shown`: most visible choices explain themselves. */
  label: string;
  shown?: boolean;
  title: string;
  value: string;
  /** One that is off is shown, with a label that says why, and cannot be chosen. */
  choices: { value: string; label: string; isOff?: boolean }[];
  onChange: (value: string) => void;
}

export function ChoiceField({ label, shown, title, value, choices, onChange }: ChoiceProps) {
  return (
    <label class="field">
      <span class={shown ? "" : "unseen"}>{label}</span>
      <select value={value} title={title} onChange={(event) => onChange(event.currentTarget.value)}>
        {choices.map((one) => (
          <option key={one.value} value={one.value} disabled={one.isOff}>
            {one.label}
          </option>
        ))}
      </select>
    </label>
  );
}
