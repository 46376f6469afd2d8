import type { RefObject } from "preact";
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { messageOf } from "../common/message";
import { Painter } from "./painter";
import type { StageSize } from "./stage_content";

/** Size of an element, followed as it changes. */
export function useStageSize(box: RefObject<HTMLElement | null>): StageSize {
  const [stage, setStage] = useState<StageSize>({ width: 600, height: 400, scale: 1 });
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
  return stage;
}

/** The painter of a canvas while its WebGL context exists, and a message while it does not. */
export function usePainter(canvas: RefObject<HTMLCanvasElement | null>) {
  const painter = useRef<Painter | undefined>(undefined);
  const [problem, setProblem] = useState<string>();
  useEffect(() => {
    const element = canvas.current;
    if (!element) return undefined;
    const start = (): void => {
      try {
        painter.current = new Painter(element);
        setProblem(undefined);
      } catch (error) {
        setProblem(messageOf(error));
      }
    };
    const stop = (event: Event): void => {
      event.preventDefault(); // otherwise the browser never restores the context
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
  return { painter, problem, setProblem };
}
