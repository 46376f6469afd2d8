// What each look of a sequential verdict saw, by gate, and why there are no more looks.
import { counted, number, seconds } from "../common/format";
import type { Job, LookRecord, TargetDetail } from "../data/generated";

/** The looks that one gate decided or held up. */
export interface PathOfGate {
  gate: string;
  /** Limits of the gate; absent where it has none on that side. */
  min?: number;
  max?: number;
  looks: LookRecord[];
}

/** JSON has no infinity: null stands there. */
export const isNumber = (value: number | null | undefined): value is number =>
  value !== null && value !== undefined && Number.isFinite(value);

const numbersOf = ({ value, low, high }: LookRecord): number[] =>
  [value, low, high].filter(isNumber);

/** The paths of all gates that a look has numbers of: that of the last look first, then the next to last. */
export function pathsOf({ looks, checks }: TargetDetail): PathOfGate[] {
  const shown = looks.filter((look) => look.gate !== "" && numbersOf(look).length > 0);
  const gates = [...new Set(shown.map(({ gate }) => gate).reverse())];
  return gates.map((gate) => {
    const check = checks.find(({ what }) => what === gate);
    return {
      gate,
      ...(isNumber(check?.min) ? { min: check.min } : {}),
      ...(isNumber(check?.max) ? { max: check.max } : {}),
      looks: shown.filter((look) => look.gate === gate),
    };
  });
}

const kMostStretch = 2.5;
const kPad = 0.1;

export interface Ends {
  low: number;
  high: number;
}

/**
 * What the chart of a gate shows: the limits and the last look in any case, and as much of the others as
 * leaves these large enough. Intervals of few samples are many times as long as the last one.
 */
export function shownRange({ min, max, looks }: PathOfGate): Ends {
  const span = (numbers: number[]): Ends => ({
    low: Math.min(...numbers),
    high: Math.max(...numbers),
  });
  const last = looks[looks.length - 1];
  const limits = [min, max].filter(isNumber);
  const core = span([...limits, ...(last ? numbersOf(last) : [])]);
  const all = span([...limits, ...looks.flatMap(numbersOf)]);
  if (all.high === all.low) {
    const reach = Math.abs(all.low) / 10 || 1;
    return { low: all.low - reach, high: all.high + reach };
  }
  const size = core.high > core.low ? core.high - core.low : all.high - all.low;
  const reach = (kMostStretch * size) / 2;
  const middle = (core.low + core.high) / 2;
  const low = Math.max(all.low, middle - reach);
  const high = Math.min(all.high, middle + reach);
  const pad = kPad * (high - low);
  return { low: low - pad, high: high + pad };
}

/** The bar of a look within the range that is shown: an end that is not there, or lies beyond, is open. */
export interface Bar extends Ends {
  isOpenBelow: boolean;
  isOpenAbove: boolean;
}

export function barOf({ low, high }: LookRecord, range: Ends): Bar | undefined {
  if (!isNumber(low) && !isNumber(high)) return undefined;
  const isOpenBelow = !isNumber(low) || low < range.low;
  const isOpenAbove = !isNumber(high) || high > range.high;
  const clamped = (value: number) => Math.min(range.high, Math.max(range.low, value));
  return {
    low: isOpenBelow ? range.low : clamped(low),
    high: isOpenAbove ? range.high : clamped(high),
    isOpenBelow,
    isOpenAbove,
  };
}

/** A number of a gate; those of the means in per cent, as the reasons of verdicts have them. */
export function gateNumber(detail: TargetDetail, gate: string, value: number | undefined): string {
  if (!isNumber(value)) return "–";
  if (gate.startsWith("mean_ratio_")) return `${number(Number((100 * value).toPrecision(3)))} %`;
  const unit = detail.measures.find(({ name }) => name === gate)?.unit ?? "1";
  return unit === "1" ? number(value) : `${number(value)} ${unit}`;
}

export function intervalText(detail: TargetDetail, { gate, low, high }: LookRecord): string {
  const [from, to] = [low, high].map((end) => gateNumber(detail, gate, end));
  if (isNumber(low) && isNumber(high)) return `${from} to ${to}`;
  if (isNumber(low)) return `at least ${from}`;
  return isNumber(high) ? `at most ${to}` : "–";
}

// As `end` of JobSampling has them (src/results/job_record.h). Another one is of a newer program, and shown as it is.
const kEnds: Record<string, string> = {
  edge: "the value lies too near to its limit for more samples to decide",
  reference: "the reference allows no decision, whatever the samples",
  budget: "the budget of samples or time is spent",
  looks: "the error rates allow no further look",
};

const goesOn = ({ sampling, end }: Job): boolean =>
  end.outcome === "image" && sampling.looks > 0 && sampling.end === "";

function stopText({ jobs }: TargetDetail): string {
  const failed = jobs.find(({ end }) => end.outcome !== "image");
  if (failed) return failed.end.reason || failed.end.outcome;
  const ends = jobs.map(({ sampling }) => sampling.end).filter((end) => end !== "");
  const end = ends.find((one) => one !== "decided") ?? ends[0]; // of two renders of a difference
  return end === undefined ? "the run ended before it was decided" : (kEnds[end] ?? end);
}

const kUndecided = ["inconclusive", "missing reference", "skipped"];

/** How the looks ended, in one sentence. `isLive`: the run goes on. */
export function endText(detail: TargetDetail, isLive: boolean): string {
  const { looks, jobs } = detail;
  const last = looks[looks.length - 1];
  if (!last) return "";
  const samples = counted(last.spp, "sample");
  const times = jobs.filter(({ cost }) => cost.started !== "").map(({ cost }) => cost.wall_seconds);
  const time = seconds(times.reduce((sum, one) => sum + one, 0));
  const inLooks = `in ${counted(looks.length, "look")} (${time})`;
  if (isLive && jobs.some(goesOn)) return `Goes on: ${samples} so far, ${inLooks}.`;
  if (!kUndecided.includes(last.verdict)) return `Decided after ${samples} ${inLooks}.`;
  return `Stopped after ${samples}: ${stopText(detail)}.`;
}
