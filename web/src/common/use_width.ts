import { useEffect, useRef, useState } from "preact/hooks";

/** The width of an element in CSS pixels, 0 until it is known. */
export function useWidth() {
  const element = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(0);
  useEffect(() => {
    const own = element.current;
    if (!own) return undefined;
    const observer = new ResizeObserver(() => setWidth(Math.floor(own.clientWidth)));
    observer.observe(own);
    return () => observer.disconnect();
  }, []);
  return { element, width };
}
