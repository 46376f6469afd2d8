import { useState } from "preact/hooks";

/** A command that can be copied. */
export function Copyable({ label, text }: { label: string; text: string }) {
  const [done, setDone] = useState(false);
  const copy = async (): Promise<void> => {
    await navigator.clipboard.writeText(text);
    setDone(true);
    setTimeout(() => setDone(false), 1500);
  };
  return (
    <div class="copyable">
      <span class="label">{label}</span>
      <code tabIndex={0}>{text}</code>
      <button onClick={() => void copy()} aria-label={`Copy: ${label}`}>
        {done ? "Copied" : "Copy"}
      </button>
    </div>
  );
}
