import type { RefObject } from "preact";
import { useLayoutEffect, useState } from "preact/hooks";

const kLeast_px = 240;
const kBelow_px = 8; // between the colour scale and the edge of the window

/**
 * The height that is left for the stage between the top of `box` and the lower edge of the window, less
 * what stands below the stage in `box` (the colour scale). Scrolling does not change it.
 */
export function useRoom(box: RefObject<HTMLElement | null>, isFull: boolean): number {
  const [room, setRoom] = useState(480);
  useLayoutEffect(() => {
    const measure = (): void => {
      const element = box.current;
      const stage = element?.querySelector(".stage");
      if (!element || !stage) return;
      const scrolled = isFull ? 0 : scrollY;
      const top = stage.getBoundingClientRect().top + scrolled;
      const below = element.getBoundingClientRect().bottom - stage.getBoundingClientRect().bottom;
      const next = Math.max(kLeast_px, Math.floor(innerHeight - top - below - kBelow_px));
      setRoom((old) => (Math.abs(old - next) > 1 ? next : old));
    };
    measure();
    const observer = new ResizeObserver(measure);
    if (box.current) observer.observe(box.current);
    observer.observe(document.body);
    addEventListener("resize", measure);
    return () => {
      observer.disconnect();
      removeEventListener("resize", measure);
    };
  });
  return room;
}
