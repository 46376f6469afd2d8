// What a study says of a renderer in a sentence: the same on the front page and beside each target.
import { levelText } from "../cost/quantities";
import { answerAt, mayRank, meanRatio } from "../cost/ranking";
import type { CostStudy, StabilityStudy } from "../data/generated";

const kMetric = "psnr_srgb8";

const shortNumber = (value: number): string => String(Number(value.toPrecision(2)));

interface Ratio {
  value: number;
  low: number;
  high: number;
  count: number;
}

/** "takes 6.3 times the CPU time of orbs to 35 dB (4.8 to 8.2, 15 targets)". */
function ratioText(than: string, what: string, { value, low, high, count }: Ratio): string {
  const ends = `(${shortNumber(low)} to ${shortNumber(high)}, ${count} targets)`;
  return low <= 1 && high >= 1
    ? `no difference to ${than} is shown ${what} ${ends}`
    : `takes ${shortNumber(value)} times the CPU time of ${than} ${what} ${ends}`;
}

/** What a cost study says of one of its renderers at the quality that it was made for. */
export function costOf(study: CostStudy, name: string): string | undefined {
  const own = study.renderers.findIndex((one) => one.name === name);
  if (own < 0 || study.renderers.length < 2) return undefined;
  if (!mayRank(study)) return "nobody is ranked: its A/A check failed";
  const level = study.settings.target_db ?? 35;
  const at = levelText(study, kMetric, level);
  const { leader, fastest, targets, unreached } = answerAt(study, kMetric, level);
  if (leader === own)
    return `fastest to ${at} on ${fastest[own]} of ${targets - unreached} targets`;
  if (leader === undefined) return `nobody is shown to be fastest to ${at} more often than others`;
  const than = study.renderers[leader]?.name ?? "";
  const ratio = meanRatio(study, leader, own, kMetric, level);
  return ratio ? ratioText(than, `to ${at}`, ratio) : `cannot be compared with ${than} at ${at}`;
}

/** The first two sentences of the renderer's summary: how many changes it follows, and its worst break. */
export function stabilityOf(study: StabilityStudy, renderer: string): string | undefined {
  const start = `${renderer}: `;
  const summary = study.summaries.find((text) => text.startsWith(start));
  return summary
    ?.slice(start.length)
    .split(/(?<=\.) (?=[A-Z])/)
    .slice(0, 2)
    .join(" ");
}
