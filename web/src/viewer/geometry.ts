import type { ViewState } from "./view_state";

export interface Size {
  width: number;
  height: number;
}

export interface Pane {
  name: string;
  x: number;
  y: number;
  width: number;
  height: number;
}

/** Panes of the stage in its pixels: one, or for side by side a grid that leaves the images largest. */
export function panesOf(names: string[], stage: Size, image: Size): Pane[] {
  const gap = 4;
  let best: { columns: number; rows: number; zoom: number } = {
    columns: 1,
    rows: names.length,
    zoom: 0,
  };
  for (let columns = 1; columns <= names.length; ++columns) {
    const rows = Math.ceil(names.length / columns);
    const zoom = Math.min(stage.width / columns / image.width, stage.height / rows / image.height);
    if (zoom > best.zoom) best = { columns, rows, zoom };
  }
  const width = Math.floor((stage.width - gap * (best.columns - 1)) / best.columns);
  const height = Math.floor((stage.height - gap * (best.rows - 1)) / best.rows);
  return names.map((name, i) => ({
    name,
    x: (i % best.columns) * (width + gap),
    y: Math.floor(i / best.columns) * (height + gap),
    width,
    height,
  }));
}

export const fitZoom = (pane: Size, image: Size): number =>
  Math.min(pane.width / image.width, pane.height / image.height);

/** Zoom and middle as they are, with "fit" resolved. */
export function placed(
  view: ViewState,
  pane: Size,
  image: Size,
): { zoom: number; x: number; y: number } {
  if (view.zoom > 0) return { zoom: view.zoom, x: view.x, y: view.y };
  return { zoom: fitZoom(pane, image), x: image.width / 2, y: image.height / 2 };
}

/** Position in the image of a point of the pane. */
export function imageAt(
  view: ViewState,
  pane: Pane,
  image: Size,
  x: number,
  y: number,
): { x: number; y: number } {
  const at = placed(view, pane, image);
  return {
    x: at.x + (x - pane.x - pane.width / 2) / at.zoom,
    y: at.y + (y - pane.y - pane.height / 2) / at.zoom,
  };
}

/** The view after a zoom by `factor` that leaves the point of the image under (x, y) where it is. */
export function zoomedAt(
  view: ViewState,
  pane: Pane,
  image: Size,
  x: number,
  y: number,
  factor: number,
): ViewState {
  const at = placed(view, pane, image);
  const zoom = Math.min(256, Math.max(fitZoom(pane, image) / 4, at.zoom * factor));
  const point = imageAt(view, pane, image, x, y);
  return {
    ...view,
    zoom,
    x: point.x - (x - pane.x - pane.width / 2) / zoom,
    y: point.y - (y - pane.y - pane.height / 2) / zoom,
  };
}
