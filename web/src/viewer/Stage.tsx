import { useEffect, useRef } from "preact/hooks";
import type { Raster } from "../data/raster";
import { Divider } from "./Divider";
import { drawStage } from "./draw_stage";
import { imageAt, placed, zoomedAt, type Pane, type Size } from "./geometry";
import { usePointer } from "./pointer";
import { stagePanes, type Shown } from "./stage_content";
import type { Region } from "./statistics";
import { usePainter, useStageSize } from "./use_painter";
import { isRaster } from "./use_rasters";
import type { ViewState } from "./view_state";

interface Props {
  /** Flip: the image in front. Swipe: the left and the right image. Side by side: all images. */
  shown: Shown[];
  /** All images that can be shown without loading. */
  loaded: Raster[];
  view: ViewState;
  /** Size of the images in pixels; a guess until one of them is loaded. */
  size: Size;
  marked: { x: number; y: number } | undefined;
  outlined: Region[];
  selecting: boolean;
  onView: (view: ViewState) => void;
  onHover: (at: { x: number; y: number } | undefined) => void;
  onRegion: (region: ViewState["region"]) => void;
}

/** The pane at a point of the stage; beside all panes it is the first. */
function paneAt(panes: Pane[], stage: Size, x: number, y: number): Pane {
  const hit = panes.find(
    (pane) => x >= pane.x && x < pane.x + pane.width && y >= pane.y && y < pane.y + pane.height,
  );
  return hit ?? panes[0] ?? { name: "", x: 0, y: 0, ...stage };
}

/** The images, with what is drawn over them. */
export function Stage(props: Props) {
  const { shown, view, size } = props;
  const box = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const overlay = useRef<HTMLCanvasElement>(null);
  const stage = useStageSize(box);
  const { painter, problem, setProblem } = usePainter(canvas);
  const swiping = view.mode === "swipe" && shown.length === 2;
  const panes = stagePanes(shown, stage, size, swiping);
  useEffect(() => {
    const frame = requestAnimationFrame(() => {
      if (!canvas.current || !painter.current || !overlay.current) return;
      const { marked, outlined } = props;
      const content = { shown, panes, view, size, stage, swiping, marked, outlined };
      const { current } = painter;
      const failed = drawStage(current, canvas.current, overlay.current, content, props.loaded);
      if (failed !== undefined) setProblem(failed);
    });
    return () => cancelAnimationFrame(frame);
  });
  const handlers = usePointer({
    box,
    at: (x, y) => imageAt(view, paneAt(panes, stage, x, y), size, x, y),
    zoomBy: (x, y, factor) =>
      props.onView(zoomedAt(view, paneAt(panes, stage, x, y), size, x, y, factor)),
    panBy: (dx, dy) => {
      const pane = panes[0];
      if (!pane) return;
      const at = placed(view, pane, size);
      props.onView({ ...view, zoom: at.zoom, x: at.x - dx / at.zoom, y: at.y - dy / at.zoom });
    },
    selecting: props.selecting,
    onHover: props.onHover,
    onRegion: props.onRegion,
    size,
  });
  return (
    <div class={`stage ${props.selecting ? "selecting" : ""}`} ref={box} {...handlers}>
      <canvas
        ref={canvas}
        role="img"
        aria-label={`Image: ${shown.map(({ image }) => image.name).join(", ")}`}
      />
      <canvas ref={overlay} class="overlay" aria-hidden="true" />
      {swiping ? <Divider view={view} onView={props.onView} width={stage.width} /> : null}
      <Notes shown={shown} problem={problem} />
    </div>
  );
}

/** Messages over the images: what failed, and what is still loading. */
function Notes({ shown, problem }: { shown: Shown[]; problem: string | undefined }) {
  const waiting = shown.filter((one) => one.loaded === undefined);
  const names = waiting.map((one) => one.image.name).join(", ");
  const failed = shown.flatMap((one) =>
    one.loaded && !isRaster(one.loaded) ? [one.loaded.problem] : [],
  );
  return (
    <>
      {[problem, ...failed].filter(Boolean).map((text) => (
        <p class="stage-note" role="alert" key={text}>
          {text}
        </p>
      ))}
      {waiting.length > 0 ? (
        <p class="stage-note">
          {waiting.every((one) => one.preview)
            ? `Preview: the values of ${names} are loading …`
            : `Loading ${names} …`}
        </p>
      ) : null}
    </>
  );
}
