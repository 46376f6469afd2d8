import { useRef, useState } from "preact/hooks";

/** A command that can be copied. */
export function Copyable({ label, text }: { label: string; text: string }) {
  const [done, setDone] = useState("Copy");
  const code = useRef<HTMLElement>(null);
  const copy = async (): Promise<void> => {
    try {
      await navigator.clipboard.writeText(text);
      setDone("Copied");
    } catch {
      // Browsers have no clipboard for pages that came by plain http from another machine.
      if (code.current) getSelection()?.selectAllChildren(code.current);
      setDone("Selected: press Ctrl+C");
    }
    setTimeout(() => setDone("Copy"), 3000);
  };
  return (
    <div class="copyable">
      <span class="label">{label}</span>
      <code ref={code} tabIndex={0}>
        {text}
      </code>
      <button onClick={() => void copy()} aria-label={done === "Copy" ? `Copy: ${label}` : done}>
        {done}
      </button>
    </div>
  );
}
