interface Props {
  label: string;
  value: string;
  onChange: (reason: string) => void;
}

/** Where the user says why something is accepted. */
export function Reason({ label, value, onChange }: Props) {
  return (
    <label class="field reason-field">
      {label}
      <input
        type="text"
        value={value}
        autocomplete="off"
        required
        onInput={(event) => onChange(event.currentTarget.value)}
      />
    </label>
  );
}
