import type { CostStudy } from "../cost/types";
import type { StabilityStudy } from "../stability/types";
import { textOf } from "./embedded";
import type { Source } from "./source";

const noRun = () => Promise.reject(new Error("this file holds a study, no run"));

/** The page of a study of cost or stability written by `orbs report`. */
export function embeddedStudy(): Source {
  const kind = document.getElementById("orbs-cost") ? "cost" : "stability";
  const study: unknown = JSON.parse(textOf(`orbs-${kind}`));
  const elements = JSON.parse(textOf("orbs-images")) as Record<string, string>;
  return {
    runs: [JSON.parse(textOf(`orbs-${kind}-name`)) as string],
    kinds: [kind],
    isServed: false,
    overview: noRun,
    target: noRun,
    raster: noRun,
    preview: noRun,
    study: async () => study as CostStudy,
    stability: async () => study as StabilityStudy,
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
