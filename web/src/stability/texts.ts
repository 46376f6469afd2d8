import type {
  StabilityCell,
  StabilityRelationRecord,
  StabilitySettings,
  StabilityStep,
} from "../data/generated";

/** A magnitude with its unit; powers of two from 2^10 on as such. */
export function magnitudeText(magnitude: number, unit: string): string {
  const power = Math.log2(magnitude);
  const isPowerOfTwo = Number.isInteger(power) && Math.abs(power) >= 10;
  const tens = Math.log10(magnitude);
  const plain = Number.isInteger(tens) && Math.abs(tens) > 3 ? `1e${tens}` : `${magnitude}`;
  return `${isPowerOfTwo ? `2^${power}` : plain}${unit ? ` ${unit}` : ""}`;
}

/** What a cell of the matrix says, in a few words. */
export function cellText(cell: StabilityCell, relation: StabilityRelationRecord): string {
  if (cell.scenes === 0) return cell.not_applicable > 0 ? "not applicable" : "not measured";
  const all = cell.scenes + cell.not_applicable;
  return (
    resultText(cell, relation) + (cell.not_applicable > 0 ? ` (${cell.scenes} of ${all})` : "")
  );
}

function resultText(cell: StabilityCell, relation: StabilityRelationRecord): string {
  const text = (magnitude: number): string => magnitudeText(magnitude, relation.unit);
  const { first_break: broken, held_to: held } = cell;
  const exact = cell.bit_equal ? ", to the bit" : "";
  if (broken) {
    const what = broken.outcome === "no image" ? "no image" : "breaks";
    if (!relation.is_sweep) return what;
    return `${held === undefined ? "" : `to ${text(held)}; `}${what} at ${text(broken.magnitude)}`;
  }
  if (cell.inconclusive >= cell.scenes) return "inconclusive";
  if (!relation.is_sweep) return `holds${exact}`;
  return held === undefined ? "inconclusive" : `all, to ${text(held)}${exact}`;
}

/** The error of a step over what is allowed; 1 is the bound. Infinite where there is no image. */
export function excessOf(step: StabilityStep, settings: StabilitySettings): number {
  if (step.outcome === "no image") return Infinity;
  return Math.max(
    Math.abs(step.mean) / settings.mean_bound,
    Math.abs(step.block) / settings.block_bound,
  );
}

/** A relative difference in per cent with its standard error. */
export function percentText(value: number, error: number): string {
  if (value === 0) return "0 %";
  const percent = 100 * value;
  const shown = Math.abs(percent) < 1e-3 ? percent.toExponential(0) : percent.toPrecision(2);
  return `${percent > 0 ? "+" : ""}${shown} %${error > 0 ? ` ± ${(100 * error).toPrecision(1)}` : ""}`;
}

/** What a step says beside its numbers. */
export const stepText = (step: StabilityStep): string =>
  step.outcome === "holds" && step.is_bit_equal ? "equal to the bit" : step.outcome;

export const capitalised = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** Whether a step compared images. */
export const hasImages = ({ outcome }: StabilityStep): boolean =>
  outcome !== "no image" && outcome !== "not applicable";
