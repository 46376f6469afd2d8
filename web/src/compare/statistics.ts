// What `orbs compare-runs` says of two runs: numbers that changed beyond chance, and targets that were lost.
import type { Kind } from "./changes";

export interface NumberChange {
  direction: "worse" | "changed" | "better";
  /** "verdict", "light", "error" or "time". */
  quantity: string;
  renderer: string;
  /** "" for all targets of a renderer together. */
  requirement: string;
  target: string;
  before: string;
  after: string;
  /** How probable it is that equal programs differ so much. */
  probability: number;
  reason: string;
}

export interface RunComparison {
  /** That both runs have. */
  targets: number;
  /** Of numbers. */
  tests: number;
  false_alarm_rate: number;
  changes: NumberChange[];
  lost: { loss: string; target: string; reason: string }[];
  notes: string[];
}

/** The numbers: verdicts stand in the tables of targets. */
export const numbersOf = ({ changes }: RunComparison): NumberChange[] =>
  changes.filter(({ quantity }) => quantity !== "verdict");

export type NumberKinds = (renderer: string, target: string) => Kind;

/** What the numbers of a target did, times apart: the first change of a target is its worst. */
export function kindsOfNumbers(comparison: RunComparison | undefined): NumberKinds {
  const kinds = new Map<string, Kind>();
  for (const { direction, quantity, renderer, target } of comparison?.changes ?? []) {
    if (quantity === "verdict" || quantity === "time" || target === "") continue;
    const key = `${renderer}\n${target}`;
    if (!kinds.has(key)) kinds.set(key, direction);
  }
  return (renderer, target) => kinds.get(`${renderer}\n${target}`) ?? "same";
}

/** "1 in 340". */
export function chanceText(probability: number): string {
  if (probability < 1e-9) return "< 1 in 1e9";
  return `1 in ${Number((1 / probability).toPrecision(2)).toLocaleString("en")}`;
}
