import { decoded } from "./decoder";
import { pngAddress } from "./display";
import type { Raster } from "./raster";
import type { Source } from "./source";
import type { Overview, TargetDetail } from "./generated";

export function textOf(id: string): string {
  const element = document.getElementById(id);
  if (!element) throw new Error("this file was written without it");
  return element.textContent ?? "";
}

const noStudy = () => Promise.reject(new Error("this file holds a run, no study"));

/** The page written by `orbs report`: script elements of the file hold all data. */
export function embeddedSource(): Source {
  const written = JSON.parse(textOf("orbs-overview")) as Overview;
  // The run in a file is never live.
  const overview = { ...written, run: { ...written.run, live: false } };
  const elements = JSON.parse(textOf("orbs-images")) as Record<string, string>;
  const raster = async (file: string, layer: string): Promise<Raster> => {
    const element = elements[file];
    if (!element)
      throw new Error(
        "this file was kept small and does not hold it; " +
          "'orbs serve' shows it from the folder of the run",
      );
    if (layer)
      throw new Error("this file holds only the main layer; 'orbs serve' shows the others");
    return decoded(textOf(element));
  };
  let targets: TargetDetail[] | undefined;
  return {
    runs: [overview.run.name],
    kinds: ["run"],
    suites: [`${overview.run.suite} ${overview.run.size}`],
    isServed: false,
    overview: async () => overview,
    target: async (_run, index) => {
      targets ??= JSON.parse(textOf("orbs-targets")) as TargetDetail[];
      const target = targets[index];
      if (!target) throw new Error("this run has no such target");
      return target;
    },
    costChanges: () =>
      Promise.reject(new Error("this page is one file, 'orbs serve' compares studies")),
    comparison: () => Promise.reject(new Error("this page is one file, 'orbs serve' tests them")),
    raster: (_run, file, layer) => raster(file, layer),
    // The floats are at hand: a second, smaller form of each image would make the file larger.
    preview: async (_run, file) => pngAddress(await raster(file, "")),
    study: noStudy,
    picture: noStudy,
    fileAddress: () => undefined,
    follow: () => () => undefined,
  };
}
