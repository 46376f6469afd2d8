import type { Action } from "../common/keys";
import { nudge, normalise, show, toWorst, toWorstTile, zoomTo, type Controls } from "./controls";
import { fitZoom } from "./geometry";
import { kDifference } from "./difference";
import { kCurves, kDefaultView, kMeasures, kModes, type ViewState } from "./view_state";

function next<T>(list: readonly T[], now: T): T {
  return list[(list.indexOf(now) + 1) % list.length] ?? now;
}

const act = (key: string, label: string, run: () => void, keyName?: string): Action =>
  keyName ? { key, label, run, group: "Images", keyName } : { key, label, run, group: "Images" };

const setter =
  ({ view, setView }: Controls) =>
  (change: Partial<ViewState>): void =>
    setView({ ...view, ...change });

/** Which images are shown, and how they are arranged. */
function imageActions(c: Controls): Action[] {
  const { view } = c;
  const set = setter(c);
  const maps = c.images.filter((image) => image.kind === "map");
  const pictures = c.images.filter((image) => image.kind !== "map").map(({ name }) => name);
  const { [kDifference]: _, ...ends } = view.ends;
  const measures = kMeasures.filter((one) => one !== "noise" || c.lackOfNoise === "");
  return [
    ...c.images.slice(0, 9).map((image, i) =>
      act(String(i + 1), `show ${image.name}`, () => {
        c.setBlinking(false);
        show(c, image.name);
      }),
    ),
    // For the help only: useFront shows the reference while the key is held.
    act("Shift", "show image B (the reference)", () => undefined, "hold Shift"),
    act("h", "difference of A and B, or A", () =>
      show(c, c.front?.name === kDifference ? c.pair.a : kDifference),
    ),
    act("b", "next image as B", () => set({ b: next(pictures, c.pair.b) })),
    act("i", "next measure of the difference", () =>
      set({ measure: next(measures, view.measure), ends }),
    ),
    act(" ", "blink the ticked images", () => c.setBlinking(!c.blinking), "Space"),
    act("s", "swipe between the image and B", () =>
      set({ mode: view.mode === "swipe" ? "flip" : "swipe" }),
    ),
    act("m", "flip, swipe, side by side", () => set({ mode: next(kModes, view.mode) })),
    act("d", "next map: those of the run, then the difference by each measure", () => {
      const { name } = c.front ?? { name: "" };
      const isLast = view.measure === measures.at(-1);
      if (name === kDifference && (!isLast || maps.length === 1))
        return set({ measure: next(measures, view.measure), ends });
      show(
        c,
        next(
          maps.map((map) => map.name),
          name,
        ),
      );
    }),
  ];
}

/** How the values of an image become colours. */
function appearanceActions(c: Controls): Action[] {
  const { view } = c;
  const set = setter(c);
  const addOffset = (step: number): void =>
    set({ offset: Number((view.offset + step).toFixed(3)) });
  const channels = c.channels.map(({ value }) => value);
  const { exposure, offset, curve, gamma, channel, layer, log, zebra, ends } = kDefaultView;
  return [
    act("e", "exposure +½ stop", () => set({ exposure: view.exposure + 0.5 })),
    act("Shift+E", "exposure −½ stop", () => set({ exposure: view.exposure - 0.5 })),
    act("o", "offset +0.05", () => addOffset(0.05)),
    act("Shift+O", "offset −0.05", () => addOffset(-0.05)),
    act("g", "sRGB, gamma, linear, false colour", () => set({ curve: next(kCurves, view.curve) })),
    act("n", "normalise to a percentile of what is visible", () => normalise(c)),
    act("l", "linear or logarithmic colour scale", () => set({ log: !view.log })),
    act("z", "zebra stripes on clipped values", () => set({ zebra: !view.zebra })),
    act("x", "next channel", () => set({ channel: next(channels, c.channel) })),
    act("r", "reset the appearance", () =>
      set({ exposure, offset, curve, gamma, channel, layer, log, zebra, ends }),
    ),
  ];
}

/** Which part of the images is shown. */
function zoomActions(c: Controls): Action[] {
  const set = setter(c);
  const zoom = c.view.zoom || fitZoom({ width: 600, height: 500 }, c.size);
  const arrow = (key: string, dx: number, dy: number): Action =>
    act(key, "move by a pixel", () => nudge(c, dx, dy), "← → ↑ ↓");
  return [
    act("f", "fit to the window", () => set({ zoom: 0 })),
    act("Shift+F", "fill the window with the images", () => c.setFull(!c.full)),
    act("0", "one screen pixel per pixel", () => zoomTo(c, 1)),
    act("+", "zoom in", () => zoomTo(c, Math.min(256, zoom * 2))),
    act("-", "zoom out", () => zoomTo(c, Math.max(1 / 16, zoom / 2))),
    arrow("ArrowLeft", -1, 0),
    arrow("ArrowRight", 1, 0),
    arrow("ArrowUp", 0, -1),
    arrow("ArrowDown", 0, 1),
  ];
}

/** Where the errors are. */
function errorActions(c: Controls): Action[] {
  return [
    act("u", "next worst pixel", () => toWorst(c, 1)),
    act("y", "previous worst pixel", () => toWorst(c, -1)),
    act("w", "worst tile", () => toWorstTile(c)),
    act("a", "draw a region (or hold C and drag)", () => c.setSelecting(!c.selecting)),
  ];
}

/** Escape ends what was begun in the viewer; without that it leaves for the overview. */
function escapeActions(c: Controls): Action[] {
  if (c.selecting) return [act("Escape", "stop drawing", () => c.setSelecting(false))];
  return c.full ? [act("Escape", "leave the full window", () => c.setFull(false))] : [];
}

/** Everything that the viewer can do, by key; the toolbar has a button for each. */
export const viewActions = (c: Controls): Action[] => [
  ...escapeActions(c),
  ...imageActions(c),
  ...appearanceActions(c),
  ...zoomActions(c),
  ...errorActions(c),
];
