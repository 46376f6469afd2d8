import { useLayoutEffect } from "preact/hooks";

/** What the user can do, by key or by button; the help lists all actions. */
export interface Action {
  key: string;
  label: string;
  run: () => void;
  group: string;
  /** Shown instead of `key` if that is not readable. */
  keyName?: string;
}

const sets: Action[][] = [];

export const allActions = (): Action[] => sets.flat();

function isTyping(target: EventTarget | null): boolean {
  return target instanceof HTMLInputElement
    ? !["checkbox", "radio", "range", "button"].includes(target.type)
    : target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement;
}

// Elements that use Space, Enter and the arrow keys themselves while they have the focus.
const kWithKeys = "button, a, summary, [role=slider], input, pre, code";

addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || isTyping(event.target)) return;
  if (document.querySelector("dialog[open]")) return; // the browser handles its keys
  const hasKeys = event.target instanceof HTMLElement && event.target.closest(kWithKeys);
  if (hasKeys && (event.key === " " || event.key === "Enter" || event.key.startsWith("Arrow")))
    return;
  const name =
    event.shiftKey && event.key.length === 1 ? `Shift+${event.key.toUpperCase()}` : event.key;
  for (const set of [...sets].reverse()) {
    // A capital without Shift comes from Caps Lock, which is ignored.
    const plain = event.shiftKey ? event.key : event.key.toLowerCase();
    const action = set.find(
      (one) => one.key === name || one.key === event.key || one.key === plain,
    );
    if (!action) continue;
    event.preventDefault();
    action.run();
    return;
  }
});

/** Binds actions to their keys while the component is mounted. */
export function useActions(actions: Action[]): void {
  // A layout effect runs before the next key event: actions of an earlier render hold old state.
  useLayoutEffect(() => {
    sets.push(actions);
    return () => void sets.splice(sets.indexOf(actions), 1);
  });
}
