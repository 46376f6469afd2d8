import { note } from "../route";

interface Props {
  label: string;
  /** The parameter of the address that holds the choice. */
  param: string;
  chosen: string;
  options: { name: string; label: string }[];
}

export function Choice({ label, param, chosen, options }: Props) {
  return (
    <label>
      {label}{" "}
      <select value={chosen} onChange={(event) => note({ [param]: event.currentTarget.value })}>
        {options.map((option) => (
          <option key={option.name} value={option.name}>
            {option.label}
          </option>
        ))}
      </select>
    </label>
  );
}
