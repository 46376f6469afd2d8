import { counted } from "./format";
import type { Source } from "../data/source";
import type { Overview, Progress } from "../data/generated";

/** The run that is shown, and the source of the others. */
export interface Session {
  source: Source;
  run: number;
  overview: Overview;
  /** Progress of a live run, once the server has sent it. */
  progress: Progress | undefined;
  /** Why the state of a live run is not up to date. */
  connectionProblem: string | undefined;
}

/** Index of the run of that name; `usual` without a name, -1 if there is no such run. */
export const runNamed = (source: Source, name: string | undefined, usual: number): number =>
  name ? source.runs.indexOf(name) : usual;

/** Query that names a run: without it a link would open whichever run is the newest by then. */
export const runQuery = (source: Source, run: number, param = "run"): Record<string, string> =>
  source.runs.length > 1 ? { [param]: source.runs[run] ?? "" } : {};

/** Index of the cell of a target by a renderer; -1 if the run has none. */
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

/** Whether the state of a cell is the verdict of a look, and more samples may follow. */
export const isPreliminary = (overview: Overview, index: number): boolean =>
  overview.cells.preliminary?.[index] === 1;

/** How far a render in looks is: "goes on: 64 samples so far"; "" where none follow. */
export const goesOnText = (overview: Overview, index: number): string =>
  isPreliminary(overview, index)
    ? `goes on: ${counted(overview.cells.spp[index] ?? 0, "sample")} so far`
    : "";

export const reasonOf = (overview: Overview, index: number): string =>
  overview.reasons[overview.cells.reason[index] ?? -1] ?? "";

/** "37.2 dB without noise" where the verdict rests on that and the image's own PSNR is shown. */
export const besidePsnr = (overview: Overview, metric: string, index: number): string =>
  metric === "psnr_srgb8"
    ? (overview.texts_beside_psnr[overview.cells.beside_psnr[index] ?? 0] ?? "")
    : "";

export const isInfinite = (overview: Overview, metric: string, index: number): boolean =>
  overview.infinite[metric]?.includes(index) ?? false;
