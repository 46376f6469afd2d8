// The studies and runs beside a run that say something of the same suite.
import { useEffect, useState } from "preact/hooks";
import type { CostStudy, Overview, StabilityStudy, StudyKind } from "../data/generated";
import type { Source } from "../data/source";

export interface Found<Study> {
  /** Index in the source. */
  run: number;
  name: string;
  study: Study;
}

export interface RelatedStudies {
  cost: Found<CostStudy>[];
  stability: Found<StabilityStudy>[];
}

/** Studies that were read, by source: the front page and every target ask for the same ones. */
const read = new WeakMap<Source, Map<number, Promise<unknown>>>();

function studyOf(source: Source, kind: StudyKind, run: number): Promise<unknown> {
  const own = read.get(source) ?? new Map<number, Promise<unknown>>();
  read.set(source, own);
  const found = own.get(run) ?? source.study(kind, run).catch(() => undefined);
  own.set(run, found);
  return found;
}

/** Overviews of runs that have ended, by source: each target asks for those of the same runs. */
const ended = new WeakMap<Source, Map<number, Promise<Overview>>>();

/** The overview of another run, read once if it has ended. */
export async function overviewOf(source: Source, run: number): Promise<Overview> {
  const own = ended.get(source) ?? new Map<number, Promise<Overview>>();
  ended.set(source, own);
  const found = own.get(run) ?? source.overview(run);
  own.set(run, found);
  const forget = (): void => void own.delete(run);
  void found.then((overview) => (overview.run.live ? forget() : undefined), forget);
  return found;
}

async function relatedOf(source: Source, suite: string): Promise<RelatedStudies> {
  const related: RelatedStudies = { cost: [], stability: [] };
  for (const [run, kind] of source.kinds.entries()) {
    if (kind === "run") continue;
    const study = await studyOf(source, kind, run);
    const name = source.runs[run] ?? "";
    if (kind === "cost" && (study as CostStudy | undefined)?.suite === suite)
      related.cost.push({ run, name, study: study as CostStudy });
    if (kind === "stability" && study)
      related.stability.push({ run, name, study: study as StabilityStudy });
  }
  return related;
}

/** Nothing until they are read: the run itself is shown first. */
export function useRelated(source: Source, suite: string): RelatedStudies {
  const [found, setFound] = useState<RelatedStudies>({ cost: [], stability: [] });
  useEffect(() => {
    let isWanted = true;
    void relatedOf(source, suite).then((related) => {
      if (isWanted) setFound(related);
    });
    return () => void (isWanted = false);
  }, [source, suite]);
  return found;
}
