// How the images of a target open.
import { isOpen } from "../common/states";
import type { State, TargetDetail } from "../data/generated";

/**
 * Whether a target opens as result, reference and difference side by side: all that is judged and no pass. A
 * wrong image by itself may look right.
 */
export function showsItsError(state: State | undefined, { images }: TargetDetail): boolean {
  const has = (kind: string): boolean => images.some((image) => image.kind === kind);
  return !isOpen(state) && state?.name !== "pass" && has("result") && has("reference");
}
