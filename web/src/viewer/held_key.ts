import { useEffect, useRef } from "preact/hooks";

/** Calls `onChange` when `key`, in lower case, goes down or up while the component is mounted. */
export function useHeldKey(key: string, onChange: (held: boolean) => void): void {
  const now = useRef(onChange);
  now.current = onChange;
  useEffect(() => {
    const update = (event: KeyboardEvent): void => {
      if (event.key.toLowerCase() === key) now.current(event.type === "keydown");
    };
    // A key that is released in another window sends no event to this one.
    const release = (): void => now.current(false);
    addEventListener("keydown", update);
    addEventListener("keyup", update);
    addEventListener("blur", release);
    return () => {
      removeEventListener("keydown", update);
      removeEventListener("keyup", update);
      removeEventListener("blur", release);
    };
  }, [key]);
}
