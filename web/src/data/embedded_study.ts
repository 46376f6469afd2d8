import type { CostStudy } from "../cost/types";
import { textOf } from "./embedded";
import type { Source } from "./source";

const noRun = () => Promise.reject(new Error("this file holds a cost study, no run"));

/** The page of a cost study written by `orbs report`. */
export function embeddedStudy(): Source {
  const study = JSON.parse(textOf("orbs-cost")) as CostStudy;
  const elements = JSON.parse(textOf("orbs-images")) as Record<string, string>;
  return {
    runs: [JSON.parse(textOf("orbs-cost-name")) as string],
    kinds: ["cost"],
    isServed: false,
    overview: noRun,
    target: noRun,
    raster: noRun,
    thumbnail: async () => undefined,
    study: async () => study,
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
