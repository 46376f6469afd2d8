import { useLayoutEffect } from "preact/hooks";

/** One thing that can be done: by its key, by its button, and listed on the '?' sheet. */
export interface Action {
  key: string;
  label: string;
  run: () => void;
  group: string;
  /** Shown instead of the key, for keys without a readable name. */
  keyName?: string;
}

const sets: Action[][] = [];

export const allActions = (): Action[] => sets.flat();

function isTyping(target: EventTarget | null): boolean {
  return target instanceof HTMLInputElement
    ? !["checkbox", "radio", "range", "button"].includes(target.type)
    : target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement;
}

// What is pressed, ticked, moved or scrolled by these keys when it has the focus.
const kWithKeys = "button, a, summary, [role=slider], input, pre, code";

addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || isTyping(event.target)) return;
  if (document.querySelector("dialog[open]")) return; // its own keys are the browser's
  const hasKeys = event.target instanceof HTMLElement && event.target.closest(kWithKeys);
  if (hasKeys && (event.key === " " || event.key === "Enter" || event.key.startsWith("Arrow")))
    return;
  const name =
    event.shiftKey && event.key.length === 1 ? `Shift+${event.key.toUpperCase()}` : event.key;
  for (const set of [...sets].reverse()) {
    // Without Shift a capital comes from Caps Lock, which means nothing here.
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

/** Makes actions reachable by key while the component is there. */
export function useActions(actions: Action[]): void {
  // Before the next key can come: an action of an earlier render would act on what was true then.
  useLayoutEffect(() => {
    sets.push(actions);
    return () => void sets.splice(sets.indexOf(actions), 1);
  });
}
