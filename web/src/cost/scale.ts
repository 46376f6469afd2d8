/** Maps values of an axis to positions in pixels. */
export interface Scale {
  log: boolean;
  min: number;
  max: number;
  at(value: number): number;
  /** Values of the lines of the grid that have a label. */
  ticks: number[];
}

const kMostTicks = 7;

function logTicks(min: number, max: number): number[] {
  const [from, to] = [Math.ceil(Math.log10(min)), Math.floor(Math.log10(max))];
  const decades = Math.log10(max / min);
  const factors = decades < 1.2 ? [1, 2, 3, 5, 7] : decades < 2.5 ? [1, 3] : [1];
  const step = Math.max(1, Math.ceil((to - from + 1) / kMostTicks));
  const ticks: number[] = [];
  for (let power = from - 1; power <= to; power += factors.length > 1 ? 1 : step)
    for (const factor of factors) ticks.push(factor * 10 ** power);
  // The powers before the range only begin the steps within it.
  const aligned = factors.length > 1 ? ticks : ticks.map((_, i) => 10 ** (from + i * step));
  return aligned.filter((tick) => tick >= min * 0.999 && tick <= max * 1.001);
}

function linearTicks(min: number, max: number): number[] {
  const rough = (max - min) / (kMostTicks - 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5, 10].find((factor) => factor * power >= rough) ?? 10);
  const ticks: number[] = [];
  for (let i = Math.ceil(min / step); i * step <= max; ++i) ticks.push(i * step);
  return ticks;
}

/** The range of the values with some room around them; undefined if the axis can show none. */
export function rangeOf(values: Iterable<number>, log: boolean): [number, number] | undefined {
  let [min, max] = [Infinity, -Infinity];
  for (const value of values) {
    if (!Number.isFinite(value) || (log && value <= 0)) continue;
    min = Math.min(min, value);
    max = Math.max(max, value);
  }
  if (min > max) return undefined;
  if (log) {
    const room = Math.max((max / min) ** 0.06, 1.15);
    return [min / room, max * room];
  }
  const room = Math.max((max - min) * 0.07, Math.abs(max) * 0.01, 1e-9);
  return [min - room, max + room];
}

export function scaleOf(
  [min, max]: [number, number],
  log: boolean,
  [begin, end]: [number, number],
): Scale {
  const along = log
    ? (value: number) => Math.log(value / min) / Math.log(max / min)
    : (value: number) => (value - min) / (max - min);
  return {
    log,
    min,
    max,
    at: (value) => begin + (end - begin) * along(value),
    ticks: log ? logTicks(min, max) : linearTicks(min, max),
  };
}

const kRaised: Record<string, string> = { "-": "⁻" };
"⁰¹²³⁴⁵⁶⁷⁸⁹".split("").forEach((digit, i) => (kRaised[String(i)] = digit));

/** 0.001 as "10⁻³"; decimals from `plainFrom` on. */
export function tickText(value: number, plainFrom: number): string {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= plainFrom && size < 1e5) return String(Number(value.toPrecision(3)));
  const power = Math.floor(Math.log10(size) + 1e-9);
  const factor = Number((value / 10 ** power).toPrecision(2));
  const raised = [...String(power)].map((c) => kRaised[c] ?? c).join("");
  return factor === 1 ? `10${raised}` : `${factor}·10${raised}`;
}
