// How the images of a target open.
import { isOpen } from "../common/states";
import type { State, TargetDetail } from "../data/generated";
import type { Region } from "../viewer/statistics";

/**
 * Whether a target opens as result, reference and difference side by side: all that is judged and no pass. A
 * wrong image by itself may look right.
 */
export function showsItsError(state: State | undefined, { images }: TargetDetail): boolean {
  const has = (kind: string): boolean => images.some((image) => image.kind === kind);
  return !isOpen(state) && state?.name !== "pass" && has("result") && has("reference");
}

/** The largest part of the image that is wrong for certain, as the viewer outlines it; none if none is known. */
export const worstRegion = ({ wrong_regions: [largest] }: TargetDetail): Region[] =>
  largest?.where?.length === 4 ? [largest.where as Region] : [];
