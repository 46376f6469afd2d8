export function seconds(value: number | null | undefined): string {
  if (value === null || value === undefined) return "–";
  if (value < 0.0995) return `${(value * 1000).toPrecision(2)} ms`;
  if (value < 99.5) return `${value.toPrecision(3)} s`;
  const total = Math.round(value);
  const minutes = Math.floor(total / 60);
  if (minutes < 60) return `${minutes} min ${total % 60} s`;
  return `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

export function bytes(value: number | null | undefined): string {
  if (value === null || value === undefined || value === 0) return "–";
  return value < 1e9 ? `${(value / 1e6).toPrecision(3)} MB` : `${(value / 1e9).toPrecision(3)} GB`;
}

/** A number in a table: four significant digits, "∞" if it is infinite, "–" if there is none. */
export function number(value: number | null | undefined, infinite = false): string {
  if (infinite) return "∞";
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  return size >= 1e-3 && size < 1e5 ? String(Number(value.toPrecision(4))) : value.toExponential(3);
}

/** The nine significant digits that identify a 32-bit float. */
export function rawFloat(value: number): string {
  if (Number.isNaN(value)) return "NaN";
  if (!Number.isFinite(value)) return value > 0 ? "+Inf" : "−Inf";
  return String(Number(value.toPrecision(9)));
}

export const withUnit = (text: string, unit: string): string =>
  unit && unit !== "1" ? `${text} ${unit}` : text;

export const counted = (count: number, one: string): string =>
  `${count} ${one}${count === 1 ? "" : "s"}`;
