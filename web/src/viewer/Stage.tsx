import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { reasonOf } from "../common/answer";
import type { Raster } from "../data/raster";
import type { ImageEntry } from "../data/types";
import { panesOf, imageAt, placed, zoomedAt, type Pane, type Size } from "./geometry";
import { drawOverlay } from "./overlay";
import { paintSettings, type PaintSettings } from "./paint_settings";
import { Painter, type Paint } from "./painter";
import { usePointer } from "./pointer";
import { isRaster, type Loaded } from "./use_rasters";
import type { Range } from "./statistics";
import type { ViewState } from "./view_state";

export interface Shown {
  image: ImageEntry;
  loaded: Loaded;
  range: Range | undefined;
}

interface Props {
  /** The image in front; for swipe the left and the right one; for side by side all. */
  shown: Shown[];
  /** All images that may be shown next. */
  loaded: Raster[];
  view: ViewState;
  /** Size of the images, known as soon as one is there. */
  size: Size;
  marked: { x: number; y: number } | undefined;
  selecting: boolean;
  onView: (view: ViewState) => void;
  onHover: (at: { x: number; y: number } | undefined) => void;
  onRegion: (region: ViewState["region"]) => void;
}

const kSurround = 0.18; // neutral: a coloured or bright surround changes how colours are judged

function paintOf(
  shown: Shown,
  raster: Raster,
  view: ViewState,
  pane: Pane,
  scale: number,
  size: Size,
): Paint {
  const at = placed(view, pane, size);
  const settings: PaintSettings = paintSettings(shown.image, view, raster, shown.range);
  const box = [pane.x, pane.y, pane.width, pane.height].map((v) => v * scale) as [
    number,
    number,
    number,
    number,
  ];
  return {
    ...settings,
    raster,
    pane: box,
    clip: box,
    // An image of another size than its reference lies with its corner at the same place.
    origin: [at.x - pane.width / 2 / at.zoom, at.y - pane.height / 2 / at.zoom],
    zoom: at.zoom * scale,
    zebra: view.zebra,
  };
}

