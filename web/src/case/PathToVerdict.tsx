import { Scroll } from "../common/Scroll";
import type { Session } from "../common/session";
import { StateMark } from "../common/StateMark";
import { TableHead, type Column } from "../common/TableHead";
import type { LookRecord, Overview, TargetDetail } from "../data/generated";
import { endText, gateNumber, intervalText, pathsOf } from "./path_to_verdict";
import { PathChart } from "./PathChart";

const kColumns: Column[] = [
  { label: "Samples", isNumber: true, title: "samples per pixel at the time of the look" },
  { label: "Verdict" },
  { label: "Gate", title: "the gate that decided, or that was farthest from being decided" },
  { label: "Value", isNumber: true },
  { label: "Interval", isNumber: true, title: "the interval that the decision rests on" },
];

const stateNamed = (overview: Overview, name: string) =>
  overview.states.find((state) => state.name === name);

interface RowProps {
  overview: Overview;
  detail: TargetDetail;
  look: LookRecord;
}

function LookRow({ overview, detail, look }: RowProps) {
  return (
    <tr>
      <th scope="row" class="number">
        {look.spp}
      </th>
      <td>
        <StateMark state={stateNamed(overview, look.verdict)} />
      </td>
      <td>{look.gate || "–"}</td>
      <td class="number">{gateNumber(detail, look.gate, look.value)}</td>
      <td class="number">{intervalText(detail, look)}</td>
    </tr>
  );
}

/** How the verdict came about, look by look, where the samples were not fixed beforehand. */
export function PathToVerdict({ session, detail }: { session: Session; detail: TargetDetail }) {
  const { overview } = session;
  const { looks = [] } = detail;
  if (looks.length === 0) return null;
  const paths = pathsOf(detail);
  return (
    <section class="path">
      <h2>Path to the verdict</h2>
      {paths.length > 0 ? (
        <PathChart
          detail={detail}
          paths={paths}
          stateOf={(look) => stateNamed(overview, look.verdict)}
        />
      ) : null}
      <p>{endText(detail, overview.run.live)}</p>
      <details class="numbers">
        <summary>The numbers of each look</summary>
        <Scroll label="Table of looks">
          <table>
            <TableHead columns={kColumns} />
            <tbody>
              {looks.map((look) => (
                <LookRow key={look.spp} overview={overview} detail={detail} look={look} />
              ))}
            </tbody>
          </table>
        </Scroll>
      </details>
    </section>
  );
}
