// Images of cost studies.
import type { CostStudy } from "../data/generated";
import type { ImageEntry } from "../data/source";

/** The images of all points of a target, in the order of the curves; "orbs 16 spp". */
export function sweepImages(study: CostStudy, run: number, target: string): ImageEntry[] {
  return study.curves
    .filter((curve) => study.targets[curve.target]?.name === target)
    .flatMap((curve) =>
      curve.points
        .filter((point) => point.exr)
        .map((point) => ({
          name: `${study.renderers[curve.renderer]?.name} ${point.setting}`,
          kind: "other",
          file: point.exr,
          run,
        })),
    );
}
