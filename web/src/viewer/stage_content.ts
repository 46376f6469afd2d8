import type { Raster } from "../data/raster";
import type { ImageEntry } from "../data/source";
import { panesOf, type Pane, type Size } from "./geometry";
import type { Range, Region } from "./statistics";
import type { Loaded } from "./use_rasters";
import type { ViewState } from "./view_state";

/** An image in one pane of the stage. */
export interface Shown {
  image: ImageEntry;
  loaded: Loaded;
  /** Shown until the image is loaded: fewer pixels, of 8 bits. */
  preview: Raster | undefined;
  range: Range | undefined;
}

/** Size of the stage in CSS pixels; `scale` is the number of device pixels per CSS pixel. */
export interface StageSize extends Size {
  scale: number;
}

/** All that is drawn on the stage. */
export interface StageContent {
  shown: Shown[];
  /** One pane for each image that is shown, in CSS pixels. */
  panes: Pane[];
  view: ViewState;
  /** Size of the images in their own pixels. */
  size: Size;
  stage: StageSize;
  /** A divider separates the two images, which share one pane. */
  swiping: boolean;
  marked: { x: number; y: number } | undefined;
  /** x0, y0, x1, y1 of parts of the images that are outlined. */
  outlined: Region[];
}

/** One pane for each image; the two images of a swipe both fill the stage. */
export function stagePanes(shown: Shown[], stage: StageSize, size: Size, swiping: boolean): Pane[] {
  const names = shown.map(({ image }) => image.name);
  const { width, height } = stage;
  return swiping
    ? names.map((name) => ({ name, x: 0, y: 0, width, height }))
    : panesOf(names, stage, size);
}
