import type { Action } from "../common/keys";
import type { ImageEntry } from "../data/types";
import { fitZoom, type Size } from "./geometry";
import type { Range } from "./statistics";
import { kCurves, kModes, type ViewState } from "./view_state";
import type { Worst } from "./worst";

/** All that the keys and the buttons of the viewer act on. */
export interface Controls {
  images: ImageEntry[];
  view: ViewState;
  setView: (view: ViewState) => void;
  front: ImageEntry | undefined;
  size: Size;
  /** Of what is seen of the image in front, once it has been counted. */
  range: Range | undefined;
  worst: Worst | undefined;
  worstIndex: number;
  setWorstIndex: (index: number) => void;
  selecting: boolean;
  setSelecting: (on: boolean) => void;
  blinking: boolean;
  setBlinking: (on: boolean) => void;
  held: boolean;
  /** What can be shown of the image in front, and what of that is. */
  channels: { value: string; label: string }[];
  channel: string;
  layers: string[];
  ticked: string[];
  falseColour: boolean;
  scaleEnd: number;
}

function next<T>(list: readonly T[], now: T, step = 1): T {
  return list[(list.indexOf(now) + step + list.length) % list.length] ?? now;
}

/** Shows the pixel large enough that its numbers can be read beside its neighbours'. */
function lookAt(view: ViewState, x: number, y: number, least: number): ViewState {
  return { ...view, zoom: Math.max(view.zoom, least), x: x + 0.5, y: y + 0.5 };
}

export function toWorst(c: Controls, step: number): void {
  const pixels = c.worst?.pixels ?? [];
  if (pixels.length === 0) return;
  const index = c.worstIndex < 0 ? 0 : (c.worstIndex + step + pixels.length) % pixels.length;
  const pixel = pixels[index];
  if (!pixel) return;
  c.setWorstIndex(index);
  c.setView(lookAt(c.view, pixel.x, pixel.y, 12));
}

export function toWorstTile(c: Controls): void {
  const tile = c.worst?.tile;
  if (!tile) return;
  const [x0, y0, x1, y1] = tile;
  c.setView({ ...c.view, region: tile, zoom: 8, x: (x0 + x1) / 2, y: (y0 + y1) / 2 });
}

/** Exposure and offset that bring the image's range to 0 to 1; of false colours the end to its largest magnitude. */
export function normalise(c: Controls): void {
  if (!c.range || !c.front) return;
  const { min, max } = c.range;
  if (c.falseColour) {
    c.setView({
      ...c.view,
      ends: { ...c.view.ends, [c.front.name]: Math.max(Math.abs(min), Math.abs(max)) || 1 },
    });
  } else if (max > min) {
    c.setView({ ...c.view, exposure: Math.log2(1 / (max - min)), offset: -min / (max - min) });
  }
}

export function nudge(c: Controls, dx: number, dy: number): void {
  const { view, size } = c;
  const at = view.zoom > 0 ? view : { zoom: 1, x: size.width / 2, y: size.height / 2 };
  c.setView({ ...view, zoom: at.zoom, x: at.x + dx, y: at.y + dy });
}

export function zoomTo(c: Controls, zoom: number): void {
  const { view, size } = c;
  const middle = view.zoom > 0 ? view : { x: size.width / 2, y: size.height / 2 };
  c.setView({ ...view, zoom, x: middle.x, y: middle.y });
}

/** Everything that the viewer can do, by key; the toolbar has a button for each. */
export function viewActions(c: Controls): Action[] {
  const { view, setView } = c;
  const maps = c.images.filter((image) => image.kind === "map");
  const set = (change: Partial<ViewState>): void => setView({ ...view, ...change });
  const zoomNow = view.zoom || fitZoom({ width: 600, height: 500 }, c.size);
  const act = (key: string, label: string, run: () => void, keyName?: string): Action =>
    keyName ? { key, label, run, group: "Images", keyName } : { key, label, run, group: "Images" };
  return [
    ...c.images.slice(0, 9).map((image, i) =>
      act(String(i + 1), image.name, () => {
        c.setBlinking(false);
        set({ image: image.name });
      }),
    ),
    {
      key: "Shift",
      keyName: "hold Shift",
      label: "reference",
      group: "Images",
      run: () => undefined,
    },
    act(" ", "blink the ticked images", () => c.setBlinking(!c.blinking), "Space"),
    act("s", "swipe", () => set({ mode: view.mode === "swipe" ? "flip" : "swipe" })),
    act("m", "flip, swipe, side by side", () => set({ mode: next(kModes, view.mode) })),
    act("d", "next map of the error", () => {
      const current = maps.findIndex((image) => image.name === view.image);
      set({ image: maps[(current + 1) % maps.length]?.name ?? view.image });
    }),
    act("e", "exposure +½", () => set({ exposure: view.exposure + 0.5 })),
    act("Shift+E", "exposure −½", () => set({ exposure: view.exposure - 0.5 })),
    act("o", "offset +0.05", () => set({ offset: Number((view.offset + 0.05).toFixed(3)) })),
    act("Shift+O", "offset −0.05", () => set({ offset: Number((view.offset - 0.05).toFixed(3)) })),
    act("g", "sRGB, gamma, linear, false colour", () => set({ curve: next(kCurves, view.curve) })),
    act("n", "normalise to the image's range", () => normalise(c)),
    act("l", "linear or logarithmic colour scale", () => set({ log: !view.log })),
    act("z", "zebra on clipped values", () => set({ zebra: !view.zebra })),
    act("x", "next channel", () =>
      set({
        channel: next(
          c.channels.map(({ value }) => value),
          c.channel,
        ),
      }),
    ),
    act("r", "reset how it looks", () =>
      set({
        exposure: 0,
        offset: 0,
        curve: "srgb",
        gamma: 2.2,
        channel: "",
        layer: "",
        log: false,
        zebra: false,
        ends: {},
      }),
    ),
    act("f", "fit", () => set({ zoom: 0 })),
    act("0", "one to one", () => zoomTo(c, 1)),
    act("+", "closer", () => zoomTo(c, Math.min(256, zoomNow * 2))),
    act("-", "further away", () => zoomTo(c, Math.max(1 / 16, zoomNow / 2))),
    act("ArrowLeft", "move by a pixel", () => nudge(c, -1, 0), "← → ↑ ↓"),
    {
      key: "ArrowRight",
      keyName: "← → ↑ ↓",
      label: "move by a pixel",
      group: "Images",
      run: () => nudge(c, 1, 0),
    },
    {
      key: "ArrowUp",
      keyName: "← → ↑ ↓",
      label: "move by a pixel",
      group: "Images",
      run: () => nudge(c, 0, -1),
    },
    {
      key: "ArrowDown",
      keyName: "← → ↑ ↓",
      label: "move by a pixel",
      group: "Images",
      run: () => nudge(c, 0, 1),
    },
    act("u", "next worst pixel", () => toWorst(c, 1)),
    act("y", "previous worst pixel", () => toWorst(c, -1)),
    act("w", "worst tile", () => toWorstTile(c)),
    act("a", "draw a region (or hold C and drag)", () => c.setSelecting(!c.selecting)),
  ];
}
