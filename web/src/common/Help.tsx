import { useEffect, useRef } from "preact/hooks";
import { allActions } from "./keys";

/** The '?' sheet: every key there is now, by group. */
export function Help({ onClose }: { onClose: () => void }) {
  const dialog = useRef<HTMLDialogElement>(null);
  useEffect(() => dialog.current?.showModal(), []);
  const groups = new Map<string, { keys: string; label: string }[]>();
  for (const action of allActions()) {
    const list = groups.get(action.group) ?? [];
    const keys = action.keyName ?? action.key;
    // The four arrows are one line.
    if (!list.some((known) => known.keys === keys && known.label === action.label))
      list.push({ keys, label: action.label });
    groups.set(action.group, list);
  }
  return (
    <dialog class="help" ref={dialog} onClose={onClose} aria-label="Keys">
      <form method="dialog">
        <h2>Keys</h2>
        <div class="help-groups">
          {[...groups].map(([group, list]) => (
            <section key={group}>
              <h3>{group}</h3>
              <dl>
                {list.map(({ keys, label }) => (
                  <div key={keys + label}>
                    <dt>
                      <kbd>{keys}</kbd>
                    </dt>
                    <dd>{label}</dd>
                  </div>
                ))}
              </dl>
            </section>
          ))}
        </div>
        <button>Close</button>
      </form>
    </dialog>
  );
}
