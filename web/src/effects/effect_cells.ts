// The cost and the worth of single effects, from what orbs effect-cost measured.
import type { EffectCostRecord, SceneEffects } from "../data/generated";

export interface Ratio {
  value: number;
  low: number | undefined;
  high: number | undefined;
}

export interface EffectCost {
  /** CPU time with the effect over that without it. */
  time: Ratio;
  /** Change of the mean without it, relative to the image that is called for. */
  meanChange: number | undefined;
  record: EffectCostRecord;
}

/** The transport that differs from a scene's by one effect alone. */
const kPoorer: Record<string, Record<string, string>> = {
  spectral: { spectral: "rgb" },
  polarisation: { polarised: "spectral", "polarised-bispectral": "bispectral" },
  fluorescence: { bispectral: "spectral", "polarised-bispectral": "polarised" },
};

/** How the scene was rendered without the effect; undefined if it was not, or as other work. */
export function costOf(scene: SceneEffects, effect: string): EffectCost | undefined {
  const poorer = kPoorer[effect]?.[scene.transport];
  const record =
    scene.costs.find(({ name }) => name === `without ${effect}`) ??
    scene.costs.find(({ name }) => name === poorer);
  if (!record || !record.is_comparable || record.time_ratio <= 0) return undefined;
  const inverse = (ratio: number | undefined) =>
    ratio === undefined || ratio <= 0 ? undefined : 1 / ratio;
  return {
    time: {
      value: 1 / record.time_ratio,
      low: inverse(record.time_high),
      high: inverse(record.time_low),
    },
    meanChange: record.mean_change,
    record,
  };
}

/** The most expensive of the transports that carry more than the scene calls for: what it does not pay. */
export function spared(scene: SceneEffects): EffectCostRecord | undefined {
  return scene.costs
    .filter(({ name, is_enough, is_comparable }) => {
      // Of a scene in three colours every transport carries more, but coloured surfaces look different in it.
      const carriesMore = is_enough || (scene.transport === "rgb" && !name.startsWith("without "));
      return carriesMore && is_comparable;
    })
    .sort((a, b) => b.time_ratio - a.time_ratio)[0];
}

/** All effects that a scene calls for, those of most scenes first. */
export function effectsOf(scenes: SceneEffects[]): string[] {
  const counts = new Map<string, number>();
  for (const { called_for } of scenes)
    for (const effect of called_for) counts.set(effect, (counts.get(effect) ?? 0) + 1);
  return [...counts].sort(([, a], [, b]) => b - a).map(([effect]) => effect);
}

export interface EffectSummary {
  effect: string;
  scenes: number;
  measured: number;
  /** Median of the scenes, and the smallest and the largest of them. */
  time: Ratio | undefined;
  /** The largest change of a mean without the effect that is beyond three standard errors. */
  mostChange: number | undefined;
}

function middle(sorted: number[]): number {
  const half = (sorted.length - 1) / 2;
  return ((sorted[Math.floor(half)] ?? 0) + (sorted[Math.ceil(half)] ?? 0)) / 2;
}

export function summaryOf(scenes: SceneEffects[], effect: string): EffectSummary {
  const calling = scenes.filter(({ called_for }) => called_for.includes(effect));
  const costs = calling.flatMap((scene) => costOf(scene, effect) ?? []);
  const times = costs.map(({ time }) => time.value).sort((a, b) => a - b);
  const changes = costs.flatMap(({ meanChange, record }) =>
    meanChange !== undefined && Math.abs(meanChange) > 3 * (record.mean_change_error ?? 0)
      ? meanChange
      : [],
  );
  return {
    effect,
    scenes: calling.length,
    measured: costs.length,
    time: times.length ? { value: middle(times), low: times[0], high: times.at(-1) } : undefined,
    mostChange: changes.sort((a, b) => Math.abs(b) - Math.abs(a))[0],
  };
}

export const timesText = ({ value }: Ratio): string => `× ${value.toFixed(2)}`;

export const rangeText = ({ low, high }: Ratio): string =>
  low === undefined || high === undefined ? "" : `${low.toFixed(2)} to ${high.toFixed(2)}`;

export function changeText(change: number | undefined): string {
  if (change === undefined) return "";
  const percent = 100 * change;
  const text = Math.abs(percent) < 0.1 ? "less than 0.1" : Math.abs(percent).toPrecision(2);
  return `${text} % ${percent < 0 ? "darker" : "brighter"}`;
}
