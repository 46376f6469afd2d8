import type { State } from "../data/generated";

/** Appearance of a state. Word and symbol carry the meaning; the colour only repeats it. */
export interface Look {
  symbol: string;
  tone: "good" | "quiet" | "unsure" | "bad" | "broken" | "active";
}

// States that have a symbol. The appearance of any other follows from `failure` alone.
const known: Record<string, Look> = {
  pass: { symbol: "✓", tone: "good" },
  "pass with remarks": { symbol: "!", tone: "good" },
  known: { symbol: "≈", tone: "good" },
  unsupported: { symbol: "–", tone: "quiet" },
  skipped: { symbol: "○", tone: "quiet" },
  waiting: { symbol: "·", tone: "quiet" },
  running: { symbol: "▶", tone: "active" },
  inconclusive: { symbol: "?", tone: "unsure" },
  "missing reference": { symbol: "∅", tone: "unsure" },
  crash: { symbol: "⚡", tone: "broken" },
  timeout: { symbol: "◔", tone: "broken" },
};

// States of targets that were not rendered: neither better nor worse than any other state.
const open = ["waiting", "running", "skipped"];

export const isOpen = (state: State | undefined): boolean =>
  state === undefined || open.includes(state.name);

export function lookOf(state: State | undefined): Look {
  if (!state) return { symbol: " ", tone: "quiet" };
  return (
    known[state.name] ??
    (state.failure ? { symbol: "✗", tone: "bad" } : { symbol: "·", tone: "quiet" })
  );
}
