import { rawFloat } from "../common/format";
import { valueAt, type Raster } from "../data/raster";
import { seenChannels } from "./channels";
import { placed, type Pane, type Size } from "./geometry";
import type { StageContent } from "./stage_content";
import { isRaster } from "./use_rasters";
import type { ViewState } from "./view_state";

const kOutline = "#ff8a3d"; // neither the yellow of the region nor the magenta of the marked pixel
const kNumbersFrom = 36; // screen pixels per pixel; below that four digits do not fit

/** A value with few characters, to fit into one pixel. */
function tiny(value: number): string {
  if (!Number.isFinite(value)) return rawFloat(value);
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e4)
    return value
      .toPrecision(3)
      .slice(0, 7)
      .replace(/^(-?)0\./, "$1.");
  return value.toExponential(1).replace("e+", "e");
}

function drawNumbers(
  pen: CanvasRenderingContext2D,
  raster: Raster,
  pane: Pane,
  view: ViewState,
  size: Size,
): void {
  const at = placed(view, pane, size);
  const left = pane.x + pane.width / 2 - at.x * at.zoom;
  const top = pane.y + pane.height / 2 - at.y * at.zoom;
  const x0 = Math.max(0, Math.floor((pane.x - left) / at.zoom));
  const y0 = Math.max(0, Math.floor((pane.y - top) / at.zoom));
  const x1 = Math.min(raster.width, Math.ceil((pane.x + pane.width - left) / at.zoom));
  const y1 = Math.min(raster.height, Math.ceil((pane.y + pane.height - top) / at.zoom));
  const channels = seenChannels(raster, view.channel);
  pen.font = `${Math.min(14, at.zoom / 4.2)}px ui-monospace, monospace`;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.lineWidth = 3;
  const line = Math.min(15, at.zoom / 3.6);
  for (let y = y0; y < y1; ++y)
    for (let x = x0; x < x1; ++x)
      channels.forEach((c, i) => {
        const text = tiny(valueAt(raster, c, y * raster.width + x));
        const tx = left + (x + 0.5) * at.zoom;
        const ty = top + (y + 0.5) * at.zoom + (i - (channels.length - 1) / 2) * line;
        // Light text with a dark outline is readable on any colour.
        pen.strokeStyle = "rgba(0,0,0,.75)";
        pen.strokeText(text, tx, ty);
        pen.fillStyle =
          channels.length === 1 ? "#fff" : (["#ff9d94", "#8fe89a", "#9cc4ff"][c] ?? "#fff");
        pen.fillText(text, tx, ty);
      });
}

function drawBox(
  pen: CanvasRenderingContext2D,
  pane: Pane,
  view: ViewState,
  size: Size,
  [x0, y0, x1, y1]: [number, number, number, number],
  colour: string,
): void {
  const at = placed(view, pane, size);
  const left = pane.x + pane.width / 2 + (x0 - at.x) * at.zoom;
  const top = pane.y + pane.height / 2 + (y0 - at.y) * at.zoom;
  const width = (x1 - x0) * at.zoom;
  const height = (y1 - y0) * at.zoom;
  pen.lineWidth = 3;
  pen.strokeStyle = "rgba(0,0,0,.8)";
  pen.strokeRect(left, top, width, height);
  pen.lineWidth = 1.5;
  pen.strokeStyle = colour;
  pen.strokeRect(left, top, width, height);
}

function drawTitle(pen: CanvasRenderingContext2D, text: string, x: number, y: number): void {
  pen.font = "600 13px system-ui, sans-serif";
  pen.textAlign = "left";
  pen.textBaseline = "top";
  const width = pen.measureText(text).width;
  pen.fillStyle = "rgba(0,0,0,.65)";
  pen.fillRect(x, y, width + 12, 21);
  pen.fillStyle = "#fff";
  pen.fillText(text, x + 6, y + 4);
}

/** Draws over the images: values in large pixels, the region, the marked pixel, names. */
export function drawOverlay(canvas: HTMLCanvasElement, content: StageContent): void {
  const pen = canvas.getContext("2d");
  if (!pen) return;
  const { shown, panes, view, size, stage } = content;
  pen.setTransform(stage.scale, 0, 0, stage.scale, 0, 0);
  pen.clearRect(0, 0, stage.width, stage.height);
  let numbers = 0;
  shown.forEach((one, i) => {
    const pane = panes[i];
    if (!pane) return;
    pen.save();
    pen.beginPath();
    const divider = stage.width * view.swipe;
    if (content.swiping && i === 0) pen.rect(0, 0, divider, stage.height);
    else if (content.swiping) pen.rect(divider, 0, stage.width, stage.height);
    else pen.rect(pane.x, pane.y, pane.width, pane.height);
    pen.clip();
    if (isRaster(one.loaded) && placed(view, pane, size).zoom >= kNumbersFrom) {
      drawNumbers(pen, one.loaded, pane, view, size);
      ++numbers;
    }
    for (const box of content.outlined) drawBox(pen, pane, view, size, box, kOutline);
    if (view.region) drawBox(pen, pane, view, size, view.region, "#ffd84d");
    const { marked } = content;
    if (marked)
      drawBox(
        pen,
        pane,
        view,
        size,
        [marked.x - 0.5, marked.y - 0.5, marked.x + 1.5, marked.y + 1.5],
        "#ff4dff",
      );
    pen.restore();
    if (content.swiping && i === 1)
      drawTitle(pen, one.image.name, Math.min(divider + 8, stage.width - 90), 8);
    else drawTitle(pen, one.image.name, pane.x + 8, pane.y + 8);
  });
  canvas.dataset["numbers"] = String(numbers);
  canvas.dataset["outlined"] = content.outlined.map((box) => box.join()).join(" ");
}
