import type { State } from "../data/types";

/** What a state looks like. Words and symbols carry the meaning; colour only repeats it. */
export interface Look {
  symbol: string;
  tone: "good" | "quiet" | "unsure" | "bad" | "broken" | "active";
}

// Looks that read better than those that follow from the data alone. A state that is not here gets one of those.
const known: Record<string, Look> = {
  pass: { symbol: "✓", tone: "good" },
  unsupported: { symbol: "–", tone: "quiet" },
  skipped: { symbol: "○", tone: "quiet" },
  waiting: { symbol: "·", tone: "quiet" },
  running: { symbol: "▶", tone: "active" },
  inconclusive: { symbol: "?", tone: "unsure" },
  "missing reference": { symbol: "∅", tone: "unsure" },
  crash: { symbol: "⚡", tone: "broken" },
  timeout: { symbol: "◔", tone: "broken" },
};

// Of images that nobody has rendered: neither better nor worse than any other.
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
