import { useLayoutEffect, useRef, useState } from "preact/hooks";

/** The range of rows of equal height within the window, and `spare` rows beyond its edges. */
export function useWindow(count: number, rowHeight: number, spare: number) {
  const body = useRef<HTMLDivElement>(null);
  const [span, setSpan] = useState({ begin: 0, end: Math.ceil(2000 / rowHeight) });
  useLayoutEffect(() => {
    const update = (): void => {
      const top = body.current?.getBoundingClientRect().top ?? 0;
      const begin = Math.max(0, Math.floor(-top / rowHeight) - spare);
      const end = Math.min(count, Math.ceil((innerHeight - top) / rowHeight) + spare);
      setSpan((old) => (old.begin === begin && old.end === end ? old : { begin, end }));
    };
    update();
    addEventListener("scroll", update, { passive: true });
    addEventListener("resize", update);
    return () => {
      removeEventListener("scroll", update);
      removeEventListener("resize", update);
    };
  }, [count, rowHeight, spare]);
  return { body, ...span };
}
