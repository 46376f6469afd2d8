import { TableHead, type Column } from "../common/TableHead";
import { chanceText, numbersOf, type RunComparison } from "./statistics";

const kColumns: Column[] = [
  { label: "" },
  { label: "Renderer" },
  { label: "Requirement" },
  { label: "Target" },
  { label: "What" },
  { label: "Before" },
  { label: "After" },
  { label: "By chance", title: "how often equal programs differ so much" },
];

const kWords: Record<string, string> = {
  light: "mean light",
  error: "squared error",
  time: "CPU time",
};

const kTones = { worse: "tone-bad", better: "tone-good", changed: "tone-unsure" };

/** The numbers that changed beyond chance, as `orbs compare-runs` has it, and what is not compared. */
export function Numbers({ comparison }: { comparison: RunComparison }) {
  const numbers = numbersOf(comparison);
  const percent = 100 * comparison.false_alarm_rate;
  return (
    <section class="compare-numbers" aria-label="Numbers beyond chance">
      <h2>
        {numbers.length === 0
          ? "No number changed beyond chance"
          : `Numbers that changed beyond chance: ${numbers.length}`}
      </h2>
      {numbers.length > 0 ? (
        <table>
          <TableHead columns={kColumns} />
          <tbody>
            {numbers.map((one) => (
              <tr key={`${one.quantity} ${one.renderer} ${one.requirement} ${one.target}`}>
                <th scope="row" class={kTones[one.direction]}>
                  {one.direction}
                </th>
                <td>{one.renderer}</td>
                <td>{one.requirement}</td>
                <td>{one.target || "all together"}</td>
                <td>{kWords[one.quantity] ?? one.quantity}</td>
                <td>{one.before}</td>
                <td>{one.after}</td>
                <td class="quiet">{chanceText(one.probability)}</td>
              </tr>
            ))}
          </tbody>
        </table>
      ) : null}
      <p class="quiet">
        {comparison.tests} tests of numbers on {comparison.targets} targets. Of two runs of equal
        programs any is called changed in {percent} % of comparisons.
      </p>
      {comparison.lost.length + comparison.notes.length > 0 ? (
        <details>
          <summary>What was not compared</summary>
          <ul>
            {comparison.notes.map((note) => (
              <li key={note}>{note}</li>
            ))}
            {comparison.lost.map(({ loss, target, reason }) => (
              <li key={`${loss} ${target}`}>
                {target}: {loss}
                {reason ? `, ${reason}` : ""}
              </li>
            ))}
          </ul>
        </details>
      ) : null}
    </section>
  );
}
