// Images of the rungs of cost studies.
import type { CostStudy } from "../cost/types";
import type { ImageEntry } from "../data/types";

/** The images of all rungs on a target, in the order of the curves; "orbs 16 spp". */
export function rungImages(study: CostStudy, run: number, target: string): ImageEntry[] {
  return study.curves
    .filter((curve) => study.targets[curve.target]?.name === target)
    .flatMap((curve) =>
      curve.points
        .filter((point) => point.exr)
        .map((point) => ({
          name: `${study.renderers[curve.renderer]?.name} ${point.rung}`,
          kind: "other",
          file: point.exr,
          run,
        })),
    );
}
