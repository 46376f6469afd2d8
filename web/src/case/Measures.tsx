import { number, withUnit } from "../common/format";
import type { Check, Measure, TargetDetail } from "../data/types";

function toleranceText(check: Check | undefined): string {
  if (!check) return "";
  const parts = [];
  if (check.min !== undefined) parts.push(`≥ ${number(check.min)}`);
  if (check.max !== undefined) parts.push(`≤ ${number(check.max)}`);
  return parts.join(", ");
}

function betterText(measure: Measure): string {
  if (measure.signed) return "nearer to 0 is better";
  return measure.lower_is_better ? "lower is better" : "higher is better";
}

/** The interval of a number, then the pixels that it is of. */
function detailText({ low, high, where }: Measure): string {
  const parts = [];
  if (low !== undefined && high !== undefined) parts.push(`${number(low)} to ${number(high)}`);
  if (where) parts.push(`in [${where.join(", ")}]`);
  return parts.join(", ");
}

/** Every number with what it may be and what it means, then the conditions that are no metric. */
export function Measures({ detail }: { detail: TargetDetail }) {
  const { measures, checks, remarks = [] } = detail;
  const others = checks.filter((check) => !measures.some((measure) => measure.name === check.what));
  if (measures.length === 0 && checks.length === 0) return null;
  return (
    <section class="measures">
      <h2>Numbers</h2>
      {measures.length > 0 ? (
        <table>
          <thead>
            <tr>
              <th scope="col">Metric</th>
              <th scope="col" class="number">
                Value
              </th>
              <th scope="col">Tolerance</th>
            </tr>
          </thead>
          <tbody>
            {measures.map((measure) => {
              const check = checks.find((one) => one.what === measure.name);
              return (
                <tr key={measure.name} class={check ? (check.passed ? "met" : "unmet") : ""}>
                  <th scope="row">
                    <details>
                      <summary title={measure.definition}>{measure.name}</summary>
                      <p class="definition">{measure.definition}</p>
                    </details>
                  </th>
                  <td class="number">
                    {withUnit(number(measure.value, measure.infinite), measure.unit)}{" "}
                    <span class="quiet">{detailText(measure)}</span>
                  </td>
                  <td>
                    {toleranceText(check)}{" "}
                    {check ? (
                      <span class={check.passed ? "tone-good" : "tone-bad"}>
                        {check.passed ? "✓ met" : "✗ not met"}
                      </span>
                    ) : (
                      <span class="quiet">{betterText(measure)}</span>
                    )}
                  </td>
                </tr>
              );
            })}
          </tbody>
        </table>
      ) : null}
      {remarks.length > 0 ? (
        <ul class="checks">
          {remarks.map((remark) => (
            <li key={remark}>{remark}</li>
          ))}
        </ul>
      ) : null}
      {others.length > 0 ? (
        <ul class="checks">
          {others.map((check) => (
            <li key={check.reason}>
              <span class={check.passed ? "tone-good" : "tone-bad"}>
                {check.passed ? "✓" : "✗"}
              </span>{" "}
              {check.reason}
            </li>
          ))}
        </ul>
      ) : null}
    </section>
  );
}
