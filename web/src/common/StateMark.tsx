import type { State } from "../data/generated";
import { lookOf } from "./states";

/** A state as symbol, word and colour. */
export function StateMark({ state, word = true }: { state: State | undefined; word?: boolean }) {
  const look = lookOf(state);
  return (
    <span class={`state tone-${look.tone}`}>
      <span class="symbol" aria-hidden="true">
        {look.symbol}
      </span>
      <span class={word ? "word" : "unseen"}>{state?.name ?? "not tested"}</span>
    </span>
  );
}
