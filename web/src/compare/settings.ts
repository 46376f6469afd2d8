import { number } from "../common/format";
import type { Overview } from "../data/generated";
import type { Change } from "./changes";

/** The ratio of the samples per pixel, B over A, of the targets that both have: the least and the most. */
function samplesText(a: Overview, b: Overview, changes: Change[]): string {
  const ratios = changes.flatMap(({ before, after }) => {
    const [old, now] = [a.cells.spp[before] ?? 0, b.cells.spp[after] ?? 0];
    return old > 0 && now > 0 ? [now / old] : [];
  });
  if (ratios.length === 0) return "";
  const [least, most] = [Math.min(...ratios), Math.max(...ratios)];
  if (least === 1 && most === 1) return "";
  return least === most
    ? `samples per pixel × ${number(least)}`
    : `samples per pixel × ${number(least)} to × ${number(most)}`;
}

/** What was set differently: it explains a change before any other cause. */
export function settingsThatDiffer(a: Overview, b: Overview, changes: Change[]): string[] {
  const pair = (name: string, old: string, now: string): string =>
    old === now ? "" : `${name} ${old || "unknown"} → ${now || "unknown"}`;
  return [
    samplesText(a, b, changes),
    pair("size of the images", a.run.size, b.run.size),
    pair("suite", a.run.suite, b.run.suite),
    pair("orbs", a.run.orbs_version, b.run.orbs_version),
    pair("processor", a.run.host.cpu, b.run.host.cpu),
  ].filter(Boolean);
}
