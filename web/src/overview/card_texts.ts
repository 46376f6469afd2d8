// What stands in the cells of a report card, and what it rests on.
import type { RelatedStudies } from "../common/related";
import { costOf, stabilityOf } from "../common/said";
import type { ReportCard } from "../data/generated";

export interface Said {
  text: string;
  /** Index of the study in the source; undefined if the run itself says it. */
  run?: number;
  /** What it rests on, in a few words. */
  source: string;
}

/** By the newest study that holds the renderer, else by the looks of the run. */
export function costSaid(card: ReportCard, cards: ReportCard[], related: RelatedStudies): Said {
  for (const { run, name, study } of related.cost) {
    const text = costOf(study, card.renderer);
    if (text) return { text, run, source: name };
  }
  if (card.cost) return { text: card.cost.sentence, source: "this run" };
  const isBase = cards.some((other) => other.cost?.than === card.renderer);
  return isBase
    ? { text: "the others are compared with it", source: "this run" }
    : { text: "not known", source: "'orbs cost' measures it" };
}

/** By the newest stability study that holds the renderer. */
export function stabilitySaid({ renderer }: ReportCard, related: RelatedStudies): Said {
  for (const { run, name, study } of related.stability) {
    const text = stabilityOf(study, renderer);
    if (text) return { text, run, source: name };
  }
  return { text: "not known", source: "'orbs stability' measures it" };
}
