import type { Raster } from "../data/raster";
import { placed, type Pane } from "./geometry";
import { drawOverlay } from "./overlay";
import { paintSettings } from "./paint_settings";
import type { Paint, Painter, Rectangle } from "./painter";
import type { Shown, StageContent, StageSize } from "./stage_content";
import { isRaster } from "./use_rasters";

// A neutral dark grey: a coloured or bright surround changes the perception of colours.
const kSurround = 0.18;

/** The part of the stage that image `index` of a swipe fills, in device pixels. */
function swipeClip(index: number, stage: StageSize, swipe: number): Rectangle {
  const [width, height] = [stage.width * stage.scale, stage.height * stage.scale];
  const divider = Math.round(width * swipe);
  return index === 0 ? [0, 0, divider, height] : [divider, 0, width - divider, height];
}

function paintOf(content: StageContent, shown: Shown, raster: Raster, pane: Pane): Paint {
  const { view, size, stage } = content;
  const at = placed(view, pane, size);
  // A preview has fewer pixels, which are as much larger.
  const factor = raster === shown.preview ? size.width / raster.width : 1;
  const box = [pane.x, pane.y, pane.width, pane.height].map((v) => v * stage.scale) as Rectangle;
  return {
    ...paintSettings(shown.image, view, raster, shown.range),
    raster,
    pane: box,
    clip: content.swiping ? swipeClip(content.shown.indexOf(shown), stage, view.swipe) : box,
    // The top left corners of an image and its reference coincide, even if their sizes differ.
    origin: [
      (at.x - pane.width / 2 / at.zoom) / factor,
      (at.y - pane.height / 2 / at.zoom) / factor,
    ],
    zoom: at.zoom * stage.scale * factor,
    zebra: view.zebra,
  };
}

function fitToStage(canvas: HTMLCanvasElement, stage: StageSize): void {
  const width = Math.round(stage.width * stage.scale);
  const height = Math.round(stage.height * stage.scale);
  // Assigning a size clears the canvas, even if it is the same size.
  if (canvas.width !== width || canvas.height !== height)
    [canvas.width, canvas.height] = [width, height];
}

/**
 * Draws the images and their overlay. The textures of all images but `loaded` are freed.
 * Returns a message if an image could not be drawn.
 */
export function drawStage(
  painter: Painter,
  canvas: HTMLCanvasElement,
  overlay: HTMLCanvasElement,
  content: StageContent,
  loaded: Raster[],
): string | undefined {
  const { shown, stage } = content;
  let problem: string | undefined;
  for (const one of [canvas, overlay]) fitToStage(one, stage);
  painter.keepOnly(loaded);
  painter.clear(kSurround);
  shown.forEach((one, i) => {
    const pane = content.panes[i];
    const raster = one.loaded === undefined ? one.preview : one.loaded;
    if (!pane || !isRaster(raster)) return;
    const most = painter.mostPixels;
    if (Math.max(raster.width, raster.height) > most)
      problem = `the image is larger than the ${most} pixels that this graphics driver draws`;
    else painter.paint(paintOf(content, one, raster, pane), kSurround);
  });
  drawOverlay(overlay, content);
  const names = (isIn: (one: Shown) => boolean): string =>
    shown.map((one) => (isIn(one) ? one.image.name : "")).join(" ");
  canvas.dataset["drawn"] = names((one) => isRaster(one.loaded));
  canvas.dataset["preview"] = names((one) => one.loaded === undefined && one.preview !== undefined);
  return problem;
}
