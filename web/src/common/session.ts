import type { Source } from "../data/source";
import type { Overview, Progress } from "../data/types";

/** The run that is shown, and how to get at the rest. */
export interface Session {
  source: Source;
  run: number;
  overview: Overview;
  /** Of a run that goes on, once it has been told. */
  progress: Progress | undefined;
  /** Why nothing newer is known of a run that goes on. */
  trouble: string | undefined;
}

/** The run that a member of a query names; without a name the usual one, -1 when there is no such run. */
export const runNamed = (source: Source, name: string | undefined, usual: number): number =>
  name ? source.runs.indexOf(name) : usual;

/** The member of a query that names a run. Without it a link would show another run as soon as there is a newer one. */
export const runQuery = (source: Source, run: number, param = "run"): Record<string, string> =>
  source.runs.length > 1 ? { [param]: source.runs[run] ?? "" } : {};

/** Index of the image of a case by a renderer, -1 when the run has none. */
export function findCell(
  overview: Overview,
  caseName: string,
  target: string,
  renderer: string,
): number {
  const { cells } = overview;
  const wantedCase = overview.cases.findIndex((one) => one.name === caseName);
  const wantedTarget = overview.targets.indexOf(target);
  const wantedRenderer = overview.renderers.findIndex((one) => one.name === renderer);
  return cells.case.findIndex(
    (one, i) =>
      one === wantedCase &&
      cells.target[i] === wantedTarget &&
      cells.renderer[i] === wantedRenderer,
  );
}

export interface CellNames {
  case: string;
  target: string;
  renderer: string;
}

export function namesOf(overview: Overview, index: number): CellNames {
  const { cells } = overview;
  return {
    case: overview.cases[cells.case[index] ?? -1]?.name ?? "",
    target: overview.targets[cells.target[index] ?? -1] ?? "",
    renderer: overview.renderers[cells.renderer[index] ?? -1]?.name ?? "",
  };
}

export const stateOf = (overview: Overview, index: number) =>
  overview.states[overview.cells.state[index] ?? -1];

export const reasonOf = (overview: Overview, index: number): string =>
  overview.reasons[overview.cells.reason[index] ?? -1] ?? "";

export const isInfinite = (overview: Overview, metric: string, index: number): boolean =>
  overview.infinite[metric]?.includes(index) ?? false;
