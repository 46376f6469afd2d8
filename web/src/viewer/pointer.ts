import type { RefObject } from "preact";
import { useEffect, useRef } from "preact/hooks";
import type { Size } from "./geometry";
import { useHeldKey } from "./held_key";
import type { Region } from "./statistics";

interface Point {
  x: number;
  y: number;
}

interface Options {
  box: RefObject<HTMLDivElement | null>;
  /** Position in the image of a point of the stage. */
  at: (x: number, y: number) => Point;
  zoomBy: (x: number, y: number, factor: number) => void;
  panBy: (dx: number, dy: number) => void;
  /** Dragging draws a region instead of moving the image. */
  selecting: boolean;
  onHover: (at: Point | undefined) => void;
  onRegion: (region: Region | undefined) => void;
  size: Size;
}

/** The pixels between two positions, clamped to the image; undefined if there are none. */
function regionBetween(a: Point, b: Point, size: Size): Region | undefined {
  const clamp = (v: number, most: number): number => Math.min(most, Math.max(0, v));
  const region: Region = [
    clamp(Math.floor(Math.min(a.x, b.x)), size.width),
    clamp(Math.floor(Math.min(a.y, b.y)), size.height),
    clamp(Math.ceil(Math.max(a.x, b.x)), size.width),
    clamp(Math.ceil(Math.max(a.y, b.y)), size.height),
  ];
  return region[2] > region[0] && region[3] > region[1] ? region : undefined;
}

/** Position of an event relative to the top left corner of the stage. */
function localPoint({ box }: Options, event: { clientX: number; clientY: number }): Point {
  const rectangle = box.current?.getBoundingClientRect();
  return {
    x: event.clientX - (rectangle?.left ?? 0),
    y: event.clientY - (rectangle?.top ?? 0),
  };
}

function useWheel(options: RefObject<Options>): void {
  useEffect(() => {
    const element = options.current?.box.current;
    const wheel = (event: WheelEvent): void => {
      const { current } = options;
      event.preventDefault();
      if (!current) return;
      const at = localPoint(current, event);
      const lines = event.deltaMode === 1 ? 16 : 1;
      current.zoomBy(at.x, at.y, 2 ** ((-event.deltaY * lines) / 200));
    };
    // A passive listener could not keep the page from scrolling.
    element?.addEventListener("wheel", wheel, { passive: false });
    return () => element?.removeEventListener("wheel", wheel);
  }, []);
}

/** Two fingers zoom around the one that rests. */
function pinch(options: Options, before: Point, at: Point, other: Point): void {
  const distance = (p: Point): number => Math.hypot(p.x - other.x, p.y - other.y);
  options.zoomBy(other.x, other.y, distance(at) / Math.max(1, distance(before)));
}

/** Pointers on the stage: dragging pans or draws a region, the wheel and two fingers zoom. */
export function usePointer(options: Options) {
  const now = useRef(options);
  now.current = options;
  const down = useRef(new Map<number, Point>());
  const start = useRef<Point | undefined>(undefined);
  const heldC = useRef(false); // a change does not render the component again
  useHeldKey("c", (held) => void (heldC.current = held));
  useEffect(() => {
    // Before all other listeners: Escape while a region is drawn ends the drawing and nothing else.
    const cancel = (event: KeyboardEvent): void => {
      if (event.key !== "Escape" || !start.current) return;
      event.stopImmediatePropagation();
      event.preventDefault();
      start.current = undefined;
      down.current.clear();
      now.current.onRegion(undefined);
    };
    addEventListener("keydown", cancel, { capture: true });
    return () => removeEventListener("keydown", cancel, { capture: true });
  }, []);
  useWheel(now);
  const moved = (event: PointerEvent): void => {
    const { current } = now;
    const at = localPoint(current, event);
    current.onHover(current.at(at.x, at.y));
    const before = down.current.get(event.pointerId);
    if (!before) return;
    const other = [...down.current].find(([id]) => id !== event.pointerId)?.[1];
    if (start.current)
      current.onRegion(regionBetween(start.current, current.at(at.x, at.y), current.size));
    else if (other) pinch(current, before, at, other);
    else current.panBy(at.x - before.x, at.y - before.y);
    down.current.set(event.pointerId, at);
  };
  const up = (event: PointerEvent): void => {
    down.current.delete(event.pointerId);
    start.current = undefined;
  };
  return {
    onPointerDown: (event: PointerEvent) => {
      if (event.button !== 0) return;
      const { current } = now;
      (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
      const at = localPoint(current, event);
      down.current.set(event.pointerId, at);
      start.current = current.selecting || heldC.current ? current.at(at.x, at.y) : undefined;
      if (start.current) current.onRegion(undefined);
    },
    onPointerMove: moved,
    onPointerUp: up,
    onPointerCancel: up,
    onPointerLeave: () => now.current.onHover(undefined),
  };
}
