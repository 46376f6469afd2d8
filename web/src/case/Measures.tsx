import { number, withUnit } from "../common/format";
import { TableHead, type Column } from "../common/TableHead";
import type { Check, Measure, TargetDetail } from "../data/generated";
import { Checks, lookOfCheck } from "./Checks";

const kColumns: Column[] = [
  { label: "Metric" },
  { label: "Value", isNumber: true },
  { label: "Gate" },
];

function limitsText(check: Check | undefined): string {
  if (!check) return "";
  const parts = [];
  if (check.min !== undefined) parts.push(`≥ ${number(check.min)}`);
  if (check.max !== undefined) parts.push(`≤ ${number(check.max)}`);
  return parts.join(", ");
}

function betterText(measure: Measure): string {
  if (measure.signed) return "closer to 0 is better";
  return measure.lower_is_better ? "lower is better" : "higher is better";
}

/** The confidence interval of a value, then the pixels that it covers. */
function detailText({ low, high, where }: Measure): string {
  const parts = [];
  if (low !== undefined && high !== undefined) parts.push(`${number(low)} to ${number(high)}`);
  if (where) parts.push(`in [${where.join(", ")}]`);
  return parts.join(", ");
}

function MeasureRow({ measure, check }: { measure: Measure; check: Check | undefined }) {
  const look = check && lookOfCheck(check);
  return (
    <tr>
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
        {limitsText(check)}{" "}
        {look ? (
          <span class={`tone-${look.tone}`}>
            {look.symbol} {look.word}
          </span>
        ) : (
          <span class="quiet">{betterText(measure)}</span>
        )}
      </td>
    </tr>
  );
}

/** The table of all numbers with their gates and definitions. */
function Numbers({ measures, checks }: { measures: Measure[]; checks: Check[] }) {
  return (
    <details class="numbers">
      <summary>All {measures.length} numbers</summary>
      <table>
        <TableHead columns={kColumns} />
        <tbody>
          {measures.map((measure) => (
            <MeasureRow
              key={measure.name}
              measure={measure}
              check={checks.find((one) => one.what === measure.name)}
            />
          ))}
        </tbody>
      </table>
    </details>
  );
}

/** The checks, those that are not met first; what else is known; and all numbers, folded away. */
export function Measures({ detail }: { detail: TargetDetail }) {
  const { measures, checks, remarks = [], hidden = "" } = detail;
  if (measures.length === 0 && checks.length === 0) return null;
  return (
    <section class="measures">
      <h2>Checks</h2>
      <Checks checks={checks} />
      {remarks.length > 0 ? (
        <ul class="checks">
          {remarks.map((remark) => (
            <li key={remark}>{remark}</li>
          ))}
        </ul>
      ) : null}
      {hidden === "" ? null : <p class="quiet">{hidden}</p>}
      {measures.length > 0 ? <Numbers measures={measures} checks={checks} /> : null}
    </section>
  );
}
