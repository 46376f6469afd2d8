import { useEffect, useMemo, useState } from "preact/hooks";
import type { ImageEntry } from "../data/source";
import { kDifference } from "./difference";
import { useHeldKey } from "./held_key";
import { kDefaultView, type ViewState } from "./view_state";

const kBlink_ms = 1000;

/** The name of the image of a diagnosis whose fault can be undone (src/report/target_data.cpp). */
const kFaultUndone = "fault undone";

/** The name that blinking shows now; undefined while it is off. */
function useBlink(on: boolean, names: string[]): string | undefined {
  const [step, setStep] = useState(0);
  useEffect(() => {
    if (!on) return undefined;
    const timer = setInterval(() => setStep((n) => n + 1), kBlink_ms);
    return () => clearInterval(timer);
  }, [on]);
  return on ? names[step % names.length] : undefined;
}

export interface Front {
  /** The image in front; undefined if there are no images. */
  front: ImageEntry | undefined;
  /** The images on the stage: one, two of a swipe, or all that are side by side. */
  visible: ImageEntry[];
  /** Names of the images of blink and side by side. */
  ticked: string[];
  /** The images that are compared, as far as they are there. */
  pair: Pair;
}

/** Names of two images that are compared; "" if there is none. */
export interface Pair {
  a: string;
  b: string;
}

/**
 * Side by side, a diagnosis is shown to the eye: the result, the reference, the result with the fault undone and
 * what is left of the difference. Where a fault cannot be undone, the reference with it takes the place of the
 * reference.
 */
function pairOfProof(images: ImageEntry[], view: ViewState): Pair | undefined {
  const proof = images.find(({ kind }) => kind === "proof");
  if (!proof || view.mode !== "side" || view.a !== kDefaultView.a || view.b !== kDefaultView.b)
    return undefined;
  return proof.name === kFaultUndone
    ? { a: proof.name, b: kDefaultView.b }
    : { a: kDefaultView.a, b: proof.name };
}

/** A is the result and B the reference, unless the view names others that are there. */
export function pairOf(images: ImageEntry[], view: ViewState): Pair {
  const proven = pairOfProof(images, view);
  if (proven) return proven;
  const named = (name: string, kind: string): string =>
    (
      images.find((image) => image.name === name && image.kind !== "map") ??
      images.find((image) => image.kind === kind)
    )?.name ?? "";
  return { a: named(view.a, "result"), b: named(view.b, "reference") };
}

/** Which images are shown: Shift (image B) comes before blinking, and blinking before the chosen image. */
export function useFront(images: ImageEntry[], view: ViewState, blinking: boolean): Front {
  const [shift, setShift] = useState(false);
  useHeldKey("shift", setShift);
  const pair = pairOf(images, view);
  const [imageA, imageB] = [pair.a, pair.b].map((name) => images.find((one) => one.name === name));
  const chosen = images.find((image) => image.name === view.image) ?? images[0];
  const names = view.ticked.filter((name) => images.some((image) => image.name === name));
  // Blinking shows a difference by itself. A layer has no picture of its own to know errors by.
  const withDifference = view.mode === "side" || view.layer !== "";
  const proofs = view.mode === "side" ? images.filter(({ kind }) => kind === "proof") : [];
  const pictures = proofs.length > 0 ? [kDefaultView.a, kDefaultView.b] : [pair.a, pair.b];
  const usual = [
    ...pictures,
    ...proofs.map(({ name }) => name),
    ...(withDifference ? [kDifference] : []),
  ];
  const ticked = names.length > 0 ? names : usual.filter((name) => name !== "");
  const blink = useBlink(blinking, ticked);
  const front = (shift && imageB) || images.find((image) => image.name === blink) || chosen;
  const other = front === imageB ? imageA : imageB;
  const visible = useMemo((): ImageEntry[] => {
    if (!front) return [];
    if (view.mode === "side") return images.filter((image) => ticked.includes(image.name));
    return view.mode === "swipe" && other && other !== front ? [front, other] : [front];
  }, [images, view.mode, front, other, ticked.join()]);
  return { front, visible, ticked, pair };
}
