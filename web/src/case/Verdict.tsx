import { goesOnText, reasonOf, stateOf, type Session } from "../common/session";
import { StateMark } from "../common/StateMark";

const kNone = "none of the usual faults";

interface Props {
  session: Session;
  index: number;
  /** Which usual fault explains a failure; "" if none was tried. */
  diagnosis: string;
  /** What is wrong for certain in the largest part of the image; "" if nothing is known. */
  region: string;
}

/** The verdict with its first reason, which is the diagnosis where the fault is known; the others are folded away. */
export function Verdict({ session, index, diagnosis, region }: Props) {
  const [first = "", ...others] = reasonOf(session.overview, index).split("; ");
  // What a named fault does to a region is no news: the fault comes first.
  const isNamed = first !== "" && first === diagnosis;
  const goesOn = goesOnText(session.overview, index);
  return (
    <div class="reason">
      <StateMark state={stateOf(session.overview, index)} />{" "}
      {goesOn ? <span class="goes-on tone-active">{goesOn}</span> : null}
      {isNamed ? <b class="diagnosis">{first}</b> : null}
      {region ? (
        <b class="wrong-region" title="outlined in the images; larger than noise for certain">
          {region}
        </b>
      ) : null}
      {isNamed ? null : first}
      {others.length > 0 ? (
        <details class="more-reasons">
          <summary>and {others.length} more</summary>
          <ul>
            {others.map((reason) => (
              <li key={reason}>{reason}</li>
            ))}
          </ul>
        </details>
      ) : null}
      {diagnosis.startsWith(kNone) ? (
        <span class="diagnosis quiet">Diagnosis: {diagnosis}</span>
      ) : null}
    </div>
  );
}
