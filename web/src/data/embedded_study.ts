import type { Studies } from "../studies";
import { textOf } from "./embedded";
import type { StudyKind } from "./generated";
import type { Source } from "./source";

const noRun = () => Promise.reject(new Error("this file holds a study, no run"));

/** The page of a study written by `orbs report`. */
export function embeddedStudy(): Source {
  const about = JSON.parse(textOf("orbs-about")) as { name: string; kind: StudyKind };
  const study: unknown = JSON.parse(textOf("orbs-study"));
  const elements = JSON.parse(textOf("orbs-images")) as Record<string, string>;
  return {
    runs: [about.name],
    kinds: [about.kind],
    suites: [""],
    isServed: false,
    overview: noRun,
    target: noRun,
    comparison: noRun,
    costChanges: noRun,
    raster: noRun,
    preview: noRun,
    study: async <K extends StudyKind>() => study as Studies[K],
    picture: async (_run, file) => {
      const element = elements[file];
      if (!element)
        throw new Error(
          "This file was kept small and does not hold the image; " +
            "'orbs serve' shows it from the folder of the study.",
        );
      return `data:image/png;base64,${textOf(element)}`;
    },
    fileAddress: () => undefined,
    follow: () => () => undefined,
  };
}