/** The images themselves, with what is drawn over them. */
export function Stage(props: Props) {
  const { shown, view, size } = props;
  const box = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const overlay = useRef<HTMLCanvasElement>(null);
  const painter = useRef<Painter | undefined>(undefined);
  const [problem, setProblem] = useState<string>();
  const [stage, setStage] = useState<Size & { scale: number }>({
    width: 600,
    height: 400,
    scale: 1,
  });

  useLayoutEffect(() => {
    const element = box.current;
    if (!element) return undefined;
    const measure = (): void =>
      setStage({
        width: element.clientWidth,
        height: element.clientHeight,
        scale: devicePixelRatio || 1,
      });
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(element);
    return () => observer.disconnect();
  }, []);

  useEffect(() => {
    const element = canvas.current;
    if (!element) return undefined;
    const start = (): void => {
      try {
        painter.current = new Painter(element);
        setProblem(undefined);
      } catch (error) {
        setProblem(reasonOf(error));
      }
    };
    const stop = (event: Event): void => {
      event.preventDefault(); // or the browser never starts it again
      painter.current = undefined;
      delete element.dataset["drawn"];
      setProblem(
        "the graphics driver has stopped; the images are drawn as soon as it starts again",
      );
    };
    start();
    element.addEventListener("webglcontextlost", stop);
    element.addEventListener("webglcontextrestored", start);
    return () => {
      element.removeEventListener("webglcontextlost", stop);
      element.removeEventListener("webglcontextrestored", start);
      painter.current?.dispose();
    };
  }, []);

  const swiping = view.mode === "swipe" && shown.length === 2;
  const panes = swiping
    ? shown.map(({ image }) => ({
        name: image.name,
        x: 0,
        y: 0,
        width: stage.width,
        height: stage.height,
      }))
    : panesOf(
        shown.map(({ image }) => image.name),
        stage,
        size,
      );

  useEffect(() => {
    const frame = requestAnimationFrame(() => {
      const element = canvas.current;
      if (!element || !painter.current || !overlay.current) return;
      for (const one of [element, overlay.current]) {
        const width = Math.round(stage.width * stage.scale);
        const height = Math.round(stage.height * stage.scale);
        if (one.width !== width || one.height !== height) [one.width, one.height] = [width, height];
      }
      painter.current.keepOnly(props.loaded);
      painter.current.clear(kSurround);
      shown.forEach((one, i) => {
        const pane = panes[i];
        if (!pane || !isRaster(one.loaded)) return;
        const most = painter.current?.mostPixels ?? 0;
        if (Math.max(one.loaded.width, one.loaded.height) > most)
          return setProblem(
            `the image is larger than the ${most} pixels that this graphics driver draws`,
          );
        const paint = paintOf(one, one.loaded, view, pane, stage.scale, size);
        if (swiping) {
          const divider = Math.round(stage.width * stage.scale * view.swipe);
          const height = stage.height * stage.scale;
          paint.clip =
            i === 0
              ? [0, 0, divider, height]
              : [divider, 0, stage.width * stage.scale - divider, height];
        }
        painter.current?.paint(paint, kSurround);
      });
      drawOverlay(overlay.current, {
        shown,
        panes,
        view,
        size,
        stage,
        swiping,
        marked: props.marked,
      });
      element.dataset["drawn"] = shown
        .map((one) => (isRaster(one.loaded) ? one.image.name : ""))
        .join(" ");
    });
    return () => cancelAnimationFrame(frame);
  });

  const paneAt = (x: number, y: number): Pane =>
    panes.find(
      (pane) => x >= pane.x && x < pane.x + pane.width && y >= pane.y && y < pane.y + pane.height,
    ) ??
    panes[0] ?? { name: "", x: 0, y: 0, ...stage };
  const handlers = usePointer({
    box,
    at: (x, y) => imageAt(view, paneAt(x, y), size, x, y),
    zoomBy: (x, y, factor) => props.onView(zoomedAt(view, paneAt(x, y), size, x, y, factor)),
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

  const waiting = shown.filter((one) => one.loaded === undefined).map((one) => one.image.name);
  const failed = shown.flatMap((one) =>
    one.loaded && !isRaster(one.loaded) ? [one.loaded.problem] : [],
  );
  return (
    <div class={`stage ${props.selecting ? "selecting" : ""}`} ref={box} {...handlers}>
      <canvas
        ref={canvas}
        role="img"
        aria-label={`Image: ${shown.map(({ image }) => image.name).join(", ")}`}
      />
      <canvas ref={overlay} class="overlay" aria-hidden="true" />
      {swiping ? <Divider view={view} onView={props.onView} width={stage.width} /> : null}
      {[problem, ...failed].filter(Boolean).map((text) => (
        <p class="stage-note" role="alert" key={text}>
          {text}
        </p>
      ))}
      {waiting.length > 0 ? <p class="stage-note">Loading {waiting.join(", ")} …</p> : null}
    </div>
  );
}

function Divider({
  view,
  onView,
  width,
}: {
  view: ViewState;
  onView: (view: ViewState) => void;
  width: number;
}) {
  const move = (swipe: number): void => onView({ ...view, swipe: Math.min(1, Math.max(0, swipe)) });
  return (
    <div
      class="divider"
      role="slider"
      tabIndex={0}
      aria-label="Divider"
      aria-valuemin={0}
      aria-valuemax={100}
      aria-valuenow={Math.round(view.swipe * 100)}
      style={{ left: `${view.swipe * 100}%` }}
      onPointerDown={(event) => {
        event.stopPropagation();
        event.currentTarget.setPointerCapture(event.pointerId);
      }}
      onPointerMove={(event) => {
        if (!event.currentTarget.hasPointerCapture(event.pointerId)) return;
        event.stopPropagation();
        const left = event.currentTarget.parentElement?.getBoundingClientRect().left ?? 0;
        move((event.clientX - left) / width);
      }}
      onKeyDown={(event) => {
        const step = event.key === "ArrowLeft" ? -0.01 : event.key === "ArrowRight" ? 0.01 : 0;
        if (!step) return;
        event.preventDefault();
        event.stopPropagation();
        move(view.swipe + step);
      }}
    />
  );
}
