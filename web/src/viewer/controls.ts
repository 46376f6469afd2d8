import type { Raster } from "../data/raster";
import type { ImageEntry } from "../data/source";
import type { Size } from "./geometry";
import type { PaintSettings } from "./paint_settings";
import type { ViewState } from "./view_state";
import type { Pair } from "./use_front";
import { percentileRange, visiblePixels } from "./visible_range";
import type { Worst } from "./worst";

/** All that the keys and the buttons of the viewer act on. */
export interface Controls {
  images: ImageEntry[];
  view: ViewState;
  setView: (view: ViewState) => void;
  front: ImageEntry | undefined;
  /** How the image in front is painted. */
  settings: PaintSettings | undefined;
  size: Size;
  /** The image in front, once it is loaded. */
  raster: Raster | undefined;
  /** The size of the pane of the image in front, in CSS pixels. */
  pane: () => Size;
  worst: Worst | undefined;
  /** How many pixels of A and B differ. */
  differing: number | undefined;
  /** Rank of the worst pixel that is visited, from 0; -1 before the first visit. */
  worstIndex: number;
  setWorstIndex: (index: number) => void;
  selecting: boolean;
  setSelecting: (on: boolean) => void;
  blinking: boolean;
  setBlinking: (on: boolean) => void;
  /** The viewer fills the window. */
  full: boolean;
  setFull: (on: boolean) => void;
  /** Channels that the image in front offers, and the one that is shown. */
  channels: { value: string; label: string }[];
  channel: string;
  layers: string[];
  /** Why the difference cannot be divided by its noise; "" if it can. */
  lackOfNoise: string;
  /** Names of the images of blink and side by side. */
  ticked: string[];
  pair: Pair;
  /** Names of images that can be added. */
  extra: string[];
  /** Address of the file of an image; undefined if it has none that can be saved. */
  addressOf: (image: ImageEntry) => string | undefined;
}

/** Shows one image; side by side it was one of several. */
export function show(c: Controls, image: string, change: Partial<ViewState> = {}): void {
  const mode = c.view.mode === "side" ? "flip" : c.view.mode;
  c.setView({ ...c.view, mode, image, ...change });
}

/** Centres a pixel, at a zoom of at least `least`. */
function lookAt(view: ViewState, x: number, y: number, least: number): ViewState {
  return { ...view, zoom: Math.max(view.zoom, least), x: x + 0.5, y: y + 0.5 };
}

/** Visits the worst pixel that is `step` ranks after the visited one. */
export function toWorst(c: Controls, step: number): void {
  const pixels = c.worst?.pixels ?? [];
  if (pixels.length === 0) return;
  const index = c.worstIndex < 0 ? 0 : (c.worstIndex + step + pixels.length) % pixels.length;
  const pixel = pixels[index];
  if (!pixel) return;
  c.setWorstIndex(index);
  c.setView(lookAt(c.view, pixel.x, pixel.y, 12));
}

/** Shows the tile with the largest mean error, and makes it the region. */
export function toWorstTile(c: Controls): void {
  const tile = c.worst?.tile;
  if (!tile) return;
  const [x0, y0, x1, y1] = tile;
  c.setView({ ...c.view, region: tile, zoom: 8, x: (x0 + x1) / 2, y: (y0 + y1) / 2 });
}

/**
 * Chooses exposure and offset so that the range of what is visible becomes 0 to 1; in false colour
 * ends the scale at its largest magnitude. The range is that of the chosen percentile.
 */
export function normalise(c: Controls): void {
  if (!c.raster || !c.front || !c.settings) return;
  const { raster, view } = c;
  const visible = visiblePixels(view, c.pane(), raster);
  const range = percentileRange(raster, c.settings.channels, visible, view.percentile);
  if (!range) return;
  const { min, max } = range;
  if (c.settings?.falseColour) {
    c.setView({
      ...c.view,
      ends: { ...c.view.ends, [c.front.name]: Math.max(Math.abs(min), Math.abs(max)) || 1 },
    });
  } else if (max > min) {
    c.setView({ ...c.view, exposure: Math.log2(1 / (max - min)), offset: -min / (max - min) });
  }
}

/** Moves the centre of the view by whole pixels. */
export function nudge(c: Controls, dx: number, dy: number): void {
  const { view, size } = c;
  const at = view.zoom > 0 ? view : { zoom: 1, x: size.width / 2, y: size.height / 2 };
  c.setView({ ...view, zoom: at.zoom, x: at.x + dx, y: at.y + dy });
}

/** Zooms around the centre of the view. */
export function zoomTo(c: Controls, zoom: number): void {
  const { view, size } = c;
  const middle = view.zoom > 0 ? view : { x: size.width / 2, y: size.height / 2 };
  c.setView({ ...view, zoom, x: middle.x, y: middle.y });
}
