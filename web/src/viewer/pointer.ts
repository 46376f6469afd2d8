import type { RefObject } from "preact";
import { useEffect, useRef } from "preact/hooks";
import type { Size } from "./geometry";
import type { Region } from "./statistics";

interface Options {
  box: RefObject<HTMLDivElement | null>;
  /** Position in the image of a point of the stage. */
  at: (x: number, y: number) => { x: number; y: number };
  zoomBy: (x: number, y: number, factor: number) => void;
  panBy: (dx: number, dy: number) => void;
  /** Dragging draws a region instead of moving the image. */
  selecting: boolean;
  onHover: (at: { x: number; y: number } | undefined) => void;
  onRegion: (region: Region | undefined) => void;
  size: Size;
}

interface Point {
  x: number;
  y: number;
}

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

/** Mouse, pen and fingers on the stage: drag moves, wheel and two fingers zoom, C or the button makes regions. */
export function usePointer(options: Options) {
  const now = useRef(options);
  now.current = options;
  const down = useRef(new Map<number, Point>());
  const start = useRef<Point | undefined>(undefined);
  const isC = useRef(false);

  const local = (event: { clientX: number; clientY: number }): Point => {
    const box = now.current.box.current?.getBoundingClientRect();
    return { x: event.clientX - (box?.left ?? 0), y: event.clientY - (box?.top ?? 0) };
  };

  useEffect(() => {
    const keys = (event: KeyboardEvent): void => {
      if (event.key.toLowerCase() === "c") isC.current = event.type === "keydown";
    };
    const release = (): void => void (isC.current = false); // it comes up in another window
    const element = now.current.box.current;
    // Not passive: the page must not scroll along.
    const wheel = (event: WheelEvent): void => {
      event.preventDefault();
      const at = local(event);
      const lines = event.deltaMode === 1 ? 16 : 1;
      now.current.zoomBy(at.x, at.y, 2 ** ((-event.deltaY * lines) / 200));
    };
    element?.addEventListener("wheel", wheel, { passive: false });
    addEventListener("keydown", keys);
    addEventListener("keyup", keys);
    addEventListener("blur", release);
    return () => {
      element?.removeEventListener("wheel", wheel);
      removeEventListener("keydown", keys);
      removeEventListener("keyup", keys);
      removeEventListener("blur", release);
    };
  }, []);

  const moved = (event: PointerEvent): void => {
    const at = local(event);
    const { current } = now;
    current.onHover(current.at(at.x, at.y));
    const before = down.current.get(event.pointerId);
    if (!before) return;
    if (start.current) {
      current.onRegion(regionBetween(start.current, current.at(at.x, at.y), current.size));
    } else if (down.current.size === 1) {
      current.panBy(at.x - before.x, at.y - before.y);
    } else {
      const other = [...down.current].find(([id]) => id !== event.pointerId)?.[1];
      if (other) {
        const distance = (p: Point): number => Math.hypot(p.x - other.x, p.y - other.y);
        current.zoomBy(other.x, other.y, distance(at) / Math.max(1, distance(before)));
      }
    }
    down.current.set(event.pointerId, at);
  };
  const up = (event: PointerEvent): void => {
    down.current.delete(event.pointerId);
    start.current = undefined;
  };
  return {
    onPointerDown: (event: PointerEvent) => {
      if (event.button !== 0) return;
      (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
      const at = local(event);
      down.current.set(event.pointerId, at);
      start.current = now.current.selecting || isC.current ? now.current.at(at.x, at.y) : undefined;
      if (start.current) now.current.onRegion(undefined);
    },
    onPointerMove: moved,
    onPointerUp: up,
    onPointerCancel: up,
    onPointerLeave: () => now.current.onHover(undefined),
  };
}
