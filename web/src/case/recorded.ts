/** One member of a record: its path in words, its value as text, and the unit that its key ends with. */
export interface RecordedValue {
  name: string;
  value: string;
  unit: string;
}

/** The last word of a key is the unit of its number: "wall_seconds". */
const UNITS: Record<string, string> = { seconds: "s", bytes: "B", cores: "cores", px: "px" };

function nameAndUnit(key: string): { name: string; unit: string } {
  const words = key.split("_");
  const unit = words.length > 1 ? UNITS[words[words.length - 1] ?? ""] : undefined;
  return { name: (unit ? words.slice(0, -1) : words).join(" "), unit: unit ?? "" };
}

function textOf(value: unknown): string {
  if (typeof value === "boolean") return value ? "yes" : "no";
  return Array.isArray(value) ? value.map(textOf).join(" ") : String(value ?? "");
}

/** All members of a record in their order, nested ones behind the name of their group; empty ones are left out. */
export function recordedValues(record: object, group = ""): RecordedValue[] {
  return Object.entries(record).flatMap(([key, value]: [string, unknown]) => {
    const { name, unit } = nameAndUnit(key);
    const path = group === "" ? name : `${group}: ${name}`;
    if (typeof value === "object" && value !== null && !Array.isArray(value))
      return recordedValues(value, path);
    const text = textOf(value);
    return text === "" ? [] : [{ name: path, value: text, unit }];
  });
}
