import { useLayoutEffect, useRef } from "preact/hooks";

/** What the user can do, by key or by button; the help lists all actions. */
export interface Action {
  key: string;
  label: string;
  run: () => void;
  group: string;
  /** Shown instead of `key` if that is not readable. */
  keyName?: string;
}

/** The actions of a component, as of its last render. */
interface Slot {
  actions: Action[];
}

const slots: Slot[] = [];

export const allActions = (): Action[] => slots.flatMap(({ actions }) => actions);

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
  for (const { actions } of [...slots].reverse()) {
    // A capital without Shift comes from Caps Lock, which is ignored.
    const plain = event.shiftKey ? event.key : event.key.toLowerCase();
    const action = actions.find(
      (one) => one.key === name || one.key === event.key || one.key === plain,
    );
    if (!action) continue;
    event.preventDefault();
    action.run();
    return;
  }
});

/**
 * Binds actions to their keys while the component is mounted. Of two components with the same key the
 * one that was mounted last comes first, whichever of them was rendered last: Escape in the viewer must
 * not leave it because the address has just changed and the page was rendered again.
 */
export function useActions(actions: Action[]): void {
  const slot = useRef<Slot>({ actions });
  // A layout effect runs before the next key event: actions of an earlier render hold old state.
  useLayoutEffect(() => void (slot.current.actions = actions));
  useLayoutEffect(() => {
    const own = slot.current;
    slots.push(own);
    return () => void slots.splice(slots.indexOf(own), 1);
  }, []);
}
