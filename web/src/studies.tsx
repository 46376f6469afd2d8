// The kinds of studies: a new one is a row here, beside its row in src/results/study_kinds.h.
import type { ComponentProps, ComponentType } from "preact";
import { CostPage } from "./cost/CostPage";
import type { StudyKind } from "./data/generated";
import type { Source } from "./data/source";
import type { Route } from "./route";
import { StabilityPage } from "./stability/StabilityPage";

/** The view of each kind, which says the type of the kind's file. */
const kPages = {
  cost: CostPage,
  stability: StabilityPage,
} satisfies Record<StudyKind, unknown>;

export type Studies = { [Kind in StudyKind]: ComponentProps<(typeof kPages)[Kind]>["study"] };
export type AnyStudy = Studies[StudyKind];

interface Props<Study> {
  source: Source;
  run: number;
  study: Study;
  route: Route;
}

export function StudyPage({ kind, ...props }: Props<AnyStudy> & { kind: StudyKind }) {
  // The file that the kind names is of the kind's type.
  const Page = kPages[kind] as ComponentType<Props<AnyStudy>>;
  return <Page {...props} />;
}
