import type { Check } from "../data/generated";

interface Look {
  symbol: string;
  tone: string;
  word: string;
}

/** What is known of a check: what noise or the size leaves open is never shown as not met. */
export function lookOfCheck(check: Check): Look {
  if (check.measured === false) return { symbol: "–", tone: "quiet", word: "not measured" };
  if (check.decided === false) return { symbol: "?", tone: "unsure", word: "undecided" };
  return check.passed
    ? { symbol: "✓", tone: "good", word: "met" }
    : { symbol: "✗", tone: "bad", word: "not met" };
}

const rank = (check: Check): number =>
  check.measured === false ? 3 : check.decided === false ? 1 : check.passed ? 2 : 0;

/** All checks: those that are not met first, then the undecided ones. */
export function Checks({ checks }: { checks: Check[] }) {
  if (checks.length === 0) return null;
  const sorted = [...checks].sort((a, b) => rank(a) - rank(b));
  return (
    <ul class="checks" aria-label="Checks">
      {sorted.map((check) => {
        const { symbol, tone, word } = lookOfCheck(check);
        return (
          <li key={`${check.what} ${check.reason}`}>
            <span class={`tone-${tone}`}>
              <span aria-hidden="true">{symbol}</span> <span class="unseen">{word}:</span>
            </span>{" "}
            {check.reason}
          </li>
        );
      })}
    </ul>
  );
}
